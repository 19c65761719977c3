#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "solver/calibrate/method_advice.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/fence_table.hpp"
#include "verification/problems/oblique_runs.hpp"
#include "verification/problems/sliding_scenes.hpp"

namespace talus::verification::problems {

Case advice();

namespace {

constexpr const char* page = R"(
**Problem.** `talus advise` promises: this integrator with this step or tolerance gives that quantity to that relative
accuracy, and no other in the list does for less. Is it kept on scenes for which it was not made? And is it refused
where no step can keep it?

**Method.** A value is taken for true when the last three runs of one method, over an octave of steps or a decade of
tolerance, agree to a tenth of the accuracy and the last three of another, of a different order, to a quarter of it;
one of the two must choose its own steps. Extremes are sought between the steps too, by parabolas where the curve is
smooth. Then each integrator climbs its own ladder, six rungs to an octave or decade. A rung is advised when nine in a
row, itself the coarsest, and eight between it and the next err by less than half the accuracy, judged by what `talus
run` prints: extremes over the steps. So the error of an advised run is bounded by $(.5 + .35)$ of the accuracy.

**Hypothesis.** The advised run errs by less than the accuracy, and so do runs a little beside it. Against the cheapest
run that brute force finds, from which on all finer ones are as good, half the accuracy costs a method of order 1 a
factor of 2, the rungs one of 1.12 and those of brute force one of 1.07: 2.4 at most.

| scene | quantity | known by |
|:--|:--|:-----|
| bob caught by its cable, $m$ 1, $k$ 500, falls .8, $g$ 9.81, 5 s | largest tension | $mg(1 + \sqrt{1 + 2hk/(mg)})$ |
| disc, rolling and sliding impact on a plane, 1.7 contact times | velocity along it | closed form, piece by piece |
| fence of Table 2, 600 lb, slack .5, .05 s | velocity of the rock | central difference, extrapolated |
| disc between twelve posts about three, 60 s | its place | nobody: refused |

The program was made on the pendulum, the bouncing disc and the pendulum on a cable of `cases/`; none of these four was
run with it before its rules stood.

**Source.** The rules are this program's own; closed forms as in cases `caught_fall` and `friction`.

**What would break it.** A lucky run taken for a rule; extremes judged between the steps, where nobody prints them;
small differences of the start that are not followed.
)";

/// What is asked of one scene.
struct Question {
  const char* name;
  Scene scene;
  const char* quantity;
  double accuracy{};
  std::vector<std::string> among;
  double truth{};
  double doubt{};  ///< of the truth itself, relative
};

Scene caught_bob() {
  ModelBuilder builder;
  builder.gravity({0.0, -9.81});
  const BodyId bob = builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.0, -0.2}});
  builder.add(Cable{
      .name = "rope", .a = {bob, {}}, .b = {std::nullopt, {}}, .rest_length = 1.0, .law = TensionOnly{500.0, 0.0}});
  Scene scene{.title = "caught bob", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.plan = {0.01, 5.0, 0.01, false};
  return scene;
}

double caught_tension() {
  const double weight = 9.81;
  return weight * (1.0 + std::sqrt(1.0 + 2.0 * 0.8 * 500.0 / weight));
}

constexpr double contact_time = 3.14159265358979;  // of the oblique impact: pi sqrt(m/k), m = k = 1

Scene oblique() {
  Scene scene = oblique_scene(oblique_disc(0.8, 2.0), EndRule::clamped);
  scene.title = "oblique impact";
  go_back(scene.initial, 0.5 * contact_time);
  scene.plan = {0.01, 1.7 * contact_time, 0.01, false};
  return scene;
}

double oblique_speed() {
  const reference::ObliqueImpact impact = oblique_disc(0.8, 2.0);
  return impact.slip_rate - reference::rebound(impact, reference::EndRule::clamped).speed_lost;
}

Scene billiard(double end) {
  ModelBuilder builder;
  const BodyId disc = builder.add(
      Body{.name = "disc", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{0.5}, .p_WB = {0.01, 0.1}});
  const auto post = [&](const std::string& name, double radius, double distance, double turn) {
    const double angle = 2.0 * contact_time * turn;
    const BodyId made = builder.add(Body{.name = name,
                                         .mobility = Mobility::fixed,
                                         .shape = Circle{radius},
                                         .p_WB = {distance * std::cos(angle), distance * std::sin(angle)}});
    builder.add(Contact{.name = name, .a = disc, .b = made, .law = LinearSpringDashpot{1e4, 0.0, EndRule::clamped}});
  };
  for (int i = 0; i < 3; ++i)
    post(fmt::format("inner{}", i + 1), 0.5, 1.4, i / 3.0);
  for (int i = 0; i < 12; ++i)
    post(fmt::format("outer{}", i + 1), 1.0, 3.0, i / 12.0);
  Scene scene{.title = "billiard", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, disc, {1.0, 0.37}, 0.0);
  scene.plan = {0.01, end, 0.01, false};
  return scene;
}

AdviceRules rules_of(const Question& question, const Setup& setup) {
  AdviceRules rules{.accuracy = question.accuracy, .among = question.among};
  if (setup.has("lucky_runs")) rules.kept = 1.0, rules.in_a_row = 1, rules.beside = 0;
  rules.judges_as_printed = !setup.has("judged_between_steps");
  rules.follows_differences = !setup.has("differences_not_followed");
  return rules;
}

/// A run as `talus run` makes it, and what it prints of a quantity.
struct Run {
  double error{std::numeric_limits<double>::infinity()};
  double evaluations{};
};

Run run_with(const Question& question, const RunMethod& method, Findings& findings) {
  const Scene scene = with_method(question.scene, method);
  const Quantity quantity = quantity_named(scene.model, question.quantity);
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, scene.plan.ledger};
  Recorder recorder{dynamics, scene.initial, scene.plan.ledger};
  Integrator integrator = scene.integrator;
  State state = scene.initial;
  const Observer observer = std::ref(recorder);
  const Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1});
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  if (!outcome) return {std::numeric_limits<double>::infinity(), static_cast<double>(system.evaluations())};
  const Recorder::Extreme& extreme = recorder.extremes()[quantity.column];
  const double value = quantity.of(extreme.least, extreme.largest, recorder.row()[quantity.column]);
  return {std::abs(value / question.truth - 1.0), static_cast<double>(system.evaluations())};
}

/// Runs beside an advised one: up to half as many steps again, tolerances down to a third.
double error_beside(const Question& question, const RunMethod& advised, Findings& findings) {
  double worst = 0.0;
  for (int i = 1; i <= 12; ++i) {
    const double x = std::fmod(0.7548776662466927 * i, 1.0), y = std::fmod(0.5698402909980532 * i, 1.0);
    RunMethod method = advised;
    method.steps = std::lround(static_cast<double>(advised.steps) * (1.0 + 0.5 * x));
    method.tolerance = advised.tolerance * std::pow(3.0, -y);
    worst = std::max(worst, run_with(question, method, findings).error);
  }
  return worst;
}

/// The fewest evaluations of all methods, each on a fine ladder of its own, from which on all finer runs up to four
/// times the cost are as good. `own`: cost and error of those of the advised method, over the advice's and what is
/// asked.
double cheapest(const Question& question, const Advice& advice, Findings& findings, Series& own) {
  double best = std::numeric_limits<double>::infinity();
  const double most = 4.0 * static_cast<double>(advice.best->evaluations);
  const auto climb = [&](const std::function<RunMethod(int)>& rung, int rungs) {
    double candidate = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rungs; ++i) {
      const RunMethod method = rung(i);
      if (method.tolerance == 0.0 && static_cast<double>(method.steps) > 8.0 * most) break;
      const Run run = run_with(question, method, findings);
      if (run.evaluations > most) break;
      const RunMethod& best_method = advice.best->method;
      if (method.integrator == best_method.integrator && (method.tolerance != 0.0) == (best_method.tolerance != 0.0)) {
        own.x.push_back(run.evaluations / static_cast<double>(advice.best->evaluations));
        own.y.push_back(run.error / question.accuracy);
      }
      if (run.error > question.accuracy)
        candidate = std::numeric_limits<double>::infinity();
      else
        candidate = std::min(candidate, run.evaluations);
    }
    best = std::min(best, candidate);
  };
  for (const std::string& name : question.among.empty() ? integrator_names() : question.among) {
    const auto admitted = [&](double tolerance) {
      try {
        static_cast<void>(choose_integrator(question.scene.model, name, tolerance));
        return true;
      } catch (const std::exception&) {
        return false;
      }
    };
    if (admitted(0.0)) climb([&](int i) { return RunMethod{name, 0.0, std::lround(10.0 * std::pow(1.07, i))}; }, 200);
    if (admitted(1e-3))
      climb([&](int i) { return RunMethod{name, 0.08 * std::pow(10.0, -i / 8.0), advice.best->method.steps}; }, 80);
  }
  return best;
}

std::string words(const RunMethod& method, double duration) {
  return method.tolerance == 0.0
             ? fmt::format("{}, step {:.2e}", method.integrator, duration / static_cast<double>(method.steps))
             : fmt::format("{}, {:.1e}", method.integrator, method.tolerance);
}

void check_question(const Question& question, Findings& findings, const Setup& setup, Table& table, Figure& figure) {
  const Quantity quantity = quantity_named(question.scene.model, question.quantity);
  const Advice advice = advise_method(question.scene, quantity, rules_of(question, setup));
  findings.count(static_cast<std::uint64_t>(advice.evaluations));
  const auto check = [&](const char* what) { return fmt::format("{}: {}", question.name, what); };
  if (!findings.expect_true(check("advised"), advice.best.has_value(), "the motion is regular")) return;
  const TriedMethod& best = *advice.best;
  findings.expect_between(check("error of the value upon which two methods agree over the accuracy"),
                          std::abs(advice.reference.value / question.truth - 1.0) / question.accuracy, 0.0,
                          0.35 + question.doubt / question.accuracy,
                          "a tenth of the accuracy within one method, a quarter to the other, and the doubt of an "
                          "extrapolated truth");
  const Run run = run_with(question, best.method, findings);
  const double beside = error_beside(question, best.method, findings);
  findings.expect_between(check("error of the advised run over the accuracy"), run.error / question.accuracy, 0.0, 1.0,
                          "the promise");
  findings.expect_between(check("largest error of twelve runs beside it over the accuracy"), beside / question.accuracy,
                          0.02, 1.0,
                          "the promise is no matter of luck; below a fiftieth the advice would be much too dear");
  findings.expect_true(check("costs what was said"), run.evaluations == static_cast<double>(best.evaluations),
                       "the same run");
  if (setup.coarse) return;
  Series own{.label = question.name, .x = {}, .y = {}, .style = Style::points};
  const double brute = cheapest(question, advice, findings, own);
  figure.series.push_back(std::move(own));
  findings.expect_between(
      check("evaluations over the fewest by brute force"), run.evaluations / brute, 0.5, 2.4,
      "half the accuracy costs order 1 a factor of 2, the rungs 1.12 and those of brute force 1.07; "
      "brute force asks all finer runs to four times the cost, and may come out twice as dear");
  table.rows.push_back({question.name, fmt::format("{:.0e}", question.accuracy),
                        words(best.method, question.scene.plan.end), fmt::format("{:.1e}", best.error),
                        fmt::format("{:.1e}", run.error), fmt::format("{:.1e}", beside),
                        fmt::format("{}", best.evaluations), fmt::format("{:.0f}", brute)});
}

/// The rock's speed by a method that shares only the forces, extrapolated from two steps, as in `located_events`.
void know_fence(Question& question, Findings& findings) {
  const auto speed = [&](double step) {
    Question at = question;
    at.truth = 1.0;
    const long steps = std::lround(question.scene.plan.end / step);
    const Scene scene = with_method(at.scene, {"central_difference", 0.0, steps});
    const Dynamics dynamics{scene.model};
    RigidBodySystem system{dynamics, false};
    Integrator integrator = scene.integrator;
    State state = scene.initial;
    static_cast<void>(simulate(system, integrator, state, scene.plan));
    findings.count(static_cast<std::uint64_t>(system.evaluations()));
    return pose(scene.model, state, *find_body(scene.model, "rock")).v_WB.x;
  };
  const double coarse = speed(4e-7), fine = speed(2e-7);
  question.truth = 2.0 * fine - coarse;
  question.doubt = 0.5 * std::abs((fine - coarse) / question.truth);
}

void check_billiard(Findings& findings, const Setup& setup, Table& table) {
  Question question{"billiard", billiard(60.0), "disc.x.end", 1e-2, {}, 0.0, 0.0};
  const Quantity quantity = quantity_named(question.scene.model, question.quantity);
  const Advice advice = advise_method(question.scene, quantity, rules_of(question, setup));
  findings.count(static_cast<std::uint64_t>(advice.evaluations));
  findings.expect_true("billiard: refused because its differences grow",
                       advice.refusal && advice.refusal->kind == Refusal::Kind::chaotic,
                       "round posts spread what comes between them: no step can keep any promise");
  if (setup.coarse) return;
  findings.expect_between("billiard: growth of a difference of 1e-11 in the start, share of the result",
                          advice.growth.result, 1e-2, 1e3,
                          "at least the accuracy that was asked; at most the size of the yard over the value");
  // Two methods at their best, which is what brute force would take for true.
  PilotRuns runs{question.scene, quantity};
  const Pilot one = runs.run({"stormer_cowell", 1e-12, 2000}, 10'000'000);
  const Pilot two = runs.run({"odeint_fehlberg78", 1e-12, 2000}, 10'000'000);
  findings.count(static_cast<std::uint64_t>(runs.evaluations()));
  findings.expect_between("billiard: distance of two methods at tolerances of 1e-12 [share of the yard's radius]",
                          std::abs(one.printed - two.printed) / 3.0, 1e-2, 2.0, "nothing of the place is left");
  question.scene.plan.end = 4.0;
  const Advice early = advise_method(question.scene, quantity, rules_of(question, setup));
  findings.count(static_cast<std::uint64_t>(early.evaluations));
  findings.expect_true("billiard: its first 4 s are advised", early.best.has_value(),
                       "after few impacts differences are still small: it is the time that is refused, not the scene");
  table.rows.push_back({"billiard, 60 s", "1e-02", "refused", "-",
                        fmt::format("{:.0e} grows to {:.0e}", advice.growth.share, advice.growth.result), "-",
                        fmt::format("{}", advice.evaluations), "-"});
}

std::vector<Question> questions(Findings& findings, const Setup& setup) {
  std::vector<Question> all{{"caught bob", caught_bob(), "cable.rope.tension.max", 1e-3, {}, caught_tension(), 0.0},
                            {"caught bob, velocity Verlet",
                             caught_bob(),
                             "cable.rope.tension.max",
                             1e-2,
                             {"velocity_verlet"},
                             caught_tension(),
                             0.0}};
  if (setup.coarse) return all;
  all.push_back({"caught bob, finer", caught_bob(), "cable.rope.tension.max", 1e-5, {}, caught_tension(), 0.0});
  all.push_back({"oblique impact", oblique(), "disc.vx.end", 1e-3, {}, oblique_speed(), 0.0});
  all.push_back({"oblique impact, Runge-Kutta 4", oblique(), "disc.vx.end", 1e-2, {"rk4"}, oblique_speed(), 0.0});
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.options.start = scenes::FenceStart::plain;
  Question rock{"fence", scenes::fence_scene(fence).scene, "rock.vx.end", 1e-3, {}, 0.0, 0.0};
  rock.scene.plan.end = 0.05;
  rock.scene.plan.ledger = false;
  know_fence(rock, findings);
  all.push_back(std::move(rock));
  return all;
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "advice",
              .caption =
                  "What is advised for which accuracy; the error promised (largest of its pilots), that of the "
                  "advised run, the largest of twelve beside it; its evaluations and the fewest by brute force.",
              .columns = {"scene", "accuracy", "advice", "promised", "error", "beside", "evaluations", "fewest"},
              .rows = {}};
  Figure figure{.name = "beside",
                .title = "Errors of the advised methods beside the advice",
                .caption =
                    "Runs by brute force of the method that was advised for each scene: error over the accuracy "
                    "against cost over that of the advice, which stands at 1. All that cost more than it keep "
                    "the accuracy; some that cost less do so by luck.",
                .x = {.label = "evaluations over those advised", .log = true},
                .y = {.label = "error over accuracy", .log = true},
                .series = {},
                .lines = {{'y', 1.0, "accuracy"}, {'x', 1.0, "advice"}}};
  for (const Question& question : questions(findings, setup))
    check_question(question, findings, setup, table, figure);
  check_billiard(findings, setup, table);
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace

Case advice() {
  return {.id = "advice",
          .title = "Advice on method and step",
          .family = "speed and accuracy",
          .requirements = {{"integrator.velocity_verlet", {"caught bob, velocity Verlet: error of the advised run"}},
                           {"integrator.rk4", {"oblique impact, Runge-Kutta 4: error of the advised run"}}},
          .main_checks = {"caught bob: error of the advised run over the accuracy",
                          "caught bob, finer: largest error of twelve runs beside it over the accuracy",
                          "caught bob, velocity Verlet: largest error of twelve runs beside it over the accuracy",
                          "oblique impact: largest error of twelve runs beside it over the accuracy",
                          "fence: error of the advised run over the accuracy",
                          "fence: evaluations over the fewest by brute force",
                          "billiard: refused because its differences grow"},
          .source = "This program's own rules; closed forms as in the cases caught_fall and friction",
          .page = page,
          .faults = {{"lucky_runs", "one run at the whole accuracy is taken for enough",
                      "caught bob, velocity Verlet: largest error of twelve runs beside it over the accuracy"},
                     {"judged_between_steps", "pilots are judged by extremes between the steps, which no run prints",
                      "caught bob: error of the advised run over the accuracy"},
                     {"differences_not_followed", "small differences of the start are not followed",
                      "billiard: refused because its differences grow"}},
          .tier = Tier::quick,
          .time_limit = 60.0,
          .run = run};
}

}  // namespace talus::verification::problems
