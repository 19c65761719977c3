#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// Something that must be shown to work: an equation of the 1993 report, a problem of the catalogue, a law, an end
/// rule, a contact method, an integrator or a shape.
struct Requirement {
  std::string id;     ///< "Eq. 21", "B6", "law.NAME", "end_rule.NAME", "method.NAME", "integrator.NAME", "shape.NAME".
  std::string group;  ///< "equation", "B: normal contact", "law", "end_rule", "method", "integrator" or "shape".
  std::string text;   ///< One line: what it says.
};

/// All requirements: the report's numbered equations, the catalogue and the solver's closed lists. A case may name
/// these and no others; those that no case names are shown in the report as open.
[[nodiscard]] std::vector<Requirement> all_requirements();

}  // namespace talus::verification
