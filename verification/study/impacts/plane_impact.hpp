#pragma once

#include <vector>

#include "solver/laws/law_list.hpp"
#include "verification/check/convergence.hpp"
#include "verification/check/findings.hpp"

/// One impact of a disc of unit mass on a plane under any contact law, and its errors over the phases of a step.
namespace talus::verification::problems {

struct PlaneImpact {
  double speed{1.0};   ///< of approach [L/T]
  double radius{8.0};  ///< [L]; determines the digits of the overlap
  double step{};       ///< [T]
  double phase{};      ///< fraction of a step before touch
  double longest{};    ///< the run is stopped after this time [T]
};

/// Results at each step from the first to that at which the force is zero again; empty if the run diverged or the
/// contact did not end.
struct PlaneRebound {
  std::vector<double> time;   ///< from touch [T]
  std::vector<double> depth;  ///< overlap [L]
  std::vector<double> force;  ///< [F]
  double speed{};             ///< final speed away from the plane [L/T]
  double balance_error{};     ///< final energy balance error, relative to the initial energy
  double lost{};              ///< dissipated energy, relative to the same

  bool ended() const { return time.size() > 3; }
};
[[nodiscard]] PlaneRebound plane_rebound(const ContactLaw& law, const PlaneImpact& impact, Findings& findings);

/// Fractional part x - floor(x).
[[nodiscard]] double fraction(double x);

}  // namespace talus::verification::problems
