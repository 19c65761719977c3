#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// An error of the 1993 report that a case proves.
struct Erratum {
  std::string id;         ///< "E1", ...
  std::string where;      ///< Equation, section and page of the report.
  std::string printed;    ///< What stands there.
  std::string corrected;  ///< What it must be.
  std::string evidence;   ///< The numbers or the argument.
  std::string proved_by;  ///< Id of the case that shows it.
};

/// The errata that the cases prove, numbered as they were found.
[[nodiscard]] std::vector<Erratum> all_errata();

}  // namespace talus::verification
