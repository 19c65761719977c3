#pragma once

#include <cstddef>
#include <vector>

#include "solver/granular/discs.hpp"

namespace talus {

/// Numbers of discs, row of the field by row and along each row, those of walls behind all others: so numbered, discs
/// that are near each other lie near each other in memory. result[k]: which disc is to be number k.
[[nodiscard]] std::vector<std::size_t> order_by_rows(const DiscShapes& shapes, const Discs& discs);

/// The same discs in that order. What contacts remember stands with systems, not here: for use before a run begins.
[[nodiscard]] DiscShapes reordered(const DiscShapes& shapes, const std::vector<std::size_t>& order);
[[nodiscard]] Discs reordered(const Discs& discs, const std::vector<std::size_t>& order);

}  // namespace talus
