/// Friction in motion, compared with the mechanics of a disc on a table and of a body on a slope.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

BOOST_AUTO_TEST_SUITE(friction_tests)

using namespace talus;

namespace {

constexpr double g = 9.81, radius = 0.1, stiffness = 2e6, mu = 0.3;

/// A disc or particle of mass 2 that presses on a table with its weight; gravity is tilted to represent a slope.
Model on_table(Mobility mobility, double slope, std::optional<CoulombFriction> friction) {
  ModelBuilder builder;
  builder.gravity({g * std::sin(slope), -g * std::cos(slope)});
  const BodyId table = builder.add(Body{.name = "table", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const double overlap = 2.0 * g * std::cos(slope) / stiffness;
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mobility = mobility,
                                       .mass = 2.0,
                                       .inertia = mobility == Mobility::free ? 0.01 : 0.0,
                                       .shape = Circle{radius},
                                       .p_WB = {0.0, radius - overlap}});
  builder.add(Contact{
      .name = "disc-table", .a = disc, .b = table, .law = LinearSpringDashpot{stiffness, 200.0}, .friction = friction});
  return builder.build();
}

struct Run {
  State state;
  double balance_error{};
};

Run run(const Model& model, Vec2 velocity, const char* integrator, double step, double end) {
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics};
  State state = rest_state(model);
  set_velocity(model, state, *find_body(model, "disc"), velocity, 0.0);
  system.begin(state);
  EnergyLedger ledger{dynamics, state};
  Integrator method = make_integrator(integrator);
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, end, end, true})));
  return {state, ledger.accounts(state).energy_balance_error};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sliding_disc_ends_rolling_at_two_thirds_of_its_speed) {
  // mu g t = v0 - v and mu g t = r w/2 until v = r w: v = 2/3 v0 whatever mu. The spring, stretched by mu m g/k_s when
  // the slip ends, then oscillates with the mass m/3 that the contact feels: slip rates of up to mu g sqrt(3 m/k_s) =
  // 0.0051 m/s, a third of it in the disc's velocity.
  const Model model = on_table(Mobility::free, 0.0, CoulombFriction{mu, stiffness});
  for (const char* integrator : {"velocity_verlet", "central_difference", "euler_cromer", "rk4", "odeint_dopri5"}) {
    const Run end = run(model, {3.0, 0.0}, integrator, 2e-5, 0.6);
    BOOST_TEST_CONTEXT(integrator) {
      BOOST_TEST(std::abs(end.state.v[0] - 2.0) < 1.8e-3);
      BOOST_TEST(std::abs(end.state.v[0] + radius * end.state.v[2]) < 5.2e-3);
      // A third of the energy is dissipated.
      const double lost = end.state.work[static_cast<std::size_t>(Mechanism::friction)];
      BOOST_TEST(std::abs(lost - 3.0) < 6e-3);
      BOOST_TEST(std::abs(end.balance_error) < 2e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(on_a_slope_it_slips_above_the_friction_angle_only) {
  const double steep = 0.5;  // tan = 0.546 > 0.3
  const Model slipping = on_table(Mobility::particle, steep, CoulombFriction{mu, stiffness});
  const Run down = run(slipping, {0.0, 0.0}, "velocity_verlet", 2e-5, 0.5);
  const double acceleration = g * (std::sin(steep) - mu * std::cos(steep));
  // Slip begins when the spring is stretched, after sqrt of a few 1e-5 s.
  BOOST_TEST(std::abs(down.state.v[0] - 0.5 * acceleration) < 5e-3 * acceleration);
  const double flat = 0.14;  // tan = 0.141, and twice that is still < 0.3
  const Model sticking = on_table(Mobility::particle, flat, CoulombFriction{mu, stiffness});
  const Run stays = run(sticking, {0.0, 0.0}, "velocity_verlet", 2e-5, 2.0);
  // It oscillates on the spring by up to twice its static stretch.
  BOOST_TEST(stays.state.q[0] <= 2.0 * 2.0 * g * std::sin(flat) / stiffness * 1.0001);
  BOOST_TEST(stays.state.work[static_cast<std::size_t>(Mechanism::friction)] == 0.0);
}

BOOST_AUTO_TEST_CASE(slides_the_other_way_alike) {
  const Model model = on_table(Mobility::free, 0.0, CoulombFriction{mu, stiffness});
  const Run right = run(model, {3.0, 0.0}, "velocity_verlet", 2e-5, 0.2);
  const Run left = run(model, {-3.0, 0.0}, "velocity_verlet", 2e-5, 0.2);
  BOOST_TEST(left.state.v[0] == -right.state.v[0]);
  BOOST_TEST(left.state.v[2] == -right.state.v[2]);
  BOOST_TEST(left.state.q[1] == right.state.q[1]);
}

/// A particle of mass 1 at distance `gap` above a plane, with contact stiffness 1 and tangential stiffness 1/4.
Model above_sticky_plane(double gap) {
  ModelBuilder builder;
  const BodyId table = builder.add(Body{.name = "table", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const BodyId disc = builder.add(Body{
      .name = "disc", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{1.0}, .p_WB = {0.0, 1.0 + gap}});
  builder.add(Contact{.name = "impact",
                      .a = disc,
                      .b = table,
                      .law = LinearSpringDashpot{1.0, 0.0},
                      .friction = CoulombFriction{1e9, 0.25}});
  return builder.build();
}

BOOST_AUTO_TEST_CASE(a_contact_that_sticks_from_the_touch_on_is_of_second_order) {
  // A particle that sticks oscillates along the plane, v = cos(w_t t) with w_t = sqrt(k_s/m) = 1/2 and t from the first
  // contact, wherever in a step that occurs; sampled half-way through the contact.
  for (const char* integrator : {"velocity_verlet", "central_difference", "rk4"}) {
    double errors[2]{};
    for (const int refined : {0, 1}) {
      const double step = 0.02 / (1 + refined);
      for (int phase = 0; phase < 16; ++phase) {
        const double gap = step * (phase + 0.5) / 16.0;
        const Run end = run(above_sticky_plane(gap), {1.0, -1.0}, integrator, step, 1.5);
        errors[refined] += std::pow(end.state.v[0] - std::cos(0.5 * (1.5 - gap)), 2);
      }
    }
    BOOST_TEST_CONTEXT(integrator) {
      BOOST_TEST(std::sqrt(errors[0] / 16.0) < 0.1 * 0.02 * 0.02);
      // 16 after one halving of the step, because errors are squared; without the slip of the first partial step it
      // would be 4.
      BOOST_TEST(errors[0] / errors[1] > 12.0);
      BOOST_TEST(errors[0] / errors[1] < 20.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_scene_that_starts_overlapped_and_closing_starts_with_an_unstretched_spring) {
  // Overlap 0.4, closing with speed 1: contact may have begun at overlap/rate = 0.4 earlier, but the scene does not
  // specify that. From the start v = cos(t/2) along the plane; a spring stretched by 0.4 would make it cos(t/2) - 0.2
  // sin(t/2).
  const Model model = above_sticky_plane(-0.4);
  const Dynamics dynamics{model};
  for (const std::string& integrator : integrator_names()) {
    if (needs_closed_form(integrator)) continue;  // friction has none
    RigidBodySystem system{dynamics};
    State state = rest_state(model);
    set_velocity(model, state, *find_body(model, "disc"), {1.0, -1.0}, 0.0);
    const State given = state;
    Integrator method = make_integrator(integrator, needs_tolerance(integrator) ? 1e-9 : 0.0);
    const double step = 0.005;
    double first_stretch = 1.0, energy = 0.0;
    const Observer observers[] = {[&](const State& seen, const StepInfo& info) {
      if (info.step > 0) return;
      first_stretch = seen.z.front();
      Workspace work = dynamics.workspace();
      dynamics.update(seen, work);
      energy = dynamics.energies(seen, work).total();
    }};
    BOOST_TEST_CONTEXT(integrator) {
      BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, 1.0, 1.0, true}, observers)));
      BOOST_TEST(first_stretch == 0.0);
      BOOST_TEST(energy == 1.0 + 0.5 * 0.4 * 0.4, boost::test_tools::tolerance(1e-15));
      // Second order: about (h/2)^2 = 6e-6. First order: half a step's change of the speed, h/4 sin(1/2) = 6e-4. A
      // stretch of 0.4 would cause 0.096.
      BOOST_TEST(std::abs(state.v[0] - std::cos(0.5)) < (order(method) == 1 ? 6.1e-4 : 6e-6));
    }
    // A second call of begin() changes nothing.
    State once = given, twice = given;
    system.begin(once);
    system.begin(twice);
    system.begin(twice);
    BOOST_TEST((once == twice));
  }
}

BOOST_AUTO_TEST_CASE(a_smooth_contact_keeps_no_memory) {
  const Model smooth = on_table(Mobility::free, 0.0, {});
  BOOST_TEST(rest_state(smooth).z.empty());
  BOOST_TEST(!Dynamics{smooth}.follows_motion());
  const Model rough = on_table(Mobility::free, 0.0, CoulombFriction{mu, stiffness});
  BOOST_TEST(rest_state(rough).z.size() == 1u);
  // Friction with a coefficient of zero is the smooth contact.
  const Model none = on_table(Mobility::free, 0.0, CoulombFriction{0.0, stiffness});
  const Run a = run(smooth, {3.0, 0.0}, "rk4", 2e-5, 0.02), b = run(none, {3.0, 0.0}, "rk4", 2e-5, 0.02);
  BOOST_TEST(a.state.q == b.state.q, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
