/// Bodies with one guided axis, checked by energy, momentum, and the directions that a guide leaves free.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/dynamics/springs.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

BOOST_AUTO_TEST_SUITE(guides_tests)

using namespace talus;

namespace {

constexpr double mass = 2.0, inertia = 0.5, length = 0.8, g = 10.0;

/// A bar that hangs from a pin sliding along x; or the same rotated by a right angle: along y, with gravity along x.
Model hung(Mobility mobility, double angle) {
  ModelBuilder builder;
  const bool along_x = mobility == Mobility::guided_x;
  builder.gravity(along_x ? Vec2{0.0, -g} : Vec2{g, 0.0});
  Body body{.name = "bar", .mobility = mobility, .mass = mass, .inertia = inertia, .p_BPin = {0.0, length}};
  body.angle = along_x ? angle : angle + 0.5 * std::numbers::pi;
  body.p_WB = -(rotation(body.angle) * body.p_BPin);
  builder.add(body);
  return builder.build();
}

struct Run {
  State state;
  Accounts accounts;
};

Run run(const Model& model, State state, const char* integrator, double step, double end) {
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics};
  system.begin(state);
  EnergyLedger ledger{dynamics, state};
  Integrator method = make_integrator(integrator);
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, end, end, true})));
  return {state, ledger.accounts(state)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_pendulum_on_a_sliding_pin_keeps_energy_and_its_place_along_the_guide) {
  for (const Mobility mobility : {Mobility::guided_x, Mobility::guided_y}) {
    const double start = 1.2;
    const Model model = hung(mobility, start);
    const Run end = run(model, rest_state(model), "rk4", 1e-4, 2.0);
    const double theta = end.state.q[1] - model.bodies[0].angle + start, w = end.state.v[1];
    // No force acts along the guide, so the centre of mass keeps its position there; across the guide it falls by L
    // (cos theta - cos theta0).
    BOOST_TEST(end.state.q[0] == rest_state(model).q[0]);
    const double across = length * std::sin(theta) * w;
    const double energy =
        0.5 * inertia * w * w + 0.5 * mass * across * across + mass * g * length * (std::cos(start) - std::cos(theta));
    BOOST_TEST(std::abs(energy) < 1e-9);
    BOOST_TEST(std::abs(w) > 0.1);
    BOOST_TEST(std::abs(end.accounts.energy_balance_error) < 1e-9);
    // Weight and guide force account for all of the momentum.
    BOOST_TEST(norm(end.accounts.momentum_balance_error) < 1e-9);
    BOOST_TEST(std::abs(end.accounts.angular_momentum_balance_error) < 1e-9);
    // The pin has remained on its guide.
    const Vec2 pin_now = world_point(pose(model, end.state, BodyId{0}), model.bodies[0].p_BPin);
    BOOST_TEST(std::abs(mobility == Mobility::guided_x ? pin_now.y : pin_now.x) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(both_guides_are_one_turned_by_a_right_angle) {
  const Model x = hung(Mobility::guided_x, 0.7), y = hung(Mobility::guided_y, 0.7);
  State sx = rest_state(x), sy = rest_state(y);
  set_velocity(x, sx, BodyId{0}, {0.3, 0.0}, 1.5);
  set_velocity(y, sy, BodyId{0}, {0.0, 0.3}, 1.5);
  const Run a = run(x, sx, "velocity_verlet", 1e-3, 1.0), b = run(y, sy, "velocity_verlet", 1e-3, 1.0);
  BOOST_TEST(std::abs(a.state.q[0] - b.state.q[0]) < 1e-12);
  BOOST_TEST(std::abs(a.state.q[1] + 0.5 * std::numbers::pi - b.state.q[1]) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_sliding_body_falls_or_stays) {
  ModelBuilder builder;
  builder.gravity({3.0, -10.0});
  builder.add(Body{.name = "x", .mobility = Mobility::sliding_x, .mass = 2.0, .p_WB = {1.0, 5.0}});
  builder.add(Body{.name = "y", .mobility = Mobility::sliding_y, .mass = 2.0, .p_WB = {1.0, 5.0}, .force = {7.0, 4.0}});
  const Model model = builder.build();
  const Run end = run(model, rest_state(model), "velocity_verlet", 0.125, 1.0);
  BOOST_TEST(end.state.q[0] == 1.0 + 0.5 * 3.0);
  BOOST_TEST(end.state.q[1] == 5.0 - 0.5 * 8.0);
  BOOST_TEST(pose(model, end.state, BodyId{0}).p_WB.y == 5.0);
  BOOST_TEST(norm(end.accounts.momentum_balance_error) < 1e-12);
  BOOST_TEST(std::abs(end.accounts.energy_balance_error) < 1e-12);
  State state = rest_state(model);
  BOOST_CHECK_THROW(set_velocity(model, state, BodyId{0}, {0.0, 1.0}, 0.0), InputError);
  BOOST_CHECK_THROW(set_velocity(model, state, BodyId{0}, {1.0, 0.0}, 1.0), InputError);
}

BOOST_AUTO_TEST_CASE(springs_at_a_guided_body_stretch_as_it_moves) {
  // Compares the gradient of the elongation with the elongation of a slightly displaced body.
  for (const Mobility mobility : {Mobility::guided_x, Mobility::guided_y}) {
    Model model = hung(mobility, 0.7);
    model.cables.push_back(Cable{.name = "stay",
                                 .a = {BodyId{0}, {0.3, -0.2, 0.0}},
                                 .b = {std::nullopt, {2.0, 1.0, 0.0}},
                                 .law = TensionOnly{1.0}});
    const Dynamics dynamics{model};
    const State rest = rest_state(model);
    const Spring spring = springs(dynamics, rest).back();
    for (const std::size_t i : {0u, 1u}) {
      State moved = rest;
      Workspace work = dynamics.workspace();
      moved.q[i] += 1e-6;
      dynamics.update(moved, work);
      const double more = dynamics.elongation(work, CableId{0});
      moved.q[i] -= 2e-6;
      dynamics.update(moved, work);
      BOOST_TEST(std::abs((more - dynamics.elongation(work, CableId{0})) / 2e-6 - spring.gradient[i]) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
