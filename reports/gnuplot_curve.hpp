/// One curve of a figure in gnuplot's language.
#pragma once

#include <string>

#include "reports/colour_scale.hpp"
#include "reports/plot.hpp"

namespace talus::reports {

/// What draws it.
struct CurveScript {
  std::string data;     ///< its numbers, as data blocks
  std::string command;  ///< what `plot` is given
};

/// `block`: name of its data block, or how those of several begin; `index`: of the curve in its figure, from 0;
/// `scale` turns values into colours. Only curves of lines and points with a label stand in the panel's key.
[[nodiscard]] CurveScript curve_script(const Curve& curve, const std::string& block, std::size_t index,
                                       const ColourScale& scale);

}  // namespace talus::reports
