/// The tables on a fence's sheet, in the scene's units with the other system in brackets.
#pragma once

#include <string>
#include <vector>

#include "reports/sheet/sheet_record.hpp"

namespace talus::reports {

/// Head of a column: its unit or name below its group; adjacent columns of the same group share one head.
struct SheetHead {
  std::string group;
  std::string unit{};
  bool text{};  ///< left-aligned, as the first column is; numbers are right-aligned
};

struct SheetTable {
  enum class Location { page, left, right };  ///< over the full page width, or in one of two columns below

  std::string title;
  Location location{Location::page};
  std::vector<SheetHead> heads;
  std::vector<std::vector<std::string>> rows;
  std::string note{};  ///< printed below the table; may be empty
};

/// Table of the rocks; and, in this order, tables of hangers and cables, heights, anchors, sequence of yields and
/// breaks, energy. A long list is cut, and its note says so.
[[nodiscard]] SheetTable rock_table(const SheetRecord& record);
[[nodiscard]] std::vector<SheetTable> fence_tables(const SheetRecord& record);

}  // namespace talus::reports
