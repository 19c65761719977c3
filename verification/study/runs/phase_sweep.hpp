#pragma once

#include <functional>
#include <span>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/convergence.hpp"

/// One impact, run with several numbers of steps and onset phases, and its error relative to a reference in time.
namespace talus::verification::problems {

/// An impact that a sweep can start anywhere before the touch.
struct PhasedImpact {
  Scene at_touch;          ///< bodies touch at t = 0
  double contact_time{};   ///< time unit in which steps are counted [T]
  double watch{};          ///< the error is evaluated this many contact times after touch, at the next whole step
  std::size_t observed{};  ///< index of the velocity that is compared
  /// Moves the state back by t [T] >= 0 along the free motion.
  std::function<void(State& state, double t)> taken_back;
  /// Exact velocity at ascending times after touch [T].
  std::function<std::vector<double>(std::span<const double> times)> exact;
};

/// (3 - sqrt 5)/2, the offset common to all phases.
inline constexpr double common_offset = 0.3819660112501051;

/// How the step of a phase depends on the number N of steps per contact.
enum class Offset {
  none,    ///< t_c/N: commensurate, errors of onset and release cancel
  common,  ///< t_c/(N + common_offset)
  own,     ///< t_c/(N + offset), a different offset for each phase: release phases are spread like onset phases
};

/// Relative errors of a sweep, one entry for each number of steps per contact.
struct Sweep {
  std::vector<double> steps;  ///< contact time over mean step
  Convergence rms;            ///< against 1/steps
  std::vector<double> largest;
  std::vector<std::vector<double>> by_phase;  ///< signed, in the order of even_phases
  std::vector<double> evaluations;            ///< mean per phase
};

/// Runs all of `counts` steps per contact from `phases` evenly spaced onsets.
[[nodiscard]] Sweep sweep(const PhasedImpact& impact, const Integrator& integrator, std::span<const double> counts,
                          Offset offset, std::size_t phases = fewest_phases);

}  // namespace talus::verification::problems
