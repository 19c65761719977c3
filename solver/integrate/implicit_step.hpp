#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/integrate/affine_piece.hpp"
#include "solver/integrate/hybrid_system.hpp"

namespace talus {

/// What errors of a motion are measured against.
struct ErrorScales {
  double speed{};                   ///< [L/T]
  double way{};                     ///< displacement [L]
  double tolerance{};               ///< error allowed, relative to these
  std::span<const double> lengths;  ///< by which one unit of each coordinate moves its body [L]
};

/// Steps of a diagonally implicit Runge-Kutta method of order 4, L-stable and stiffly accurate, with an embedded method
/// of order 3 for the error (ESDIRK4(3)6L[2]SA of Kennedy & Carpenter 2003). The stages are solved by Newton's method
/// with a linearization of the system, so that stiff contacts whose forces hardly change do not limit the step. Within
/// a step the coordinates are the polynomial of order 5 through coordinates, velocities and accelerations at both ends,
/// memory and accounts the cubic through values and rates.
class ImplicitStep {
 public:
  ImplicitStep() = default;
  explicit ImplicitStep(const State& like);

  /// Linearizes the system in a state whose derivative was the last that it was asked for. False if it cannot be used.
  [[nodiscard]] bool begin(HybridSystem& system, const State& at);
  /// Upper bound of the rates at which the linearized system moves [1/T].
  double fastest_rate(std::span<const double> lengths) const { return talus::fastest_rate(piece_, lengths); }

  /// Takes a step of length h. `rates`: at its beginning; afterwards, if the error is at most 1, at its end. Returns
  /// the error in multiples of the tolerance: infinite if Newton's method does not converge.
  [[nodiscard]] double take(HybridSystem& system, const State& begin, Rates& rates, double h, const ErrorScales& scales,
                            State& end);
  /// The state at a time within the last step, which began with this state.
  void state_at(const State& begin, double t, State& out) const;

  /// Names what is needed within the last step, of states like this one.
  void serialize(Archive& archive, const State& like);

 private:
  static constexpr std::size_t stages = 6;

  bool solve_stage(HybridSystem& system, const State& begin, double h, std::size_t stage, const ErrorScales& scales);
  void place_stage(const State& begin, double h, std::size_t stage);
  double error(double h, const ErrorScales& scales);

  AffinePiece piece_;
  AffineSolver solver_;
  Rates begin_rates_, end_rates_;  ///< at both ends of the last step
  State end_;                      ///< its end, before an event cut it short or modes were brought up to date

  // Scratch of a step.
  std::array<Rates, stages> rates_;
  std::array<std::vector<double>, stages> velocities_;
  State at_;
  Rates found_;
  double fastest_rate_{};
  std::vector<double> change_, residual_, missed_q_, missed_v_;
};

}  // namespace talus
