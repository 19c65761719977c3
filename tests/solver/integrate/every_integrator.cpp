/// The contract of an integrator (solver/integrate/concepts.hpp), tested over the closed list on a system of its own:
/// the order each one declares is measured here on smooth motion.
#define BOOST_TEST_MODULE every_integrator
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"

using namespace talus;

namespace {

/// x'' = -x^3, a spring that stiffens: smooth, nonlinear, with work that accounts for v^2/2 so that it must stay
/// constant.
struct Duffing {
  long evaluations{0};

  void drift(State& state, double h) { drift_coordinates(state, h); }
  void kick(State& state, double h) {
    Rates rates{state};
    derivative(state, rates);
    kick_velocities(state, rates, h);
  }
  void settle(State&) {}
  void derivative(const State& state, Rates& out) {
    ++evaluations;
    out.v[0] = -state.q[0] * state.q[0] * state.q[0];
    out.work[0] = out.v[0] * state.v[0];
    out.impulse[0] = out.v[0];
  }
  void evaluate(State& state, Rates& out) { derivative(state, out); }
};

/// x'' = -4 x - .3 x', with the loss as work and the force as impulse: motion in one linear piece.
struct Oscillator : Duffing {
  void derivative(const State& state, Rates& out) {
    ++evaluations;
    out.v[0] = -4.0 * state.q[0] - 0.3 * state.v[0];
    out.work[0] = 0.3 * state.v[0] * state.v[0];
    out.impulse[0] = out.v[0];
  }
  void kick(State& state, double h) {
    Rates rates{state};
    derivative(state, rates);
    kick_velocities(state, rates, h);
  }
  void evaluate(State& state, Rates& out) { derivative(state, out); }
  void affine_piece(const State&, AffinePiece& out) const { out.terms = {{0, 0, 4.0, 0.3}}; }
  bool keeps_accounts() const { return true; }
};

State start() {
  State state;
  state.q = {1.0};
  state.v = {0.25};
  return state;
}

struct End {
  State state;
  long evaluations{};
};

template <class System = Duffing>
End integrated(Integrator integrator, int steps, double duration) {
  return std::visit(
      [&](auto& method) {
        static_assert(IntegratorFor<std::decay_t<decltype(method)>, System>);
        System system;
        State state = start();
        const double h = duration / steps;
        method.start(system, state, h);
        for (int i = 0; i < steps; ++i)
          method.step(system, state, h);
        return End{State{synchronized(method, system, state, h)}, system.evaluations};
      },
      integrator);
}

/// Reference: the adapter's Fehlberg 7(8) under tight control; the methods under test share no formula with it but one,
/// which is tested by its own order between coarse steps far above the reference's error.
State reference(double duration) { return integrated(make_integrator("odeint_fehlberg78", 1e-14), 1, duration).state; }

/// Distance in phase space: a single coordinate's error may pass through zero and show any slope.
double error(const State& state, const State& exact) {
  return std::hypot(state.q[0] - exact.q[0], state.v[0] - exact.v[0]);
}

std::vector<Integrator> fixed_step_integrators() {
  std::vector<Integrator> made;
  for (const std::string& known : integrator_names()) {
    if (!needs_tolerance(known) && !needs_closed_form(known)) made.push_back(make_integrator(known));
  }
  return made;
}

}  // namespace

BOOST_AUTO_TEST_CASE(declared_order_is_measured) {
  const double duration = 5.0;
  const State exact = reference(duration);
  for (const Integrator& integrator : fixed_step_integrators()) {
    BOOST_TEST_CONTEXT(name(integrator)) {
      const int n = order(integrator) >= 8 ? 20 : 100;
      const double coarse = error(integrated(integrator, n, duration).state, exact);
      const double fine = error(integrated(integrator, 2 * n, duration).state, exact);
      const double slope = std::log2(coarse / fine);
      // Two points of a nonlinear motion: the next order's share of the error moves the slope by less than one.
      BOOST_TEST(slope > order(integrator) - 0.8);
      BOOST_TEST(slope < order(integrator) + 1.3);
    }
  }
}

BOOST_AUTO_TEST_CASE(work_advances_with_the_motion) {
  // d(work)/dt = a v integrates to v^2/2 by the same stages; at one order less or better, so a fine step shows
  // agreement.
  for (const Integrator& integrator : fixed_step_integrators()) {
    BOOST_TEST_CONTEXT(name(integrator)) {
      const End end = integrated(integrator, 4000, 5.0);
      const double gained = 0.5 * (end.state.v[0] * end.state.v[0] - 0.0625);
      // Leapfrog methods take the power with the velocity at the start of the kick: first order, h max|a|^2 t/2 = 3e-3;
      // the lagged one with that of a step before, three times as much.
      BOOST_TEST(std::abs(end.state.work[0] - gained) <
                 (name(integrator) == LaggedCentralDifference::name ? 9e-3 : 3e-3));
      BOOST_TEST(std::abs(end.state.impulse[0] - (end.state.v[0] - 0.25)) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(step_control_keeps_its_tolerance) {
  const State exact = reference(5.0);
  for (const char* known :
       {"odeint_dopri5", "odeint_cash_karp54", "odeint_fehlberg78", "odeint_bulirsch_stoer", "stormer_cowell"}) {
    BOOST_TEST_CONTEXT(known) {
      for (const double tolerance : {1e-6, 1e-9}) {
        const End end = integrated(make_integrator(known, tolerance), 5, 5.0);
        BOOST_TEST(error(end.state, exact) < 100.0 * tolerance);  // tens of steps, each within the tolerance
        BOOST_TEST(end.state.t == 5.0, boost::test_tools::tolerance(1e-15));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(linear_motion_is_exact) {
  // x = e^(-.15 t) (cos w t + (.25 + .15)/w sin w t), w^2 = 4 - .15^2; energy x'^2/2 + 2 x^2.
  const double t = 20.0, w = std::sqrt(4.0 - 0.0225), b = 0.4 / w, decay = std::exp(-0.15 * t);
  const double x = decay * (std::cos(w * t) + b * std::sin(w * t));
  const double v = decay * w * (b * std::cos(w * t) - std::sin(w * t)) - 0.15 * x;
  for (const int steps : {1, 7, 1000}) {
    // Times are summed here, each sum rounded by up to 2e-15.
    const double near = 1e-14 + 2e-15 * std::sqrt(steps);
    const End end = integrated<Oscillator>(make_integrator("exact"), steps, t);
    BOOST_TEST(std::abs(end.state.q[0] - x) < near);
    BOOST_TEST(std::abs(end.state.v[0] - v) < near);
    const double lost = 0.5 * (0.0625 - v * v) + 2.0 * (1.0 - x * x);
    BOOST_TEST(std::abs(end.state.work[0] - lost) < near);
    BOOST_TEST(std::abs(end.state.impulse[0] - (v - 0.25)) < near);
  }
}

BOOST_AUTO_TEST_CASE(evaluations_a_step_are_as_stated) {
  const auto evaluations = [](const char* known) { return integrated(make_integrator(known), 100, 1.0).evaluations; };
  BOOST_TEST(evaluations("central_difference") == 100);
  BOOST_TEST(evaluations("euler_cromer") == 100);
  BOOST_TEST(evaluations("velocity_verlet") == 101);
  BOOST_TEST(evaluations("euler") == 100);
  BOOST_TEST(evaluations("taylor") == 100);
  BOOST_TEST(evaluations("rk4") == 400);
  BOOST_TEST(evaluations("blanes_moan4") == 601);
}

BOOST_AUTO_TEST_CASE(same_input_same_bits) {
  for (const std::string& known : integrator_names()) {
    const Integrator integrator = make_integrator(known, needs_tolerance(known) ? 1e-9 : 0.0);
    BOOST_TEST(
        (integrated<Oscillator>(integrator, 50, 1.0).state == integrated<Oscillator>(integrator, 50, 1.0).state));
  }
}

BOOST_AUTO_TEST_CASE(a_copy_of_a_running_method_and_one_put_back_go_on_as_the_original) {
  for (const std::string& known : integrator_names()) {
    const Integrator integrator = make_integrator(known, needs_tolerance(known) ? 1e-9 : 0.0);
    BOOST_TEST_CONTEXT(name(integrator)) {
      // 3 steps: a multistep method is still being started.
      for (const int steps : {1, 3, 20}) {
        Integrator running = integrator;
        std::visit(
            [&]<class Method>(Method& method) {
              Oscillator system;
              State state = start();
              method.start(system, state, 0.05);
              for (int i = 0; i < steps; ++i)
                method.step(system, state, 0.05);
              Method copy = method;
              State twin = state, third = state;
              Memory saving;
              method.remember(saving, state);
              Method fresh = std::get<Method>(integrator);
              Memory putting_back{saving.items()};
              fresh.remember(putting_back, state);
              for (int i = 0; i < 10; ++i) {
                method.step(system, state, 0.05);
                copy.step(system, twin, 0.05);
                fresh.step(system, third, 0.05);
              }
              BOOST_TEST((state == twin));
              BOOST_TEST((state == third));
            },
            running);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(symmetric_methods_run_backwards) {
  // Undamped, each is its own inverse with -h: only rounding remains after 1000 steps there and back.
  for (const char* known : {"velocity_verlet", "blanes_moan4"}) {
    BOOST_TEST_CONTEXT(known) {
      Integrator integrator = make_integrator(known);
      std::visit(
          [](auto& method) {
            Duffing system;
            State state = start();
            method.start(system, state, 0.01);
            for (int i = 0; i < 1000; ++i)
              method.step(system, state, 0.01);
            for (int i = 0; i < 1000; ++i)
              method.step(system, state, -0.01);
            BOOST_TEST(state.q[0] == 1.0, boost::test_tools::tolerance(1e-12));
            BOOST_TEST(state.v[0] == 0.25, boost::test_tools::tolerance(1e-12));
          },
          integrator);
    }
  }
}

BOOST_AUTO_TEST_CASE(counter_examples_gain_energy_and_the_symplectic_method_does_not) {
  // x'' = -x for 100 swings of 100 steps, the logarithm of the energy's growth in a step.
  struct Linear : Duffing {
    void derivative(const State& state, Rates& out) { out.v[0] = -state.q[0]; }
    void evaluate(State& state, Rates& out) { derivative(state, out); }
  };
  const double h = 2.0 * std::numbers::pi / 100.0;
  const auto exponent = [&](const char* known) {
    Integrator integrator = make_integrator(known);
    return std::visit(
        [&](auto& method) {
          Linear system;
          State state = start();
          const auto energy = [&] { return state.q[0] * state.q[0] + state.v[0] * state.v[0]; };
          const double before = energy();
          method.start(system, state, h);
          for (int i = 0; i < 10000; ++i)
            method.step(system, state, h);
          return std::log(energy() / before) / 10000.0;
        },
        integrator);
  };
  BOOST_TEST(exponent("euler") == std::log1p(h * h), boost::test_tools::tolerance(1e-10));
  // Its map has the determinant 1 + h^2/2; the swing's form tilts the energy by h once, not in each step.
  BOOST_TEST(std::abs(exponent("taylor") - std::log1p(0.5 * h * h)) < h / 10000.0);
  BOOST_TEST(std::abs(exponent("blanes_moan4")) < 1e-6 / 10000.0);
}

BOOST_AUTO_TEST_CASE(dashpots_take_the_fourth_order_method_to_the_first) {
  // x'' = -x - 2 xi x' against its closed form: what the docstring says of velocities taken before their kicks.
  struct Damped : Duffing {
    void derivative(const State& state, Rates& out) { out.v[0] = -state.q[0] - 0.4 * state.v[0]; }
    void evaluate(State& state, Rates& out) { derivative(state, out); }
  };
  const double t = 5.0, xi = 0.2, w = std::sqrt(1.0 - xi * xi), fade = std::exp(-xi * t);
  State exact = start();
  exact.q[0] = fade * (std::cos(w * t) + (0.25 + xi) / w * std::sin(w * t));
  exact.v[0] = fade * (0.25 * std::cos(w * t) - (1.0 + 0.25 * xi) / w * std::sin(w * t));
  const auto error_of = [&](const char* known, int steps) {
    Integrator integrator = make_integrator(known);
    return std::visit(
        [&](auto& method) {
          Damped system;
          State state = start();
          method.start(system, state, t / steps);
          for (int i = 0; i < steps; ++i)
            method.step(system, state, t / steps);
          return error(state, exact);
        },
        integrator);
  };
  const double slope = std::log2(error_of("blanes_moan4", 200) / error_of("blanes_moan4", 400));
  BOOST_TEST(std::abs(slope - 1.0) < 0.05);  // the next power of a step of .0125
  const double equal_work = error_of("blanes_moan4", 200) / error_of("velocity_verlet", 1200);
  BOOST_TEST(equal_work > 1.5);
  BOOST_TEST(equal_work < 3.0);
}

BOOST_AUTO_TEST_CASE(central_difference_is_the_report_s_stagger) {
  CentralDifference method;
  Duffing system;
  State state = start();
  const double h = 0.125;
  method.start(system, state, h);
  BOOST_TEST(state.q[0] == 1.0 + 0.5 * h * 0.25);
  const double q = state.q[0];
  method.step(system, state, h);
  const double v = 0.25 + h * -(q * q * q);
  BOOST_TEST(state.v[0] == v);
  BOOST_TEST(state.q[0] == q + h * v);
  BOOST_TEST(synchronized(method, system, state, h).q[0] == q + h * v - 0.5 * h * v);
}

BOOST_AUTO_TEST_CASE(names_and_options_are_checked) {
  BOOST_CHECK_EXCEPTION(static_cast<void>(make_integrator("verlett")), InputError, [](const InputError& error) {
    return std::string{error.what()}.starts_with(
               "integrator 'verlett' is not known; nearest: velocity_verlet; known: ") ||
           std::string{error.what()}.starts_with("integrator 'verlett' is not known; nearest: ");
  });
  BOOST_CHECK_THROW(static_cast<void>(make_integrator("velocity_verlet", 1e-6)), InputError);
  BOOST_CHECK_THROW(static_cast<void>(make_integrator("odeint_abm8", 1e-6)), InputError);
  BOOST_CHECK_THROW(static_cast<void>(make_integrator("odeint_bulirsch_stoer")), InputError);
}
