#include "verification/study/scenes/scenes_in_motion.hpp"

#include <algorithm>
#include <numbers>

#include "solver/model/model_builder.hpp"
#include "verification/study/scenes/weak_hangers.hpp"

namespace talus::verification::problems {
namespace {

constexpr LinearSpringDashpot bump{4.1e4, 90.0, EndRule::clamped};
constexpr CoulombFriction rough{0.37, 2.3e4};

Body ground(const char* name, Shape shape, Vec2 position, double angle) {
  return {.name = name, .mobility = Mobility::fixed, .shape = std::move(shape), .p_WB = position, .angle = angle};
}

Body thrown(const char* name, double mass, double inertia, Shape shape, Vec2 position, double angle) {
  return {.name = name, .mass = mass, .inertia = inertia, .shape = std::move(shape), .p_WB = position, .angle = angle};
}

Contact touch(const char* name, BodyId a, BodyId b, ContactMethod method = ContactMethod::resultant) {
  return {.name = name, .a = a, .b = b, .law = bump, .method = method, .friction = rough};
}

/// A carriage on a rail, drawn by a cable that breaks.
void add_carriage(ModelBuilder& builder, BodyId roller) {
  const BodyId carriage =
      builder.add(Body{.name = "carriage", .mobility = Mobility::sliding_x, .mass = 3.1, .p_WB = {-3.9, 2.6}});
  builder.add(Cable{.name = "weak",
                    .a = {roller, {0.1, 0.2, 0.0}},
                    .b = {carriage, {}},
                    .rest_length = 2.6,
                    .law = ElasticPlastic{.stiffness = 2.7e3, .yield = 120.0, .hardening = 900.0, .strength = 140.0}});
}

/// A bob on two hardening cables with a hanger that breaks, and a pinned bar.
void add_bob(ModelBuilder& builder, BodyId roller, BodyId plate) {
  const BodyId bob = builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 4.3, .p_WB = {0.3, 5.1}});
  const ElasticPlastic rope{.stiffness = 6.1e3, .yield = 55.0, .table = {{0.07, 90.0}, {0.3, 130.0}}};
  builder.add(
      Cable{.name = "left", .a = {bob, {}}, .b = {std::nullopt, {-2.2, 6.3, 0.4}}, .rest_length = 2.8, .law = rope});
  builder.add(
      Cable{.name = "right", .a = {bob, {}}, .b = {std::nullopt, {2.9, 6.1, -0.3}}, .rest_length = 2.8, .law = rope});
  builder.add(Hanger{.name = "hook", .body = bob, .p = {}, .strength = 49.0});
  const BodyId bar = builder.add(Body{.name = "bar",
                                      .mobility = Mobility::pinned,
                                      .mass = 2.2,
                                      .inertia = 0.9,
                                      .shape = Rectangle{0.15, 1.1},
                                      .p_WB = {2.6, 1.9},
                                      .angle = 0.2,
                                      .p_BPin = {0.02, 0.9}});
  builder.add(touch("roller-bar", roller, bar));
  builder.add(touch("plate-bar", plate, bar));
}

}  // namespace

Scene mixed_pile() {
  ModelBuilder builder{si};
  builder.gravity({0.3, -9.7});
  const BodyId field =
      builder.add(ground("field", Terrain{{{-6.1, 0.6}, {-1.3, 0.07}, {1.9, 0.21}, {8.3, -0.4}}}, {}, 0.0));
  const BodyId wall = builder.add(ground("wall", HalfPlane{}, {4.3, 0.0}, 0.5 * std::numbers::pi));
  const BodyId roller = builder.add(thrown("roller", 2.1, 0.17, Circle{0.41}, {-2.1, 0.72}, 0.3));
  const BodyId plate = builder.add(thrown("plate", 1.7, 0.23, Rectangle{0.53, 0.31}, {0.9, 1.1}, 0.4));
  const BodyId brick = builder.add(thrown("brick", 2.9, 0.31, Rectangle{0.37, 0.43}, {1.1, 2.4}, -0.2));
  const BodyId stone = builder.add(thrown("stone", 3.7, 0.53, Superquadric{0.57, 0.36, 3.5}, {-0.7, 1.3}, 1.1));
  builder.add(touch("roller-field", roller, field));
  builder.add(touch("plate-field", plate, field, ContactMethod::nodes));
  builder.add(touch("stone-field", stone, field, ContactMethod::nodes));
  builder.add(touch("roller-stone", roller, stone));
  builder.add(touch("plate-stone", plate, stone, ContactMethod::nodes));
  builder.add(touch("plate-brick", plate, brick));
  builder.add(touch("stone-wall", stone, wall));
  builder.add(touch("brick-wall", brick, wall));
  builder.add(touch("roller-wall", roller, wall));
  builder.add(Cable{.name = "leash",
                    .a = {stone, {0.2, 0.1, 0.0}},
                    .b = {std::nullopt, {-1.9, 3.6, 0.0}},
                    .rest_length = 2.3,
                    .law = TensionOnly{1.9e3, 35.0}});
  add_carriage(builder, roller);
  add_bob(builder, roller, plate);
  Scene scene{.title = "Crowded yard", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, roller, {4.3, 0.0}, -3.0);
  set_velocity(scene.model, scene.initial, plate, {1.1, -0.4}, 2.0);
  set_velocity(scene.model, scene.initial, brick, {0.7, -1.3}, -1.7);
  set_velocity(scene.model, scene.initial, stone, {2.3, -0.6}, 0.9);
  return scene;
}

scenes::Fence rough_fence() {
  scenes::Fence fence = weak_fence(1.5e4);
  fence.friction = 0.3;
  fence.limit_top = 1.1e5;
  fence.limit_bottom = 4e4;
  fence.options.hardening = 0.02;
  return fence;
}

Scene free_group() {
  ModelBuilder builder{si};
  const BodyId a = builder.add(thrown("a", 1.3, 0.1053, Circle{0.45}, {-1.2, 0.1}, 0.4));
  const BodyId b = builder.add(thrown("b", 0.9, 0.07, Circle{0.4}, {0.05, -0.2}, -1.3));
  const BodyId c = builder.add(thrown("c", 2.3, 0.31, Rectangle{0.5, 0.35}, {1.3, 0.25}, 0.5));
  const BodyId d = builder.add(thrown("d", 0.7, 0.06, Circle{0.37}, {0.1, 1.1}, 2.1));
  builder.add(touch("a-b", a, b));
  builder.add(touch("b-c", b, c));
  builder.add(touch("a-d", a, d));
  builder.add(touch("d-c", d, c));
  builder.add(touch("b-d", b, d));
  builder.add(Cable{.name = "tie",
                    .a = {a, {0.1, 0.3, 0.0}},
                    .b = {c, {-0.2, 0.1, 0.0}},
                    .rest_length = 2.2,
                    .law = TensionOnly{700.0, 3.0}});
  Scene scene{.title = "Free group", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, a, {1.9, 0.3}, 2.0);
  set_velocity(scene.model, scene.initial, b, {-0.4, 0.6}, -1.0);
  set_velocity(scene.model, scene.initial, c, {-1.1, -0.2}, 0.7);
  set_velocity(scene.model, scene.initial, d, {0.2, -1.4}, 3.0);
  return scene;
}

int mechanisms_at_work(const State& state) {
  return static_cast<int>(std::ranges::count_if(state.work, [](double work) { return work != 0.0; }));
}

}  // namespace talus::verification::problems
