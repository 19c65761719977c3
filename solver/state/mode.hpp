#pragma once

#include <cstdint>

namespace talus {

/// The mode of one law instance: an index into the law's own list of mode names. Motion is smooth while no mode
/// changes.
using Mode = std::uint8_t;

}  // namespace talus
