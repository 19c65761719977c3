#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "solver/granular/contact_lanes.hpp"
#include "solver/granular/disc_lanes.hpp"
#include "solver/granular/disc_stages.hpp"
#include "solver/granular/step_block.hpp"
#include "solver/laws/law_list.hpp"

/// Sweeps with a law and friction: definitions of evaluate_pair_forces() and kick_and_drift(), and their instantiation.
namespace talus {
namespace stages {

/// Number of pairs, rounded up to whole packs.
inline std::size_t whole_packs(const StepBlock& w) { return (w.pairs->count + pack_size - 1) / pack_size * pack_size; }

/// Moves the discs from <= i < to, except those that move later.
inline void move_others(const StepBlock& w, std::size_t from, std::size_t to, Sizes& fastest) {
  for (const WallDiscs& later : w.later) {
    if (later.end <= from || later.begin >= to) continue;
    if (from < later.begin) move(w, from, later.begin, fastest);
    from = std::min(later.end, to);
  }
  move(w, from, to, fastest);
}

}  // namespace stages

template <class L, class F>
double kick_and_drift(const L& law, const F& friction, const StepBlock& w) {
  constexpr std::size_t room = sweep_block + pack_size;
  std::array<double, 5 * room> numbers;
  const stages::Pushes pushes{&numbers[0], &numbers[2 * room], &numbers[3 * room], &numbers[4 * room]};
  const bool moves = !turns_discs<F> && w.drift != 0.0;
  Sizes fastest{};
  std::size_t moved = w.begin;
  if (w.kicks) {
    w.contacts->begin();
    stages::NextOutgoing next{w};
    const std::size_t pairs = stages::whole_packs(w);
    for (std::size_t from = 0; from < pairs; from += sweep_block) {
      const std::size_t to = std::min(from + sweep_block, pairs);
      const std::span<const std::uint32_t> touching = stages::find_touching(w, from, to);
      stages::push(law, friction, w, touching, pushes);
      stages::give(w, touching, pushes, next);
      if (!moves || to == pairs) continue;
      const std::size_t first = std::min<std::size_t>(w.pairs->first[to] / 2, w.end);
      const std::size_t done = moved + (first - std::min(first, moved)) / points_per_pack * points_per_pack;
      stages::give_outgoing(w, 2 * done, next);
      stages::move_others(w, moved, done, fastest);
      moved = done;
    }
    stages::give_outgoing(w, 2 * w.end, next);
    stages::end_sweep(w);
  }
  if (moves) stages::move_others(w, moved, w.end, fastest);
  return largest(fastest);
}

template <class L, class F>
void evaluate_pair_forces(const L& law, const F& friction, const StepBlock& w, PairForces& out) {
  const std::size_t pairs = stages::whole_packs(w);
  out.force.resize(2 * (pairs + pack_size));
  for (auto* numbers : {&out.friction, &out.arm_a, &out.arm_b})
    numbers->resize(pairs + pack_size);
  out.first.resize(pairs), out.second.resize(pairs);
  out.count = 0;
  w.contacts->begin();
  for (std::size_t from = 0; from < pairs; from += sweep_block) {
    const std::span<const std::uint32_t> touching = stages::find_touching(w, from, std::min(from + sweep_block, pairs));
    stages::push(law, friction, w, touching, stages::pushes_of(out).from(out.count));
    for (const std::uint32_t pair : touching) {
      out.first[out.count] = w.pairs->first[pair], out.second[out.count] = w.pairs->second[pair];
      ++out.count;
    }
  }
  stages::end_sweep(w);
}

/// Instantiates the sweeps of a list of laws, without and with each friction that they can have:
/// `template struct talus::LawSweeps<List>;`
template <class List, class Frictions = DiscFrictions>
struct LawSweeps;
template <class... L, class... F>
struct LawSweeps<LawList<L...>, LawList<F...>> {
  template <class With, class Of>
  static auto sweeps() {
    if constexpr (CanHaveFriction<Of, With>)
      return std::tuple{&evaluate_pair_forces<Of, With>, &kick_and_drift<Of, With>};
    else
      return std::tuple{};
  }
  template <class With>
  static auto with_friction() {
    return std::tuple_cat(sweeps<With, L>()...);
  }
  /// Never called: the functions that it names are instantiated with it. (Variables marked as used crash clang 14.)
  static auto all() { return std::tuple_cat(with_friction<Frictionless>(), with_friction<F>()...); }
};

}  // namespace talus
