#include "solver/granular/disc_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "solver/base/pack.hpp"

namespace talus {
namespace {

constexpr std::size_t places_per_pack = pack_size / 2;

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
constexpr Chosen chosen = [] {
  Chosen made;
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::uint32_t lane = 0; lane < pack_size; ++lane) {
      if ((bits >> lane & 1U) != 0) made.lanes[bits][made.count[bits]++] = lane;
    }
  }
  return made;
}();

using Bytes [[gnu::vector_size(8)]] = std::uint8_t;
using Numbers [[gnu::vector_size(32)]] = std::uint32_t;

/// One bit for each lane that is true.
[[gnu::always_inline]] inline std::size_t bits_of(const Sizes& is) {
  const Bytes bytes = __builtin_convertvector(is, Bytes);
  std::uint64_t all;
  std::memcpy(&all, &bytes, sizeof all);
  // Bit k of byte k; the factor brings them together in the highest byte.
  return static_cast<std::size_t>((all & 0x0101010101010101U) * 0x0102040810204080U >> 56U);
}

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. Beyond them `found` is written
/// to up to the end of a pack.
[[gnu::always_inline]] inline std::size_t near_pairs(const DiscSweep& w, double nearer, std::size_t from,
                                                     std::size_t to, std::uint32_t* found) {
  std::size_t count = 0;
  Pack radii = Pack{} + w.equal_radii;
  for (std::size_t k = from; k < to; k += pack_size) {
    Pack x, y;
    differences(x, y, w.places, w.first + k, w.second + k);
    if (w.radii != nullptr) load(radii, w.radii + k);
    const Pack within = radii + nearer;
    const std::size_t bits = bits_of(x * x + y * y < within * within);
    Numbers numbers;
    std::memcpy(&numbers, chosen.lanes[bits].data(), sizeof numbers);
    numbers += static_cast<std::uint32_t>(k);
    std::memcpy(found + count, &numbers, sizeof numbers);
    count += chosen.count[bits];
  }
  return count;
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

/// Forces on the second discs of eight touching pairs.
template <class L>
[[gnu::always_inline]] inline void push(const L& law, const DiscSweep& w, const std::uint32_t* pairs, double* force_x,
                                        double* force_y) {
  std::array<std::uint32_t, pack_size> first, second, listed;
  for (std::size_t l = 0; l < pack_size; ++l)
    first[l] = w.first[pairs[l]], second[l] = w.second[pairs[l]];
  Pack x, y, distance, rate{}, largest{}, force, radii = Pack{} + w.equal_radii;
  if (w.radii != nullptr) collect(radii, [&](std::size_t l) { return w.radii[pairs[l]]; });
  if constexpr (L::memory_size == 1) {
    for (std::size_t l = 0; l < pack_size; ++l)
      listed[l] = w.listed != nullptr ? w.listed[pairs[l]] : pairs[l];
    Sizes since;
    collect(since, [&](std::size_t l) { return static_cast<std::int64_t>(w.pasts[listed[l]].sweep); });
    collect(largest, [&](std::size_t l) { return w.pasts[listed[l]].largest; });
    keep_where(largest, since == static_cast<std::int64_t>(w.now) - 1);
  }
  differences(x, y, w.places, first.data(), second.data());
  distance = x * x + y * y;
  square_root(distance);
  const Pack overlap = radii - distance, n_x = x / distance, n_y = y / distance;
  if (w.before != nullptr) {
    Pack v_x, v_y;
    differences(v_x, v_y, w.before, first.data(), second.data());
    rate = -(v_x * n_x + v_y * n_y);
  }
  law.settled(overlap, rate, largest, force);
  // Rounded, an overlap may be none after all.
  const Sizes overlaps = overlap > Pack{};
  keep_where(force, overlaps);
  store(force * n_x, force_x), store(force * n_y, force_y);
  if constexpr (L::memory_size == 1) {
    keep_where(largest, overlaps);
    for (std::size_t l = 0; l < pack_size; ++l)
      w.pasts[listed[l]] = {largest[l], w.now};
  }
}

/// Gives the discs of touching pairs their impulses, in order.
[[gnu::always_inline]] inline void give(const DiscSweep& w, const std::uint32_t* pairs, std::size_t count,
                                        const double* force_x, const double* force_y) {
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t k = pairs[t], i = w.first[k] / 2, place = w.second[k] / 2;
    const std::size_t j = place < w.discs ? place : w.ghost_disc[place - w.discs];
    const double a = w.kick * w.inverse_mass[i & w.unlike], b = w.kick * w.inverse_mass[j & w.unlike];
    const Place force{force_x[t], force_y[t]};
    Place v;
    std::memcpy(&v, w.velocities + 2 * i, sizeof v);
    v -= a * force;
    std::memcpy(w.velocities + 2 * i, &v, sizeof v);
    std::memcpy(&v, w.velocities + 2 * j, sizeof v);
    v += b * force;
    std::memcpy(w.velocities + 2 * j, &v, sizeof v);
    if (w.wall == nullptr) continue;
    if (w.wall[i] != DiscShapes::free) w.wall_forces[w.wall[i]] -= Vec2{force[0], force[1]};
    if (w.wall[j] != DiscShapes::free) w.wall_forces[w.wall[j]] += Vec2{force[0], force[1]};
  }
}

/// Moves the discs from <= i < to, whole packs of them; raises the largest square of their own speeds.
[[gnu::always_inline]] inline void move(const DiscSweep& w, std::size_t from, std::size_t to, Sizes& fastest) {
  const Pack mean{w.flow.x, w.flow.y, w.flow.x, w.flow.y, w.flow.x, w.flow.y, w.flow.x, w.flow.y};
  for (std::size_t i = 2 * from; i < 2 * to; i += pack_size) {
    Pack place, v;
    load(place, w.places + i), load(v, w.velocities + i);
    Pack own = v - (mean + w.flow.rate * __builtin_shufflevector(place, Pack{}, 1, 8, 3, 8, 5, 8, 7, 8));
    own *= own;
    raise(fastest, own + __builtin_shufflevector(own, own, 1, 0, 3, 2, 5, 4, 7, 6));
    store(place + w.drift * v, w.places + i);
  }
}

/// The same for the last ones, fewer than a pack.
[[gnu::always_inline]] inline void move_last(const DiscSweep& w, std::size_t from, Sizes& fastest) {
  for (std::size_t i = from; i < w.discs; ++i) {
    double *const place = w.places + 2 * i, *const v = w.velocities + 2 * i;
    raise(fastest, Pack{} + w.flow.own_speed_squared({v[0], v[1]}, place[1]));
    place[0] += w.drift * v[0], place[1] += w.drift * v[1];
  }
}

/// Kicks and drifts all discs; the largest square of their own speeds.
template <class L>
[[gnu::always_inline]] inline double sweep_pairs(const L& its_law, const DiscSweep& given) {
  // Copies: what is stored to arrays cannot change them.
  const DiscSweep w = given;
  const L law = its_law;
  std::array<std::uint32_t, sweep_block + pack_size> touching;
  std::array<double, sweep_block + pack_size> force_x, force_y;
  Sizes fastest{};
  std::size_t moved = 0;
  for (std::size_t from = 0; from < w.pairs && w.kick != 0.0; from += sweep_block) {
    const std::size_t to = std::min(from + sweep_block, w.pairs);
    const std::size_t count = near_pairs(w, 0.0, from, to, touching.data());
    if (count > 0) {
      std::fill_n(touching.begin() + static_cast<std::ptrdiff_t>(count), pack_size, touching[count - 1]);
      if constexpr (L::memory_size == 1) {
        for (std::size_t t = 0; t < count; ++t)
          __builtin_prefetch(&w.pasts[w.listed != nullptr ? w.listed[touching[t]] : touching[t]], 1);
      }
      for (std::size_t t = 0; t < count; t += pack_size)
        push(law, w, &touching[t], &force_x[t], &force_y[t]);
      give(w, touching.data(), count, force_x.data(), force_y.data());
    }
    if (w.drift == 0.0 || to == w.pairs) continue;
    const std::size_t done = std::min<std::size_t>(w.first[to] / 2, w.discs) / places_per_pack * places_per_pack;
    move(w, moved, done, fastest);
    moved = done;
  }
  if (w.drift != 0.0) {
    const std::size_t whole = w.discs / places_per_pack * places_per_pack;
    move(w, moved, whole, fastest), move_last(w, whole, fastest);
  }
  return largest(fastest);
}

}  // namespace

TALUS_CLONES std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to,
                                   std::uint32_t* found) {
  return near_pairs(sweep, nearer, from, to, found);
}
TALUS_CLONES double sweep_discs(const LinearSpringDashpot& law, const DiscSweep& sweep) {
  return sweep_pairs(law, sweep);
}
TALUS_CLONES double sweep_discs(const LatchingSpring& law, const DiscSweep& sweep) { return sweep_pairs(law, sweep); }

}  // namespace talus
