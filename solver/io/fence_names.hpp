#pragma once

#include <array>
#include <string_view>

#include "solver/scenes/fence.hpp"

namespace talus {

/// Names of the motions of an element that can be held, in the order of its flags.
inline constexpr std::array<std::string_view, 3> held_axes{"x", "y", "rotation"};

/// Calls visit(name, choice) for each choice among the names of an enum, in the struct's order.
template <class Options, class Visit>
void for_each_choice(Options&& options, Visit&& visit) {
  visit("symmetry", options.symmetry);
  visit("even_centre", options.even_centre);
  visit("contact", options.contact);
  visit("calibration", options.calibration);
  visit("end_rule", options.end_rule);
  visit("bottom_end", options.bottom_end);
}

/// The name of a choice.
template <class Enum>
std::string_view choice_name(Enum choice) {
  return Names<Enum>::list[static_cast<std::size_t>(choice)];
}

}  // namespace talus
