#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "solver/base/pack.hpp"

namespace talus {

/// Selects the lanes of a pack with index from .. to - 1; these may be negative. The mask comes from a table, and
/// choose() selects between integers: gcc 12 compiles comparisons of packs, and selections between them, to a jump for
/// each lane.
inline constexpr std::array<std::int64_t, 2 * pack_size> ones_then_zeros{-1, -1, -1, -1};
[[gnu::always_inline]] inline void between(Sizes& is, std::ptrdiff_t from, std::ptrdiff_t to) {
  constexpr auto size = static_cast<std::ptrdiff_t>(pack_size);
  const auto below = [&](Sizes& lanes, std::ptrdiff_t end) {
    std::memcpy(&lanes, ones_then_zeros.data() + size - std::clamp(end, std::ptrdiff_t{0}, size), sizeof lanes);
  };
  Sizes early;
  below(is, to), below(early, from);
  is &= ~early;
}

/// Replaces the true lanes of a pack by those of another pack.
[[gnu::always_inline]] inline void choose(Pack& pack, const Sizes& is, const Pack& other) {
  Sizes bits, others;
  std::memcpy(&bits, &pack, sizeof bits), std::memcpy(&others, &other, sizeof others);
  bits = (bits & ~is) | (others & is);
  std::memcpy(&pack, &bits, sizeof bits);
}

/// Stores the true lanes; the other numbers remain unchanged.
[[gnu::always_inline]] inline void put(double* row, const Sizes& is, const Pack& numbers) {
  Pack there;
  load(there, row);
  choose(there, is, numbers);
  store(there, row);
}

/// Calls visit(lane) for each lane; visits must not depend on each other.
template <class Visit>
[[gnu::always_inline]] inline void for_lanes(Visit&& visit) {
#pragma omp simd
  for (std::size_t lane = 0; lane < pack_size; ++lane)
    visit(lane);
}

/// Numbers of neighbours, with access to each lane.
struct alignas(sizeof(Pack)) Lanes {
  std::array<double, pack_size> number;

  [[gnu::always_inline]] double operator[](std::size_t lane) const { return number[lane]; }
  [[gnu::always_inline]] double& operator[](std::size_t lane) { return number[lane]; }
  [[gnu::always_inline]] void get(Pack& pack) const { load(pack, number.data()); }
  [[gnu::always_inline]] void set(const Pack& pack) { store(pack, number.data()); }
};

/// Adds the lanes to a sum one by one, of which `left` remain: the same bits as without packs.
[[gnu::always_inline]] inline void add_lanes(double& sum, const Pack& pack, std::size_t left) {
  Lanes terms;
  terms.set(pack);
  if (left >= pack_size) {
    for (std::size_t lane = 0; lane < pack_size; ++lane)
      sum += terms[lane];
  } else {
    for (std::size_t lane = 0; lane < left; ++lane)
      sum += terms[lane];
  }
}

/// Selects the lanes for which ask(lane) is true.
template <class Ask>
[[gnu::always_inline]] inline void ask_lanes(Sizes& is, Ask&& ask) {
  alignas(sizeof(Pack)) std::array<std::int64_t, pack_size> answer;
  for_lanes([&](std::size_t lane) { answer[lane] = ask(lane) ? -1 : 0; });
  std::memcpy(&is, answer.data(), sizeof is);
}

}  // namespace talus
