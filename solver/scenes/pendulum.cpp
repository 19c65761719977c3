#include "solver/scenes/pendulum.hpp"

#include <cmath>

#include "solver/model/model_builder.hpp"

namespace talus::scenes {

Scene pendulum(const Pendulum& p) {
  ModelBuilder builder{si};
  builder.gravity({0.0, -p.gravity});
  const Vec2 down{0.0, -p.arm};
  const BodyId bob = builder.add(Body{.name = "bob",
                                      .mobility = Mobility::pinned,
                                      .mass = p.mass,
                                      .inertia = p.inertia,
                                      .p_WB = down,
                                      .p_BPin = -down});
  Scene scene{.title = "Rigid pendulum", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.initial.q[0] = p.amplitude;
  set_velocity(scene.model, scene.initial, bob, {}, p.spin);
  return scene;
}

double small_swing_frequency(const Pendulum& p) {
  return std::sqrt(p.mass * p.gravity * p.arm / (p.inertia + p.mass * p.arm * p.arm));
}

Scene cable_pendulum(const CablePendulum& p) {
  ModelBuilder builder{si};
  builder.gravity({0.0, -p.gravity});
  const double stretched = p.length + p.mass * p.gravity * std::cos(p.amplitude) / p.stiffness;
  const BodyId bob = builder.add(Body{.name = "bob",
                                      .mobility = Mobility::particle,
                                      .mass = p.mass,
                                      .p_WB = {stretched * std::sin(p.amplitude), -stretched * std::cos(p.amplitude)}});
  builder.add(Cable{.name = "cable",
                    .a = {bob, {}},
                    .b = {std::nullopt, {}},
                    .rest_length = p.length,
                    .law = TensionOnly{p.stiffness, 0.0}});
  Scene scene{.title = "Pendulum on a cable", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

}  // namespace talus::scenes
