/// Properties stated by the docstrings of single methods, beyond the contract of all (every_integrator.cpp).
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "tests/solver/integrate/smooth_systems.hpp"

BOOST_AUTO_TEST_SUITE(methods_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(symmetric_methods_run_backwards) {
  // In undamped motion each method with -h is its own inverse: only rounding remains after 1000 steps there and back.
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
  // x'' = -x for 100 periods of 100 steps; the logarithm of the energy's growth in a step.
  const double h = 2.0 * std::numbers::pi / 100.0;
  const auto exponent = [&](const char* known) {
    Integrator integrator = make_integrator(known);
    return std::visit(
        [&](auto& method) {
          Damped system{0.0};
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
  // The determinant of its map is 1 + h^2/2; the shape of its ellipse tilts the energy by h once, not in each step.
  BOOST_TEST(std::abs(exponent("taylor") - std::log1p(0.5 * h * h)) < h / 10000.0);
  BOOST_TEST(std::abs(exponent("blanes_moan4")) < 1e-6 / 10000.0);
}

BOOST_AUTO_TEST_CASE(linear_limits_have_their_closed_forms) {
  BOOST_TEST(*linear_limit("central_difference", 0.0) == 2.0);
  BOOST_TEST(*linear_limit("velocity_verlet", 0.1) == 2.0 * (std::sqrt(1.01) - 0.1));
  BOOST_TEST(*linear_limit("rk4", 0.0) == 2.0 * std::numbers::sqrt2, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(*linear_limit("rk4", 0.5) - 2.623) < 1e-3);
  BOOST_TEST(*linear_limit("euler", 0.0) == 0.0);
  BOOST_TEST(*linear_limit("taylor", 0.0) == 0.0);
  BOOST_TEST(!linear_limit("odeint_dopri5", 0.0).has_value());
  // A limit does not depend on those that were found before.
  const double undamped = *linear_limit("rk4", 0.0), damped = *linear_limit("rk4", 0.5);
  BOOST_TEST(damped != undamped);
  BOOST_TEST(*linear_limit("blanes_moan4", 0.5) != damped);
  BOOST_TEST(*linear_limit("rk4", 0.5) == damped);
  BOOST_TEST(*linear_limit("rk4", 0.0) == undamped);
}

BOOST_AUTO_TEST_CASE(dashpots_take_the_fourth_order_method_to_the_first) {
  // x'' = -x - 2 xi x' compared with its closed form: the effect that the docstring describes of velocities taken
  // before their kicks.
  const double t = 5.0, xi = 0.2, w = std::sqrt(1.0 - xi * xi), fade = std::exp(-xi * t);
  State exact = start();
  exact.q[0] = fade * (std::cos(w * t) + (0.25 + xi) / w * std::sin(w * t));
  exact.v[0] = fade * (0.25 * std::cos(w * t) - (1.0 + 0.25 * xi) / w * std::sin(w * t));
  const auto error_of = [&](const char* known, int steps) {
    Integrator integrator = make_integrator(known);
    return std::visit(
        [&](auto& method) {
          Damped system{xi};
          State state = start();
          method.start(system, state, t / steps);
          for (int i = 0; i < steps; ++i)
            method.step(system, state, t / steps);
          return error(state, exact);
        },
        integrator);
  };
  const double slope = std::log2(error_of("blanes_moan4", 200) / error_of("blanes_moan4", 400));
  BOOST_TEST(std::abs(slope - 1.0) < 0.05);  // the next power of a step of 0.0125
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

BOOST_AUTO_TEST_CASE(a_restored_method_with_located_events_has_known_orders_and_guards) {
  StormerCowell running;
  running.tolerance = 1e-9;
  Oscillator system;
  State state = start();
  running.start(system, state, 0.05);
  for (int i = 0; i < 20; ++i)
    running.step(system, state, 0.05);
  Archive saved;
  running.serialize(saved, state);
  const auto message = [&](const char* item, std::vector<double> value) {
    ArchiveItems items = saved.items();
    items.at(item) = std::move(value);
    Archive restoring{items};
    try {
      StormerCowell{}.serialize(restoring, state);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  for (const char* part : {"order", "used"}) {
    for (const double wrong : {0.0, 15.0}) {
      const std::string found = message(part, {wrong});
      BOOST_TEST(found.starts_with(fmt::format("{}: found {}; it must lie in [1, ", part, wrong)), found);
    }
  }
  BOOST_TEST(message("masked", {1.0}) == "guards: found 0, of which 1 may be masked; there must be 0");
}

BOOST_AUTO_TEST_SUITE_END()
