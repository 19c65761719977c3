#pragma once

#include <cstdint>

namespace talus {

/// The mode of one law instance: an index into the law's own list of mode names. Motion is smooth while no mode
/// changes. Wider than a byte: a byte may stand for any memory, and after each one written a compiler would read all
/// others anew.
using Mode = std::uint16_t;

}  // namespace talus
