#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace talus::app {

/// Maximum number of curves in a panel, unless elements are named or all are requested: the number that colours and
/// dashes can distinguish.
inline constexpr std::size_t maximum_curves = 8;

/// Maximum minus minimum; NaN values are skipped. 0 without values.
[[nodiscard]] double range_of(const std::vector<double>& values);

/// Indices of the `maximum` largest values in ascending order; of equal values the first are chosen. All indices if
/// there are no more than `maximum` values.
[[nodiscard]] std::vector<std::size_t> indices_of_largest(const std::vector<double>& values, std::size_t maximum);

/// Adds the note that only `drawn` of `all` curves are drawn in a panel; no note if all are drawn.
void note_left_out(const std::string& panel, std::size_t drawn, std::size_t all, std::vector<std::string>& notes);

}  // namespace talus::app
