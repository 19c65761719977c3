#pragma once

#include <array>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/speed_accuracy/squeezed_disc.hpp"
#include "verification/reference/amplification.hpp"

/// The methods that take steps of fixed length, and how their runs of a squeezed disc grow.
namespace talus::verification::problems {

/// One method and what is known of it.
struct FixedStepMethod {
  const char* name;
  reference::Scheme scheme;
  int dimension;  ///< eigenvalues other than zero of one step
  int start;      ///< first of a run's states from which each follows from those before by the same map
  double scale;   ///< its map reaches 1.25 of this eta
  bool undamped;  ///< whether it has limits at xi = 0 that runs can tell
  bool doubles;   ///< whether two of its eigenvalues are one where two of the motion's are, at xi = 1
};
inline constexpr std::array fixed_step_methods{
    FixedStepMethod{"velocity_verlet", reference::Scheme::half_step, 2, 1, 2.0, true, false},
    FixedStepMethod{"central_difference", reference::Scheme::half_step, 2, 1, 2.0, true, false},
    FixedStepMethod{"euler_cromer", reference::Scheme::half_step, 2, 1, 2.0, true, false},
    FixedStepMethod{"lagged_central_difference", reference::Scheme::late, 3, 1, 1.0, true, false},
    FixedStepMethod{"euler", reference::Scheme::euler, 2, 0, 2.0, false, true},
    FixedStepMethod{"taylor", reference::Scheme::taylor, 2, 0, 2.0, false, false},
    FixedStepMethod{"blanes_moan4", reference::Scheme::blanes_moan4, 2, 1, 5.0, true, false},
    FixedStepMethod{"rk4", reference::Scheme::rk4, 2, 0, 3.0, true, true},
    FixedStepMethod{"odeint_dopri5", reference::Scheme::dopri5, 2, 0, 3.4, false, true},
    FixedStepMethod{"odeint_cash_karp54", reference::Scheme::cash_karp54, 2, 0, 3.8, false, true},
    FixedStepMethod{"odeint_fehlberg78", reference::Scheme::fehlberg78, 2, 0, 4.2, false, true},
    FixedStepMethod{"odeint_abm8", reference::Scheme::abm8, 16, 9, 0.4, false, true},
};

/// Methods without a step of fixed length, and so without a limit of it: those that choose its length by a tolerance,
/// and the one that takes each linear piece of the motion in closed form.
inline constexpr std::array methods_without_limit{"odeint_bulirsch_stoer", "stormer_cowell", "exact"};

/// Steps at which growth begins or ends, on its map and beyond, in ascending order. Only where nothing damps does it
/// look for narrow ones.
[[nodiscard]] std::vector<double> exact_limits(const FixedStepMethod& method, double xi);

/// A disc squeezed between two planes with that damping ratio.
[[nodiscard]] SqueezedRuns squeezed_runs(double xi);

/// ln of the largest multiplier of the first steps, of two runs: one from a distance, one from a velocity. They begin
/// as far out as runs of that length may without coming to where a contact opens; a method's own start (eight steps of
/// Adams', one of Verlet's) is left out. NaN where none is short enough.
[[nodiscard]] double first_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta,
                                  const Setup& setup);

/// An error of first_growth() in roundings of a state: they count by the exact growth in a run of the fit more, for it
/// begins by so much nearer to rest or comes by so much nearer to it.
[[nodiscard]] double in_roundings(const FixedStepMethod& method, double error, double exact);

constexpr double most_mark = 9e-3;   // [m]
constexpr long longest_run = 50000;  // steps

/// ln growth per step of a run by its last sixty states or fewer, between 1e-7 and that mark. NaN if it does not come
/// so far.
[[nodiscard]] double long_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, double start,
                                 const Setup& setup);

/// Whether a run of 4000 steps keeps its size: the largest distance in the second half is not above that in the first
/// by more than a hundredth, by which the highest states of two beats may differ.
[[nodiscard]] bool stays(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, const Setup& setup);

}  // namespace talus::verification::problems
