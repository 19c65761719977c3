#include "verification/problems/normal_contact/struck_bar.hpp"

#include <cmath>

#include "solver/model/model_builder.hpp"

namespace talus::verification::problems {

double inertia(const StruckBar& bar) {
  return bar.mass * (bar.half_width * bar.half_width + bar.half_height * bar.half_height) / 3.0;
}

double arm(const StruckBar& bar) { return std::abs(bar.pinned ? bar.half_height - bar.height : bar.height); }

Scene struck_bar(const StruckBar& bar) {
  constexpr double radius = 1.0;
  ModelBuilder builder;
  const BodyId struck = builder.add(Body{.name = "bar",
                                         .mobility = bar.pinned ? Mobility::pinned : Mobility::free,
                                         .mass = bar.mass,
                                         .inertia = inertia(bar),
                                         .shape = Rectangle{bar.half_width, bar.half_height},
                                         .p_BPin = {0.0, bar.half_height}});
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mobility = Mobility::particle,
                                       .mass = bar.disc_mass,
                                       .shape = Circle{radius},
                                       .p_WB = {-(bar.half_width + radius + bar.gap), bar.height}});
  builder.add(Contact{.name = "impact", .a = disc, .b = struck, .law = bar.law});
  Scene scene{.title = "Bar struck by a disc", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, disc, {bar.speed, 0.0}, 0.0);
  return scene;
}

}  // namespace talus::verification::problems
