#include "verification/problems/program/agreement/agreeing_scenes.hpp"

#include <fmt/format.h>

#include <numbers>

namespace talus::verification::problems::agreeing_files {
namespace {

const std::string fence_text = R"(title = "Two rocks on a yielding fence"
units = "US"

[fence]
steps = 400
print_every = 50
history_every = 1
step_factor = 1
gravity = "32.18 ft/s^2"
connections = 2
columns = 5
layers = 2
layer_spacing = "2.6 ft"
layer_overlap = "0.5 ft"
rock_overlap = "0.6 ft"
span = "30 ft"
sag = "3 ft"
spacing = "2.5 ft"
young = "20000000 psi"
y_top = "6.67 ft"
y_bottom = "-4 ft"
area_top = "1.076 in^2"
area_bottom = "0.25 in^2"
limit_top = "20000 lbf"
limit_bottom = "3000 lbf"
slack = "0.02 ft"
restitution = 0.4
penetration = 0.05
friction = 0.3
history_elements = [2, 3, 4, 5, 6, 7, 8, 9, 10]
history_codes = [15, 16, 35, 36, 37, 38, 48, 51]

[fence.ground]
a = "10 ft"
b = "0.5 ft"
position = ["0 ft", "-5 ft"]

[[fence.rock]]
a = "1.201 ft"
b = "1.201 ft"
density = "5.13 slug/ft^3"
spin = "34 rad/s"
position = ["2.451 ft", "-1.3 ft"]
velocity = ["-65 ft/s", "0 ft/s"]

[[fence.rock]]
a = "1.1 ft"
b = "1.1 ft"
density = "5.13 slug/ft^3"
spin = "-20 rad/s"
position = ["2.55 ft", "1.3 ft"]
velocity = ["-50 ft/s", "0 ft/s"]

[fence.column]
a = "1.25 ft"
b = "4 ft"
density = "0.76 slug/ft^3"

[fence.options]
integrator = "auto"
hardening = 0.02
hanger_strength = "15000 lbf"
strength_top = "23500 lbf"
)";

}  // namespace

Facts yard() {
  return {.file = "yard",
          .title = "Contacts and cables of several kinds",
          .text = R"(title = "Contacts and cables of several kinds"
units = "SI"
gravity = ["0 m/s^2", "-10 m/s^2"]

[[body]]
name = "ground"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]

[[body]]
name = "low"
mobility = "free"
mass = "2 kg"
inertia = "0.25 kg m^2"
shape = { kind = "circle", radius = "0.5 m" }
position = ["0 m", "0.52 m"]
velocity = ["1 m/s", "-2 m/s"]
spin = "3 rad/s"

[[body]]
name = "high"
mobility = "particle"
mass = "1.5 kg"
shape = { kind = "circle", radius = "0.4 m" }
position = ["0.1 m", "1.45 m"]
velocity = ["0 m/s", "-3 m/s"]
force = ["0.5 N", "0 N"]

[[body]]
name = "side"
mobility = "free"
mass = "1 kg"
inertia = "0.1 kg m^2"
shape = { kind = "circle", radius = "0.3 m" }
position = ["0.95 m", "0.6 m"]
velocity = ["-2 m/s", "0 m/s"]
moment = "0.2 N m"

[[body]]
name = "beam"
mobility = "sliding_y"
mass = "3 kg"
position = ["-3 m", "2 m"]
velocity = ["0 m/s", "-1 m/s"]

[[contact]]
name = "low-ground"
between = ["low", "ground"]
law = "linear_spring_dashpot"
stiffness = "2000 N/m"
damping = "8 N s/m"
friction = 0.4

[[contact]]
name = "high-low"
between = ["high", "low"]
law = "latching_spring"
stiffness = "3000 N/m"
unloading_stiffness = "5000 N/m"

[[contact]]
name = "side-low"
between = ["side", "low"]
law = "hertz"
modulus = "60000 N/m^2"
radius = "0.2 m"

[[cable]]
name = "tie"
law = "elastic_plastic"
from = { body = "beam", point = ["0 m", "0 m"] }
to = { point = ["-3 m", "4 m"] }
stiffness = "900 N/m"
yield = "60 N"

[[cable]]
name = "rope"
law = "tension_only"
from = { body = "high", point = ["0 m", "0 m"] }
to = { point = ["0.6 m", "3 m"] }
stiffness = "200 N/m"
damping = "3 N s/m"
rest_length = "1.6 m"

[run]
integrator = "velocity_verlet"
step = "0.5 ms"
end = "0.3 s"
interval = "0.5 ms"
)",
          .integrator = "velocity_verlet",
          .units = &si,
          .gravity = 10.0,
          .step = 5e-4,
          .steps = 600,
          .steps_a_state = 60,
          .degrees_of_freedom = 9,
          .law_instances = 3 + 1 + 2,
          .bodies =
              {{.name = "ground", .kind = "ground", .moves = false, .shape = Shape::plane},
               {.name = "low", .mass = 2.0, .inertia = 0.25, .shape = Shape::circle, .a = low_radius},
               {.name = "high", .turns = false, .mass = 1.5, .shape = Shape::circle, .a = high_radius, .force_x = 0.5},
               {.name = "side", .mass = 1.0, .inertia = 0.1, .shape = Shape::circle, .a = side_radius, .moment = 0.2},
               {.name = "beam", .turns = false, .mass = 3.0}},
          .cables = {{.name = "tie",
                      .from = {.body = 4},
                      .to = {.x = -3.0, .y = 4.0},
                      .stiffness = 900.0,
                      .yield = 60.0,
                      .rest = 2.0},
                     {.name = "rope",
                      .from = {.body = 2},
                      .to = {.x = 0.6, .y = 3.0},
                      .stiffness = 200.0,
                      .damping = 3.0,
                      .rest = 1.6}},
          .contacts = {"low-ground", "high-low", "side-low"}};
}

Facts fence() {
  Facts facts{.file = "fence",
              .title = "Two rocks on a yielding fence",
              .text = fence_text,
              .integrator = "stormer_cowell",
              .integrator_step = "steps chosen by stormer_cowell, events located, tolerance 1e-10",
              .units = &us,
              .gravity = 32.18,
              .steps = 400,
              .steps_a_state = 50,
              .degrees_of_freedom = 24,
              .mirrored = true};
  facts.bodies.push_back(
      {.name = "ground", .kind = "ground", .moves = false, .shape = Shape::plane, .y = ground_top, .number = 1});
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const double a = rocks[r].radius, mass = 4.0 / 3.0 * std::numbers::pi * a * a * a * rock_density;
    facts.bodies.push_back({.name = fmt::format("rock{}", r + 1),
                            .kind = "rock",
                            .mass = mass,
                            .inertia = 0.4 * mass * a * a,
                            .shape = Shape::circle,
                            .a = a,
                            .number = static_cast<int>(r) + 2});
  }
  const double mass = 2.0 * std::numbers::pi * column_a * column_a * column_b * column_density;
  for (const int layer : {1, 2}) {
    const std::string prefix = layer == 1 ? "" : "back_";
    const double x = layer == 1 ? 0.0 : -layer_spacing;
    const auto first = static_cast<int>(facts.bodies.size());
    for (int i = 0; i < columns_of_half; ++i) {
      facts.bodies.push_back({.name = fmt::format("{}column{}", prefix, i + 1),
                              .kind = "column",
                              .mass = mass,
                              .inertia = mass * (column_a * column_a / 4.0 + column_b * column_b / 3.0),
                              .shape = Shape::box,
                              .a = column_a,
                              .b = column_b,
                              .along = spacing * i,
                              .layer = layer,
                              .number = first + i + layer,
                              .multiplicity = i == 0 ? 1.0 : 2.0});
      facts.hangers.push_back(fmt::format("{}hanger{}", prefix, i + 1));
    }
    for (const bool top : {true, false}) {
      for (int i = 0; i < (top ? columns_of_half : columns_of_half - 1); ++i) {
        const bool last = i + 1 == columns_of_half;
        const End anchor{-1, x, y_top + sag, 0.5 * fence_span};
        const double y = top ? y_top : y_bottom;
        facts.cables.push_back({.name = fmt::format("{}{}{}", prefix, top ? "top" : "bottom", i + 1),
                                .from = {first + i, 0.0, y, spacing * i},
                                .to = last ? anchor : End{first + i + 1, 0.0, y, spacing * (i + 1)},
                                .yield = top ? limit_top : limit_bottom,
                                .strength = top ? strength_top : infinite,
                                .hardening = hardening,
                                .layer = layer,
                                .top = top});
      }
    }
  }
  // The faces of two columns touch by two springs, others by one; each spring has friction, and each column may sleep.
  const auto columns = static_cast<int>(facts.hangers.size()), cables = static_cast<int>(facts.cables.size());
  facts.law_instances = 2 * (7 + 2) + cables + columns + columns;
  facts.contacts = {"rock1-column1",      "rock1-back_column1", "rock1-ground", "rock2-column1",
                    "rock2-back_column1", "rock2-ground",       "rock1-rock2",  "column1-back_column1"};
  return facts;
}

}  // namespace talus::verification::problems::agreeing_files
