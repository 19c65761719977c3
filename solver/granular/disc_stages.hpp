#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/base/pack.hpp"
#include "solver/granular/sweep_input.hpp"

/// Stages of a sweep, by blocks of pairs. Each is a separate function, so that its data stay in registers: a single
/// function took a tenth longer where a third of the discs touch.
namespace talus::stages {

/// Output arrays for the forces of a block's touching pairs on their second discs.
struct Pushes {
  double* force;                     ///< x, y of each [F]
  double *friction, *arm_a, *arm_b;  ///< as in PairForces

  Pushes from(std::size_t k) const { return {force + 2 * k, friction + k, arm_a + k, arm_b + k}; }
};
inline Pushes pushes_of(PairForces& of) {
  return {of.force.data(), of.friction.data(), of.arm_a.data(), of.arm_b.data()};
}

/// Finds the touching pairs among from <= k < to, a block of packs, appends them to the contacts, and looks up which
/// contacts they were before. Returns their indices, in order, followed by a pack that repeats the last one.
std::span<const std::uint32_t> find_touching(const StepBlock& sweep, std::size_t from, std::size_t to);
/// Ends, after the last block, the contacts that existed before and were not found again.
void end_sweep(const StepBlock& sweep);
/// Records that the contact of the pair with this index in the whole list has ended, if its memory matters.
void part(const StepBlock& sweep, std::size_t listed, double largest, double stretch);

/// The next outgoing pair of a sweep whose first disc has not received its impulse, and the index of that disc's
/// position; larger than all indices if there is none.
struct NextOutgoing {
  std::size_t pair{}, first{};

  explicit NextOutgoing(const StepBlock& sweep) { find(sweep); }
  void proceed(const StepBlock& sweep) { ++pair, find(sweep); }

 private:
  void find(const StepBlock& sweep) {
    first = pair < sweep.outgoing->count ? sweep.outgoing->first[pair] : ~std::size_t{0};
  }
};
/// Applies the impulse of each of these pairs to both discs; before each of them, those of preceding outgoing pairs to
/// their first discs.
void give(const StepBlock& sweep, std::span<const std::uint32_t> touching, Pushes pushes, NextOutgoing& next);
/// Applies the impulses of outgoing pairs to first discs whose positions have indices below to_index.
void give_outgoing(const StepBlock& sweep, std::size_t to_index, NextOutgoing& next);

/// Moves the discs from <= i < to; raises the largest squared speed relative to the mean flow.
void move(const StepBlock& sweep, std::size_t from, std::size_t to, Sizes& fastest);

/// Index of the position of the disc itself, by the index of its position or its image's; disc(): index of the disc.
[[gnu::always_inline]] inline std::size_t own_index(const StepBlock& w, std::size_t at) {
  return at < 2 * w.discs ? at : 2 * std::size_t{w.ghost_disc[at / 2 - w.discs]};
}
[[gnu::always_inline]] inline std::size_t disc(const StepBlock& w, std::size_t at) { return own_index(w, at) / 2; }

}  // namespace talus::stages
