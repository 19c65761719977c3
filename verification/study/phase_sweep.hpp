#pragma once

#include <functional>
#include <span>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/convergence.hpp"

/// One impact, run with many steps and from many onset phases, and its error against a reference in time.
namespace talus::verification::problems {

/// An impact that a sweep can start anywhere before the touch.
struct PhasedImpact {
  Scene at_touch;          ///< bodies touch at t = 0
  double contact_time{};   ///< what a step is counted in [T]
  double watch{};          ///< the error is taken this many contact times after the touch, at the next whole step
  std::size_t observed{};  ///< index of the velocity that is compared
  /// The free motion of the state, taken back by t [T] >= 0.
  std::function<void(State& state, double t)> taken_back;
  /// The exact velocity at ascending times after the touch [T].
  std::function<std::vector<double>(std::span<const double> times)> exact;
};

/// (3 - sqrt 5)/2, the offset common to all phases.
inline constexpr double common_offset = 0.3819660112501051;

/// How the step of a phase follows from the number N of steps per contact.
enum class Offset {
  none,    ///< t_c/N: commensurate, errors of onset and release cancel
  common,  ///< t_c/(N + common_offset)
  own,     ///< t_c/(N + offset), another offset for each phase: release phases are spread as the onset's
};

/// Relative errors of a sweep, one entry for each number of steps per contact.
struct Sweep {
  std::vector<double> steps;  ///< contact time over mean step
  Convergence rms;            ///< against 1/steps
  std::vector<double> largest;
  std::vector<std::vector<double>> by_phase;  ///< signed, in the order of even_phases
  std::vector<double> evaluations;            ///< of a phase, mean
};

/// Runs all of `counts` steps per contact from `phases` evenly spread onsets.
[[nodiscard]] Sweep sweep(const PhasedImpact& impact, const Integrator& integrator, std::span<const double> counts,
                          Offset offset, std::size_t phases = fewest_phases);

}  // namespace talus::verification::problems
