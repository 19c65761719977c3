#include "verification/problems/program/fit/fitted_ball.hpp"

#include <fmt/format.h>

namespace talus::verification::problems::fitted_parameters {

std::string ball(const std::string& more_of_contact, bool falls) {
  return fmt::format(
      R"(title = "Ball on a floor"
units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]

[[body]]
name = "floor"
mobility = "fixed"
position = ["0 m", "0 m"]
shape = {{ kind = "half_plane" }}

[[body]]
name = "ball"
mobility = "{}"
mass = "{} kg"
{}position = ["0 m", "{} m"]
velocity = ["0 m/s", "{} m/s"]
shape = {{ kind = "circle", radius = "{} m" }}

[[contact]]
name = "hit"
between = ["ball", "floor"]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
damping = "10 N s/m"
end_rule = "attractive"
{}
[run]
{}
end = "0.1 s"
interval = "10 ms"
watch = "off"
)",
      falls ? -gravity : 0.0, more_of_contact.empty() ? "particle" : "free", mass,
      more_of_contact.empty() ? "" : fmt::format("inertia = \"{} kg m^2\"\n", 0.4 * mass * radius * radius),
      falls ? radius + drop : radius, falls ? 0.0 : -1.0, radius, stiffness, more_of_contact,
      more_of_contact.empty() ? "integrator = \"exact\"\nstep = \"10 ms\""
                              : "integrator = \"velocity_verlet\"\nstep = \"0.05 ms\"");
}

std::string parameter(const std::string& field, const std::string& range, const std::string& more) {
  return fmt::format("[[parameter]]\nfield = \"{}\"\nrange = {}\n{}", field, range, more);
}

}  // namespace talus::verification::problems::fitted_parameters
