#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/cell/block_means.hpp"
#include "solver/granular/packing.hpp"
#include "solver/granular/stress.hpp"

namespace talus::verification::problems {

/// Discs of unlike size with latching contacts, sheared without walls at a kept volume. Units: the middle diameter d,
/// the mass m of such a disc, and the loading stiffness K1.
struct DensePlan {
  double fraction{};    ///< phi
  double shear_rate{};  ///< [sqrt(K1/m)]
  std::size_t discs{};  ///< free ones
  double before{1.0};   ///< strain to forget the start
  double strain{3.0};   ///< strain that is measured, in ten blocks
  double friction{};    ///< between discs; 0: none, and discs do not turn
  double spread{0.2};   ///< diameters d (1 -+ spread)
  double restitution{0.7};
  double steps_in_contact{10.0};  ///< of two discs of the middle size
  std::uint64_t starts{1};        ///< runs, each from a packing of its own seed
  bool still_box{};               ///< planted fault: images that do not slide
  bool motion_alone{};            ///< planted fault: stress by the motion alone
};

/// What was measured: means of all starts. Errors are the larger of what blocks and what starts (if there are several)
/// tell.
struct DenseFlow {
  double fraction{};
  Estimate friction{};    ///< mu = S/p
  Estimate inertial{};    ///< I = rate d sqrt(rho/p), rho = 4 m/(pi d^2)
  Estimate pressure{};    ///< [K1]: a force over a length
  double coordination{};  ///< contacts of a disc
  double overlap{};       ///< mean of the contacts [d]
  std::uint64_t steps{};  ///< of all starts
};

/// Discs grown to .82 at most and blown up from there on: pressed on each other until they flow. They move with the
/// mean flow.
[[nodiscard]] Packing dense_packing(const DensePlan& plan, std::uint64_t seed);

/// Runs it by FastDiscSystem.
[[nodiscard]] DenseFlow run_dense(const DensePlan& plan);

/// The stress of one start after so many steps, without friction, by either system [K1].
struct BothStresses {
  Virial fast, plain;
};
[[nodiscard]] BothStresses stress_by_both(const DensePlan& plan, long steps);

}  // namespace talus::verification::problems
