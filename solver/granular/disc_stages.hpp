#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/base/pack.hpp"
#include "solver/granular/sweep_input.hpp"

/// Stages of a sweep, block by block of pairs. Each is a function of its own, so that what it works on stays in
/// registers: all in one took a tenth longer where a third of the discs touch.
namespace talus::stages {

/// What touching pairs of a block do to their second discs: where that is put.
struct Pushes {
  double* force;                     ///< x, y of each [F]
  double *friction, *arm_a, *arm_b;  ///< as in PairForces

  Pushes from(std::size_t k) const { return {force + 2 * k, friction + k, arm_a + k, arm_b + k}; }
};
inline Pushes pushes_of(PairForces& of) {
  return {of.force.data(), of.friction.data(), of.arm_a.data(), of.arm_b.data()};
}

/// Adds those that touch of the pairs from <= k < to, a block of packs, to the contacts, and finds which these were
/// before. Their numbers, in order; behind them the last again, for a pack.
std::span<const std::uint32_t> find_touching(const StepBlock& sweep, std::size_t from, std::size_t to);
/// After the last block: contacts that there were before and that are not found again have ended.
void end_sweep(const StepBlock& sweep);
/// The contact of a pair with this number in the whole list has ended: if what it remembers matters, it is told.
void part(const StepBlock& sweep, std::size_t listed, double largest, double stretch);

/// Of the pairs that go out of a sweep's discs the next one whose first disc has not got its impulse, and where the
/// place of that begins; behind all places if there is none.
struct NextOutgoing {
  std::size_t pair{}, first{};

  explicit NextOutgoing(const StepBlock& sweep) { find(sweep); }
  void proceed(const StepBlock& sweep) { ++pair, find(sweep); }

 private:
  void find(const StepBlock& sweep) {
    first = pair < sweep.outgoing->count ? sweep.outgoing->first[pair] : ~std::size_t{0};
  }
};
/// Gives both discs of each of these pairs its impulse; before, the first discs of pairs that go out and stand before
/// it in the order of all.
void give(const StepBlock& sweep, std::span<const std::uint32_t> touching, Pushes pushes, NextOutgoing& next);
/// Gives the first discs of pairs that go out their impulses, up to those of this place.
void give_outgoing(const StepBlock& sweep, std::size_t to_place, NextOutgoing& next);

/// Moves the discs from <= i < to; raises the largest square of their own speeds.
void move(const StepBlock& sweep, std::size_t from, std::size_t to, Sizes& fastest);

/// Where the place begins of the disc that is, or whose image is, at the place that begins there; the disc.
[[gnu::always_inline]] inline std::size_t own_place(const StepBlock& w, std::size_t at) {
  return at < 2 * w.discs ? at : 2 * std::size_t{w.ghost_disc[at / 2 - w.discs]};
}
[[gnu::always_inline]] inline std::size_t disc(const StepBlock& w, std::size_t at) { return own_place(w, at) / 2; }

}  // namespace talus::stages
