#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace talus::fuzz {

/// A text made from one or two of the sound ones by one to four changes: of bits, bytes, spans, lines, numbers, tokens
/// and nesting. The same for the same state of `random` everywhere.
[[nodiscard]] std::string mutated(const std::vector<std::string>& sound, std::mt19937_64& random);

}  // namespace talus::fuzz
