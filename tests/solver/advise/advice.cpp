#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/advise/method_advice.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"

BOOST_AUTO_TEST_SUITE(advice_tests)

using namespace talus;

namespace {

/// A mass on a spring of frequency 1, without gravity, released at elongation 1: x = cos t to t = 10, largest tension
/// 1.
Scene oscillator() {
  ModelBuilder builder;
  const BodyId bob =
      builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {101.0, 0.0}});
  builder.add(Cable{
      .name = "bob", .a = {bob, {}}, .b = {std::nullopt, {}}, .rest_length = 100.0, .law = TensionOnly{1.0, 0.0}});
  Scene scene{.title = "oscillator", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.plan = {0.1, 1.5, 0.1, true};
  return scene;
}

Pilot pilot_of(const Scene& scene, const std::string& name, const RunMethod& method) {
  const Quantity quantity = quantity_named(scene.model, name);
  PilotRuns runs{scene, quantity, true};  // one of these scenes has overlaps beyond the limit of the run monitor
  return runs.run(method, 1'000'000);
}

}  // namespace

BOOST_AUTO_TEST_CASE(quantities_are_named_as_the_columns_of_the_history) {
  const Model model = oscillator().model;
  const std::vector<Column> columns = history_columns(model, true);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (columns[i].name.starts_with("balance_error.")) continue;
    const Quantity found = quantity_named(model, columns[i].name + ".max");
    BOOST_TEST(found.column == i);
    BOOST_TEST(found.ledger == (i >= history_columns(model, false).size()));
  }
  // A body and a cable of the same name.
  BOOST_TEST(quantity_named(model, "body.bob.x.end").column == quantity_named(model, "bob.x.end").column);
  BOOST_TEST(columns[quantity_named(model, "cable.bob.tension.min").column].name == "bob.tension");
  BOOST_TEST(quantity_named(model, "bob.vx.abs_max").of(-3.0, 2.0, 1.0) == 3.0);
  BOOST_TEST(quantity_named(model, "bob.vx.max").of(-3.0, 2.0, 1.0) == 2.0);
  BOOST_TEST(quantity_named(model, "bob.vx.min").of(-3.0, 2.0, 1.0) == -3.0);
  BOOST_TEST(quantity_named(model, "bob.vx.end").of(-3.0, 2.0, 1.0) == 1.0);
}

BOOST_AUTO_TEST_CASE(unknown_quantities_are_refused_by_name) {
  const Model model = oscillator().model;
  const auto says = [&](const char* name, const std::string& expected) {
    BOOST_CHECK_EXCEPTION((void)quantity_named(model, name), InputError, [&](const InputError& error) {
      return std::string{error.what()}.find(expected) != std::string::npos;
    });
  };
  says("bob", "found \"bob\"; it must be a column of the history and max, min, abs_max or end");
  says("cable.bob.tensio.max", "column 'cable.bob.tensio' is not known; nearest: cable.bob.tension; known: body.bob.x");
  says("bob.x", "found \"bob.x\"; it must end in .max, .min, .abs_max or .end, e.g. bob.x.max");
  says("body.bob.x", "found \"body.bob.x\"; it must end in .max, .min, .abs_max or .end, e.g. body.bob.x.max");
  says("bob.x.mean", "reduction 'mean' is not known; nearest: max; known: max, min, abs_max, end");
  says("balance_error.energy.max", "column 'balance_error.energy' is not known");
}

BOOST_AUTO_TEST_CASE(extremes_lie_between_the_steps_where_the_curve_is_smooth) {
  // sin t to t = 3, with its maximum at pi/2.
  Scene scene = oscillator();
  scene.plan.end = 3.0;
  scene.initial.q[0] = 100.0;
  scene.initial.v[0] = 1.0;
  const Pilot pilot = pilot_of(scene, "bob.elongation.max", {"stormer_cowell", 1e-13, 29});
  const double h = 3.0 / 29.0;
  BOOST_TEST(pilot.printed < 1.0 - 1e-5);
  // The parabola's error is at most that of the fourth derivative: h^4/128.
  BOOST_TEST(std::abs(pilot.between - 1.0) < h * h * h * h / 128.0);
  BOOST_TEST(pilot.values.size() == 30U);
}

BOOST_AUTO_TEST_CASE(no_parabola_goes_through_a_jump) {
  // The force of a heavily damped contact is largest at its beginning, c v; later samples are smaller.
  const Scene scene = [] {
    Scene made = scenes::bouncing_disc(
        {.mass = 1.0, .radius = 1.0, .gap = 0.5, .contact = LinearSpringDashpot{1.0, 2.0, EndRule::clamped}});
    made.plan = {0.1, 3.0, 0.1, true};
    return made;
  }();
  const Pilot pilot = pilot_of(scene, scene.model.contacts[0].name + ".force.max", {"stormer_cowell", 1e-10, 997});
  BOOST_TEST(pilot.failure.empty());
  BOOST_TEST(pilot.printed > 0.0);
  BOOST_TEST(pilot.between == pilot.printed);
}

BOOST_AUTO_TEST_CASE(a_run_ends_at_the_same_time_by_every_method) {
  const Scene scene = oscillator();
  for (const long steps : {7L, 64L, 331L}) {
    const Scene changed = with_method(scene, {"rk4", 0.0, steps});
    BOOST_TEST(step_count(changed.plan) == steps);
    BOOST_TEST(changed.plan.end == scene.plan.end);
  }
  const Pilot pilot = pilot_of(scene, "bob.x.end", {"odeint_fehlberg78", 0.0, 53});
  BOOST_TEST(std::abs(pilot.printed - (100.0 + std::cos(1.5))) < 1e-12);
  BOOST_TEST(pilot.evaluations == 53 * 13);
}

BOOST_AUTO_TEST_CASE(a_run_that_takes_too_much_is_given_up) {
  const Scene scene = oscillator();
  const Quantity quantity = quantity_named(scene.model, "bob.x.end");
  PilotRuns runs{scene, quantity, false};
  const Pilot pilot = runs.run({"rk4", 0.0, 1000}, 100);
  BOOST_TEST(pilot.failure == "given up after 100 evaluations");
  BOOST_TEST(runs.evaluations() == 100);
  BOOST_TEST(!runs.run({"rk4", 1e-3, 10}, 100).failure.empty());
}

BOOST_AUTO_TEST_CASE(ladders_follow_the_list_of_integrators) {
  std::size_t fixed = 0, controlled = 0;
  for (const MethodLadder& ladder : method_ladders(integrator_names(), 800)) {
    ++(ladder.by_tolerance ? controlled : fixed);
    const RunMethod low = ladder.at(1.0, 50), high = ladder.at(2.0, 50);
    BOOST_CHECK_NO_THROW((void)make_integrator(low.integrator, low.tolerance));
    BOOST_TEST((ladder.by_tolerance ? low.tolerance == 1e-2 && high.tolerance == 1e-3 && high.steps == 50
                                    : low.steps == 200 && high.steps == 400));
  }
  for (const std::string& name : integrator_names()) {
    fixed -= needs_tolerance(name) ? 0U : 1U;
    controlled -= has_step_control(name) ? 1U : 0U;
  }
  BOOST_TEST(fixed == 0U);
  BOOST_TEST(controlled == 0U);
}

BOOST_AUTO_TEST_CASE(advice_keeps_its_promise_on_an_exact_motion) {
  // x - 100 = cos t, so for a relative accuracy of x the motion itself must be a hundred times more accurate.
  const Scene scene = oscillator();
  const Quantity quantity = quantity_named(scene.model, "bob.tension.end");
  for (const double accuracy : {1e-2, 1e-4, 1e-7}) {
    const Advice advice = advise_method(scene, quantity, {.accuracy = accuracy});
    BOOST_REQUIRE(advice.best.has_value());
    BOOST_TEST(std::abs(advice.reference.value / std::cos(1.5) - 1.0) < 0.35 * accuracy);
    const Pilot pilot = pilot_of(scene, "bob.tension.end", advice.best->method);
    BOOST_TEST(std::abs(pilot.printed / std::cos(1.5) - 1.0) < accuracy);
    BOOST_TEST(pilot.evaluations == advice.best->evaluations);
    for (const TriedMethod& tried : advice.tried)
      BOOST_TEST((!tried.verdict.empty() || tried.evaluations >= advice.best->evaluations));
  }
}

BOOST_AUTO_TEST_CASE(advice_is_the_same_every_time_and_keeps_to_the_list) {
  const Scene scene = oscillator();
  const Quantity quantity = quantity_named(scene.model, "bob.tension.end");
  AdviceRules rules{.accuracy = 1e-3};
  const Advice one = advise_method(scene, quantity, rules), two = advise_method(scene, quantity, rules);
  BOOST_TEST(one.best->method.integrator == two.best->method.integrator);
  BOOST_TEST(one.best->error == two.best->error);
  BOOST_TEST(one.evaluations == two.evaluations);
  rules.among = {"rk4"};
  BOOST_TEST(advise_method(scene, quantity, rules).best->method.integrator == "rk4");
  rules.among = {"rk5"};
  BOOST_CHECK_THROW((void)advise_method(scene, quantity, rules), InputError);
  BOOST_CHECK_THROW((void)advise_method(scene, quantity, {.accuracy = 0.0}), InputError);
  BOOST_CHECK_THROW((void)advise_method(scene, quantity, {.accuracy = 1e-3, .evaluations = 0}), InputError);
}

BOOST_AUTO_TEST_CASE(what_no_step_can_give_is_refused_with_the_reason) {
  const Scene scene = oscillator();
  const auto kind = [](const Advice& advice) { return advice.refusal ? advice.refusal->kind : Refusal::Kind{-1}; };
  const Advice zero = advise_method(scene, quantity_named(scene.model, "bob.y.end"), {.accuracy = 1e-3});
  BOOST_TEST((kind(zero) == Refusal::Kind::vanishing));
  BOOST_TEST(!zero.best.has_value());
  const Quantity quantity = quantity_named(scene.model, "bob.tension.end");
  BOOST_TEST((kind(advise_method(scene, quantity, {.accuracy = 1e-3, .evaluations = 50})) == Refusal::Kind::stiff));
  BOOST_TEST(
      (kind(advise_method(scene, quantity, {.accuracy = 1e-6, .evaluations = 30000, .among = {"euler_cromer"}})) ==
       Refusal::Kind::unreached));

  // An inverted pendulum: its initial deviation grows by e^(t sqrt(g)), so that 1e-9 determines when it falls.
  Scene balanced = scenes::pendulum(
      {.mass = 1.0, .inertia = 1e-9, .arm = 1.0, .gravity = 9.81, .amplitude = std::numbers::pi * (1.0 - 1e-9)});
  balanced.plan = {0.01, 20.0, 0.1, false};
  const Advice fallen = advise_method(
      balanced, quantity_named(balanced.model, balanced.model.bodies[0].name + ".angle.end"), {.accuracy = 1e-3});
  BOOST_TEST((kind(fallen) == Refusal::Kind::chaotic));
  BOOST_TEST(fallen.growth.result > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
