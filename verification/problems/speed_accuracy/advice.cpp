#include "solver/advise/method_advice.hpp"
#include "solver/advise/method_ladder.hpp"
#include "solver/advise/pilot.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/study/impacts/oblique_runs.hpp"
#include "verification/study/runs/recorded_run.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/scenes/sliding_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::advice {
namespace {

/// A scene, the quantity on which advice is requested, and its exact value.
struct Question {
  const char* name;
  Scene scene;
  const char* quantity;
  double accuracy{};
  std::vector<std::string> among;  ///< integrators to choose from; empty: all
  double truth{};                  ///< exact value of the quantity
  double doubt{};                  ///< relative uncertainty of `truth`
};

constexpr double pi = std::numbers::pi;

/// A plan that sets the end time and switches the ledger off; its steps are replaced by those of the method.
RunPlan until(double end) { return {0.001 * end, end, 0.001 * end, false}; }

/// Scenes that were used to develop the rules of the advice: a bob of mass 1 that falls 0.8 and is caught by its cable
/// (k 500, g 9.81, five seconds), and a disc that hits a plane obliquely, with friction (case `friction`).
Question caught_bob(double accuracy, std::vector<std::string> among) {
  const double gravity = 9.81, stiffness = 500.0, fall = 0.8;
  SceneBuilder builder;
  builder.gravity({0.0, -gravity});
  const BodyId bob = builder.add_particle("bob", 1.0, {0.0, fall - 1.0});
  builder.add_cable("rope", {bob, {}}, {std::nullopt, {}}, 1.0, TensionOnly{stiffness, 0.0});
  Scene scene = builder.at_rest("caught bob");
  scene.plan = until(5.0);
  const double truth = gravity * (1.0 + std::sqrt(1.0 + 2.0 * fall * stiffness / gravity));
  return {among.empty() ? "caught bob" : "caught bob, fixed steps",
          std::move(scene),
          "cable.rope.tension.max",
          accuracy,
          std::move(among),
          truth};
}

Question oblique_impact(double accuracy, std::vector<std::string> among) {
  const reference::ObliqueImpact impact = oblique_disc(0.8, 2.0);
  Scene scene = oblique_scene(impact, EndRule::clamped);
  go_back(scene.initial, 0.5 * pi);
  scene.plan = until(1.7 * pi);
  return {among.empty() ? "oblique impact" : "oblique impact, fixed steps",
          std::move(scene),
          "disc.vx.end",
          accuracy,
          std::move(among),
          impact.slip_rate - reference::rebound(impact, reference::EndRule::clamped).speed_lost};
}

/// Scenes that were first run after the rules had been fixed: a ball by Hertz's law (4/3 E sqrt(R) = 1, m = 1, v = 1),
/// a latching spring (K1 = 1, K2 = 4), and the rock of Table 3's fence to 0.05 s. For the fence `truth` is extrapolated
/// from central differences at 4e-7 and 2e-7 s; `findings` counts their evaluations.
Question hertz_impact(double accuracy) {
  Scene scene = scenes::bouncing_disc({.mass = 1.0,
                                       .radius = 20.0,
                                       .gap = 0.7,
                                       .speed = 1.0,
                                       .contact = Hertz{.modulus = 0.75, .radius = 1.0, .damping = 0.0}});
  scene.plan = until(6.0);
  const double depth = reference::hertz_events({1.0, 0.0, 1.0, 1.0}, reference::EndRule::clamped).largest_depth;
  return {"Hertzian impact", std::move(scene), "contact.impact.force.max", accuracy, {}, std::pow(depth, 1.5)};
}

Question latched_impact(double accuracy, std::vector<std::string> among) {
  Scene scene =
      scenes::bouncing_disc({.mass = 1.0, .radius = 20.0, .gap = 0.3, .contact = LatchingSpring{1.0, 4.0, 0.0}});
  scene.plan = until(3.5);
  // e = sqrt(K1/K2), away from the plane.
  return {among.empty() ? "latching impact" : "latching impact, fixed steps",
          std::move(scene),
          "disc.vy.end",
          accuracy,
          std::move(among),
          0.5};
}

Question fence_impact(double accuracy, Findings& findings) {
  scenes::Fence fence = published_fence("table_3.DAT");
  fence.options.start = scenes::FenceStart::plain;
  Question question{"fence of Table 3", scenes::fence_scene(fence).scene, "rock.vx.end", accuracy, {}};
  question.scene.plan = until(0.05);
  const auto speed = [&](double step) {
    const Scene scene = with_method(question.scene, {"central_difference", 0.0, std::lround(0.05 / step)});
    const State end = run_scene(scene, scene.integrator, scene.plan, findings).state;
    return pose(scene.model, end, *find_body(scene.model, "rock")).v_WB.x;
  };
  const double coarse = speed(4e-7), fine = speed(2e-7);
  question.truth = 2.0 * fine - coarse;
  question.doubt = 0.5 * std::abs((fine - coarse) / question.truth);
  return question;
}

/// Five discs in a square box of width 4, without friction or loss, run to `end`. The final positions are chaotic, so
/// that there is no reference value.
Question gas(double end, double accuracy) {
  SceneBuilder builder;
  const LinearSpringDashpot bump{1e4, 0.0, EndRule::clamped};
  const std::array<Vec2, 5> positions{{{-1.3, -1.2}, {1.1, -1.0}, {0.1, 0.2}, {-1.2, 1.3}, {1.3, 1.1}}};
  const std::array<Vec2, 5> speeds{{{0.9, 0.3}, {-0.4, 0.8}, {0.7, -0.6}, {0.2, -0.9}, {-0.8, -0.1}}};
  std::vector<BodyId> bodies;
  for (int i = 0; i < 4; ++i) {
    const double turn = 0.5 * pi * i;
    bodies.push_back(builder.add_fixed(fmt::format("wall{}", i + 1), HalfPlane{},
                                       {2.0 * std::sin(turn), -2.0 * std::cos(turn)}, turn));
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const BodyId disc = builder.add_particle(fmt::format("disc{}", i + 1), 1.0, positions[i], Circle{0.4});
    for (std::size_t k = 0; k < bodies.size(); ++k)
      builder.add_contact(fmt::format("pair{}_{}", i + 1, k + 1), bodies[k], disc, bump);
    bodies.push_back(disc);
  }
  Scene scene = builder.at_rest("gas");
  for (std::size_t i = 0; i < positions.size(); ++i)
    set_velocity(scene.model, scene.initial, bodies[4 + i], speeds[i], 0.0);
  scene.plan = until(end);
  return {"gas", std::move(scene), "disc1.x.end", accuracy, {}};
}

AdviceRules rules_of(const Question& question, const Setup& setup) {
  AdviceRules rules{.accuracy = question.accuracy, .among = question.among};
  if (setup.has("lucky_runs")) rules.kept = 1.0, rules.in_a_row = 1, rules.beside = 0;
  rules.judges_as_printed = !setup.has("judged_between_steps");
  rules.follows_differences = !setup.has("differences_not_followed");
  return rules;
}

/// A run as by `talus run`: error of the printed value of the quantity, and cost.
struct Run {
  double error{std::numeric_limits<double>::infinity()};
  double evaluations{};
};

Run run_with(const Question& question, const RunMethod& method, Findings& findings) {
  const Scene scene = with_method(question.scene, method);
  const Quantity quantity = quantity_named(scene.model, question.quantity);
  const RecordedRun run{scene, findings};
  const auto evaluations = static_cast<double>(run.end().evaluations);
  if (!run.end().finished) return {std::numeric_limits<double>::infinity(), evaluations};
  return {std::abs(run.value(quantity) / question.truth - 1.0), evaluations};
}

/// Largest error of twelve runs near the advised one: up to 1.5 times as many steps, tolerances down to a third.
double error_beside(const Question& question, const RunMethod& advised, Findings& findings) {
  double worst = 0.0;
  for (int i = 1; i <= 12; ++i) {
    const double x = std::fmod(0.7548776662466927 * i, 1.0), y = std::fmod(0.5698402909980532 * i, 1.0);
    RunMethod method = advised;
    method.steps = std::lround(static_cast<double>(advised.steps) * (1.0 + 0.5 * x));
    method.tolerance = advised.tolerance * std::pow(3.0, -y);
    keep_largest(worst, run_with(question, method, findings).error);
  }
  return worst;
}

/// Largest error of the runs that the search judges together: the advised one, those of the next rungs, and added ones,
/// whose steps are shorter by up to a sixth of an octave, at multiples of the golden ratio.
double error_of_judged(const Question& question, const RunMethod& advised, const AdviceRules& rules,
                       Findings& findings) {
  double worst = run_with(question, advised, findings).error;
  const auto judge = [&](long steps) {
    keep_largest(worst, run_with(question, {advised.integrator, 0.0, steps}, findings).error);
  };
  for (int i = 1; i <= rules.beside; ++i)
    judge(std::lround(static_cast<double>(advised.steps) * std::exp2(std::fmod(0.6180339887498949 * i, 1.0) / 6.0)));
  const Dynamics dynamics{question.scene.model};
  const std::vector<MethodLadder> ladders =
      method_ladders({advised.integrator}, std::lround(resolving_steps(dynamics, question.scene)));
  const MethodLadder& ladder = ladders.front();
  const double height = std::log2(static_cast<double>(advised.steps) / static_cast<double>(ladder.coarsest));
  for (int i = 1; i < rules.in_a_row; ++i)
    judge(ladder.at((std::round(6.0 * height) + i) / 6.0, 0).steps);
  return worst;
}

/// Lowest position of a disc that bounces without loss, by the parabola through three steps of coarse exact runs:
/// largest error over the largest overlap, v sqrt(m/k) = 1.
double lowest_error(double coarsest, Findings& findings) {
  constexpr double radius = 20.0, end = 6.0;
  Scene scene = scenes::bouncing_disc({.mass = 1.0,
                                       .radius = radius,
                                       .gap = 0.7,
                                       .speed = 1.0,
                                       .contact = LinearSpringDashpot{1.0, 0.0, EndRule::clamped}});
  scene.plan = until(end);
  const Quantity quantity = quantity_named(scene.model, "disc.y.min");
  PilotRuns runs{scene, quantity, true};
  double worst = 0.0;
  for (int i = 0; i < 12; ++i) {
    const Pilot pilot = runs.run({"exact", 0.0, std::lround(end / coarsest) + i}, 1000);
    keep_worst(worst, pilot.failure.empty() ? pilot.between - (radius - 1.0) : std::nan(""));
  }
  findings.count(runs.evaluations());
  return worst;
}

/// Smallest number of evaluations of all methods, each on a separate fine ladder, such that all finer runs up to four
/// times the cost of the advice are as accurate. `own`: receives the runs of the advised method, cost relative to that
/// of the advice, error relative to the required accuracy.
double cheapest(const Question& question, const Advice& advice, Findings& findings, Series& own) {
  double best = std::numeric_limits<double>::infinity();
  const double maximum = 4.0 * static_cast<double>(advice.best->evaluations);
  const auto climb = [&](const std::function<RunMethod(int)>& rung, int rungs) {
    double candidate = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rungs; ++i) {
      const RunMethod method = rung(i);
      if (method.tolerance == 0.0 && static_cast<double>(method.steps) > 8.0 * maximum) break;
      const Run run = run_with(question, method, findings);
      if (run.evaluations > maximum) break;
      const RunMethod& best_method = advice.best->method;
      if (method.integrator == best_method.integrator && (method.tolerance != 0.0) == (best_method.tolerance != 0.0)) {
        own.add(run.evaluations / static_cast<double>(advice.best->evaluations), run.error / question.accuracy);
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

std::string text_of(const RunMethod& method, double duration) {
  return method.tolerance == 0.0
             ? fmt::format("{}, step {:.2e}", method.integrator, duration / static_cast<double>(method.steps))
             : fmt::format("{}, {:.1e}", method.integrator, method.tolerance);
}

void check_question(const Question& question, Findings& findings, const Setup& setup, Table& table, Figure& figure) {
  const Quantity quantity = quantity_named(question.scene.model, question.quantity);
  const Advice advice = advise_method(question.scene, quantity, rules_of(question, setup));
  findings.count(advice.evaluations);
  const auto check = [&](const char* what) { return fmt::format("{}: {}", question.name, what); };
  if (!findings.expect_true(check("advice given"), advice.best.has_value(), "the motion is regular")) return;
  const TriedMethod& best = *advice.best;
  findings.expect_between(
      check("error of the reference value over the accuracy"),
      std::abs(advice.reference.value / question.truth - 1.0) / question.accuracy, 0.0,
      0.35 + question.doubt / question.accuracy,
      "0.1 of the accuracy within one method, 0.25 to the other, plus the uncertainty of an extrapolated exact value");
  const Run run = run_with(question, best.method, findings);
  const double beside = error_beside(question, best.method, findings);
  findings.expect_between(check("error of the advised run over the accuracy"), run.error / question.accuracy, 0.0, 1.0,
                          "the promised accuracy");
  findings.expect_between(check("largest error of twelve neighbouring runs over the accuracy"),
                          beside / question.accuracy, 0.0, 1.0,
                          "the promised accuracy must not be due to chance; the comparison with the fewest evaluations "
                          "shows whether it is too expensive");
  if (const AdviceRules rules = rules_of(question, setup); best.method.tolerance == 0.0 && rules.beside > 0) {
    Question judged = question;  // by the reference value of the search, as the reported error
    judged.truth = advice.reference.value;
    findings.expect(check("largest error of the runs judged with the advised one over the reported error"),
                    error_of_judged(judged, best.method, rules, findings) / best.error, 1.0,
                    Tolerance::round_off(1e-9, "the same runs, repeated here; errors of at least 1e-7, relative to 1"));
  }
  findings.expect_true(check("evaluations as reported"), run.evaluations == static_cast<double>(best.evaluations),
                       "the same run");
  if (setup.coarse) return;
  Series own{.label = question.name, .style = Style::points};
  const double brute = cheapest(question, advice, findings, own);
  figure.series.push_back(std::move(own));
  findings.expect_between(
      check("evaluations over the minimum by brute force"), run.evaluations / brute, 0.5, 2.4,
      "half the accuracy costs order 1 a factor of 2, the spacing of the rungs 1.12 and that of the brute-force runs "
      "1.07; brute force requires all finer runs up to four times the cost to be accurate, and may cost twice as much");
  table.rows.push_back(cells("{} | {:.0e} | {} | {:.1e} | {:.1e} | {:.1e} | {} | {:.0f}", question.name,
                             question.accuracy, text_of(best.method, question.scene.plan.end), best.error, run.error,
                             beside, best.evaluations, brute));
}

void check_gas(Findings& findings, const Setup& setup, Table& table) {
  const Question question = gas(setup.coarse ? 25.0 : 100.0, 1e-2);
  const Quantity quantity = quantity_named(question.scene.model, question.quantity);
  AdviceRules rules = rules_of(question, setup);
  rules.evaluations = setup.coarse ? 150'000 : 1'000'000;
  const Advice advice = advise_method(question.scene, quantity, rules);
  findings.count(advice.evaluations);
  findings.expect_true({"refused_gas", "gas: advice refused because differences grow"},
                       advice.refusal && advice.refusal->kind == Refusal::Kind::chaotic,
                       "impacts of round bodies amplify differences: no step can keep the promised accuracy");
  if (setup.coarse) return;
  findings.expect_between("gas: largest difference of the result over the accuracy",
                          advice.growth.result / question.accuracy, 1.0, 1e5,
                          "at least the required accuracy; at most the width of the box over a thousandth of it");
  // Two fine runs; brute force would accept either as the reference.
  PilotRuns runs{question.scene, quantity, false};
  const Pilot one = runs.run({"stormer_cowell", 1e-12, 2000}, 10'000'000);
  const Pilot two = runs.run({"rk4", 0.0, 100'000}, 10'000'000);
  findings.count(runs.evaluations());
  findings.expect_between("gas: difference of two fine runs over the width of the box",
                          std::abs(one.printed - two.printed) / 3.2, 1e-2, 1.0,
                          "no step gives the position to 1 %; discs reach 3.2 of the box's width of 4");
  const Question soon = gas(2.0, 1e-2);
  const Advice early = advise_method(soon.scene, quantity, rules_of(soon, setup));
  findings.count(early.evaluations);
  findings.expect_true("gas: advice given for the time of its first impacts", early.best.has_value(),
                       "differences are still small: the duration is refused, not the scene");
  table.rows.push_back(cells("gas of five discs to 100 | 1e-02 | refused | - | {:.0e} grows to {:.0e} | - | {} | -",
                             advice.growth.fraction, advice.growth.result, advice.evaluations));
}

std::vector<Question> questions(Findings& findings, const Setup& setup) {
  std::vector<Question> all{caught_bob(1e-3, {}), caught_bob(1e-2, {"velocity_verlet"})};
  if (setup.coarse) return all;
  all.push_back(oblique_impact(1e-3, {}));
  all.push_back(oblique_impact(1e-2, {"rk4"}));
  all.push_back(hertz_impact(1e-4));
  all.push_back(latched_impact(1e-4, {}));
  all.push_back(latched_impact(1e-2, {"velocity_verlet"}));
  all.push_back(fence_impact(1e-3, findings));
  return all;
}

void run(Findings& findings, const Setup& setup) {
  Table table{
      .name = "advice",
      .caption =
          "Advice for each scene and accuracy; promised error (largest of the pilot runs), error of the advised run, "
          "largest error of twelve neighbouring runs; evaluations of the advised run, and minimum by brute force.",
      .columns = {"scene", "accuracy", "advice", "promised", "error", "neighbours", "evaluations", "minimum"}};
  Figure figure{
      .name = "beside",
      .title = "Errors of the advised methods near the advice",
      .caption =
          "Brute-force runs with the method advised for each scene: error over the accuracy against cost over that of "
          "the advice, which lies at 1. To the right of it errors stay below the accuracy, except for some coarser "
          "tolerances of the same cost; to the left some runs are accurate by chance.",
      .x = {.label = "evaluations over those of the advice", .log = true, .min = 0.2, .max = 5.0},
      .y = {.label = "error over accuracy", .log = true, .min = 1e-3, .max = 1e2},
      .series = {},
      .lines = {{'y', 1.0, "accuracy"}, {'x', 1.0, "advice"}}};
  // Each fault costs a complete search, so that it is injected only where it must be detected.
  const bool in_gas = setup.has("differences_not_followed");
  if (!in_gas) {
    for (const Question& question : questions(findings, setup))
      check_question(question, findings, setup, table, figure);
  }
  if (setup.fault.empty()) {
    constexpr double coarsest = 0.3;  // of w h
    findings.expect("lowest position between the steps of a bounce: largest error over the overlap",
                    lowest_error(coarsest, findings), 0.0,
                    Tolerance::truncation(0.0235 * std::pow(coarsest, 4), 1.0,
                                          "-cos x sampled at d - z, d and d + z with z = w h: its fourth-order term "
                                          "-x^4/24 shifts the parabola by d^2 (z^2 - d^2)/8 at its lowest point, at "
                                          "most 3 z^4/128 at d = z/2. The lowest step alone misses z^2/8"));
  }
  if (in_gas || setup.fault.empty()) check_gas(findings, setup, table);
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace

Case definition() {
  return {
      .id = "advice",
      .title = "Advice on integrator and step",
      .family = "speed and accuracy",
      .requirements = {{"integrator.velocity_verlet",
                        {"caught bob, fixed steps: error of the advised run over the accuracy"}},
                       {"integrator.rk4", {"oblique impact, fixed steps: error of the advised run over the accuracy"}}},
      .main_checks = {"caught bob: error of the advised run over the accuracy",
                      "Hertzian impact: largest error of twelve neighbouring runs over the accuracy",
                      "caught bob, fixed steps: largest error of twelve neighbouring runs over the accuracy",
                      "latching impact, fixed steps: largest error of twelve neighbouring runs over the accuracy",
                      "fence of Table 3: error of the advised run over the accuracy",
                      "fence of Table 3: evaluations over the minimum by brute force", "refused_gas"},
      .source = "Rules of this program; closed forms as in cases damped_bungee, friction, hertz and latching_spring",
      .faults = {{"lucky_runs", "one run at the full accuracy taken as sufficient",
                  "caught bob, fixed steps: largest error of twelve neighbouring runs over the accuracy"},
                 {"judged_between_steps", "pilot runs judged by extremes between the steps, which no run prints",
                  "caught bob: error of the advised run over the accuracy"},
                 {"differences_not_followed", "growth of small initial differences not measured", "refused_gas"}},
      .seconds = 9.0,
      .run = run};
}

}  // namespace talus::verification::problems::advice
