/// Same input, same bits: in Debug and Release, with gcc and clang, on any machine. The fingerprints below are of the
/// final states of busy runs; a change that moves one must say in its commit why the physics allows it.
#define BOOST_TEST_MODULE same_bits
#include <bit>
#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "solver/cell/cell_run.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "tests/solver/cell/cell_runs.hpp"

using namespace talus;

namespace {

/// FNV-1a over the bits of numbers.
class Fingerprint {
 public:
  void add(double value) {
    for (std::uint64_t bits = std::bit_cast<std::uint64_t>(value), i = 0; i < 8; ++i, bits >>= 8)
      hash_ = (hash_ ^ (bits & 0xFF)) * 1099511628211ULL;
  }
  void add(std::span<const double> values) {
    for (const double value : values)
      add(value);
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

std::uint64_t fingerprint(const State& state) {
  Fingerprint found;
  found.add(state.t);
  found.add(state.q), found.add(state.v);
  // What takes nothing adds nothing: a new mechanism of loss moves no fingerprint.
  for (const double value : state.work) {
    if (value != 0.0) found.add(value);
  }
  found.add(state.impulse);
  return found.hash();
}

std::uint64_t fingerprint_after(const Scene& scene, const std::string& integrator, double step, double end) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  State state = scene.initial;
  Integrator method = make_integrator(integrator, needs_tolerance(integrator) ? 1e-8 : 0.0);
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, end, end, true})));
  return fingerprint(state);
}

}  // namespace

BOOST_AUTO_TEST_CASE(busy_runs_keep_their_bits) {
  const LinearSpringDashpot law{1e5, 300.0, EndRule::clamped};
  const Scene cables = scenes::two_cable({.contact = law});
  const Scene swing = scenes::cable_pendulum({.amplitude = 1.0});
  BOOST_TEST(fingerprint_after(cables, "velocity_verlet", 1e-4, 6.0) == 11486823219985779728ULL);
  BOOST_TEST(fingerprint_after(cables, "odeint_dopri5", 1e-3, 6.0) == 14574491308656528655ULL);
  BOOST_TEST(fingerprint_after(swing, "euler_cromer", 1e-3, 10.0) == 6521606193200252689ULL);
}

/// Rows of columns and cables, two layers and many rocks: what packs of lanes compute.
BOOST_AUTO_TEST_CASE(fences_keep_their_bits) {
  const std::map<std::string, std::uint64_t> known{{"table_2", 10125187800089106335ULL},
                                                   {"appendix_nine_rocks", 11773401334372128861ULL}};
  for (const auto& [name, expected] : known) {
    const Scene scene = read_scene_file(TALUS_CASES "/fence/" + name + ".toml").scene;
    const std::uint64_t found =
        fingerprint_after(scene, std::string{talus::name(scene.integrator)}, scene.plan.step, scene.plan.end);
    BOOST_TEST(found == expected, "{\"" << name << "\", " << found << "ULL}");
  }
}

/// Each law of discs, smooth and rough.
BOOST_AUTO_TEST_CASE(cells_of_discs_keep_their_bits) {
  Fingerprint found;
  for (const ShearCell& cell : cells()) {
    CellRun cell_run{cell, plan(cell, 40.0)};
    const Discs discs = run(cell_run).discs();
    for (const std::vector<double>* const numbers : {&discs.x, &discs.y, &discs.vx, &discs.vy, &discs.spin})
      found.add(*numbers);
  }
  BOOST_TEST(found.hash() == 7093094268254931125ULL);
}

BOOST_AUTO_TEST_CASE(every_integrator_keeps_its_bits) {
  // All of them have one: a method that is new to the list is missed here.
  const std::map<std::string, std::uint64_t> known{
      {"central_difference", 15866185157683527678ULL},
      {"lagged_central_difference", 11291033050510010627ULL},
      {"velocity_verlet", 13240825129815983676ULL},
      {"euler_cromer", 17903864731287387547ULL},
      {"euler", 16014106991901968200ULL},
      {"taylor", 9083810516005533203ULL},
      {"rk4", 11948236881650085091ULL},
      {"blanes_moan4", 1912630844891909491ULL},
      {"odeint_dopri5", 9939422345637207075ULL},
      {"odeint_cash_karp54", 928000603784826100ULL},
      {"odeint_fehlberg78", 8057793489152338382ULL},
      {"odeint_abm8", 6454437596423483322ULL},
      {"odeint_bulirsch_stoer", 13360995008684920914ULL},
      {"stormer_cowell", 4460525110964388703ULL},
      {"exact", 15397057124451120078ULL},
  };
  const LinearSpringDashpot law{1e5, 300.0, EndRule::clamped};
  const Scene column = scenes::pivoted_cylinder({.rock_radius = 1.5, .contact = law, .method = ContactMethod::nodes});
  const Scene disc = scenes::bouncing_disc({.gap = 0.5, .gravity = 9.81, .contact = law});
  for (const std::string& name : integrator_names()) {
    const std::uint64_t found = fingerprint_after(needs_closed_form(name) ? disc : column, name, 1e-4, 0.6);
    const auto place = known.find(name);
    BOOST_TEST((place != known.end() && place->second == found), "{\"" << name << "\", " << found << "ULL},");
  }
}
