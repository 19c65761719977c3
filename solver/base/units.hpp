#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/base/dimension.hpp"

namespace talus {

/// A consistent system of units. A scene carries it for labels and for conversion on input and output; the solver
/// itself has no units.
struct UnitSystem {
  std::string_view name;  ///< as written in a scene
  std::string_view mass;  ///< unit symbols
  std::string_view length;
  std::string_view time;
  std::string_view force;
  double mass_in_kg{};   ///< size of one unit of mass
  double length_in_m{};  ///< size of one unit of length; time is in seconds in all systems

  friend constexpr bool operator==(const UnitSystem&, const UnitSystem&) = default;
};

/// Constants that are exact by definition (international agreement of 1959; CGPM 1901 for g_n), written as expressions
/// so that nothing is rounded twice.
namespace exact {
inline constexpr double foot_in_m = 0.3048;
inline constexpr double pound_in_kg = 0.45359237;
inline constexpr double standard_gravity = 9.80665;  ///< [m/s^2]
inline constexpr double pound_force_in_N = pound_in_kg * standard_gravity;
inline constexpr double slug_in_kg = pound_force_in_N / foot_in_m;
}  // namespace exact

inline constexpr UnitSystem si{"SI", "kg", "m", "s", "N", 1.0, 1.0};
inline constexpr UnitSystem us{"US", "slug", "ft", "s", "lbf", exact::slug_in_kg, exact::foot_in_m};

/// Names of all unit systems.
[[nodiscard]] std::vector<std::string> unit_system_names();
/// The unit system called `name`. Errors: InputError listing the known names.
[[nodiscard]] UnitSystem unit_system(std::string_view name);

/// Size in SI of one consistent unit of a dimension in the system, e.g. 4.448 for force in US.
[[nodiscard]] double si_size(const UnitSystem& system, Dimension dimension);

/// Symbol of the consistent unit of a dimension, e.g. "lbf/ft" for stiffness in US; "1" for pure numbers.
[[nodiscard]] std::string symbol(const UnitSystem& system, Dimension dimension);

/// Description of a dimension in messages: "a mass", "an angular velocity", ...
[[nodiscard]] std::string text_of(Dimension dimension);

/// Symbols of all units that a quantity may use.
[[nodiscard]] std::vector<std::string> unit_symbols();

/// Reads a quantity such as "65 ft/s", "85.42 slug ft^2" or "-9.81 m/s^2" and returns it in consistent units of
/// `system`. Units are products and quotients of symbols with integer powers; lb is a mass, lbf a force. Errors:
/// InputError with what was found and what is allowed: no number, no unit, an unknown unit (with the nearest known
/// one), or a unit whose dimension is not `wanted`.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension wanted, const UnitSystem& system);

/// A quantity of any dimension.
struct AnyQuantity {
  double value{};  ///< in consistent units
  Dimension dimension;
};

/// Reads a quantity of any dimension; a bare number is a pure number. Errors: as parse_quantity, but for the dimension.
[[nodiscard]] AnyQuantity parse_any_quantity(std::string_view text, const UnitSystem& system);

/// Converts a number in a unit, e.g. 2e7 in "psi", to consistent units of `system`; bit-identical to parse_quantity()
/// of number and unit as one text. Errors: as parse_quantity.
[[nodiscard]] double consistent(double number, std::string_view unit, Dimension wanted, const UnitSystem& system);

}  // namespace talus
