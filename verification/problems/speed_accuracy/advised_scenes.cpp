#include "verification/problems/speed_accuracy/advised_scenes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/advise/pilot.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/reference/hertz_impact.hpp"
#include "verification/study/fence_table.hpp"
#include "verification/study/oblique_runs.hpp"
#include "verification/study/scene_run.hpp"
#include "verification/study/sliding_scenes.hpp"

namespace talus::verification::problems {
namespace {

constexpr double pi = std::numbers::pi;

/// A plan of which only the end and the ledger, off, are of use: methods bring their own steps.
RunPlan until(double end) { return {0.001 * end, end, 0.001 * end, false}; }

}  // namespace

Question caught_bob(double accuracy, std::vector<std::string> among) {
  const double gravity = 9.81, stiffness = 500.0, fall = 0.8;
  ModelBuilder builder;
  builder.gravity({0.0, -gravity});
  const BodyId bob =
      builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.0, fall - 1.0}});
  builder.add(Cable{
      .name = "rope", .a = {bob, {}}, .b = {std::nullopt, {}}, .rest_length = 1.0, .law = TensionOnly{stiffness, 0.0}});
  Scene scene{.title = "caught bob", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.plan = until(5.0);
  const double truth = gravity * (1.0 + std::sqrt(1.0 + 2.0 * fall * stiffness / gravity));
  return {among.empty() ? "caught bob" : "caught bob, fixed steps",
          std::move(scene),
          "cable.rope.tension.max",
          accuracy,
          std::move(among),
          truth};
}

Question oblique_impact(double accuracy, std::vector<std::string> among) {
  const reference::ObliqueImpact impact = oblique_disc(0.8, 2.0);
  Scene scene = oblique_scene(impact, EndRule::clamped);
  go_back(scene.initial, 0.5 * pi);
  scene.plan = until(1.7 * pi);
  return {among.empty() ? "oblique impact" : "oblique impact, fixed steps",
          std::move(scene),
          "disc.vx.end",
          accuracy,
          std::move(among),
          impact.slip_rate - reference::rebound(impact, reference::EndRule::clamped).speed_lost};
}

Question hertz_impact(double accuracy) {
  Scene scene = scenes::bouncing_disc({.mass = 1.0,
                                       .radius = 20.0,
                                       .gap = 0.7,
                                       .speed = 1.0,
                                       .contact = Hertz{.modulus = 0.75, .radius = 1.0, .damping = 0.0}});
  scene.plan = until(6.0);
  const double depth = reference::hertz_events({1.0, 0.0, 1.0, 1.0}, reference::EndRule::clamped).largest_depth;
  return {"Hertzian impact", std::move(scene), "contact.impact.force.max", accuracy, {}, std::pow(depth, 1.5)};
}

Question latched_impact(double accuracy, std::vector<std::string> among) {
  Scene scene =
      scenes::bouncing_disc({.mass = 1.0, .radius = 20.0, .gap = 0.3, .contact = LatchingSpring{1.0, 4.0, 0.0}});
  scene.plan = until(3.5);
  // e = sqrt(K1/K2), away from the plane.
  return {among.empty() ? "latching impact" : "latching impact, fixed steps",
          std::move(scene),
          "disc.vy.end",
          accuracy,
          std::move(among),
          0.5};
}

Question fence_impact(double accuracy, Findings& findings) {
  scenes::Fence fence = published_fence("table_3.DAT");
  fence.options.start = scenes::FenceStart::plain;
  Question question{"fence of Table 3", scenes::fence_scene(fence).scene, "rock.vx.end", accuracy, {}};
  question.scene.plan = until(0.05);
  const auto speed = [&](double step) {
    const Scene scene = with_method(question.scene, {"central_difference", 0.0, std::lround(0.05 / step)});
    const State end = run_scene(scene, scene.integrator, scene.plan, findings).state;
    return pose(scene.model, end, *find_body(scene.model, "rock")).v_WB.x;
  };
  const double coarse = speed(4e-7), fine = speed(2e-7);
  question.truth = 2.0 * fine - coarse;
  question.doubt = 0.5 * std::abs((fine - coarse) / question.truth);
  return question;
}

Question gas(double end, double accuracy) {
  ModelBuilder builder;
  const LinearSpringDashpot bump{1e4, 0.0, EndRule::clamped};
  const std::array<Vec2, 5> places{{{-1.3, -1.2}, {1.1, -1.0}, {0.1, 0.2}, {-1.2, 1.3}, {1.3, 1.1}}};
  const std::array<Vec2, 5> speeds{{{0.9, 0.3}, {-0.4, 0.8}, {0.7, -0.6}, {0.2, -0.9}, {-0.8, -0.1}}};
  std::vector<BodyId> bodies;
  for (int i = 0; i < 4; ++i) {
    const double turn = 0.5 * pi * i;
    bodies.push_back(builder.add(Body{.name = fmt::format("wall{}", i + 1),
                                      .mobility = Mobility::fixed,
                                      .shape = HalfPlane{},
                                      .p_WB = {2.0 * std::sin(turn), -2.0 * std::cos(turn)},
                                      .angle = turn}));
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BodyId disc = builder.add(Body{.name = fmt::format("disc{}", i + 1),
                                         .mobility = Mobility::particle,
                                         .mass = 1.0,
                                         .shape = Circle{0.4},
                                         .p_WB = places[i]});
    for (std::size_t k = 0; k < bodies.size(); ++k)
      builder.add(Contact{.name = fmt::format("pair{}_{}", i + 1, k + 1), .a = bodies[k], .b = disc, .law = bump});
    bodies.push_back(disc);
  }
  Scene scene{.title = "gas", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  for (std::size_t i = 0; i < places.size(); ++i)
    set_velocity(scene.model, scene.initial, bodies[4 + i], speeds[i], 0.0);
  scene.plan = until(end);
  return {"gas", std::move(scene), "disc1.x.end", accuracy, {}};
}

}  // namespace talus::verification::problems
