#pragma once

#include <cstddef>
#include <vector>

#include "solver/granular/discs.hpp"

namespace talus {

/// Order of discs by rows of the field and along each row, with wall discs last: numbered in this order, neighbouring
/// discs are close in memory. result[k]: the disc that gets the number k.
[[nodiscard]] std::vector<std::size_t> order_by_rows(const DiscShapes& shapes, const Discs& discs);

/// The same discs in that order. Contact memories are stored in systems and are not reordered: for use before a run
/// begins.
[[nodiscard]] DiscShapes reordered(const DiscShapes& shapes, const std::vector<std::size_t>& order);
[[nodiscard]] Discs reordered(const Discs& discs, const std::vector<std::size_t>& order);

}  // namespace talus
