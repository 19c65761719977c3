#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/integrate/hybrid_system.hpp"
#include "solver/integrate/linear_segment.hpp"

namespace talus {

/// Scales of the errors of a motion.
struct ErrorScales {
  double speed{};                   ///< [L/T]
  double displacement{};            ///< displacement [L]
  double tolerance{};               ///< error allowed, relative to these scales
  std::span<const double> lengths;  ///< distance by which one unit of each coordinate moves its body [L]
};

/// Diagonally implicit Runge-Kutta steps of order 4, L-stable and stiffly accurate, with an embedded method of order 3
/// for the error (ESDIRK4(3)6L[2]SA of Kennedy & Carpenter 2003). The stages are solved by Newton's method with a
/// linearization of the system, so that stiff contacts whose forces hardly change do not limit the step. Within a step
/// the coordinates are the polynomial of degree 5 through coordinates, velocities and accelerations at both ends;
/// memory, work and impulse are the cubics through values and rates.
class ImplicitStep {
 public:
  ImplicitStep() = default;
  explicit ImplicitStep(const State& like);

  /// Linearizes the system in the state whose derivative was last evaluated. Returns false if no implicit step is
  /// possible.
  [[nodiscard]] bool begin(HybridSystem& system, const State& at);
  /// Upper bound of the oscillation and decay rates of the linearized system [1/T].
  double fastest_rate(std::span<const double> lengths) const { return talus::fastest_rate(piece_, lengths); }

  /// Takes a step of length h. `rates`: those at its beginning on entry; those at its end on return, if the error is at
  /// most 1. Returns the error in multiples of the tolerance: infinite if Newton's method does not converge.
  [[nodiscard]] double take(HybridSystem& system, const State& begin, Rates& rates, double h, const ErrorScales& scales,
                            State& end);
  /// State at a time within the last step; `begin`: the state at the beginning of that step.
  void state_at(const State& begin, double t, State& out) const;

  /// Serializes what state_at() needs; `like` gives the sizes.
  void serialize(Archive& archive, const State& like);

 private:
  static constexpr std::size_t stages = 6;

  bool solve_stage(HybridSystem& system, const State& begin, double h, std::size_t stage, const ErrorScales& scales);
  void set_stage(const State& begin, double h, std::size_t stage);
  double error(double h, const ErrorScales& scales);

  LinearSegment piece_;
  AffineSolver solver_;
  Rates begin_rates_, end_rates_;  ///< at both ends of the last step
  State end_;                      ///< state at its end, before truncation by an event and before the update of modes

  // Scratch of a step.
  std::array<Rates, stages> rates_;
  std::array<std::vector<double>, stages> velocities_;
  State at_;
  Rates found_;
  double fastest_rate_{};
  std::vector<double> change_, residual_, missed_q_, missed_v_;
};

}  // namespace talus
