#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/cell/block_means.hpp"
#include "solver/granular/packing.hpp"
#include "solver/granular/stress.hpp"

namespace talus::verification::problems {

/// Plan of a flow: discs of different size with latching contacts, sheared without walls at constant volume. Units: the
/// middle diameter d, the mass m of such a disc, and the loading stiffness K1.
struct DensePlan {
  double fraction{};    ///< phi
  double shear_rate{};  ///< [sqrt(K1/m)]
  std::size_t discs{};  ///< number of free discs
  double before{1.0};   ///< strain before the measurement
  double strain{3.0};   ///< measured strain, in ten blocks
  double friction{};    ///< coefficient between discs; 0: none, and discs do not turn
  double spread{0.2};   ///< diameters d (1 -+ spread)
  double restitution{0.7};
  double steps_in_contact{10.0};  ///< of two discs of the middle size
  std::uint64_t starts{1};        ///< number of runs, each from a packing with a different seed
  bool still_box{};               ///< injected fault: images that do not slide
  bool motion_alone{};            ///< injected fault: stress from motion alone
};

/// Measured means over all starts. Errors are the larger of those from blocks and, with several starts, from their
/// scatter.
struct DenseFlow {
  double fraction{};
  Estimate friction{};    ///< mu = S/p
  Estimate inertial{};    ///< I = rate d sqrt(rho/p), rho = 4 m/(pi d^2)
  Estimate pressure{};    ///< [K1]: a force over a length
  double coordination{};  ///< contacts per disc
  double overlap{};       ///< mean over the contacts [d]
  std::uint64_t steps{};  ///< of all starts
};

/// Discs grown to a solid fraction of 0.82 at most and then enlarged to that of the plan: they overlap until they flow.
/// They move with the mean flow.
[[nodiscard]] Packing dense_packing(const DensePlan& plan, std::uint64_t seed);

/// Runs the plan with FastDiscSystem.
[[nodiscard]] DenseFlow run_dense(const DensePlan& plan);

/// Stress of one start after `steps` steps without friction, by both systems [K1].
struct BothStresses {
  Virial fast, plain;
};
[[nodiscard]] BothStresses stress_by_both(const DensePlan& plan, long steps);

}  // namespace talus::verification::problems
