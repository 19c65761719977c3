/// The tables on a fence's sheet, in SI and US units side by side.
#pragma once

#include <string>
#include <vector>

#include "reports/sheet_record.hpp"

namespace talus::reports {

/// Head of a column: its unit below its group; neighbours of the same group share one head.
struct SheetHead {
  std::string group;
  std::string unit{};
};

struct SheetTable {
  enum class Place { page, left, right };  ///< over the whole page, or in one of two columns below

  std::string title;
  Place place{Place::page};
  std::vector<SheetHead> heads;
  std::vector<std::vector<std::string>> rows;
  std::string note{};  ///< below it; may be empty
};

/// What the rocks did; and, in their order, hangers and cables, anchors, order of yields and breaks, travel and
/// heights, energy. A long list is cut, and its note says so.
[[nodiscard]] SheetTable rock_table(const SheetRecord& record);
[[nodiscard]] std::vector<SheetTable> fence_tables(const SheetRecord& record);

}  // namespace talus::reports
