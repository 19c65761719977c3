/// The drawing on a fence's sheet.
#pragma once

#include <string>

#include "reports/gnuplot_script.hpp"
#include "reports/sheet_record.hpp"

namespace talus::reports {

/// What the drawing is shown on. No letter is smaller than 8 pt on A4 paper, on a screen from 800 pixels, and on a
/// phone of 390; there the views stand below each other.
enum class SheetMedium { paper, screen, phone };

/// The commands that draw, as folder/stem.<format>: the fence from the side with the rocks' paths, and along the cable,
/// both at the start, at the largest travel and at the end; and the largest forces over time. Metres and kilonewtons.
/// The width of the canvas is set to that of the medium.
[[nodiscard]] std::string sheet_script(const SheetRecord& record, const Canvas& canvas, const std::string& stem,
                                       SheetMedium medium);

}  // namespace talus::reports
