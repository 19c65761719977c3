#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace talus {

/// Mode of one law instance: an index into the mode names of the law. Motion is smooth while no mode changes. Wider
/// than a byte, because a byte may alias any memory: after each byte written, a compiler would read everything else
/// again.
using Mode = std::uint16_t;

/// True if any of `count` modes is not 0, the first mode of its law; tests four at a time.
[[nodiscard]] inline bool any_set(const Mode* modes, std::size_t count) {
  std::size_t i = 0;
  for (std::uint64_t four = 0; i + sizeof four / sizeof(Mode) <= count; i += sizeof four / sizeof(Mode)) {
    std::memcpy(&four, modes + i, sizeof four);
    if (four != 0) return true;
  }
  for (; i < count; ++i) {
    if (modes[i] != 0) return true;
  }
  return false;
}

}  // namespace talus
