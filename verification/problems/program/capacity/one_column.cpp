#include "verification/problems/program/capacity/one_column.hpp"

#include <fmt/format.h>

namespace talus::verification::problems::fence_capacity {

std::string fence(const std::string& of_rock, const std::string& more) {
  return fmt::format(R"(title = "One column on one cable"
units = "SI"

[fence]
columns = 1
layers = 1
connections = 1
spacing = "1 m"
y_top = "0 m"
y_bottom = "-0.5 m"
span = "{} m"
sag = "0.001 m"
young = "{} Pa"
area_top = "{} m^2"
area_bottom = "1e-4 m^2"
limit_top = "1e9 N"
limit_bottom = "1e9 N"
restitution = 1.0
penetration = 0.002
gravity = "1e-6 m/s^2"
duration = "0.4 s"
step_factor = 4

[fence.ground]
position = ["0 m", "-5 m"]
a = "10 m"
b = "0.5 m"
density = "1000 kg/m^3"

[fence.column]
a = "0.2 m"
b = "1 m"
mass = "{} kg"
held = ["y", "rotation"]

[[fence.rock]]
a = "{} m"
b = "{} m"
mass = "{} kg"
position = ["{} m", "0 m"]
velocity = ["-5 m/s", "0 m/s"]
{}
[fence.options]
strength_top = "1 N"
{})",
                     2.0 * half_span, young, area, column_mass, own_radius, own_radius, own_mass, own_x, of_rock, more);
}

double breaking_energy(const Setup& setup) {
  const double stiffness = young * area / half_span, draw = strength / stiffness;
  return (setup.has("one_half") ? 1.0 : 2.0) * 0.5 * stiffness * draw * draw;
}

std::string question(int cells, const std::string& more) {
  return fmt::format(
      "title = \"One column\"\nbase = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"12 "
      "m/s\"]\n"
      "set = {{ \"fence.options.strength_top\" = \"{} N\" }}\nseed = 3\n{}[map]\ncells = {}\nruns = 12\naudit = 20\n"
      "[changes]\nspeed = 0.002\n",
      strength, more, cells);
}

}  // namespace talus::verification::problems::fence_capacity
