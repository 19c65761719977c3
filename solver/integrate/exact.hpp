#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/integrate/located_steps.hpp"

namespace talus {

/// Motion that is linear between events, exact to round-off with one force evaluation per segment: with a0 from that
/// evaluation, and the stiffness K and damping C of the segment, the solution of q'' = a0 - K (q - q0) - C (q' - v0) is
/// summed as a power series. Steps serve the search for events alone.
///
/// Work and impulse, if accumulated, are integrated over each step by Gauss's eight-point rule, with one force
/// evaluation per point.
class LinearMotion {
 public:
  static constexpr std::string_view name = "exact";
  static constexpr int order = 0;  ///< no truncation error
  static constexpr StepControl step_control = StepControl::closed_form;

  LinearMotion() = default;
  LinearMotion(const State& state, double) : found_{state}, along_{state} {}

  void begin(HybridSystem& system, const State& start, double interval);
  void shorten_to_probe() { fraction_ = 1e-4; }
  std::string advance(HybridSystem& system, const State& begin, State& end, double longest);
  NearEnd near_end(const State& end) const { return {&end, false}; }
  void state_at(const State& begin, const State& end, double t, State& out) const;
  void complete(HybridSystem& system, const State& begin, State& end);
  bool ends_at_outputs(const HybridSystem& system) const { return system.keeps_accounts(); }
  double next_step() const { return step_; }
  double usual_step() const { return step_; }
  void serialize(Archive& archive, const State& like);

 private:
  void sum_series(const State& begin, double h, State& out) const;

  LinearSegment piece_;
  std::vector<double> q0_, v0_, a0_;  ///< at the beginning of the segment
  double step_{};                     ///< step of the segment: at most one radian of its fastest motion [T]
  double fraction_{1.0};              ///< fraction of step_ for the next step

  // Scratch of a step.
  mutable std::vector<double> terms_;  ///< terms of the series, power by power
  Rates found_;
  State along_;
};

/// The exact propagator, for scenes whose motion is linear between events: see obstacle_to_closed_form().
using Exact = LocatedSteps<LinearMotion>;

}  // namespace talus
