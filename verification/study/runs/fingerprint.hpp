#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/io/output/checkpoint.hpp"

namespace talus::verification::problems {

/// 64-bit hash over the name and content of each item, bit by bit (FNV-1a, in hexadecimal digits). Items that differ in
/// any bit, including the sign of a zero, have different fingerprints, except with a probability of 2^-64.
inline std::string fingerprint(const ArchiveItems& items) {
  std::string bytes;
  const auto add_number = [&](double value) {
    for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), i = 0; i < 8; ++i, bits >>= 8)
      bytes += static_cast<char>(bits & 0xFF);
  };
  // Each text is prefixed by its length, so that adjacent items cannot be confused.
  const auto add_text = [&](std::string_view text) { add_number(static_cast<double>(text.size())), bytes += text; };
  for (const auto& [name, item] : items) {
    add_text(name);
    if (const auto* const numbers = std::get_if<std::vector<double>>(&item)) {
      add_number(static_cast<double>(numbers->size()));
      for (const double number : *numbers)
        add_number(number);
    } else {
      add_text(std::get<std::string>(item));
    }
  }
  return fnv1a(bytes);
}

}  // namespace talus::verification::problems
