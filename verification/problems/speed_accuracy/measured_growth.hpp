#pragma once

#include "verification/problems/speed_accuracy/squeezed_disc.hpp"
#include "verification/reference/integration/amplification.hpp"
#include "verification/study/toolkit.hpp"

/// The methods with fixed steps, and the growth of their runs of a squeezed disc.
namespace talus::verification::problems {

/// One method and its known properties.
struct FixedStepMethod {
  const char* name;
  reference::Scheme scheme;
  int dimension;  ///< number of non-zero eigenvalues of one step
  int start;      ///< index of the first state of a run from which on each state follows by the same map
  double scale;   ///< the map of growth extends to 1.25 times this eta
  bool undamped;  ///< it has limits at xi = 0 that runs can resolve
  bool doubles;   ///< two of its eigenvalues coincide where two of the motion do, at xi = 1
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

/// Methods without a fixed step, and so without a step limit: those that choose their steps by a tolerance, and the one
/// that integrates each linear segment of the motion in closed form.
inline constexpr std::array methods_without_limit{"odeint_bulirsch_stoer", "stormer_cowell", "exact"};

/// Exact steps eta at which growth begins or ends, on the map of the method and beyond, in ascending order. Narrow
/// intervals are searched for only without damping.
[[nodiscard]] std::vector<double> exact_limits(const FixedStepMethod& method, double xi);

/// A disc squeezed between two planes with that damping ratio.
[[nodiscard]] SqueezedRuns squeezed_runs(double xi);

/// ln of the largest multiplier, fitted to the first steps of two runs: one starts mainly with a displacement, one
/// mainly with a velocity. They start with the largest deviation for which runs of that length do not reach the limit
/// of SqueezedRuns::run(); the starting steps of a method (eight of Adams', one of Verlet's) are omitted. NaN if there
/// is no such deviation.
[[nodiscard]] double first_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta,
                                  const Setup& setup);

/// An error of first_growth() in units of the rounding of a state. The unit is multiplied by the exact growth (or
/// decay) over a run of the fit, because the run starts closer to rest, or ends closer to it, by this factor.
[[nodiscard]] double in_roundings(const FixedStepMethod& method, double error, double exact);

constexpr double maximum_mark = 9e-3;  // [m]
constexpr long longest_run = 50000;    // steps

/// ln growth per step of a run, fitted to its last sixty states or fewer, between 1e-7 and `maximum_mark`. NaN if the
/// run does not reach that mark.
[[nodiscard]] double long_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, double start,
                                 const Setup& setup);

/// True if a run of 4000 steps does not grow: the largest deviation in the second half exceeds that in the first by at
/// most 1 %, by which the maxima of two beats may differ.
[[nodiscard]] bool stays(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, const Setup& setup);

}  // namespace talus::verification::problems
