#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/advise/advice_reference.hpp"

namespace talus {

/// Result of the search on one ladder.
struct TriedMethod {
  RunMethod method;     ///< the cheapest that satisfies the rules, or the last tried
  double error{};       ///< largest relative error of that run, the consecutive finer ones and those next to it;
                        ///< infinite if the run failed
  long evaluations{};   ///< force evaluations of the run
  std::string verdict;  ///< reason for rejection (text); empty if the method satisfies the rules
};

/// The cheapest integrator and step that give a quantity to an accuracy, or the reason why there is none.
struct Advice {
  std::optional<TriedMethod> best;
  std::optional<Refusal> refusal;  ///< set if `best` is not
  Reference reference;             ///< the value; without its curve
  Growth growth;                   ///< growth of small initial differences
  std::vector<TriedMethod> tried;  ///< one for each ladder, cheapest first, rejected ones last
  long evaluations{};              ///< of all pilot runs together
};

/// Finds the integrator and step that give a quantity, as `talus run` prints it, to the required accuracy with the
/// smallest number of force evaluations.
///
/// First the reference value is computed: all integrators are refined until two of different orders agree to within a
/// fraction of the accuracy (see ReferenceSearch::find), including extremes between the steps; and the growth of small
/// initial differences is measured. Then each integrator is refined in steps of a sixth of an octave (of a decade of
/// tolerance). A method is accepted if nine consecutive runs, and eight more next to the coarsest of them, have errors
/// below half the accuracy, so that no accidentally accurate run is advised. Methods with step control get as many
/// outputs as the extremes of the curve require. Same input, same advice. Errors: InputError for rules out of range or
/// an unknown integrator among them.
[[nodiscard]] Advice advise_method(const Scene& scene, const Quantity& quantity, const AdviceRules& rules);

}  // namespace talus
