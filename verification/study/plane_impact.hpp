#pragma once

#include <vector>

#include "solver/laws/law_list.hpp"
#include "verification/check/convergence.hpp"
#include "verification/check/findings.hpp"

/// One impact of a disc of unit mass on a plane under any contact law, and its errors over the phases of a step.
namespace talus::verification::problems {

struct PlaneImpact {
  double speed{1.0};   ///< of approach [L/T]
  double radius{8.0};  ///< [L]; its digits are those of the overlap
  double step{};       ///< [T]
  double phase{};      ///< share of a step that passes before the touch
  double longest{};    ///< the contact is given up after this time [T]
};

/// What the solver gives at each step from the first to that at which the force is zero again; empty when the
/// run diverged or the contact did not end.
struct PlaneRebound {
  std::vector<double> time;   ///< from touch [T]
  std::vector<double> depth;  ///< [L]
  std::vector<double> force;  ///< [F]
  double speed{};             ///< away from the plane in the end [L/T]
  double closure{};           ///< of the energy in the end, over the energy at the start
  double lost{};              ///< booked as lost, over the same

  bool ended() const { return time.size() > 3; }
};
[[nodiscard]] PlaneRebound plane_rebound(const ContactLaw& law, const PlaneImpact& impact, Findings& findings);

/// x - floor(x).
[[nodiscard]] double fraction(double x);

}  // namespace talus::verification::problems
