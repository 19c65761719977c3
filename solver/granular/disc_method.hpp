#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/granular/discs.hpp"
#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/integrate/taylor.hpp"
#include "solver/integrate/velocity_verlet.hpp"

namespace talus {

/// The closed list of methods that step discs: those of fixed step and one force evaluation a step, the same as those
/// of rigid bodies.
using DiscMethod = std::variant<VelocityVerletOf<Discs>, EulerCromerOf<Discs>, CentralDifferenceOf<Discs>,
                                TaylorOf<Discs>, EulerOf<Discs>>;

/// Names of all, in the list's order.
[[nodiscard]] std::vector<std::string> disc_method_names();

/// The method of that name. Errors: InputError for an unknown name.
[[nodiscard]] DiscMethod make_disc_method(std::string_view name);

/// How far a method's steps drive an undamped swing: along a quarter of it its amplitude grows by the factor
/// exp(c pi w h), c = 1/4 for euler, whose energy grows by 1 + (w h)^2 in each of pi/(2 w h) steps, 1/8 for taylor, 0
/// for the leapfrog methods.
[[nodiscard]] double swing_gain(std::string_view name);

/// What an impact by a latching spring, a quarter of a swing at w1 and one at w2 = w1/e, keeps of its speed in a
/// method's steps, if it keeps e without them: e exp(c pi (w1 + w2) h). loading_angle: w1 h [rad] >= 0.
[[nodiscard]] double stepped_restitution(std::string_view name, double restitution, double loading_angle);

}  // namespace talus
