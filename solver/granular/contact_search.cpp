#include <algorithm>
#include <array>
#include <cstring>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"

namespace talus {

TALUS_CLONES std::size_t find_near(const StepBlock& sweep, double nearer, std::size_t from, std::size_t to,
                                   std::uint32_t* found) {
  const std::uint32_t *const first = sweep.pairs->first.data(), *const second = sweep.pairs->second.data();
  const double* const sums = sweep.pairs->radii.empty() ? nullptr : sweep.pairs->radii.data();
  const double* const positions = sweep.positions;
  // Two passes: in a single one each pack would wait for the count of the previous one, which takes 1.5 times as long.
  std::array<std::uint8_t, sweep_block / pack_size> near;
  Pack within = Pack{} + (sweep.equal_radii + nearer);
  for (std::size_t k = from; k < to; k += pack_size) {
    Pack x, y;
    listed_differences(x, y, positions, first + k, second + k);
    if (sums != nullptr) load(within, sums + k), within += nearer;
    near[(k - from) / pack_size] = static_cast<std::uint8_t>(bits_of(x * x + y * y < within * within));
  }
  std::size_t count = 0;
  for (std::size_t k = from; k < to; k += pack_size)
    count += number_lanes(near[(k - from) / pack_size], k, found + count);
  return count;
}

namespace stages {
namespace {

/// Ends a contact that existed before the sweep.
[[gnu::noinline]] void part_before(const StepBlock& w, std::size_t old) {
  const SweptContacts& contacts = *w.contacts;
  const ContactMemory of = contacts.memory(contacts.before, old);
  const std::uint32_t pair = contacts.before.pair[old];
  part(w, contacts.before.as_listed ? pair : w.pairs->number_in_list(pair), of.largest, of.stretch);
}

/// Looks up which contacts the touching pairs were before; contacts that lie between these have ended. number(t): index
/// of the t-th pair, as the contacts before are numbered.
template <class Number>
[[gnu::always_inline]] inline void find_before(const StepBlock& w, std::size_t count, Number&& number) {
  SweptContacts& contacts = *w.contacts;
  const std::uint32_t* const then = contacts.before.pair.data();
  std::uint32_t* const from = contacts.from.data();
  const auto none = static_cast<std::uint32_t>(contacts.before.count);
  std::size_t old = contacts.passed;
  for (std::size_t t = 0; t < count; ++t) {
    const std::uint32_t pair = number(t);
    for (; then[old] < pair; ++old)
      part_before(w, old);
    const bool since = then[old] == pair;
    from[t] = since ? static_cast<std::uint32_t>(old) : none;
    old += since ? 1U : 0U;
  }
  contacts.passed = old;
  std::fill_n(from + count, pack_size, none);
}

}  // namespace

void part(const StepBlock& sweep, std::size_t listed, double largest, double stretch) {
  if (largest > 0.0 || (stretch != 0.0 && sweep.contacts->kinds.friction_work))
    sweep.ended->push_back({static_cast<std::uint32_t>(listed), largest, stretch});
}

std::span<const std::uint32_t> find_touching(const StepBlock& sweep, std::size_t from, std::size_t to) {
  SweptContacts& contacts = *sweep.contacts;
  contacts.make_room(contacts.now.count + sweep_block + pack_size);
  std::uint32_t* const touching = contacts.now.pair.data() + contacts.now.count;
  const std::size_t count = find_near(sweep, sweep.reach, from, to, touching);
  contacts.now.count += count;
  if (count == 0) return {};
  std::fill_n(touching + count, pack_size, touching[count - 1]);
  if (contacts.kinds.remembered()) {
    const std::uint32_t* const listed = sweep.pairs->listed.data();
    // Only in the first sweep after lists were built or a saved state was loaded.
    if (contacts.before.as_listed && !sweep.pairs->listed.empty())
      find_before(sweep, count, [=](std::size_t t) { return listed[touching[t]]; });
    else
      find_before(sweep, count, [=](std::size_t t) { return touching[t]; });
  }
  return {touching, count};
}

void end_sweep(const StepBlock& sweep) {
  SweptContacts& contacts = *sweep.contacts;
  if (!contacts.kinds.remembered()) return;
  for (; contacts.passed < contacts.before.count; ++contacts.passed)
    part_before(sweep, contacts.passed);
}

}  // namespace stages
}  // namespace talus
