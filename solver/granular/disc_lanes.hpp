#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "solver/base/pack.hpp"

/// SIMD helpers for packs of disc pairs.
namespace talus {

inline constexpr std::size_t points_per_pack = pack_size / 2;

using Point [[gnu::vector_size(16)]] = double;
using Points = std::array<Point, points_per_pack>;

/// Two coordinates at index `to` minus those at index `from`.
[[gnu::always_inline]] inline Point difference(const double* numbers, std::size_t from, std::size_t to) {
  Point a, b;
  std::memcpy(&a, numbers + from, sizeof a), std::memcpy(&b, numbers + to, sizeof b);
  return b - a;
}

/// Joins pairs of numbers to a pack.
[[gnu::always_inline]] inline void join(Pack& pack, const Points& twos) {
  pack = __builtin_shufflevector(twos[0], twos[1], 0, 1, 2, 3);
}

/// Separates coordinates into x and y: p from the even pairs of a pack, q from the odd ones.
[[gnu::always_inline]] inline void lay_out(Pack& x, Pack& y, const Points& p, const Points& q) {
  Pack even, odd;
  join(even, p), join(odd, q);
  x = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
  y = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
}

/// Differences of positions or velocities, second disc minus first, for the pack of pairs with these indices.
[[gnu::always_inline]] inline void differences(Pack& x, Pack& y, const double* numbers, const std::uint32_t* first,
                                               const std::uint32_t* second, const std::uint32_t* pairs) {
  Points p, q;
  for (std::size_t l = 0; l < points_per_pack; ++l) {
    p[l] = difference(numbers, first[pairs[2 * l]], second[pairs[2 * l]]);
    q[l] = difference(numbers, first[pairs[2 * l + 1]], second[pairs[2 * l + 1]]);
  }
  lay_out(x, y, p, q);
}

/// The same for a pack of consecutive pairs, whose position indices are fetched two at a time.
[[gnu::always_inline]] inline void listed_differences(Pack& x, Pack& y, const double* numbers,
                                                      const std::uint32_t* first, const std::uint32_t* second) {
  static_assert(std::endian::native == std::endian::little);
  Points p, q;
  for (std::size_t l = 0; l < points_per_pack; ++l) {
    std::uint64_t from, to;
    std::memcpy(&from, first + 2 * l, sizeof from), std::memcpy(&to, second + 2 * l, sizeof to);
    p[l] = difference(numbers, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to));
    q[l] = difference(numbers, from >> 32U, to >> 32U);
  }
  lay_out(x, y, p, q);
}

/// Table by the bits of a lane mask: the lanes whose bit is set, in order, and their count.
struct Chosen {
  static constexpr std::size_t size = std::size_t{1} << pack_size;
  std::array<std::array<std::uint32_t, pack_size>, size> lanes{};
  std::array<std::uint8_t, size> count{};
};
inline constexpr Chosen chosen = [] {
  Chosen made;
  for (std::size_t bits = 0; bits < Chosen::size; ++bits) {
    for (std::uint32_t lane = 0; lane < pack_size; ++lane) {
      if ((bits >> lane & 1U) != 0) made.lanes[bits][made.count[bits]++] = lane;
    }
  }
  return made;
}();

using Numbers [[gnu::vector_size(16)]] = std::uint32_t;

/// Writes the indices of the lanes whose bits are set, where lane 0 has index `first`, to the start of `row`, and
/// returns their count. A whole pack of `row` is overwritten.
[[gnu::always_inline]] inline std::size_t number_lanes(std::size_t bits, std::size_t first, std::uint32_t* row) {
  Numbers numbers;
  std::memcpy(&numbers, chosen.lanes[bits].data(), sizeof numbers);
  numbers += static_cast<std::uint32_t>(first);
  std::memcpy(row, &numbers, sizeof numbers);
  return chosen.count[bits];
}

/// Sets each lane l to number(l).
template <class Lanes, class Number>
[[gnu::always_inline]] inline void collect(Lanes& lanes, Number&& number) {
  lanes = Lanes{number(0), number(1), number(2), number(3)};
}

/// Gathers a pack from `row` at the indices `indices`.
[[gnu::always_inline]] inline void collect(Pack& lanes, const double* row, const std::uint32_t* indices) {
  Points twos;
  for (std::size_t l = 0; l < points_per_pack; ++l)
    twos[l] = Point{row[indices[2 * l]], row[indices[2 * l + 1]]};
  join(lanes, twos);
}

/// Stores x and y of a pack interleaved: x0, y0, x1, y1, ...
[[gnu::always_inline]] inline void store_points(const Pack& x, const Pack& y, double* numbers) {
  store(__builtin_shufflevector(x, y, 0, 4, 1, 5), numbers);
  store(__builtin_shufflevector(x, y, 2, 6, 3, 7), numbers + pack_size);
}

/// Sets lanes of x to zero where the mask `is` is false.
[[gnu::always_inline]] inline void keep_where(Pack& x, const Sizes& is) {
  Sizes bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= is;
  std::memcpy(&x, &bits, sizeof bits);
}

}  // namespace talus
