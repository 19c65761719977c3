#include "solver/dynamics/dynamics.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/dynamics/springs.hpp"
#include "solver/model/model_builder.hpp"

BOOST_AUTO_TEST_SUITE(dynamics_tests)

using namespace talus;

namespace {

constexpr LinearSpringDashpot law{900.0, 3.0, EndRule::attractive};

/// One body of each mobility, cables to a body, to the world and along z, and contacts of each kind of geometry, all of
/// them closed.
Model crowded(ContactMethod method = ContactMethod::resultant) {
  ModelBuilder builder;
  builder.gravity({0.3, -9.81});
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mass = 2.0,
                                       .inertia = 0.7,
                                       .shape = Circle{1.0},
                                       .p_WB = {0.0, 0.9},
                                       .force = {1.0, 2.0},
                                       .moment = 0.5});
  const BodyId box = builder.add(
      Body{.name = "box", .mass = 3.0, .inertia = 1.1, .shape = Rectangle{0.8, 1.2}, .p_WB = {1.7, 1.0}, .angle = 0.1});
  const BodyId grain = builder.add(
      Body{.name = "grain", .mobility = Mobility::particle, .mass = 0.5, .shape = Circle{0.4}, .p_WB = {-1.3, 1.1}});
  const BodyId column = builder.add(Body{.name = "column",
                                         .mobility = Mobility::pinned,
                                         .mass = 4.0,
                                         .inertia = 5.0,
                                         .shape = Rectangle{0.5, 2.0},
                                         .p_WB = {3.0, 1.5},
                                         .angle = 0.2,
                                         .p_BPin = {0.1, 2.0}});
  const BodyId ground = builder.add(Body{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  int number = 0;
  for (const auto& [a, b] : {std::pair{disc, box}, {grain, disc}, {disc, ground}, {box, ground}, {box, column}}) {
    builder.add(Contact{.name = std::to_string(++number), .a = a, .b = b, .law = law, .method = method});
  }
  builder.add(Cable{.name = "tie",
                    .a = {disc, {0.2, 0.5, 0.0}},
                    .b = {column, {0.0, -1.0, 2.0}},
                    .rest_length = 1.0,
                    .law = TensionOnly{50.0, 1.0}});
  builder.add(Cable{.name = "stay",
                    .a = {box, {0.1, 1.0, 0.0}},
                    .b = {std::nullopt, {0.5, 6.0, 1.0}},
                    .rest_length = 2.0,
                    .law = TensionOnly{70.0, 0.5}});
  return builder.build();
}

State moving(const Model& model) {
  State state = rest_state(model);
  std::mt19937 random{42};
  std::uniform_real_distribution<double> speed{-1.0, 1.0};
  for (double& v : state.v)
    v = speed(random);
  return state;
}

struct Evaluation {
  State state;
  Workspace work;
  Rates rates;
};

Evaluation evaluate(const Dynamics& dynamics, State state) {
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  dynamics.update_modes(state, work);
  Rates rates{state};
  dynamics.rates(state, work, rates);
  return {state, work, rates};
}

double energy(const Dynamics& dynamics, const State& state) {
  Workspace work = dynamics.workspace();
  dynamics.update(state, work);
  return dynamics.energies(state, work).total();
}

/// The state advanced along its own motion by t, modes unchanged.
State moved(State state, const Rates& rates, double t) {
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    state.q[i] += t * (state.v[i] + 0.5 * t * rates.v[i]);
    state.v[i] += t * rates.v[i];
  }
  return state;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_contact_of_the_crowd_acts) {
  const Model model = crowded();
  const Dynamics dynamics{model};
  const Evaluation now = evaluate(dynamics, moving(model));
  const Layout& layout = dynamics.layout();
  std::size_t touching = 0;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const auto first = now.state.mode.begin() + static_cast<std::ptrdiff_t>(layout.contact_slots[c].mode);
    const auto acting = std::count(first, first + static_cast<std::ptrdiff_t>(layout.contact_instances[c]), Mode{1});
    BOOST_TEST(acting >= 1);
    touching += static_cast<std::size_t>(acting);
  }
  // Two of the four corners of the tilted box are above the ground, and one end of its side is separate from the
  // column.
  BOOST_TEST(touching == 6U);
  for (std::size_t c = 0; c < model.cables.size(); ++c)
    BOOST_TEST(now.state.mode[layout.cable_slots[c].mode] == 1);
}

BOOST_AUTO_TEST_CASE(calling_twice_gives_the_same_bits_and_changes_nothing) {
  const Model model = crowded();
  const Dynamics dynamics{model};
  Evaluation now = evaluate(dynamics, moving(model));
  const State before = now.state;
  Rates again{before};
  dynamics.rates(now.state, now.work, again);
  BOOST_TEST(again.v == now.rates.v);
  BOOST_TEST((now.state == before));
}

// Power balance: d(energy)/dt along the motion is minus the power of the dashpots. The terms of the ledger and the
// forces are computed by separate code; a wrong sign or factor of any force, potential or inertia breaks the balance.
BOOST_AUTO_TEST_CASE(energy_falls_by_the_dissipated_power) {
  for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
    const Model model = crowded(method);
    const Dynamics dynamics{model};
    const Evaluation now = evaluate(dynamics, moving(model));
    // Five-point difference: exact to fourth order in h, because the stiff contacts make the third derivative large
    // (1e6).
    const double h = 1e-5;
    const auto at = [&](double t) { return energy(dynamics, moved(now.state, now.rates, t)); };
    const double change = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
    double power = 0.0;
    for (const double part : now.rates.work)
      power += part;
    BOOST_TEST(power > 0.0);
    BOOST_TEST(std::abs(change + power) <
               1e-6);  // round-off of an energy of 1e3 over h: 1e-13/1e-5 = 1e-8, with a margin of 100
  }
}

// Rate of momentum compared with the recorded impulse from outside: they differ if a force has no reaction or a moment
// the wrong arm.
BOOST_AUTO_TEST_CASE(momentum_changes_by_the_impulse_from_outside) {
  const Model model = crowded();
  const Dynamics dynamics{model};
  const Evaluation now = evaluate(dynamics, moving(model));
  const double h = 1e-5;
  const auto momenta = [&](double t) {
    Workspace work = dynamics.workspace();
    dynamics.update(moved(now.state, now.rates, t), work);
    return dynamics.momenta(work);
  };
  const Momenta later = momenta(h), sooner = momenta(-h);
  BOOST_TEST(std::abs((later.linear.x - sooner.linear.x) / (2 * h) - now.rates.impulse[0]) < 1e-6);
  BOOST_TEST(std::abs((later.linear.y - sooner.linear.y) / (2 * h) - now.rates.impulse[1]) < 1e-6);
  BOOST_TEST(std::abs((later.angular - sooner.angular) / (2 * h) - now.rates.impulse[2]) < 1e-6);
}

BOOST_AUTO_TEST_CASE(spring_gradients_are_the_derivatives_of_their_extents) {
  const Model model = crowded();
  const Dynamics dynamics{model};
  const State state = moving(model);
  const auto found = springs(dynamics, state);
  const double h = 1e-6;
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    State up = state, down = state;
    up.q[i] += h, down.q[i] -= h;
    const auto above = springs(dynamics, up), below = springs(dynamics, down);
    for (std::size_t s = 0; s < found.size(); ++s) {
      BOOST_TEST(std::abs((above[s].deformation - below[s].deformation) / (2 * h) - found[s].gradient[i]) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(power_of_two_scaling_of_length_mass_and_time_is_exact) {
  // Lengths are scaled by 2^2, masses by 2^3, times by 2^-1; every parameter by its dimension. All results must be the
  // same bits, scaled.
  const auto build = [](int L, int M, int T) {
    const auto s = [](double value, int power) { return std::ldexp(value, power); };
    ModelBuilder builder;
    builder.gravity({0.0, s(-9.81, L - 2 * T)});
    const LinearSpringDashpot scaled{s(900.0, M - 2 * T), s(3.0, M - T), EndRule::clamped};
    const BodyId disc = builder.add(Body{.name = "disc",
                                         .mass = s(2.0, M),
                                         .inertia = s(0.7, M + 2 * L),
                                         .shape = Circle{s(1.0, L)},
                                         .p_WB = {s(0.1, L), s(1.03, L)}});
    const BodyId box = builder.add(Body{.name = "box",
                                        .mobility = Mobility::pinned,
                                        .mass = s(3.0, M),
                                        .inertia = s(1.1, M + 2 * L),
                                        .shape = Rectangle{s(0.8, L), s(1.2, L)},
                                        .p_WB = {s(1.95, L), s(1.0, L)},
                                        .angle = 0.1,
                                        .p_BPin = {0.0, s(1.2, L)}});
    const BodyId ground = builder.add(Body{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}});
    builder.add(Contact{.name = "a", .a = disc, .b = box, .law = scaled});
    builder.add(Contact{.name = "b", .a = disc, .b = ground, .law = scaled});
    builder.add(Cable{.name = "c",
                      .a = {disc, {}},
                      .b = {std::nullopt, {s(-1.0, L), s(2.0, L), s(0.5, L)}},
                      .rest_length = s(1.2, L),
                      .law = TensionOnly{s(40.0, M - 2 * T), 0.0}});
    return builder.build();
  };
  const auto run = [](const Model& model, int L, int T) {
    const Dynamics dynamics{model};
    RigidBodySystem system{dynamics};
    State state = rest_state(model);
    state.v = {std::ldexp(0.5, L - T), std::ldexp(-0.75, L - T), std::ldexp(0.25, -T), 0.0};
    for (int i = 0; i < 500; ++i) {
      system.kick(state, std::ldexp(0.001, T));
      system.drift(state, std::ldexp(0.001, T));
    }
    return state;
  };
  const int L = 2, M = 3, T = -1;
  const State plain = run(build(0, 0, 0), 0, 0);
  const State scaled = run(build(L, M, T), L, T);
  BOOST_TEST(scaled.q[0] == std::ldexp(plain.q[0], L));
  BOOST_TEST(scaled.q[1] == std::ldexp(plain.q[1], L));
  BOOST_TEST(scaled.q[2] == plain.q[2]);
  BOOST_TEST(scaled.q[3] == plain.q[3]);
  BOOST_TEST(scaled.v[1] == std::ldexp(plain.v[1], L - T));
  BOOST_TEST(scaled.work[0] == std::ldexp(plain.work[0], M + 2 * L - 2 * T));
  BOOST_TEST((scaled.mode == plain.mode));
}

BOOST_AUTO_TEST_CASE(mirror_image_moves_as_the_mirror_image) {
  const auto run = [](double side) {
    ModelBuilder builder;
    builder.gravity({0.0, -9.81});
    const BodyId disc = builder.add(
        Body{.name = "disc", .mass = 2.0, .inertia = 0.7, .shape = Circle{1.0}, .p_WB = {-side * 1.9, 0.3}});
    const BodyId box = builder.add(Body{.name = "box",
                                        .mobility = Mobility::pinned,
                                        .mass = 3.0,
                                        .inertia = 1.1,
                                        .shape = Rectangle{1.0, 2.0},
                                        .p_BPin = {0.0, 2.0}});
    builder.add(Contact{.name = "hit", .a = disc, .b = box, .law = LinearSpringDashpot{900.0, 3.0, EndRule::clamped}});
    const Model model = builder.build();
    const Dynamics dynamics{model};
    RigidBodySystem system{dynamics};
    State state = rest_state(model);
    state.v[0] = side * 1.5, state.v[2] = side * 0.5;
    for (int i = 0; i < 1000; ++i)
      system.kick(state, 1e-3), system.drift(state, 1e-3);
    return state;
  };
  const State right = run(1.0), left = run(-1.0);
  BOOST_TEST(left.q[0] == -right.q[0]);
  BOOST_TEST(left.q[1] == right.q[1]);
  BOOST_TEST(left.q[3] == -right.q[3]);
}

BOOST_AUTO_TEST_CASE(a_contact_pushes_whichever_way_round_its_pair_is_named) {
  for (const bool swapped : {false, true}) {
    ModelBuilder builder;
    const BodyId low = builder.add(Body{.name = "low", .mass = 1.0, .inertia = 1.0, .shape = Rectangle{1.0, 1.0}});
    const BodyId high =
        builder.add(Body{.name = "high", .mass = 1.0, .inertia = 1.0, .shape = Circle{1.0}, .p_WB = {0.0, 1.9}});
    builder.add(Contact{.name = "c", .a = swapped ? high : low, .b = swapped ? low : high, .law = law});
    const Model model = builder.build();
    const Dynamics dynamics{model};
    Evaluation now = evaluate(dynamics, rest_state(model));
    LawForces forces;
    dynamics.forces(now.state, now.work, forces);
    BOOST_TEST(forces.contacts[0] == 90.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(now.rates.v[4] == 90.0, boost::test_tools::tolerance(1e-12));  // the upper one moves up
    BOOST_TEST(dynamics.contact_depth(now.work, ContactId{0}) == 0.1, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(guards_show_which_modes_last) {
  const Model model = crowded();
  const Dynamics dynamics{model};
  Evaluation now = evaluate(dynamics, moving(model));
  std::vector<double> guards(now.state.mode.size());
  dynamics.guards(now.state, now.work, guards);
  for (const double guard : guards)
    BOOST_TEST(guard > 0.0);
  State open = now.state;
  open.mode.assign(open.mode.size(), Mode{0});
  dynamics.guards(open, now.work, guards);
  for (std::size_t mode = 0; mode < guards.size(); ++mode)
    BOOST_TEST((guards[mode] < 0.0) == (now.state.mode[mode] != 0));
}

BOOST_AUTO_TEST_CASE(a_guard_evaluated_alone_is_the_same_as_among_all) {
  for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
    Model model = crowded(method);
    for (Contact& contact : model.contacts)
      contact.friction = CoulombFriction{0.5, 300.0};
    model.hangers.push_back({"hook", model.cables[1].a.body.value(), model.cables[1].a.p, 40.0});
    const Dynamics dynamics{model};
    for (const double away : {0.0, 3.0, 50.0}) {
      State state = evaluate(dynamics, moving(model)).state;
      state.q[0] += away, state.q[3] -= away;
      RigidBodySystem system{dynamics};
      std::vector<double> all;
      system.guards(state, false, std::numeric_limits<double>::infinity(), all);
      for (std::size_t mode = 0; mode < all.size(); ++mode) {
        RigidBodySystem bare{dynamics};
        Rates rates{state};
        bare.derivative(moving(model), rates);  // its stored values belong to another state
        std::vector<double> alone(all.size(), std::numeric_limits<double>::quiet_NaN());
        bare.guards_of(state, std::array{mode}, alone);
        BOOST_TEST(alone[mode] == all[mode], "mode " << mode << " " << away << ": " << alone[mode] << " " << all[mode]);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
