#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace talus {

/// The mode of one law instance: an index into the law's own list of mode names. Motion is smooth while no mode
/// changes. Wider than a byte: a byte may stand for any memory, and after each one written a compiler would read all
/// others anew.
using Mode = std::uint16_t;

/// Whether one of so many modes is another than the first of its law; eight at a time.
[[nodiscard]] inline bool any_set(const Mode* modes, std::size_t count) {
  using Eight [[gnu::vector_size(16)]] = Mode;
  Eight eights{};
  std::uint64_t set = 0;
  std::size_t i = 0;
  for (constexpr std::size_t many = sizeof(Eight) / sizeof(Mode); i + many <= count; i += many) {
    Eight eight;
    std::memcpy(&eight, modes + i, sizeof eight);
    eights |= eight;
  }
  for (; i < count; ++i)
    set |= modes[i];
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(eights);
  return (set | halves[0] | halves[1]) != 0;
}

}  // namespace talus
