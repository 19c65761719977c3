#pragma once

#include <cstddef>

namespace talus {

/// Best reach of FastDiscSystem's neighbour list beyond contact, in disc diameters, from a table measured beforehand
/// (`scripts/bench discs --skins` prints it again), so that runs do not depend on timing. solid_fraction: area of the
/// discs over that of the field. Arguments outside the table use its nearest entry.
[[nodiscard]] double list_skin(std::size_t discs, double solid_fraction);

}  // namespace talus
