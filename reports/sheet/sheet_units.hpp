/// Units on a sheet: each quantity in SI and in US units.
#pragma once

#include <string>
#include <string_view>

namespace talus::reports {

/// SI size of the US units; exact by definition (1959; CGPM 1901 for g_n).
inline constexpr double foot = 0.3048;
inline constexpr double pound = 0.45359237;
inline constexpr double pound_force = pound * 9.80665;
inline constexpr double kip = 1000.0 * pound_force;

/// SI sizes and names of a quantity's two units.
struct SheetUnits {
  double si{}, us{};
  std::string_view si_name, us_name;
};
inline constexpr SheetUnits length_units{1.0, foot, "m", "ft"};
inline constexpr SheetUnits speed_units{1.0, foot, "m/s", "ft/s"};
inline constexpr SheetUnits mass_units{1.0, pound, "kg", "lb"};
inline constexpr SheetUnits force_units{1e3, kip, "kN", "kip"};
inline constexpr SheetUnits impulse_units{1e3, kip, "kN s", "kip s"};
inline constexpr SheetUnits energy_units{1e3, foot* kip, "kJ", "kip ft"};

/// Quantities in both unit systems, those of the scene first: "213 (47.9)", with units "213 kN (47.9 kip)"; names of
/// the units alone: "kN (kip)".
[[nodiscard]] std::string both(bool us_first, double value, const SheetUnits& units);
[[nodiscard]] std::string with_units(bool us_first, double value, const SheetUnits& units);
[[nodiscard]] std::string unit_names(bool us_first, const SheetUnits& units);

/// Number with four digits, without an exponent where that is shorter.
[[nodiscard]] std::string digits(double value);

}  // namespace talus::reports
