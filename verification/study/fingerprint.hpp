#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/base/memory.hpp"

namespace talus::verification::problems {

/// A 64-bit hash of numbers and texts, bit by bit and in their order: FNV-1a. Lists that differ
/// in any bit, the sign of a zero included, have different fingerprints, but for one chance in 2^64.
class Fingerprint {
 public:
  void add(double value) {
    for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), i = 0; i < 8; ++i, bits >>= 8)
      add_byte(bits & 0xFF);
  }
  void add(std::span<const double> values) {
    add(static_cast<double>(values.size()));
    for (const double value : values)
      add(value);
  }
  void add(std::string_view text) {
    add(static_cast<double>(text.size()));
    for (const char c : text)
      add_byte(static_cast<unsigned char>(c));
  }
  /// Of each item its name and content.
  void add(const MemoryItems& items) {
    for (const auto& [name, item] : items) {
      add(std::string_view{name});
      if (const auto* const numbers = std::get_if<std::vector<double>>(&item)) {
        add(*numbers);
      } else {
        add(std::string_view{std::get<std::string>(item)});
      }
    }
  }

  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void add_byte(std::uint64_t byte) { hash_ = (hash_ ^ byte) * 1099511628211ULL; }

  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace talus::verification::problems
