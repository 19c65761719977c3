/// The top of a fence's sheet: the verdict with its forces, and the quality of the run.
#pragma once

#include <string>
#include <vector>

#include "reports/sheet/sheet_record.hpp"

namespace talus::reports {

/// A fact with its label.
struct SheetFact {
  std::string name, text;
};

struct SheetVerdict {
  std::string text;    ///< "stopped", "passed under", ...
  std::string colour;  ///< of its frame: "green", "amber" or "red"
  std::vector<SheetFact> facts;
  std::string quality;         ///< "usable" or "NOT USABLE"
  std::string quality_colour;  ///< "green" or "red"
  std::vector<SheetFact> quality_facts;
};

[[nodiscard]] SheetVerdict sheet_verdict(const SheetRecord& record);

}  // namespace talus::reports
