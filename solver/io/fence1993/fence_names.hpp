#pragma once

#include <array>
#include <string_view>

#include "solver/scenes/fence.hpp"

namespace talus {

/// The name by which a scene file selects the choices of the 1993 program for all options that it does not give.
inline constexpr std::string_view fence_rules_1993 = "1993";

/// Names of the motions of an element that can be held, in the order of its flags.
inline constexpr std::array<std::string_view, 3> held_axes{"x", "y", "rotation"};

/// Calls visit(name, choice) for each option whose value is an enum, in the struct's order. (The structured binding
/// lists all members of the struct, so that none can be forgotten.)
template <class Options, class Visit>
void for_each_choice(Options&& options, Visit&& visit) {
  // Members that are not visited: numbers (see fields()), the integrator (see the list of integrators), `watch` (see
  // MonitorRules::choices()) and the table.
  [[maybe_unused]] auto& [symmetry, even_centre, contact, calibration, end_rule, start, bottom_end, column_ground, end,
                          sleep, watch, integrator, tolerance, shear_ratio, hanger_strength, strength_top,
                          strength_bottom, hardening, rupture, table, exit_x] = options;
  visit("symmetry", symmetry);
  visit("even_centre", even_centre);
  visit("contact", contact);
  visit("calibration", calibration);
  visit("end_rule", end_rule);
  visit("start", start);
  visit("bottom_end", bottom_end);
  visit("column_ground", column_ground);
  visit("end", end);
  visit("sleep", sleep);
}

}  // namespace talus
