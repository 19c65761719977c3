/// Hangers that break: the bodies that fall, the cables afterwards, and the recorded energy.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/failure_log.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

BOOST_AUTO_TEST_SUITE(hangers_tests)

using namespace talus;

namespace {

/// Masses in a row on one cable between two anchors, 2 apart along z (the along-fence direction): all hang at x = 0,
/// the second one lower, so that the cables pull on it from the start. Each is held by a hanger with its own strength.
Model row(const std::vector<double>& strengths, double of_second_cable = 1e300, double gravity = 10.0) {
  ModelBuilder builder;
  builder.gravity({0.0, -gravity});
  std::vector<CableEnd> ends{{std::nullopt, {0.0, 0.0, 0.0}}};
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const BodyId body = builder.add(
        Body{.name = "mass" + std::to_string(i), .mass = 1.0, .inertia = 0.1, .p_WB = {0.0, i == 1 ? -1.2 : -1.0}});
    ends.push_back({body, {0.0, 0.5, 2.0 * (static_cast<double>(i) + 1.0)}});
  }
  ends.push_back({std::nullopt, {0.0, 0.0, 2.0 * (static_cast<double>(strengths.size()) + 1.0)}});
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    builder.add(Cable{.name = "cable" + std::to_string(i),
                      .a = ends[i],
                      .b = ends[i + 1],
                      .rest_length = 1.9,
                      .law = ElasticPlastic{.stiffness = 1000.0 * (1.0 + static_cast<double>(i)),
                                            .strength = i == 1 ? of_second_cable : 1e300}});
  }
  for (std::size_t i = 0; i < strengths.size(); ++i)
    builder.add(Hanger{"hanger" + std::to_string(i), *ends[i + 1].body, ends[i + 1].p, strengths[i]});
  return builder.build();
}

struct Run {
  State state;
  double balance_error{};
  double scale{};
  std::vector<Failure> failures;
};

Run run(const Model& model, double step, double end, const char* integrator = "velocity_verlet") {
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics};
  State state = rest_state(model);
  system.begin(state);
  EnergyLedger ledger{dynamics, state};
  FailureLog failures{dynamics};
  Integrator method = make_integrator(integrator);
  const Observer observers[] = {[&](const State& seen, const StepInfo& info) { failures(seen, info); }};
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {step, end, end, true}, observers)));
  const double balance_error = ledger.accounts(state).energy_balance_error;
  return {state, balance_error, ledger.energy_scale(), failures.failures()};
}

constexpr double strong = 1e9;

}  // namespace

BOOST_AUTO_TEST_CASE(holds_below_its_strength) {
  const Model held = row({strong, strong, strong});
  const Run end = run(held, 1e-4, 0.5);
  BOOST_TEST(end.failures.empty());
}

BOOST_AUTO_TEST_CASE(what_lost_its_hanger_falls_freely) {
  const Model model = row({strong, 1.0, strong});
  const Run end = run(model, 1e-4, 0.25);
  BOOST_TEST_REQUIRE(end.failures.size() == 1u);
  BOOST_TEST(end.failures[0].part == "hanger 'hanger1'");
  BOOST_TEST(end.failures[0].time == 0.0);
  const std::size_t y = 4;  // mass1.y
  BOOST_TEST(std::abs(end.state.v[y] + 10.0 * 0.25) < 1e-12);
  BOOST_TEST(std::abs(end.state.q[y] - (-1.2 - 0.5 * 10.0 * 0.25 * 0.25)) < 1e-12);
  BOOST_TEST(std::abs(end.balance_error) < 1e-4 * end.scale);
}

BOOST_AUTO_TEST_CASE(two_cables_go_on_as_one_with_one_tension) {
  // The same row without the middle mass, whose cables 1 and 2 of stiffness 2000 and 3000 are replaced by one of 1200.
  const Model broken = row({strong, 1.0, strong});
  ModelBuilder builder;
  builder.gravity({0.0, -10.0});
  std::vector<CableEnd> ends{{std::nullopt, {0.0, 0.0, 0.0}}};
  for (const double z : {2.0, 6.0}) {
    const BodyId body = builder.add(
        Body{.name = "mass" + std::to_string(ends.size()), .mass = 1.0, .inertia = 0.1, .p_WB = {0.0, -1.0}});
    ends.push_back({body, {0.0, 0.5, z}});
  }
  ends.push_back({std::nullopt, {0.0, 0.0, 8.0}});
  const double rest[] = {1.9, 3.8, 1.9}, stiffness[] = {1000.0, 1200.0, 4000.0};
  for (std::size_t i = 0; i < 3; ++i) {
    builder.add(Cable{.name = "cable" + std::to_string(i),
                      .a = ends[i],
                      .b = ends[i + 1],
                      .rest_length = rest[i],
                      .law = ElasticPlastic{.stiffness = stiffness[i]}});
  }
  const Run a = run(broken, 1e-4, 0.5), b = run(builder.build(), 1e-4, 0.5);
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(std::abs(a.state.q[i] - b.state.q[i]) < 1e-10);
    BOOST_TEST(std::abs(a.state.q[6 + i] - b.state.q[3 + i]) < 1e-10);
  }
  const Dynamics dynamics{broken};
  Workspace work = dynamics.workspace();
  dynamics.update(a.state, work);
  LawForces forces;
  dynamics.forces(a.state, work, forces);
  BOOST_TEST(forces.tensions[1] == forces.tensions[2], boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_chain_runs_through_several_broken_hangers) {
  // No hanger holds, but all cables do: the result is the bare cable, straight and without load.
  const Model model = row({1.0, 1.0, 1.0});
  const Run end = run(model, 1e-4, 0.25);
  BOOST_TEST(end.failures.size() == 3u);
  for (const std::size_t y : {1u, 4u, 7u})
    BOOST_TEST(end.state.v[y] <= -10.0 * 0.25 * 0.5);
  BOOST_TEST(std::abs(end.balance_error) < 1e-4 * end.scale);
}

BOOST_AUTO_TEST_CASE(energy_lost_by_straightening_is_recorded) {
  const Model model = row({strong, 70.0, strong});
  const Run end = run(model, 1e-5, 1.0);
  BOOST_TEST_REQUIRE(end.failures.size() == 1u);
  BOOST_TEST(end.failures[0].time > 0.0);
  BOOST_TEST(end.state.work[static_cast<std::size_t>(Mechanism::hanger_break)] > 0.0);
  BOOST_TEST(std::abs(end.balance_error) < 1e-4 * end.scale);
}

BOOST_AUTO_TEST_CASE(energy_is_recorded_once_when_a_cable_breaks_with_its_hanger) {
  // Cables 1 and 2, stretched from 1.9 to sqrt(4.04), become one with tension (4 - 3.8) 1200 = 240 between masses that
  // have not moved: more than 230. All of their stored energy is lost.
  const Model model = row({strong, 1.0, strong}, 230.0);
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics};
  State state = rest_state(model);
  system.begin(state);
  const double stretch = std::sqrt(4.04) - 1.9;
  const double lost = state.work[static_cast<std::size_t>(Mechanism::hanger_break)] +
                      state.work[static_cast<std::size_t>(Mechanism::cable_break)];
  BOOST_TEST(lost == 0.5 * 5000.0 * stretch * stretch, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_cable_that_breaks_in_a_chain_lets_all_of_it_go) {
  // 240 is below the strength at first; as the outer masses rise unequally the chain is stretched further.
  const Model model = row({strong, 1.0, strong}, 240.5);
  const Run end = run(model, 1e-5, 1.0);
  BOOST_TEST_REQUIRE(end.failures.size() == 2u);
  BOOST_TEST(end.failures[1].part == "cable 'cable1'");
  BOOST_TEST(end.failures[1].time > 0.0);
  BOOST_TEST(std::abs(end.balance_error) < 2e-4 * end.scale);
}

BOOST_AUTO_TEST_CASE(a_single_cable_is_let_go) {
  ModelBuilder builder;
  builder.gravity({0.0, -10.0});
  const BodyId body = builder.add(Body{.name = "mass", .mass = 1.0, .inertia = 0.1, .p_WB = {0.0, -1.0}});
  const CableEnd end{body, {0.0, 0.5, 0.0}};
  builder.add(Cable{.name = "stay",
                    .a = {std::nullopt, {0.0, 0.0, 0.0}},
                    .b = end,
                    .rest_length = 0.45,
                    .law = ElasticPlastic{.stiffness = 400.0}});
  builder.add(Hanger{"hanger", body, end.p, 15.0});
  const Run run_end = run(builder.build(), 1e-5, 0.3);
  BOOST_TEST_REQUIRE(run_end.failures.size() == 1u);
  // The cable pulls with 400 x 0.05 = 20 > 15: the hanger breaks at the start, the mass falls, and k e^2/2 = 0.5 is
  // lost.
  BOOST_TEST(std::abs(run_end.state.v[1] + 3.0) < 1e-12);
  BOOST_TEST(run_end.state.work[static_cast<std::size_t>(Mechanism::hanger_break)] == 0.5,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_point_has_one_hanger_and_two_cables) {
  ModelBuilder builder;
  const BodyId body = builder.add(Body{.name = "mass", .mass = 1.0, .inertia = 0.1, .p_WB = {0.0, -1.0}});
  const auto stay = [&](const char* name, double x) {
    builder.add(
        Cable{.name = name, .a = {std::nullopt, {x, 0.0, 0.0}}, .b = {body, {0.0, 0.5, 0.0}}, .law = TensionOnly{1.0}});
  };
  stay("one", 0.0);
  builder.add(Hanger{"first", body, {0.0, 0.5, 0.0}, 1.0});
  BOOST_CHECK_THROW(builder.add(Hanger{"second", body, {0.0, 0.5, 0.0}, 1.0}), InputError);
  stay("two", 1.0);
  BOOST_CHECK_NO_THROW(static_cast<void>(builder.build()));
  stay("three", 2.0);
  BOOST_CHECK_THROW(static_cast<void>(builder.build()), InputError);
}

BOOST_AUTO_TEST_CASE(wrong_hangers_are_refused) {
  ModelBuilder builder;
  const BodyId body = builder.add(Body{.name = "mass", .mass = 1.0, .inertia = 0.1, .p_WB = {0.0, -1.0}});
  BOOST_CHECK_THROW(builder.add(Hanger{"none", body, {0.0, 0.5, 0.0}, 1.0}), InputError);
  builder.add(Cable{.name = "stay", .a = {std::nullopt, {}}, .b = {body, {0.0, 0.5, 0.0}}, .law = TensionOnly{1.0}});
  BOOST_CHECK_THROW(builder.add(Hanger{"weak", body, {0.0, 0.5, 0.0}, 0.0}), InputError);
  builder.add(Cable{.name = "stiff",
                    .a = {std::nullopt, {1.0, 0.0, 0.0}},
                    .b = {body, {0.0, 0.5, 0.0}},
                    .law = ElasticPlastic{.stiffness = 2.0}});
  BOOST_CHECK_THROW(builder.add(Hanger{"mixed", body, {0.0, 0.5, 0.0}, 1.0}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
