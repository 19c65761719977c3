#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "solver/base/dimension.hpp"
#include "solver/base/vec.hpp"

namespace talus {

/// Values that a numeric field may take.
enum class Range { any, positive, non_negative, fraction, positive_fraction };

/// The words of an error message for a range: "it must be ...".
constexpr std::string_view words(Range range) {
  switch (range) {
    case Range::positive:
      return "> 0";
    case Range::non_negative:
      return ">= 0";
    case Range::fraction:
      return "in [0, 1]";
    case Range::positive_fraction:
      return "in (0, 1]";
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
    case Range::fraction:
      return value >= 0.0 && value <= 1.0;
    case Range::positive_fraction:
      return value > 0.0 && value <= 1.0;
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

/// The name of a field of T, as written in a scene; empty for a member that is none.
template <class T>
[[nodiscard]] constexpr std::string_view field_name(double T::*member) {
  for (const auto& field : T::fields())
    if (field.member == member) return field.name;
  return {};
}

/// Two fields of T of which one is at least the other.
template <class T>
struct FieldOrder {
  double T::*larger;
  double T::*smaller;
  std::string_view why;  ///< in words, as the end of a message
};

/// A vector parameter of T; the components may be any finite numbers.
template <class T>
struct VectorField {
  std::string_view name;
  Dimension dimension;
  Vec2 T::*member;
  std::string_view meaning;
};

/// A parameter of T that is a whole number between `least` and `most`.
template <class T>
struct CountField {
  std::string_view name;
  std::variant<int T::*, long T::*> member;
  long least;
  long most;
  std::string_view meaning;
};

/// A named set of values of an enum, in the enum's order: the closed list that parsing and messages go by.
template <class Enum>
struct Names;

/// The name of a value in that list.
template <class Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) {
  return Names<Enum>::list[static_cast<std::size_t>(value)];
}

}  // namespace talus
