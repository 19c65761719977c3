#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// Something that must be shown to work: an equation of the 1993 report, a problem of the catalogue, or a member of one
/// of the solver's closed lists.
struct Requirement {
  std::string id;     ///< "Eq. 21", "B6", "law.NAME", "regime.LAW.MODE", "pair.SHAPE.SHAPE", "integrator.NAME", ...
  std::string group;  ///< "equation", "B: normal contact", "law", "regime", "pair", "integrator", ...
  std::string text;   ///< One line: what it says.
  int order = 0;      ///< The order that an integrator declares; 0 for all else.
};

/// All requirements: the report's numbered equations, the catalogue and the solver's closed lists. A case may name
/// these and no others; those that no case names are shown in the report as open.
[[nodiscard]] std::vector<Requirement> all_requirements();

/// The families of cases, in the order of the report: those of the catalogue (its groups), the founding problems, the
/// fence.
[[nodiscard]] std::vector<std::string> all_families();

/// The family of a case: the one it names, or that of most of its catalogue problems (of equally many the first);
/// empty if it names none and claims no problem of the catalogue.
[[nodiscard]] std::string family_of(const std::string& named, const std::vector<std::string>& requirements);

}  // namespace talus::verification
