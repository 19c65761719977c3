#pragma once

#include <array>
#include <numbers>
#include <string_view>

#include "solver/base/dimension.hpp"

/// The tables used by units.cpp: every unit with its exact size, and every dimension that has a name.
namespace talus::unit_table {

/// Size of a unit in SI: numerator/denominator foot^foot pound^pound g_n^gravity. The exponents of the constants are
/// stored separately so that equal factors cancel exactly: "14.92 slug" is 14.92 to the last bit in a system whose unit
/// of mass is the slug.
struct Size {
  double numerator{1.0};
  double denominator{1.0};
  int foot{};
  int pound{};
  int gravity{};
};

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  Size size;
};

inline constexpr double pi = std::numbers::pi;

/// All units that a scene or a command line may use. lb is a mass, lbf = lb g_n a force, g a gram.
inline constexpr std::array units{
    Unit{"kg", dimension::mass, {}},
    Unit{"g", dimension::mass, {1.0, 1000.0}},
    Unit{"t", dimension::mass, {1000.0}},
    Unit{"lb", dimension::mass, {1.0, 1.0, 0, 1, 0}},
    Unit{"lbm", dimension::mass, {1.0, 1.0, 0, 1, 0}},
    Unit{"slug", dimension::mass, {1.0, 1.0, -1, 1, 1}},
    Unit{"m", dimension::length, {}},
    Unit{"mm", dimension::length, {1.0, 1000.0}},
    Unit{"cm", dimension::length, {1.0, 100.0}},
    Unit{"km", dimension::length, {1000.0}},
    Unit{"in", dimension::length, {1.0, 12.0, 1}},
    Unit{"ft", dimension::length, {1.0, 1.0, 1}},
    Unit{"yd", dimension::length, {3.0, 1.0, 1}},
    Unit{"mi", dimension::length, {5280.0, 1.0, 1}},
    Unit{"s", dimension::time, {}},
    Unit{"ms", dimension::time, {1.0, 1e3}},
    Unit{"us", dimension::time, {1.0, 1e6}},
    Unit{"min", dimension::time, {60.0}},
    Unit{"h", dimension::time, {3600.0}},
    Unit{"rad", dimension::angle, {}},
    Unit{"mrad", dimension::angle, {1.0, 1000.0}},
    Unit{"deg", dimension::angle, {pi, 180.0}},
    Unit{"rev", dimension::angle, {2.0 * pi}},
    Unit{"rpm", dimension::angular_velocity, {pi, 30.0}},
    Unit{"Hz", dimension::frequency, {}},
    Unit{"kHz", dimension::frequency, {1000.0}},
    Unit{"N", dimension::force, {}},
    Unit{"kN", dimension::force, {1e3}},
    Unit{"MN", dimension::force, {1e6}},
    Unit{"lbf", dimension::force, {1.0, 1.0, 0, 1, 1}},
    Unit{"kip", dimension::force, {1e3, 1.0, 0, 1, 1}},
    Unit{"J", dimension::energy, {}},
    Unit{"kJ", dimension::energy, {1e3}},
    Unit{"Pa", dimension::pressure, {}},
    Unit{"kPa", dimension::pressure, {1e3}},
    Unit{"MPa", dimension::pressure, {1e6}},
    Unit{"GPa", dimension::pressure, {1e9}},
    Unit{"psi", dimension::pressure, {144.0, 1.0, -2, 1, 1}},
};

/// Description of a dimension in messages, and the pattern of its consistent unit, in which M, L, T and F are replaced
/// by the system's symbols.
struct NamedDimension {
  Dimension dimension;
  std::string_view text;
  std::string_view pattern;
};

inline constexpr std::array named_dimensions{
    NamedDimension{dimension::number, "a pure number", "1"},
    NamedDimension{dimension::mass, "a mass", "M"},
    NamedDimension{dimension::length, "a length", "L"},
    NamedDimension{dimension::time, "a time", "T"},
    NamedDimension{dimension::angle, "an angle", "rad"},
    NamedDimension{dimension::velocity, "a velocity", "L/T"},
    NamedDimension{dimension::acceleration, "an acceleration", "L/T^2"},
    NamedDimension{dimension::angular_velocity, "an angular velocity", "rad/T"},
    NamedDimension{dimension::momentum, "a momentum", "F T"},
    NamedDimension{dimension::force, "a force", "F"},
    NamedDimension{dimension::moment, "a moment or an energy", "F L"},
    NamedDimension{dimension::angular_momentum, "an angular momentum", "F L T"},
    NamedDimension{dimension::inertia, "a moment of inertia", "M L^2"},
    NamedDimension{dimension::stiffness, "a stiffness", "F/L"},
    NamedDimension{dimension::damping, "a damping coefficient", "F T/L"},
    NamedDimension{dimension::area, "an area", "L^2"},
    NamedDimension{dimension::density, "a density", "M/L^3"},
    NamedDimension{dimension::pressure, "a pressure", "F/L^2"},
    NamedDimension{dimension::frequency, "a frequency", "1/T"},
    NamedDimension{dimension::number / dimension::length, "an inverse length", "1/L"},
};

}  // namespace talus::unit_table
