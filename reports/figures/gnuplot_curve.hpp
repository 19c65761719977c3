/// One curve of a figure as gnuplot commands.
#pragma once

#include <string>

#include "reports/figures/colour_scale.hpp"
#include "reports/figures/plot.hpp"

namespace talus::reports {

/// Script of one curve.
struct CurveScript {
  std::string data;     ///< its numbers as data blocks
  std::string command;  ///< argument of `plot`
};

/// `block`: name of the curve's data block, or prefix of several; `index`: of the curve in its figure, from 0; `scale`
/// maps values to colours. Only lines and points with a label appear in the panel's key.
[[nodiscard]] CurveScript curve_script(const Curve& curve, const std::string& block, std::size_t index,
                                       const ColourScale& scale);

}  // namespace talus::reports
