#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace talus {

/// The mode of one law instance: an index into the law's own list of mode names. Motion is smooth while no mode
/// changes. Wider than a byte: a byte may stand for any memory, and after each one written a compiler would read all
/// others again.
using Mode = std::uint16_t;

/// Whether one of so many modes is another than the first of its law; four at a time.
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
