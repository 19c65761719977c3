#pragma once

#include <array>
#include <string_view>

#include "solver/base/fields.hpp"

namespace talus {

/// How the numbers of a range are spaced: evenly, or with evenly spaced logarithms, for which both ends are > 0.
enum class Spacing { even, logarithmic };

template <>
struct Names<Spacing> {
  static constexpr std::array<std::string_view, 2> list{"even", "logarithmic"};
};

}  // namespace talus
