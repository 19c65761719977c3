#include "solver/granular/swept_pairs.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/pack.hpp"

namespace talus {
namespace {

/// Resizes with little spare capacity: lists take most of the memory of a run of many discs.
template <class Number>
void fit(std::vector<Number>& numbers, std::size_t size) {
  numbers.reserve(size);
  numbers.resize(size);
  if (numbers.capacity() > 2 * size) numbers.shrink_to_fit();
}

}  // namespace

void SweptPairs::list(std::size_t size, bool unlike) {
  resize(size + pack_size, false, unlike);
  count = size;
}

void SweptPairs::take(const SweptPairs& list, std::span<const std::uint32_t> numbers) {
  const std::size_t filled = count + numbers.size();
  if (filled > first.size()) resize(filled + filled / 8, true, !list.radii.empty());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::uint32_t pair = numbers[k];
    first[count + k] = list.first[pair], second[count + k] = list.second[pair];
    listed[count + k] = pair;
    if (!list.radii.empty()) radii[count + k] = list.radii[pair];
  }
  count = filled;
}

void SweptPairs::fill_up(std::uint32_t nowhere) {
  if (count == 0) return;
  const std::size_t filled = count + pack_size;
  // The first reach of a near list is a guess, and may need much more room than later ones.
  if (filled > first.size() || 2 * filled < first.size()) resize(filled, !listed.empty(), !radii.empty());
  std::fill_n(first.begin() + static_cast<std::ptrdiff_t>(count), pack_size, nowhere);
  std::fill_n(second.begin() + static_cast<std::ptrdiff_t>(count), pack_size, nowhere);
}

void SweptPairs::resize(std::size_t size, bool near, bool unlike) {
  fit(first, size), fit(second, size);
  if (near) fit(listed, size);
  if (unlike) fit(radii, size);
}

void SweptContacts::clear(Kinds of) {
  if (kinds != of) *this = {};
  kinds = of;
  now.count = before.count = passed = 0;
  now.as_listed = before.as_listed = true;
}

void SweptContacts::grow(std::size_t size) {
  for (Found* const found : {&now, &before}) {
    found->pair.resize(size);
    if (kinds.largest) found->largest.resize(size);
    if (kinds.stretch) found->stretch.resize(size);
    if (kinds.normal) found->normal.resize(size);
  }
  if (kinds.power) power.resize(size), released.resize(size);
  if (kinds.friction_work) friction_work.resize(size);
  if (kinds.area_power) area_power.resize(size);
}

void SweptContacts::begin() {
  make_room(1);
  std::swap(now, before);
  now.count = passed = 0;
  now.as_listed = false;
  before.pair[before.count] = ~std::uint32_t{0};  // larger than any index
  put(before, before.count, {});
}

ContactMemory SweptContacts::memory(const Found& found, std::size_t t) const {
  ContactMemory of;
  if (kinds.largest) of.largest = found.largest[t];
  if (kinds.stretch) of.stretch = found.stretch[t];
  if (kinds.normal) of.normal = found.normal[t];
  return of;
}

void SweptContacts::put(Found& found, std::size_t t, const ContactMemory& of) const {
  if (kinds.largest) found.largest[t] = of.largest;
  if (kinds.stretch) found.stretch[t] = of.stretch;
  if (kinds.normal) found.normal[t] = of.normal;
}

void SweptContacts::number_as_listed(const SweptPairs& pairs) {
  if (now.as_listed) return;
  for (std::size_t t = 0; t < now.count; ++t)
    now.pair[t] = static_cast<std::uint32_t>(pairs.number_in_list(now.pair[t]));
  now.as_listed = true;
}

void SweptContacts::add(std::uint32_t listed, const ContactMemory& of) {
  make_room(now.count + 1 + pack_size);
  now.pair[now.count] = listed;
  put(now, now.count++, of);
}

}  // namespace talus
