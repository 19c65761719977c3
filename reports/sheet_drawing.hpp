/// The drawing on a fence's sheet.
#pragma once

#include <string>

#include "reports/gnuplot_script.hpp"
#include "reports/sheet_record.hpp"

namespace talus::reports {

/// The commands that draw, as folder/stem.<format>: the fence from the side with the rocks' paths, and along the cable,
/// both at the start, at the largest travel and at the end; and the largest forces over time. Metres and kilonewtons.
[[nodiscard]] std::string sheet_script(const SheetRecord& record, const Canvas& canvas, const std::string& stem);

}  // namespace talus::reports
