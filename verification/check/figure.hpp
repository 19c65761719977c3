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

/// Errors: std::invalid_argument, with the names of figure and series, if names or captions are missing, lengths
/// differ, there is nothing to draw, or records::demand_sound() rejects the figure.
void demand_well_formed(const Figure& figure);

/// The number of points that contain a NaN or an infinity. Findings::figure turns any into a failed check.
[[nodiscard]] std::size_t not_finite(const Figure& figure);

/// The figure without the points that cannot be drawn (not finite, or not positive on a logarithmic axis). The caption
/// then ends with their number, so that they are not dropped silently. Series without remaining points are removed.
[[nodiscard]] Figure drawable(Figure figure);

}  // namespace talus::verification
