#include "verification/study/scenes/sliding_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "solver/model/model_builder.hpp"

namespace talus::verification::problems {

Scene oblique_scene(const reference::ObliqueImpact& impact, EndRule end) {
  const reference::Impact& normal = impact.normal;
  const bool rolls = impact.mobility > 1.0;
  const double radius = oblique_radius * normal.approach_speed / std::sqrt(normal.stiffness / normal.effective_mass);
  ModelBuilder builder;
  const BodyId plane = builder.add(Body{.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const BodyId disc =
      builder.add(Body{.name = "disc",
                       .mobility = rolls ? Mobility::free : Mobility::particle,
                       .mass = normal.effective_mass,
                       .inertia = rolls ? normal.effective_mass * radius * radius / (impact.mobility - 1.0) : 0.0,
                       .shape = Circle{radius},
                       .p_WB = {0.0, radius}});
  builder.add(Contact{.name = "impact",
                      .a = disc,
                      .b = plane,
                      .law = LinearSpringDashpot{normal.stiffness, normal.damping, end},
                      .friction = CoulombFriction{impact.friction, impact.tangential_stiffness}});
  Scene scene;
  scene.model = builder.build();
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, disc, {impact.slip_rate, -normal.approach_speed}, 0.0);
  return scene;
}

namespace {

double overlap(const Slope& slope) {
  return slope_mass * slope_gravity * std::cos(slope.angle) / slope.normal_stiffness;
}

double inertia() { return 0.5 * slope_mass * slope_radius * slope_radius; }

}  // namespace

reference::DraggedSlider dragged_slider(const Slope& slope) {
  const double arm = slope_radius - 0.5 * overlap(slope);
  reference::DraggedSlider slider{.mass = slope_mass,
                                  .mobility = slope.rolls ? 1.0 + slope_mass * arm * arm / inertia() : 1.0,
                                  .normal_force = slope_mass * slope_gravity * std::cos(slope.angle),
                                  .friction = slope.friction,
                                  .tangential_stiffness = slope.slip_stiffness,
                                  .drive = slope_gravity * std::sin(slope.angle),
                                  .slip_rate = slope.speed,
                                  .stretch = 0.0};
  if (slope.preloaded) {
    const double limit = slider.friction * slider.normal_force;
    const double held = slope.speed > 0.0 ? limit : slider.mass * slider.drive / slider.mobility;
    slider.stretch = std::min(held, limit) / slider.tangential_stiffness;
  }
  return slider;
}

Scene slope_scene(const Slope& slope) {
  ModelBuilder builder;
  builder.gravity({slope_gravity * std::sin(slope.angle), -slope_gravity * std::cos(slope.angle)});
  const BodyId plane = builder.add(Body{.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mobility = slope.rolls ? Mobility::free : Mobility::particle,
                                       .mass = slope_mass,
                                       .inertia = slope.rolls ? inertia() : 0.0,
                                       .shape = Circle{slope_radius},
                                       .p_WB = {0.0, slope_radius - overlap(slope)}});
  builder.add(Contact{.name = "rest",
                      .a = disc,
                      .b = plane,
                      .law = LinearSpringDashpot{slope.normal_stiffness, 0.0},
                      .friction = CoulombFriction{slope.friction, slope.slip_stiffness}});
  Scene scene;
  scene.model = builder.build();
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, disc, {slope.speed, 0.0}, 0.0);
  // The law counts the slip of the plane relative to the disc: a slip of the disc to the right is negative.
  scene.initial.z[0] = -dragged_slider(slope).stretch;
  return scene;
}

}  // namespace talus::verification::problems
