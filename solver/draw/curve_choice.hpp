#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace talus::app {

/// Curves of a panel, unless elements are named or all are requested: as many as colour and dash distinguish.
inline constexpr std::size_t most_curves = 8;

/// Maximum less minimum; what is not a number is skipped. 0 for no values.
[[nodiscard]] double range_of(const std::vector<double>& values);

/// Places of the `most` largest values, in their order; of equal ones the first. All places if there are no more.
[[nodiscard]] std::vector<std::size_t> places_of_largest(const std::vector<double>& values, std::size_t most);

/// Adds to the notes that `drawn` of `all` curves are drawn in a panel; nothing if these are all.
void note_left_out(const std::string& panel, std::size_t drawn, std::size_t all, std::vector<std::string>& notes);

}  // namespace talus::app
