#pragma once

#include <array>
#include <bit>
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

/// What stands at one of two places less what stands at the other.
[[gnu::always_inline]] inline Place difference(const double* numbers, std::size_t from, std::size_t to) {
  Place a, b;
  std::memcpy(&a, numbers + from, sizeof a), std::memcpy(&b, numbers + to, sizeof b);
  return b - a;
}

/// Four twos side by side.
[[gnu::always_inline]] inline void join(Pack& pack, const std::array<Place, 4>& twos) {
  const Places2 low = __builtin_shufflevector(twos[0], twos[1], 0, 1, 2, 3);
  const Places2 high = __builtin_shufflevector(twos[2], twos[3], 0, 1, 2, 3);
  pack = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Of even pairs and of odd ones.
[[gnu::always_inline]] inline void lay_out(Pack& x, Pack& y, const std::array<Place, 4>& p,
                                           const std::array<Place, 4>& q) {
  Pack even, odd;
  join(even, p), join(odd, q);
  x = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
  y = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
}

/// From the first discs to the second of eight pairs with these numbers, of places or velocities.
[[gnu::always_inline]] inline void differences(Pack& x, Pack& y, const double* numbers, const std::uint32_t* first,
                                               const std::uint32_t* second, const std::uint32_t* pairs) {
  std::array<Place, 4> p, q;
  for (std::size_t l = 0; l < 4; ++l) {
    p[l] = difference(numbers, first[pairs[2 * l]], second[pairs[2 * l]]);
    q[l] = difference(numbers, first[pairs[2 * l + 1]], second[pairs[2 * l + 1]]);
  }
  lay_out(x, y, p, q);
}

/// The same of eight pairs that follow each other: where their places begin is fetched two at once.
[[gnu::always_inline]] inline void listed_differences(Pack& x, Pack& y, const double* numbers,
                                                      const std::uint32_t* first, const std::uint32_t* second) {
  static_assert(std::endian::native == std::endian::little);
  std::array<Place, 4> p, q;
  for (std::size_t l = 0; l < 4; ++l) {
    std::uint64_t from, to;
    std::memcpy(&from, first + 2 * l, sizeof from), std::memcpy(&to, second + 2 * l, sizeof to);
    p[l] = difference(numbers, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to));
    q[l] = difference(numbers, from >> 32U, to >> 32U);
  }
  lay_out(x, y, p, q);
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

/// One bit for each lane whose byte is not nought: of bytes all or none of whose bits are set.
[[gnu::always_inline]] inline std::size_t bits_of(std::uint64_t bytes) {
  // Bit k of byte k; the factor brings them together in the highest byte.
  return static_cast<std::size_t>((bytes & 0x0101010101010101U) * 0x0102040810204080U >> 56U);
}

/// Writes the numbers of the lanes whose bytes are set, the first lane's being `first`, in a row, and what fills a pack
/// behind them; how many they are.
[[gnu::always_inline]] inline std::size_t number_lanes(std::uint64_t bytes, std::size_t first, std::uint32_t* row) {
  const std::size_t bits = bits_of(bytes);
  Numbers numbers;
  std::memcpy(&numbers, chosen.lanes[bits].data(), sizeof numbers);
  numbers += static_cast<std::uint32_t>(first);
  std::memcpy(row, &numbers, sizeof numbers);
  return chosen.count[bits];
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

/// Eight numbers from these places in a row.
[[gnu::always_inline]] inline void collect(Pack& lanes, const double* row, const std::uint32_t* places) {
  std::array<Place, 4> twos;
  for (std::size_t l = 0; l < 4; ++l)
    twos[l] = Place{row[places[2 * l]], row[places[2 * l + 1]]};
  join(lanes, twos);
}

/// The two coordinates of eight, those of each side by side.
[[gnu::always_inline]] inline void store_places(const Pack& x, const Pack& y, double* places) {
  store(__builtin_shufflevector(x, y, 0, 8, 1, 9, 2, 10, 3, 11), places);
  store(__builtin_shufflevector(x, y, 4, 12, 5, 13, 6, 14, 7, 15), places + pack_size);
}

/// Nought in the lanes where it is not so.
[[gnu::always_inline]] inline void keep_where(Pack& x, const Sizes& is) {
  Sizes bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= is;
  std::memcpy(&x, &bits, sizeof bits);
}

}  // namespace talus
