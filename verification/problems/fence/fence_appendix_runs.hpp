#pragma once

#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_impact.hpp"

/// The simulations of Appendix I of the 1993 report, each with its twins: the same run with what the paper does not
/// tell moved a little.
namespace talus::verification::problems {

/// One simulation and its twins.
struct Simulation {
  std::string name;
  FenceRun run;                    ///< with its history, every step
  std::vector<FenceSample> twins;  ///< their peaks; empty in coarse setups

  /// Least and largest value of a quantity over the run and its twins.
  [[nodiscard]] double low(double FenceSample::*quantity) const;
  [[nodiscard]] double high(double FenceSample::*quantity) const;
};

/// The paper's four, and one layer with the top cable only.
struct Simulations {
  Simulation one, two, nine, top_only, one_top_only;
};

/// A change of what the paper leaves open.
struct AppendixTwin {
  double spin{};    ///< added to each rock's angular velocity [rad/s]
  double height{};  ///< added to each rock's height [ft]
  double angle{};   ///< added to each rock's orientation [deg]
  int finer{1};     ///< steps for one
};

[[nodiscard]] scenes::Fence shifted(scenes::Fence fence, const AppendixTwin& twin);

/// The fence of a deck as `setup` has it: faults `mass_doubled`, `bottom_cable_left_out`, `one_layer`.
[[nodiscard]] scenes::Fence appendix_fence(const std::string& deck, const Setup& setup);

[[nodiscard]] Simulations simulations(const Setup& setup, Findings& findings);

}  // namespace talus::verification::problems
