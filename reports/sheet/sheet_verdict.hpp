/// The top of a fence's sheet: the verdict with its forces, and the quality of the run.
#pragma once

#include <array>

#include "reports/sheet/sheet_page.hpp"
#include "reports/sheet/sheet_record.hpp"

namespace talus::reports {

/// The verdict and the quality.
[[nodiscard]] std::array<SheetBox, 2> sheet_boxes(const SheetRecord& record);

}  // namespace talus::reports
