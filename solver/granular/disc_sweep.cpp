#include "solver/granular/disc_sweep.hpp"

#include <algorithm>
#include <array>
#include <concepts>

#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"

namespace talus {
namespace stages {
namespace {

/// Pairs with the lanes behind the last.
std::size_t whole_packs(const DiscSweep& w) { return (w.pairs->count + pack_size - 1) / pack_size * pack_size; }

/// Moves the discs from <= i < to but for those that move later.
void move_others(const DiscSweep& w, std::size_t from, std::size_t to, Sizes& fastest) {
  for (const WallDiscs& later : w.later) {
    if (later.end <= from || later.begin >= to) continue;
    if (from < later.begin) move(w, from, later.begin, fastest);
    from = std::min(later.end, to);
  }
  move(w, from, to, fastest);
}

template <class L, class F>
double sweep_pairs(const L& law, const F& friction, const DiscSweep& w) {
  constexpr std::size_t room = sweep_block + pack_size;
  std::array<double, 5 * room> numbers;
  const Pushes pushes{&numbers[0], &numbers[2 * room], &numbers[3 * room], &numbers[4 * room]};
  const bool moves = !std::same_as<F, CoulombFriction> && w.drift != 0.0;
  Sizes fastest{};
  std::size_t moved = w.begin;
  if (w.kicks) {
    w.contacts->begin();
    NextOutgoing next{w};
    const std::size_t pairs = whole_packs(w);
    for (std::size_t from = 0; from < pairs; from += sweep_block) {
      const std::size_t to = std::min(from + sweep_block, pairs);
      const std::span<const std::uint32_t> touching = find_touching(w, from, to);
      push(law, friction, w, touching, pushes);
      give(friction, w, touching, pushes, next);
      if (!moves || to == pairs) continue;
      const std::size_t first = std::min<std::size_t>(w.pairs->first[to] / 2, w.end);
      const std::size_t done = moved + (first - std::min(first, moved)) / places_per_pack * places_per_pack;
      give_outgoing(w, 2 * done, next);
      move_others(w, moved, done, fastest);
      moved = done;
    }
    give_outgoing(w, 2 * w.end, next);
    end_sweep(w);
  }
  if (moves) move_others(w, moved, w.end, fastest);
  return largest(fastest);
}

template <class L, class F>
void find_pair_pushes(const L& law, const F& friction, const DiscSweep& w, DiscPushes& out) {
  const std::size_t pairs = whole_packs(w);
  out.force.resize(2 * (pairs + pack_size));
  for (auto* numbers : {&out.friction, &out.arm_a, &out.arm_b})
    numbers->resize(pairs + pack_size);
  out.first.resize(pairs), out.second.resize(pairs);
  out.count = 0;
  w.contacts->begin();
  for (std::size_t from = 0; from < pairs; from += sweep_block) {
    const std::span<const std::uint32_t> touching = find_touching(w, from, std::min(from + sweep_block, pairs));
    push(law, friction, w, touching, pushes_of(out).from(out.count));
    for (const std::uint32_t pair : touching) {
      out.first[out.count] = w.pairs->first[pair], out.second[out.count] = w.pairs->second[pair];
      ++out.count;
    }
  }
  end_sweep(w);
}

}  // namespace

TALUS_CLONES void move(const DiscSweep& w, std::size_t from, std::size_t to, Sizes& fastest) {
  const NeighbourList::Flow flow = w.flow;
  const double h = w.drift;
  double *const places = w.places, *const velocities = w.velocities;
  Sizes most = fastest;
  // Of the discs of two packs, side by side.
  const auto raise_speeds = [&](const Pack& p, const Pack& q, const Pack& v_p, const Pack& v_q)
      __attribute__((always_inline)) {
    const Pack y = __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15);
    const Pack v_x = __builtin_shufflevector(v_p, v_q, 0, 8, 2, 10, 4, 12, 6, 14);
    const Pack v_y = __builtin_shufflevector(v_p, v_q, 1, 9, 3, 11, 5, 13, 7, 15);
    const Pack own_x = v_x - (flow.x + flow.rate * y), own_y = v_y - flow.y;
    raise(most, own_x * own_x + own_y * own_y);
  };
  double *place = places + 2 * from, *v = velocities + 2 * from;
  std::size_t left = to - from;
  Pack p, q, v_p, v_q;
  for (; left >= 2 * places_per_pack; left -= 2 * places_per_pack, place += 2 * pack_size, v += 2 * pack_size) {
    load(p, place), load(q, place + pack_size), load(v_p, v), load(v_q, v + pack_size);
    raise_speeds(p, q, v_p, v_q);
    store(p + h * v_p, place), store(q + h * v_q, place + pack_size);
  }
  if (left >= places_per_pack) {
    load(p, place), load(v_p, v);
    raise_speeds(p, p, v_p, v_p);
    store(p + h * v_p, place);
    left -= places_per_pack, place += pack_size, v += pack_size;
  }
  for (; left > 0; --left, place += 2, v += 2) {
    raise(most, Pack{} + flow.own_speed_squared({v[0], v[1]}, place[1]));
    place[0] += h * v[0], place[1] += h * v[1];
  }
  fastest = most;
}

}  // namespace stages

void find_pushes(const LinearSpringDashpot& law, const Frictionless& friction, const DiscSweep& sweep,
                 DiscPushes& pushes) {
  stages::find_pair_pushes(law, friction, sweep, pushes);
}
double sweep_discs(const LinearSpringDashpot& law, const Frictionless& friction, const DiscSweep& sweep) {
  return stages::sweep_pairs(law, friction, sweep);
}
void find_pushes(const LinearSpringDashpot& law, const CoulombFriction& friction, const DiscSweep& sweep,
                 DiscPushes& pushes) {
  stages::find_pair_pushes(law, friction, sweep, pushes);
}
double sweep_discs(const LinearSpringDashpot& law, const CoulombFriction& friction, const DiscSweep& sweep) {
  return stages::sweep_pairs(law, friction, sweep);
}
void find_pushes(const LatchingSpring& law, const Frictionless& friction, const DiscSweep& sweep, DiscPushes& pushes) {
  stages::find_pair_pushes(law, friction, sweep, pushes);
}
double sweep_discs(const LatchingSpring& law, const Frictionless& friction, const DiscSweep& sweep) {
  return stages::sweep_pairs(law, friction, sweep);
}
void find_pushes(const LatchingSpring& law, const CoulombFriction& friction, const DiscSweep& sweep,
                 DiscPushes& pushes) {
  stages::find_pair_pushes(law, friction, sweep, pushes);
}
double sweep_discs(const LatchingSpring& law, const CoulombFriction& friction, const DiscSweep& sweep) {
  return stages::sweep_pairs(law, friction, sweep);
}

double move_discs(const DiscSweep& sweep) {
  Sizes fastest{};
  stages::move(sweep, sweep.begin, sweep.end, fastest);
  return largest(fastest);
}

}  // namespace talus
