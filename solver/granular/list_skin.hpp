#pragma once

#include <cstddef>

namespace talus {

/// How far beyond contact the neighbour list of FastDiscSystem is best made to reach, over a disc's diameter: from a
/// table that was measured beforehand (`scripts/bench discs --skins` prints it again), so that runs look at no clock.
/// solid_fraction: area of the discs over that of the field; what lies outside the table takes its nearest entry.
[[nodiscard]] double list_skin(std::size_t discs, double solid_fraction);

}  // namespace talus
