/// The tables on a fence's sheet, in the scene's units with the other system in brackets.
#pragma once

#include <vector>

#include "reports/sheet/sheet_page.hpp"
#include "reports/sheet/sheet_record.hpp"

namespace talus::reports {

/// Tables, in this order, of rocks, hangers and cables, heights, anchors, sequence of yields and breaks, energy. A long
/// list is cut, and its note says so.
[[nodiscard]] std::vector<SheetTable> fence_tables(const SheetRecord& record);

}  // namespace talus::reports
