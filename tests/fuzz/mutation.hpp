#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace talus::fuzz {

/// A text made from one or two valid ones by one to four changes: of bits, bytes, spans, lines, numbers, tokens and
/// nesting. It depends only on the state of `random`, on every platform.
[[nodiscard]] std::string mutated(const std::vector<std::string>& sound, std::mt19937_64& random);

}  // namespace talus::fuzz
