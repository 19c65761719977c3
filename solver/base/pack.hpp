#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

// Marks a function that is compiled for several instruction sets; the loader selects the best one that the processor
// supports. The variants perform the same arithmetic on more lanes at once, so results are bit-identical. With
// TALUS_PORTABLE the function is compiled once, for every processor.
#if defined(__x86_64__) && !defined(__clang__) && !defined(TALUS_PORTABLE)
#define TALUS_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define TALUS_CLONES
#endif

namespace talus {

/// Four numbers computed in parallel, each with the same result as if computed alone. Four and not eight: for
/// processors with registers of four numbers, gcc 12 keeps packs of eight on the stack and copies them in pairs.
using Pack [[gnu::vector_size(32)]] = double;
inline constexpr std::size_t pack_size = 4;

/// Loads the next numbers of a row, of which `left` remain; lanes beyond its end are set to zero.
[[gnu::always_inline]] inline void load(Pack& pack, const double* row, std::size_t left = pack_size) {
  if (left >= pack_size) {
    std::memcpy(&pack, row, sizeof(Pack));
  } else {
    pack = Pack{};
    std::memcpy(&pack, row, left * sizeof(double));
  }
}

/// Stores a pack as the next numbers of a row, of which `left` remain; lanes beyond its end are dropped.
[[gnu::always_inline]] inline void store(const Pack& pack, double* row, std::size_t left = pack_size) {
  if (left >= pack_size) {
    std::memcpy(row, &pack, sizeof(Pack));
  } else {
    std::memcpy(row, &pack, left * sizeof(double));
  }
}

/// Square root of a number, or of each lane of a pack: correctly rounded, so that both have the same bits.
[[gnu::always_inline]] inline void square_root(double& x) { x = std::sqrt(x); }
[[gnu::always_inline]] inline void square_root(Pack& x) {
  std::array<double, pack_size> numbers;
  std::memcpy(numbers.data(), &x, sizeof x);
  for (double& number : numbers)
    number = std::sqrt(number);
  std::memcpy(&x, numbers.data(), sizeof x);
}

/// Power of a number, or of each lane of a pack, by the library's function of one number: its last bits depend on the
/// library, but not on whether a number is in a pack.
[[gnu::always_inline]] inline void raise_to_power(double& x, double exponent) { x = std::pow(x, exponent); }
[[gnu::always_inline]] inline void raise_to_power(Pack& x, double exponent) {
  for (std::size_t l = 0; l < pack_size; ++l)
    x[l] = std::pow(x[l], exponent);
}

/// Calls visit(first, left) for packs that start at `first` until the whole row is visited; `left` is pack_size, or
/// `count` for a row shorter than a pack. The last pack may overlap the one before it, so the result must not depend on
/// how often a number is visited.
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

/// Largest magnitude so far in each lane, as the bits of the double. Magnitudes are ordered like their bits read as
/// integers, where NaN is above all numbers and therefore persists.
using Sizes [[gnu::vector_size(32)]] = std::int64_t;

[[gnu::always_inline]] inline void raise(Sizes& maximum, const Sizes& other) {
  maximum = other > maximum ? other : maximum;
}
[[gnu::always_inline]] inline void raise(Sizes& maximum, const Pack& x) {
  Sizes bits;
  std::memcpy(&bits, &x, sizeof bits);
  raise(maximum, bits & std::numeric_limits<std::int64_t>::max());
}

/// Bitwise OR of all lanes.
[[gnu::always_inline]] inline std::int64_t bits_of_all(const Sizes& bits) {
  const Sizes all = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
  return all[0] | all[1];
}
/// Whether any bit is set in any lane.
[[gnu::always_inline]] inline bool any_bit(const Sizes& bits) { return bits_of_all(bits) != 0; }

/// Mask with one bit per lane, the lowest for the first: set where the lane is true, that is, has all bits set.
[[gnu::always_inline]] inline std::size_t bits_of(const Sizes& is) {
  return static_cast<std::size_t>(bits_of_all(is & Sizes{1, 2, 4, 8}));
}

/// Maximum over all lanes.
[[gnu::always_inline]] inline double largest(const Sizes& sizes) {
  Sizes maximum = sizes;
  raise(maximum, __builtin_shufflevector(maximum, maximum, 2, 3, 0, 1));
  raise(maximum, __builtin_shufflevector(maximum, maximum, 1, 0, 3, 2));
  return std::bit_cast<double>(static_cast<std::int64_t>(maximum[0]));
}

}  // namespace talus
