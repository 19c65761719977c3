/// Same input, same bits: in Debug and Release, with gcc and clang, on any machine. The fingerprints below are of the
/// final states of busy runs; a change that moves one must say in its commit why the physics allows it.
#define BOOST_TEST_MODULE same_bits
#include <bit>
#include <boost/test/unit_test.hpp>
#include <cstdint>

#include "solver/run/simulate.hpp"
#include "solver/scenes/pendulum.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"

using namespace talus;

namespace {

/// FNV-1a over the bits of a state's numbers.
std::uint64_t fingerprint(const State& state) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](double value) {
    for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), i = 0; i < 8; ++i, bits >>= 8) {
      hash = (hash ^ (bits & 0xFF)) * 1099511628211ULL;
    }
  };
  add(state.t);
  for (const double value : state.q)
    add(value);
  for (const double value : state.v)
    add(value);
  // What takes nothing adds nothing: a new mechanism of loss moves no fingerprint.
  for (const double value : state.work) {
    if (value != 0.0) add(value);
  }
  for (const double value : state.impulse)
    add(value);
  return hash;
}

std::uint64_t fingerprint_after(const Scene& scene, const char* integrator, double step, double end) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  State state = scene.initial;
  Integrator method = make_integrator(integrator);
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, end, end, true})));
  return fingerprint(state);
}

}  // namespace

BOOST_AUTO_TEST_CASE(busy_runs_keep_their_bits) {
  const LinearSpringDashpot law{1e5, 300.0, EndRule::clamped};
  const Scene column = scenes::pivoted_cylinder({.rock_radius = 1.5, .contact = law, .method = ContactMethod::nodes});
  const Scene cables = scenes::two_cable({.contact = law});
  const Scene swing = scenes::cable_pendulum({.amplitude = 1.0});
  BOOST_TEST(fingerprint_after(column, "central_difference", 1e-4, 0.6) == 15866185157683527678ULL);
  BOOST_TEST(fingerprint_after(column, "rk4", 1e-4, 0.6) == 11948236881650085091ULL);
  BOOST_TEST(fingerprint_after(cables, "velocity_verlet", 1e-4, 6.0) == 11486823219985779728ULL);
  BOOST_TEST(fingerprint_after(cables, "odeint_dopri5", 1e-3, 6.0) == 14574491308656528655ULL);
  BOOST_TEST(fingerprint_after(swing, "euler_cromer", 1e-3, 10.0) == 6521606193200252689ULL);
}
