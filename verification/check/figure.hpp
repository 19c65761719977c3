#pragma once

#include <cstddef>

#include "verification/record/figure.hpp"

namespace talus::verification {

using records::Axis;
using records::Figure;
using records::Line;
using records::Scale;
using records::Series;
using records::Slope;
using records::Style;

/// std::invalid_argument, naming figure and series, if names or captions are missing, if lengths differ, if there is
/// nothing to draw, or for what records::demand_sound() refuses.
void demand_well_formed(const Figure& figure);

/// The number of points with a NaN or an infinity in them. Findings::figure turns any into a failed check.
[[nodiscard]] std::size_t not_finite(const Figure& figure);

/// The figure without the points that cannot be drawn (not finite, or not positive on a logarithmic axis). If there
/// were any, the caption ends with their number: they do not drop out in silence. Series left without points are
/// removed.
[[nodiscard]] Figure drawable(Figure figure);

}  // namespace talus::verification
