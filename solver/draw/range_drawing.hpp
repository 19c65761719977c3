#pragma once

#include <optional>
#include <span>
#include <string>

#include "solver/draw/drawing.hpp"
#include "solver/io/file/quantity_table.hpp"

namespace talus::app {

/// Restitutions of the pairs of a range, in SI units.
struct DrawnRange {
  std::span<const QuantityColumn> abscissae;  ///< drawn are those whose values differ; one of them at least
  std::span<const double> restitutions;       ///< one for each pair
  double wanted{};
  double largest_deviation{};
};

/// A page with one panel for each abscissa: the restitutions as points, and lines at the restitution wanted and at its
/// largest deviations. Numbers are in `units`.
[[nodiscard]] DrawingRequest range_drawing(const DrawnRange& range, const std::string& title, const UnitSystem& units,
                                           const PictureOptions& picture);

/// A page with one panel for each of the results, drawn against the abscissa as points. `wanted`: the value
/// of the first result that a line marks, if there is one.
[[nodiscard]] DrawingRequest results_drawing(const QuantityColumn& abscissa, std::span<const QuantityColumn> results,
                                             std::optional<double> wanted, const std::string& title,
                                             const UnitSystem& units, const PictureOptions& picture);

}  // namespace talus::app
