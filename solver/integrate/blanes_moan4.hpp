#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/linear_limit.hpp"
#include "solver/state/state_archive.hpp"

namespace talus {

/// Symplectic method of order 4 by Blanes & Moan (2002, Table 3, SRKN_6^b): seven kicks with six drifts between them,
/// symmetric, six force evaluations per step (the last kick of a step and the first of the next share one).
///
/// Suited to motions whose forces depend on coordinates alone; their energy error then oscillates but does not drift.
/// On pendulums of 90 and 170 degrees and on two cables its error at equal force evaluations is 520, 280 and 240 times
/// below that of the triple jump (Forest & Ruth 1990, Yoshida 1990), 79, 14 and 18 times below that of Suzuki's five
/// Verlet steps (1990), and 64, 0.4 and 3 times below that of McLachlan & Atela's four kicks (1992).
///
/// Velocity-dependent forces are evaluated with the velocity before their kick: the order is then 1, and on an
/// oscillator with a dashpot the error at equal cost is twice that of velocity Verlet. Some drifts and kicks go back in
/// time: what a slider, a latch or a contact does in a backward drift is not undone by a forward one.
template <class StateType>
class BlanesMoan4Of {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "blanes_moan4";
  static constexpr int order = 4;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr std::size_t stages = 6;
  static constexpr int evaluations = 6;
  static constexpr int additions = 7;  ///< kicks per velocity
  static constexpr bool ends_with_evaluation = true;

  /// Drifts as fractions of the step: the paper's 15 digits; the middle ones follow from the sum.
  static constexpr std::array<Scalar, stages> drifts() {
    const Scalar a1{0.245298957184271}, a2{0.604872665711080};
    const Scalar a3 = Scalar{1} / 2 - (a1 + a2);
    return {a1, a2, a3, a3, a2, a1};
  }
  /// Kicks as fractions of the step; the middle one follows from the sum.
  static constexpr std::array<Scalar, stages + 1> kicks() {
    const Scalar b1{0.0829844064174052}, b2{0.396309801498368}, b3{-0.0390563049223486};
    const Scalar b4 = 1 - 2 * (b1 + b2 + b3);
    return {b1, b2, b3, b4, b3, b2, b1};
  }

  /// The omega h at which the spectral radius of the map of (q, v), from one shared kick to the next, first exceeds 1
  /// (3.1635 at xi = 0); each kick uses the velocity before it. Longer steps may be stable again but must not be relied
  /// on: without damping, growth of up to 1.0024 per step ends at 3.1685 and begins again at 5.027. A damping ratio of
  /// 0.001 suppresses that first band, so that the limit is 5.029 there; at 0.4 it is 3.839, with an unstable band up
  /// to 4.508.
  static double linear_limit(double damping_ratio) { return first_growth(growth, damping_ratio); }

  template <Evaluable<StateType> System>
  void start(System& system, StateType& state, Scalar) {
    rates_ = Rates{state};
    system.evaluate(state, rates_);
  }

  template <Evaluable<StateType> System>
  void step(System& system, StateType& state, Scalar h) {
    const auto kick = kicks();
    const auto drift = drifts();
    kick_velocities(state, rates_, kick[0] * h);
    for (std::size_t i = 0; i < stages; ++i) {
      system.drift(state, drift[i] * h);
      system.evaluate(state, rates_);
      kick_velocities(state, rates_, kick[i + 1] * h);
    }
    state.t += h;
  }

  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like};
    using talus::serialize;
    archive.scope("rates", [&] { serialize(archive, rates_); });
  }

 private:
  /// Spectral radius of that map at omega = 1.
  static double growth(double h, double damping_ratio) {
    const auto drift = BlanesMoan4Of<State>::drifts();
    auto kick = BlanesMoan4Of<State>::kicks();
    kick[0] += kick.back();
    double map[2][2];
    for (const int column : {0, 1}) {
      double q = column == 0 ? 1.0 : 0.0, v = 1.0 - q;
      for (std::size_t i = 0; i < drift.size(); ++i) {
        v += kick[i] * h * (-q - 2.0 * damping_ratio * v);
        q += drift[i] * h * v;
      }
      map[0][column] = q, map[1][column] = v;
    }
    const double half_trace = 0.5 * (map[0][0] + map[1][1]);
    const double determinant = map[0][0] * map[1][1] - map[0][1] * map[1][0];
    const double square = half_trace * half_trace - determinant;
    return square < 0.0 ? std::sqrt(determinant) : std::abs(half_trace) + std::sqrt(square);
  }

  Rates rates_;
};

using BlanesMoan4 = BlanesMoan4Of<State>;

}  // namespace talus
