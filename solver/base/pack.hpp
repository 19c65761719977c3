#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

// Marks a function that is compiled for several instruction sets, of which the loader takes the best that the
// processor has: the same arithmetic on more lanes at once, and so the same bits. With TALUS_PORTABLE it is compiled
// once, for every processor.
#if defined(__x86_64__) && !defined(__clang__) && !defined(TALUS_PORTABLE)
#define TALUS_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define TALUS_CLONES
#endif

namespace talus {

/// Four numbers that are computed side by side, each as it would be alone. Not eight: where a processor has registers of
/// four, gcc 12 keeps packs of eight on the stack and copies them by twos.
using Pack [[gnu::vector_size(32)]] = double;
inline constexpr std::size_t pack_size = 4;

/// The next numbers of a row of which `left` are left; zero in lanes beyond its end.
[[gnu::always_inline]] inline void load(Pack& pack, const double* row, std::size_t left = pack_size) {
  if (left >= pack_size) {
    std::memcpy(&pack, row, sizeof(Pack));
  } else {
    pack = Pack{};
    std::memcpy(&pack, row, left * sizeof(double));
  }
}

/// Puts them back.
[[gnu::always_inline]] inline void store(const Pack& pack, double* row, std::size_t left = pack_size) {
  if (left >= pack_size) {
    std::memcpy(row, &pack, sizeof(Pack));
  } else {
    std::memcpy(row, &pack, left * sizeof(double));
  }
}

/// Calls visit(first, left) for packs from `first` on, until all of a row is visited; `left` is a whole pack, but of a
/// row shorter than one. The last pack may overlap the one before: nothing may depend on how often it is visited.
template <class Visit>
[[gnu::always_inline]] inline void for_packs(std::size_t count, Visit&& visit) {
  using Whole = std::integral_constant<std::size_t, pack_size>;
  std::size_t first = 0;
  for (; first + pack_size <= count; first += pack_size)
    visit(first, Whole{});
  if (first == count) return;
  if (first > 0)
    visit(count - pack_size, Whole{});
  else
    visit(first, count);
}

/// The largest size in each lane so far. Sizes have the order of their bits as whole numbers, in which what is not a
/// number is above all others, and stays.
using Sizes [[gnu::vector_size(32)]] = std::int64_t;

[[gnu::always_inline]] inline void raise(Sizes& most, const Sizes& other) { most = other > most ? other : most; }
[[gnu::always_inline]] inline void raise(Sizes& most, const Pack& x) {
  Sizes bits;
  std::memcpy(&bits, &x, sizeof bits);
  raise(most, bits & std::numeric_limits<std::int64_t>::max());
}

/// The bits that are set in any lane.
[[gnu::always_inline]] inline std::int64_t bits_of_all(const Sizes& bits) {
  const Sizes all = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
  return all[0] | all[1];
}
/// Whether any bit is set in any lane.
[[gnu::always_inline]] inline bool any_bit(const Sizes& bits) { return bits_of_all(bits) != 0; }

/// A bit for each lane, the first lowest: set where the lane is true, all of whose bits are set.
[[gnu::always_inline]] inline std::size_t bits_of(const Sizes& is) {
  return static_cast<std::size_t>(bits_of_all(is & Sizes{1, 2, 4, 8}));
}

/// The largest of all lanes.
[[gnu::always_inline]] inline double largest(const Sizes& sizes) {
  Sizes most = sizes;
  raise(most, __builtin_shufflevector(most, most, 2, 3, 0, 1));
  raise(most, __builtin_shufflevector(most, most, 1, 0, 3, 2));
  return std::bit_cast<double>(static_cast<std::int64_t>(most[0]));
}

}  // namespace talus
