#pragma once

#include <string_view>

#include "solver/base/units.hpp"

namespace talus {

/// A quantity of any dimension.
struct AnyQuantity {
  double value{};  ///< in consistent units
  Dimension dimension;
};

/// Reads a quantity such as "65 ft/s"; a bare number is a pure number. Errors: InputError as parse_quantity().
[[nodiscard]] AnyQuantity parse_any_quantity(std::string_view text, const UnitSystem& system);

}  // namespace talus
