#pragma once

#include <string>
#include <string_view>

#include "solver/base/units.hpp"

namespace talus {

/// A number as text, in some unit.
struct Decimal {
  std::string text;
  bool exact{};  ///< whether reading it gives the value back to the last bit
};

/// The decimal number, of the fewest digits, that read in `unit` gives `value` [consistent units of `system`] to the
/// last bit. Where no double in that unit does (its spacing can be wider), the nearest, which is not `exact`.
[[nodiscard]] Decimal decimal(double value, std::string_view unit, Dimension dimension, const UnitSystem& system);

/// The unit that the deck of 1993 gives a quantity of this dimension in: feet, slugs, pounds (force) and seconds, but
/// inches for areas and stresses; empty for pure numbers.
[[nodiscard]] std::string deck_unit(Dimension dimension);

/// The quantity given to an option. Errors: InputError with the option's name in front; if not in the range, what is
/// allowed.
[[nodiscard]] double option_quantity(const std::string& option, const std::string& text, Dimension dimension,
                                     const UnitSystem& units, bool positive = true);

}  // namespace talus
