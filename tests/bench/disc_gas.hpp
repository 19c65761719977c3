#pragma once

#include <cstdint>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus::bench {

/// Equal discs of diameter 1 and mass 1 in a box that repeats itself, numbered by rows.
struct DiscGas {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};

/// Elastic, with angular frequency 1 of two discs in contact: k = 1/2.
inline constexpr LinearSpringDashpot elastic{0.5, 0.0};
/// The same motion by a law that remembers: its way back is as stiff.
inline constexpr LatchingSpring remembering{0.5, 0.5, 0.0};
/// A twentieth of the contact time pi.
inline constexpr double gas_step = 0.157;

/// Friction beside the elastic springs.
inline constexpr CoulombFriction rough{0.5, 0.35};

/// What a run of the elastic gas by FastDiscSystem took, and what came out.
struct GasRun {
  double nanoseconds{};  ///< of the processor, a disc-step
  std::uint64_t bits{};  ///< of all places and velocities, mixed
};
/// After a thousand steps that are not timed.
[[nodiscard]] GasRun run_gas(std::size_t columns, std::size_t rows, double solid_fraction, long steps);

/// A triangular lattice of columns times rows (even) at this solid fraction, with velocities that are normally
/// distributed, deviation .0014: the hardest of many impacts press discs about a hundredth of their diameter.
[[nodiscard]] DiscGas lattice(std::size_t columns, std::size_t rows, double solid_fraction);

}  // namespace talus::bench
