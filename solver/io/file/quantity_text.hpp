#pragma once

#include <string>
#include <string_view>

#include "solver/base/units.hpp"

namespace talus {

/// A number as text in a unit.
struct Decimal {
  std::string text;
  bool exact{};  ///< whether reading it restores the value to the last bit
};

/// The decimal number with the fewest digits that, read in `unit`, gives `value` [consistent units of `system`] to the
/// last bit. If no double in that unit does (their spacing can be wider), the nearest one, which is not `exact`.
[[nodiscard]] Decimal decimal(double value, std::string_view unit, Dimension dimension, const UnitSystem& system);

/// The unit of a quantity of this dimension in the deck of 1993: feet, slugs, pounds (force) and seconds, but inches
/// for areas and stresses; empty for pure numbers.
[[nodiscard]] std::string deck_unit(Dimension dimension);

/// Reads the quantity given to an option. Errors: InputError that begins with the option's name; if `positive`, also
/// for a value <= 0.
[[nodiscard]] double option_quantity(const std::string& option, const std::string& text, Dimension dimension,
                                     const UnitSystem& units, bool positive = true);

}  // namespace talus
