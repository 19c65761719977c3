#include "solver/scenes/pivoted_cylinder.hpp"

#include "solver/model/model_builder.hpp"

namespace talus::scenes {

Scene pivoted_cylinder(const PivotedCylinder& p) {
  ModelBuilder builder{us};
  builder.gravity({0.0, -p.gravity});
  const BodyId column = builder.add(Body{.name = "column",
                                         .mobility = Mobility::pinned,
                                         .mass = p.mass,
                                         .inertia = p.inertia,
                                         .shape = Rectangle{p.half_width, 0.5 * p.length},
                                         .p_BPin = {0.0, 0.5 * p.length}});
  const BodyId rock = builder.add(Body{.name = "rock",
                                       .mobility = Mobility::free,
                                       .mass = p.rock_mass,
                                       .inertia = 0.4 * p.rock_mass * p.rock_radius * p.rock_radius,
                                       .shape = Circle{p.rock_radius},
                                       .p_WB = {-(p.half_width + p.rock_radius), 0.0}});
  builder.add(Contact{
      .name = "impact", .a = rock, .b = column, .law = p.contact, .method = p.method, .nodes = {p.nodes, p.nodes}});
  Scene scene{.title = "Pivoted cylinder hit by a rock", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, rock, {p.speed, 0.0}, 0.0);
  return scene;
}

}  // namespace talus::scenes
