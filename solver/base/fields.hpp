#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/base/dimension.hpp"
#include "solver/base/error.hpp"
#include "solver/base/vec.hpp"

namespace talus {

/// Values that a numeric field may take.
enum class Range { any, positive, non_negative, fraction, positive_fraction, one_to_hundred };

/// Text of an error message for a range: "it must be ...".
constexpr std::string_view text_of(Range range) {
  switch (range) {
    case Range::positive:
      return "> 0";
    case Range::non_negative:
      return ">= 0";
    case Range::fraction:
      return "in [0, 1]";
    case Range::positive_fraction:
      return "in (0, 1]";
    case Range::one_to_hundred:
      return "in [1, 100]";
    case Range::any:
      break;
  }
  return "finite";
}

/// Whether `value` lies in the range. A value that is not finite never does: its difference from itself is NaN.
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
    case Range::one_to_hundred:
      return value >= 1.0 && value <= 100.0;
    case Range::any:
      break;
  }
  return value - value == 0.0;
}

/// Description of one physical parameter of a value type T: the only definition of its name, dimension and range.
/// Parsing, echo, report and conversion are derived from the table of a type's fields.
template <class T>
struct Field {
  std::string_view name;     ///< as written in a scene
  Dimension dimension;       ///< required of the quantity
  double T::*member;         ///< member that stores the value, in the scene's consistent units
  Range range;               ///< allowed values
  std::string_view meaning;  ///< one line: meaning, sign, frame
};

/// Name of the field that stores its value in `member`, as written in a scene; empty if there is none.
template <class T>
[[nodiscard]] constexpr std::string_view field_name(double T::*member) {
  for (const auto& field : T::fields())
    if (field.member == member) return field.name;
  return {};
}

/// Constraint between two fields of T: larger >= smaller.
template <class T>
struct FieldOrder {
  double T::*larger;
  double T::*smaller;
  std::string_view why;  ///< reason, as the end of a message
};

/// A vector parameter of T; the components may be any finite numbers.
template <class T>
struct VectorField {
  std::string_view name;
  Dimension dimension;
  Vec2 T::*member;
  std::string_view meaning;
};

/// A parameter of T that is a whole number from `minimum` to `maximum`.
template <class T>
struct CountField {
  std::string_view name;
  std::variant<int T::*, long T::*> member;
  long minimum;
  long maximum;
  std::string_view meaning;
};

/// Names of all values of an enum, in the enum's order: the closed list that parsing and messages use.
template <class Enum>
struct Names;

/// Name of an enum value in Names<Enum>::list.
template <class Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) {
  return Names<Enum>::list[static_cast<std::size_t>(value)];
}

/// All names of an enum, in the enum's order.
template <class Enum>
[[nodiscard]] std::vector<std::string> names_of() {
  return {Names<Enum>::list.begin(), Names<Enum>::list.end()};
}

/// The enum value of this name; empty if there is none.
template <class Enum>
[[nodiscard]] constexpr std::optional<Enum> find_named(std::string_view name) {
  const auto& names = Names<Enum>::list;
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

/// The enum value of this name. Errors: that of unknown_name(), which begins with `kind`.
template <class Enum>
[[nodiscard]] Enum value_named(std::string_view kind, std::string_view name) {
  if (const std::optional<Enum> found = find_named<Enum>(name)) return *found;
  throw unknown_name(kind, name, names_of<Enum>());
}

}  // namespace talus
