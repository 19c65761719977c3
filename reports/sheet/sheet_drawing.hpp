/// The drawing on a fence's sheet.
#pragma once

#include <string>

#include "reports/figures/gnuplot_script.hpp"
#include "reports/sheet/sheet_record.hpp"

namespace talus::reports {

/// Output medium of the drawing. No letter is smaller than 8 pt on A4 paper, on a screen of at least 800 pixels, and on
/// a phone of 390 pixels; on the phone the views are arranged vertically.
enum class SheetMedium { paper, screen, phone };

/// Commands that draw folder/stem.<format>: the fence from the side with the rocks' paths, and along the cable, both at
/// the start, at the largest travel and at the end; and the largest forces over time. Metres and kilonewtons. The width
/// of the canvas is set to that of the medium.
[[nodiscard]] std::string sheet_script(const SheetRecord& record, const Canvas& canvas, const std::string& stem,
                                       SheetMedium medium);

}  // namespace talus::reports
