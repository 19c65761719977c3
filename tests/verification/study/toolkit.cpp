#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/runs/recorded_run.hpp"
#include "verification/study/toolkit.hpp"

BOOST_AUTO_TEST_SUITE(toolkit_tests)

using namespace talus;
using namespace talus::verification;
using namespace talus::verification::problems;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Scene bounce() {
  return scenes::bouncing_disc({.radius = 1.0, .gap = 0.25, .speed = 1.0, .contact = LinearSpringDashpot{64.0, 0.0}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(phases_have_offset_steps_and_even_onsets) {
  const auto phases = offset_phases(2.0, 100.0);
  BOOST_TEST_REQUIRE(phases.size() == fewest_phases);
  for (const Phase& phase : phases) {
    BOOST_TEST(phase.step == offset_step(2.0, 100.0, phase.index));
    BOOST_TEST(phase.onset == even_phases(fewest_phases)[phase.index]);
    BOOST_TEST(phase.lead() == phase.onset * phase.step);
  }
  for (const Phase& phase : offset_phases(2.0, 100.0, 3, true))
    BOOST_TEST(phase.step == 0.02);
  const PhaseError error = phase_error(2.0, 100.0, [](const Phase& phase) { return phase.index == 5 ? -3.0 : 0.0; });
  BOOST_TEST(error.count() == fewest_phases);
  BOOST_TEST(error.max() == 3.0);
}

BOOST_AUTO_TEST_CASE(errors_stand_beside_their_predictions) {
  const PredictedErrors errors = predicted_errors({0.5, 0.25}, [](double h) { return std::array{h, 3.0 * h, h * h}; });
  BOOST_TEST(errors.last_ratio() == 0.75 / 0.0625);
  BOOST_TEST(errors.found().errors()[0] == 1.5);
  BOOST_TEST(errors.points("solver").y[1] == 0.75);
  BOOST_TEST((errors.points("solver").style == Style::points));
  BOOST_TEST(errors.line().y[1] == 0.0625);
  BOOST_TEST(errors.line().x[1] == 0.25);
  BOOST_TEST((errors.line().style == Style::lines));
  const Convergence found = convergence({4.0, 8.0}, [](double n) { return std::pair{1.0 / n, 1.0 / (n * n)}; });
  BOOST_TEST(found.fit().order == 2.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_worst_keeps_its_sign_and_a_nan_stays) {
  double worst = 0.0;
  for (const double error : {1.0, -3.0, 2.0})
    keep_worst(worst, error);
  BOOST_TEST(worst == -3.0);
  for (const double error : {not_a_number, 4.0})
    keep_worst(worst, error);
  BOOST_TEST(std::isnan(worst));
  BOOST_TEST(worst_error({1.0, 2.5, 3.0}, {1.0, 2.0, 3.25}) == 0.5);
  BOOST_TEST(std::isnan(worst_error({1.0}, {1.0, 2.0})));
  BOOST_TEST(std::isnan(worst_error({1.0, 2.0}, {1.0})));
  BOOST_TEST(worst_of({0.5, -2.0, 1.0}) == -2.0);
  BOOST_TEST(std::isnan(worst_of({1.0, not_a_number, 2.0})));
  BOOST_TEST(worst_ratio(1.1, 0.8) == 0.8);
  BOOST_TEST(worst_ratio(0.8, 1.1) == 0.8);
  BOOST_TEST(std::isnan(worst_ratio(1.1, not_a_number)));
  BOOST_TEST(std::isnan(worst_ratio(not_a_number, 1.1)));
}

BOOST_AUTO_TEST_CASE(the_largest_is_a_magnitude_and_a_nan_stays) {
  double largest = 0.0;
  for (const double error : {-2.0, 1.0})
    keep_largest(largest, error);
  BOOST_TEST(largest == 2.0);
  keep_largest(largest, not_a_number);
  keep_largest(largest, 3.0);
  BOOST_TEST(std::isnan(largest));
}

BOOST_AUTO_TEST_CASE(the_smallest_has_its_sign_and_a_nan_stays) {
  double smallest = 1.0;
  for (const double value : {3.0, -2.0, -1.0})
    keep_smallest(smallest, value);
  BOOST_TEST(smallest == -2.0);
  keep_smallest(smallest, not_a_number);
  keep_smallest(smallest, -3.0);
  BOOST_TEST(std::isnan(smallest));
}

BOOST_AUTO_TEST_CASE(a_row_has_the_cells_of_its_format) {
  using Cells = std::vector<std::string>;
  BOOST_TEST((cells("{} | {:.2f} | {}", "disc", 0.125, 3) == Cells{"disc", "0.12", "3"}));
  BOOST_TEST((cells("{} |  | {}", "", 'c') == Cells{"", "", "c"}));
  BOOST_TEST((cells("one cell") == Cells{"one cell"}));
}

BOOST_AUTO_TEST_CASE(a_scene_builder_adds_parts_as_their_members_say) {
  SceneBuilder builder;
  builder.gravity({0.0, -2.0});
  const BodyId wall = builder.add_fixed("wall", HalfPlane{}, {0.0, -1.0}, 0.5);
  const BodyId disc = builder.add_free("disc", 2.0, 0.25, Circle{0.5}, {3.0, 1.0}, 0.125);
  const BodyId bob = builder.add_particle("bob", 3.0, {4.0, 2.0});
  builder.add_contact("touch", wall, disc, LinearSpringDashpot{64.0, 1.0}, CoulombFriction{0.5, 32.0});
  builder.add_cable("cable", {disc, {}}, {bob, {}}, 1.5, TensionOnly{10.0, 0.0});
  const Scene scene = builder.at_rest("Parts");
  ModelBuilder plain;
  plain.gravity({0.0, -2.0});
  plain.add(Body{.name = "wall", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = {0.0, -1.0}, .angle = 0.5});
  plain.add(
      Body{.name = "disc", .mass = 2.0, .inertia = 0.25, .shape = Circle{0.5}, .p_WB = {3.0, 1.0}, .angle = 0.125});
  plain.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 3.0, .p_WB = {4.0, 2.0}});
  plain.add(Contact{.name = "touch",
                    .a = wall,
                    .b = disc,
                    .law = LinearSpringDashpot{64.0, 1.0},
                    .friction = CoulombFriction{0.5, 32.0}});
  plain.add(Cable{.name = "cable", .a = {disc, {}}, .b = {bob, {}}, .rest_length = 1.5, .law = TensionOnly{10.0, 0.0}});
  BOOST_TEST(scene.title == "Parts");
  const Model model = plain.build();
  BOOST_TEST(scene.initial.q == rest_state(model).q, boost::test_tools::per_element());
  const Dynamics of_scene{scene.model}, of_plain{model};
  State state = rest_state(model);
  state.q[0] -= 0.25;
  RigidBodySystem one{of_scene}, other{of_plain};
  State a = state, b = state;
  one.begin(a), other.begin(b);
  Rates rates_a{a}, rates_b{b};
  one.evaluate(a, rates_a), other.evaluate(b, rates_b);
  BOOST_TEST(rates_a.v == rates_b.v, boost::test_tools::per_element());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    BOOST_TEST(scene.model.bodies[i].name == model.bodies[i].name);
    BOOST_TEST((scene.model.bodies[i].mobility == model.bodies[i].mobility));
    BOOST_TEST(scene.model.bodies[i].mass == model.bodies[i].mass);
    BOOST_TEST(scene.model.bodies[i].inertia == model.bodies[i].inertia);
    BOOST_TEST(scene.model.bodies[i].angle == model.bodies[i].angle);
  }
  BOOST_TEST(scene.model.contacts[0].friction.has_value());
}

BOOST_AUTO_TEST_CASE(each_component_is_compared_by_one_check) {
  Findings findings;
  const Tolerance tolerance = Tolerance::model(0.1, "chosen");
  BOOST_TEST(expect_each(findings, "near", {1.0, 2.05}, {1.0, 2.0}, tolerance));
  BOOST_TEST(!expect_each(findings, "far", {0.5, 2.0}, {1.0, 2.0}, tolerance));
  BOOST_TEST(!expect_each(findings, "more", {1.0, 2.0, 3.0}, {1.0, 2.0}, tolerance));
  BOOST_TEST(!expect_each(findings, "none", {not_a_number, 2.0}, {1.0, 2.0}, tolerance));
  BOOST_TEST(findings.find("far")->measured == -0.5);
}

BOOST_AUTO_TEST_CASE(a_constant_must_be_approached_by_the_next_power) {
  Findings findings;
  const Convergence right{{0.1, 0.05}, {0.1 * 2.0 * 1.1, 0.05 * 2.0 * 1.05}};
  const Convergence wrong{{0.1, 0.05}, {0.1 * 2.2, 0.05 * 2.2}};
  expect_constant(findings, "right", right, 2.0, 1, 1, 1e-9);
  expect_constant(findings, "wrong", wrong, 2.0, 1, 1, 1e-9);
  BOOST_TEST(findings.find("error over its prediction, right")->pass);
  BOOST_TEST(!findings.find("error over its prediction, wrong")->pass);
}

BOOST_AUTO_TEST_CASE(curves_have_the_values_of_their_functions) {
  const Series line = curve("square", multiples(0.5, 0, 4), [](double x) { return x * x; });
  BOOST_TEST(line.x.size() == 5u);
  BOOST_TEST(line.y.back() == 4.0);
  BOOST_TEST((line.style == Style::lines));
  BOOST_TEST((points("solver", {1.0}, {2.0}).style == Style::points));
  BOOST_TEST((as_line(points("exact", {1.0}, {2.0})).style == Style::lines));
}

BOOST_AUTO_TEST_CASE(a_run_counts_its_evaluations_and_is_seen_at_every_step) {
  Findings findings;
  std::vector<double> times;
  const RunEnd end = run_steps(bounce(), VelocityVerlet{}, 0.01, 50, findings,
                               [&](const State& state, const StepInfo&) { times.push_back(state.t); });
  BOOST_TEST(end.finished);
  BOOST_TEST(end.state.t == 0.5);
  BOOST_TEST(times.size() == 51u);
  BOOST_TEST(findings.evaluations() == static_cast<std::uint64_t>(end.evaluations));
  BOOST_TEST(end.evaluations >= 50);
  const RunEnd stopped = run_scene(bounce(), VelocityVerlet{}, {0.01, 5.0, 5.0, false}, findings, {},
                                   [](const State& state) { return state.t > 0.095; });
  BOOST_TEST(stopped.finished);
  BOOST_TEST(stopped.state.t == 0.1, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_run_that_diverges_ends_as_nan) {
  // A step far beyond the stability limit: coordinates overflow.
  const RunEnd end = run_steps(scenes::pendulum({.amplitude = 0.5}), make_integrator("euler"), 1e200, 10);
  BOOST_TEST(!end.finished);
  for (const double number : {end.state.q[0], end.state.v[0]})
    BOOST_TEST(std::isnan(number));
}

BOOST_AUTO_TEST_CASE(a_probe_sees_overlaps_and_forces) {
  const Scene scene = bounce();
  State state = scene.initial;
  state.q[1] = 0.75;
  Probe probe{scene.model};
  state.mode[0] = UnilateralSpring::acting;
  probe.evaluate(state);
  BOOST_TEST(probe.overlap(0) == 0.25);
  BOOST_TEST(probe.forces().contacts[0] == 16.0);
}

BOOST_AUTO_TEST_CASE(a_ledger_and_a_recorded_run_balance_the_energy) {
  Scene scene = bounce();
  scene.integrator = VelocityVerlet{};
  scene.plan = {0.001, 1.0, 0.1, true};
  Findings findings;
  long seen = 0;
  const RecordedRun run{scene, findings, [&](const State&, const StepInfo&) { ++seen; }};
  BOOST_TEST(seen == 1001);
  RunLedger ledger{scene.model, first_state(scene)};
  const Accounts accounts = ledger(run.end().state);
  BOOST_TEST(accounts.energy_balance_error == run.recorder().accounts().energy_balance_error);
  BOOST_TEST(std::abs(accounts.energy_balance_error) < 1e-4);
  const Quantity speed = quantity_named(scene.model, "disc.vy.end");
  BOOST_TEST(run.value(speed) == run.end().state.v[1]);
}

BOOST_AUTO_TEST_CASE(options_are_given_but_for_the_one_that_a_fault_leaves_out) {
  const Options options{{"--grid", {}}, {"--x-limits", {"0", "1"}}};
  using Arguments = std::vector<std::string>;
  BOOST_TEST((with_options({"plot"}, options, {}) == Arguments{"plot", "--grid", "--x-limits", "0", "1"}));
  BOOST_TEST((with_options({"plot"}, options, {.fault = "without_x_limits"}) == Arguments{"plot", "--grid"}));
}

BOOST_AUTO_TEST_CASE(differences_are_named_and_none_need_a_comparison) {
  Findings findings;
  problems::Differences one, equal;
  const problems::Differences none;
  one.compare("grid", 1, 1), one.compare("title", std::string{"a"}, std::string{"b"}), equal.compare("grid", 1, 1);
  one.expect_none(findings, "one", "why"), equal.expect_none(findings, "equal", "why");
  none.expect_none(findings, "none", "why");
  BOOST_TEST(!findings.find("one")->pass);
  BOOST_TEST(findings.find("one")->measured == 1.0);
  BOOST_TEST(findings.find("one")->why == "2 comparisons: why. Differing: title");
  BOOST_TEST(findings.find("equal")->pass);
  BOOST_TEST(!findings.find("none")->pass);
}

BOOST_AUTO_TEST_SUITE_END()
