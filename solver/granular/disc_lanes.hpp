#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "solver/base/pack.hpp"

/// Eight pairs of discs side by side.
namespace talus {

inline constexpr std::size_t places_per_pack = pack_size / 2;

using Place [[gnu::vector_size(16)]] = double;
using Places2 [[gnu::vector_size(32)]] = double;

/// Both numbers of four discs, side by side.
[[gnu::always_inline]] inline void fetch_four(Pack& out, const double* numbers, const std::uint32_t* at) {
  std::array<Place, 4> p;
  for (std::size_t l = 0; l < 4; ++l)
    std::memcpy(&p[l], numbers + std::size_t{at[l]}, sizeof(Place));
  const Places2 low = __builtin_shufflevector(p[0], p[1], 0, 1, 2, 3);
  const Places2 high = __builtin_shufflevector(p[2], p[3], 0, 1, 2, 3);
  out = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// From the first discs to the second of eight pairs, of places or velocities.
[[gnu::always_inline]] inline void differences(Pack& x, Pack& y, const double* numbers, const std::uint32_t* first,
                                               const std::uint32_t* second) {
  Pack a, b, c, d;
  fetch_four(a, numbers, first), fetch_four(b, numbers, second);
  fetch_four(c, numbers, first + 4), fetch_four(d, numbers, second + 4);
  const Pack low = b - a, high = d - c;
  x = __builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14);
  y = __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15);
}

/// By the bits of eight lanes: the lanes whose bit is set, in order, and how many.
struct Chosen {
  std::array<std::array<std::uint32_t, pack_size>, 256> lanes{};
  std::array<std::uint8_t, 256> count{};
};
inline constexpr Chosen chosen = [] {
  Chosen made;
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::uint32_t lane = 0; lane < pack_size; ++lane) {
      if ((bits >> lane & 1U) != 0) made.lanes[bits][made.count[bits]++] = lane;
    }
  }
  return made;
}();

using Numbers [[gnu::vector_size(32)]] = std::uint32_t;

/// One bit for each lane that is true.
[[gnu::always_inline]] inline std::size_t bits_of(const Sizes& is) {
  const Bytes bytes = __builtin_convertvector(is, Bytes);
  std::uint64_t all;
  std::memcpy(&all, &bytes, sizeof all);
  // Bit k of byte k; the factor brings them together in the highest byte.
  return static_cast<std::size_t>((all & 0x0101010101010101U) * 0x0102040810204080U >> 56U);
}

[[gnu::always_inline]] inline void square_root(Pack& x) {
  std::array<double, pack_size> numbers;
  std::memcpy(numbers.data(), &x, sizeof x);
  for (double& number : numbers)
    number = std::sqrt(number);
  std::memcpy(&x, numbers.data(), sizeof x);
}

/// One number for each lane.
template <class Lanes, class Number>
[[gnu::always_inline]] inline void collect(Lanes& lanes, Number&& number) {
  lanes = Lanes{number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7)};
}

/// Nought in the lanes where it is not so.
[[gnu::always_inline]] inline void keep_where(Pack& x, const Sizes& is) {
  Sizes bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= is;
  std::memcpy(&x, &bits, sizeof bits);
}

}  // namespace talus
