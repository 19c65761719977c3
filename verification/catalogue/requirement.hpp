#pragma once

#include <string>

namespace talus::verification {

/// A requirement to be verified: an equation of the 1993 report, a problem of the catalogue, or a member of one of the
/// solver's closed lists.
struct Requirement {
  std::string id;     ///< "Eq. 21", "B6", "law.NAME", "regime.LAW.MODE", "pair.SHAPE.SHAPE", "integrator.NAME", ...
  std::string group;  ///< "equation", "B: normal contact", "law", "regime", "pair", "integrator", ...
  std::string text;   ///< One line: its content.
  int order = 0;      ///< The declared order of an integrator; 0 for all others.
};

}  // namespace talus::verification
