#include "solver/scenes/bouncing_disc.hpp"

#include "solver/model/model_builder.hpp"

namespace talus::scenes {

Scene bouncing_disc(const BouncingDisc& p) {
  ModelBuilder builder{si};
  builder.gravity({0.0, -p.gravity});
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mobility = Mobility::particle,
                                       .mass = p.mass,
                                       .shape = Circle{p.radius},
                                       .p_WB = {0.0, p.radius + p.gap}});
  const BodyId plane = builder.add(Body{.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  builder.add(Contact{.name = "impact", .a = disc, .b = plane, .law = p.contact});
  Scene scene{.title = "Disc on a plane", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, disc, {0.0, -p.speed}, 0.0);
  return scene;
}

}  // namespace talus::scenes
