#pragma once

#include <cstdint>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus::bench {

/// Equal discs of diameter 1 and mass 1 in a periodic box, numbered row by row.
struct DiscGas {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};

/// Elastic, with angular frequency 1 of two discs in contact: k = 1/2.
inline constexpr LinearSpringDashpot elastic{0.5, 0.0};
/// The same motion with a history-dependent law: its unloading stiffness equals its loading stiffness.
inline constexpr LatchingSpring remembering{0.5, 0.5, 0.0};
/// About a twentieth of the contact time pi.
inline constexpr double gas_step = 0.157;

/// Friction in addition to the elastic springs.
inline constexpr CoulombFriction rough{0.5, 0.35};

/// Cost and result of a run of the elastic gas by FastDiscSystem.
struct GasRun {
  double nanoseconds{};  ///< processor time of a disc-step
  std::uint64_t bits{};  ///< hash of all positions and velocities
};
/// Runs the gas; the first thousand steps are not timed.
[[nodiscard]] GasRun run_gas(std::size_t columns, std::size_t rows, double solid_fraction, long steps);

/// A triangular lattice of columns times rows (even) at this solid fraction, with normally distributed velocities of
/// standard deviation 0.0014: in the hardest of many impacts the overlap is about a hundredth of the diameter.
[[nodiscard]] DiscGas lattice(std::size_t columns, std::size_t rows, double solid_fraction);

}  // namespace talus::bench
