#include "solver/scenes/two_cable.hpp"

#include "solver/model/model_builder.hpp"

namespace talus::scenes {

Scene two_cable(const TwoCable& p) {
  ModelBuilder builder{si};
  const Circle circle{p.radius};
  const BodyId particle =
      builder.add(Body{.name = "particle", .mobility = Mobility::particle, .mass = p.mass, .shape = circle});
  const BodyId striker = builder.add(Body{.name = "striker",
                                          .mobility = Mobility::particle,
                                          .mass = p.striker_mass,
                                          .shape = circle,
                                          .p_WB = {-2.0 * p.radius, 0.0}});
  builder.add(Contact{.name = "impact", .a = striker, .b = particle, .law = p.contact});
  const TensionOnly law{p.cable_stiffness, 0.0};
  builder.add(Cable{.name = "upper",
                    .a = {particle, {}},
                    .b = {std::nullopt, {0.0, p.cable_length, 0.0}},
                    .rest_length = p.cable_length,
                    .law = law});
  builder.add(Cable{.name = "lower",
                    .a = {particle, {}},
                    .b = {std::nullopt, {0.0, -p.cable_length, 0.0}},
                    .rest_length = p.cable_length,
                    .law = law});
  Scene scene{.title = "Two-cable particle impact", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, striker, {p.speed, 0.0}, 0.0);
  return scene;
}

}  // namespace talus::scenes
