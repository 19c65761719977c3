#pragma once

#include <array>
#include <string_view>

#include "solver/base/dimension.hpp"

namespace talus {

/// Values that a numeric field may take.
enum class Range { any, positive, non_negative };

/// The words of an error message for a range: "it must be ...".
constexpr std::string_view words(Range range) {
  switch (range) {
    case Range::positive:
      return "> 0";
    case Range::non_negative:
      return ">= 0";
    case Range::any:
      break;
  }
  return "finite";
}

/// Whether `value` lies in the range (a number that is not finite never does: its difference from itself is NaN).
constexpr bool contains(Range range, double value) {
  switch (range) {
    case Range::positive:
      return value > 0.0 && value - value == 0.0;
    case Range::non_negative:
      return value >= 0.0 && value - value == 0.0;
    case Range::any:
      break;
  }
  return value - value == 0.0;
}

/// One physical parameter of a value type T: the single place that states its name, dimension and range. Parsing, echo,
/// report and conversion are derived from the table of a type's fields.
template <class T>
struct Field {
  std::string_view name;     ///< as written in a scene
  Dimension dimension;       ///< what a quantity must have to be accepted
  double T::*member;         ///< where it is kept, in the scene's consistent units
  Range range;               ///< values allowed
  std::string_view meaning;  ///< one line: meaning, sign, frame
};

/// A named set of values of an enum, in the enum's order: the closed list that parsing and messages go by.
template <class Enum>
struct Names;

}  // namespace talus
