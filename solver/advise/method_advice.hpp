#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/advise/advice_reference.hpp"

namespace talus {

/// What came of one ladder.
struct TriedMethod {
  RunMethod method;     ///< the cheapest that is good enough, or the last tried
  double error{};       ///< relative, the largest of that run, those finer and those beside it; infinite for
                        ///< none
  long evaluations{};   ///< force evaluations of the run
  std::string verdict;  ///< in words; empty where it is good enough
};

/// The method that gives a quantity to an accuracy at least cost, or why there is none.
struct Advice {
  std::optional<TriedMethod> best;
  std::optional<Refusal> refusal;  ///< there is one or the other
  Reference reference;             ///< the value; without its curve
  Growth growth;                   ///< what small differences of the start grow to
  std::vector<TriedMethod> tried;  ///< one for each ladder, cheapest first, those not good enough last
  long evaluations{};              ///< of all pilots together
};

/// Advises how to integrate a scene so that a quantity, as `talus run` prints it, has the accuracy asked for at the
/// least number of force evaluations.
///
/// First the value is looked for, by all integrators from coarse to fine until two of different orders agree to a tenth
/// of the accuracy, extremes between the steps included; and small differences of the start are followed to the end.
/// Then each integrator is tried in steps of a sixth of an octave (of a decade of its tolerance): one is good enough
/// where nine runs in a row, and eight beside the coarsest of them, have errors of less than half the accuracy: no
/// lucky run is advised. Methods that choose their own steps are looked at as often as the extremes of the curve ask
/// for. Same input, same advice. Errors: InputError for rules that make no sense, or an unknown integrator among them.
[[nodiscard]] Advice advise_method(const Scene& scene, const Quantity& quantity, const AdviceRules& rules);

}  // namespace talus
