#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>

#include "solver/run/simulate.hpp"
#include "verification/problems/speed_accuracy/work_charts.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::work_precision {
namespace {

/// Time of one run without output and ledger: median, minimum and maximum of 15 repetitions, with all methods and
/// points of a scene interleaved in a shuffled order.
struct TimedPoint {
  std::string scene, quantity, method;
  double error{};
  double median{}, fastest{}, slowest{};  ///< [ns]
};

constexpr int repetitions = 15;
/// Minimum duration of a measurement [s], from which the number of its runs follows: the cost of the clock is then
/// below 0.1 %.
constexpr double minimum_seconds = 1e-4;
constexpr double maximum_evaluations = 1e5;

/// One point of a curve, and its measured times.
struct Timed {
  const WorkCurve* curve{};
  const CurvePoint* point{};
  int runs{1};
  std::vector<double> seconds{};  // of one run
};

/// One run; returns its first coordinate, so that the compiler cannot omit any part of it.
double run_once(const WorkScene& scene, const Dynamics& dynamics, const Timed& timed) {
  const bool by_tolerance = has_step_control(timed.curve->method);
  const double span = scene.duration / static_cast<double>(scene.spans);
  const double steps = by_tolerance ? 1.0 : std::max(1.0, std::round(span / timed.point->setting));
  RigidBodySystem system{dynamics, false};
  State state = scene.scenes.front().initial;
  Integrator integrator = make_integrator(timed.curve->method, by_tolerance ? timed.point->setting : 0.0);
  const Outcome outcome = simulate(system, integrator, state, {span / steps, scene.duration, scene.duration, false});
  return outcome ? state.q[0] : 0.0;
}

double measured_seconds(const WorkScene& scene, const Dynamics& dynamics, const Timed& timed, double& sum) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < timed.runs; ++i)
    sum += run_once(scene, dynamics, timed);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / timed.runs;
}

std::vector<Timed> to_be_timed(const SceneCurves& curves) {
  std::vector<Timed> found;
  for (const WorkCurve& curve : curves.curves) {
    for (const CurvePoint& point : curve.points) {
      if (point.failed == 0 && point.evaluations <= maximum_evaluations) found.push_back({&curve, &point});
    }
  }
  return found;
}

std::string text(double number) { return fmt::format("{:.6g}", number); }

/// Times of all points of the curves of one scene that did not fail and take at most 100,000 evaluations.
std::vector<TimedPoint> timed_points(const SceneCurves& curves) {
  const WorkScene& scene = *curves.scene;
  const Dynamics dynamics{scene.scenes.front().model};
  std::vector<Timed> timed = to_be_timed(curves);
  double sum = 0.0;
  for (Timed& each : timed)
    each.runs = 1 + static_cast<int>(minimum_seconds / std::max(measured_seconds(scene, dynamics, each, sum), 1e-7));
  std::vector<std::size_t> order(timed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random{1993};
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order)
      timed[i].seconds.push_back(measured_seconds(scene, dynamics, timed[i], sum));
  }
  if (!std::isfinite(sum)) throw std::runtime_error("a timed run failed");
  std::vector<TimedPoint> points;
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    for (Timed& each : timed) {
      std::sort(each.seconds.begin(), each.seconds.end());
      points.push_back({scene.name, scene.quantities[q], each.curve->method, each.point->rms[q],
                        1e9 * each.seconds[repetitions / 2], 1e9 * each.seconds.front(), 1e9 * each.seconds.back()});
    }
  }
  return points;
}

/// One row for each point.
DataFile timing_data(const std::vector<TimedPoint>& points, const std::string& machine) {
  DataFile data{
      "work_and_time", {"scene", "quantity", "method", "error_rms", "ns_median", "ns_min", "ns_max", "machine"}, {}};
  const auto plain = [](std::string text) {
    std::replace(text.begin(), text.end(), ',', ';');
    return text;
  };
  for (const TimedPoint& point : points) {
    data.rows.push_back({plain(point.scene), plain(point.quantity), point.method, text(point.error), text(point.median),
                         text(point.fastest), text(point.slowest), plain(machine)});
  }
  return data;
}

/// A chart for each scene and quantity of the data: time against error, medians with bars from fastest to slowest.
std::vector<Figure> timing_figures(const DataFile& data, const std::string& machine) {
  std::vector<Figure> figures;
  std::string title;
  for (const auto& row : data.rows) {
    const std::string own = row[0] + ": " + row[1];
    if (own != title) {
      title = own;
      figures.push_back(
          {.name = fmt::format("time_{}", figures.size() + 1),
           .title = "Time, " + title,
           .caption =
               fmt::format("Time of a run in nanoseconds against its relative error: median of {} interleaved, "
                           "shuffled repetitions, bars from the fastest to the slowest. {}. No check uses these times.",
                           repetitions, machine),
           .x = {.label = "error", .unit = "1", .log = true},
           .y = {.label = "time of a run", .unit = "ns", .log = true}});
    }
    std::vector<Series>& series = figures.back().series;
    if (series.empty() || series.back().label != row[2]) series.push_back({.label = row[2], .style = Style::errorbars});
    series.back().x.push_back(std::stod(row[3]));
    series.back().y.push_back(std::stod(row[4]));
    series.back().y_low.push_back(std::stod(row[5]));
    series.back().y_high.push_back(std::stod(row[6]));
  }
  return figures;
}

/// The method, or the one by which a fault replaces it.
std::string given(const std::string& method, const Setup& setup) {
  return setup.has("late_events") && method == "stormer_cowell" ? "odeint_dopri5" : method;
}

/// True for methods of the checks that must fail under a fault.
bool decides_faults(std::string_view method) {
  return method == "velocity_verlet" || method == "rk4" || method == "odeint_dopri5" || method == "stormer_cowell";
}

SceneCurves curves_of(const WorkScene& scene, const Setup& setup, Findings& findings) {
  SceneCurves all{&scene, {}};
  for (const std::string method : work_methods) {
    if (setup.coarse && !decides_faults(method)) continue;
    all.curves.push_back(work_curve(scene, given(method, setup), findings));
    all.curves.back().method = method;
    if (setup.has("stages_not_counted") && method == "rk4") {
      for (CurvePoint& point : all.curves.back().points)
        point.evaluations /= 4.0;
    }
  }
  return all;
}

/// The curve of a method, which must have been run.
const WorkCurve& curve(const SceneCurves& all, const std::string& method) {
  return *std::find_if(all.curves.begin(), all.curves.end(), [&](const WorkCurve& c) { return c.method == method; });
}

/// An order given by theory, and the range of errors in which it is measured.
struct ExpectedOrder {
  const char* method;
  const char* scene;
  double order;
  double minimum, maximum;
  double admitted;  ///< deviation allowed in both directions
  const char* why;
};
constexpr const char* second =
    "smooth motion, errors in even powers of the step: the next term has the relative size of the error itself, 1e-3 "
    "at the coarsest point, which changes the order over three decades by less than twice that";
constexpr const char* smooth = "smooth motion; the next power of the step changes the order by a tenth; twice that";
constexpr const char* kink =
    "a kink of the force within a step, at 64 phases: order 2 for every method; 64 phases leave a few hundredths of a "
    "root mean square, the next power of the coarsest step a tenth";
constexpr const char* jump =
    "a jump of the force within a step, at 64 phases: order 1 for every method; 64 phases leave a few hundredths of a "
    "root mean square, the next power of the coarsest step a tenth";
constexpr ExpectedOrder orders[] = {
    {"velocity_verlet", "pendulum, 90 degrees", 2.0, 1e-6, 1e-3, 0.002, second},
    {"velocity_verlet", "pendulum, 170 degrees", 2.0, 1e-6, 1e-3, 0.002, second},
    {"velocity_verlet", "two cables", 2.0, 1e-6, 1e-3, 0.002, second},
    {"blanes_moan4", "pendulum, 170 degrees", 4.0, 3e-10, 1e-5, 0.2, smooth},
    {"blanes_moan4", "two cables", 4.0, 1e-10, 1e-5, 0.2, smooth},
    {"rk4", "two cables", 4.0, 1e-11, 1e-7, 0.2, smooth},
    {"rk4", "pendulum, 170 degrees", 5.0, 1e-9, 1e-2, 0.3,
     "near the upper equilibrium the period of an oscillation depends on its energy, of which each step loses the "
     "fraction z^6/72, z = w h: order 5 where that exceeds the phase error of order 4"},
    {"velocity_verlet", "wall, undamped", 2.0, 3e-6, 1e-2, 0.15, kink},
    {"rk4", "wall, undamped", 2.0, 3e-6, 1e-2, 0.15, kink},
    {"blanes_moan4", "wall, undamped", 2.0, 3e-6, 1e-2, 0.15, kink},
    {"velocity_verlet", "wall, damped", 1.0, 8e-4, 3e-2, 0.1, jump},
    {"rk4", "wall, damped", 1.0, 8e-4, 3e-2, 0.1, jump},
    {"blanes_moan4", "wall, damped", 1.0, 8e-4, 3e-2, 0.1, jump},
    {"central_difference", "wall, undamped", 2.0, 3e-6, 1e-2, 0.15, kink},
    {"euler_cromer", "wall, undamped", 2.0, 3e-6, 1e-2, 0.15, kink},
    {"central_difference", "wall, damped", 1.0, 8e-4, 3e-2, 0.1, jump},
    {"euler_cromer", "wall, damped", 1.0, 8e-4, 3e-2, 0.1, jump},
    {"velocity_verlet", "pinned column", 1.0, 5e-4, 3e-2, 0.04, jump},
    {"rk4", "pinned column", 1.0, 5e-4, 3e-2, 0.1, jump}};

void check_orders(const SceneCurves& all, Findings& findings, const Setup& setup) {
  for (const ExpectedOrder& expected : orders) {
    if (expected.scene != all.scene->name || (setup.coarse && !decides_faults(expected.method))) continue;
    const auto claim = findings.in(fmt::format("integrator.{}", expected.method));
    findings.expect_order(fmt::format("order of {}, {}", expected.method, expected.scene),
                          between_errors(curve(all, expected.method), 0, expected.minimum, expected.maximum),
                          expected.order - expected.admitted, expected.order + expected.admitted, expected.why);
  }
}

/// Checks the error constants of the impact on a wall, at 1,024 evaluations.
void check_constants(const SceneCurves& all, Findings& findings) {
  const auto point = [&](const char* method) {
    const std::vector<CurvePoint>& points = curve(all, method).points;
    return *std::find_if(points.rbegin(), points.rend(), [](const CurvePoint& p) { return p.evaluations < 1100.0; });
  };
  // Error over the mean step; frequency and approach speed are 1.
  const auto over_step = [&](const char* method) { return point(method).rms[0] / point(method).setting; };
  constexpr double xi = 0.2;
  const double verlet = leapfrog_impact_error(xi, reference::EndRule::clamped).restitution;
  const double runge_kutta = 2.0 * xi / 6.0;
  const char* next =
      "the next power of the step, w h = 0.007 there, and the remainder of a mean square over 64 phases: 2 %";
  findings.expect_model("error of velocity_verlet over its prediction, wall, damped",
                        over_step("velocity_verlet") / verlet, 1.0, 0.02, next);
  findings.expect_model("error of rk4 over its prediction, wall, damped", over_step("rk4") / runge_kutta, 1.0, 0.02,
                        next);
  const double at_equal_work = point("rk4").rms[0] * point("rk4").evaluations /
                               (point("velocity_verlet").rms[0] * point("velocity_verlet").evaluations);
  findings.expect_model(
      {"rk4_over_verlet", "error of rk4 over that of velocity_verlet at equal work, over its prediction, wall, damped"},
      at_equal_work / (4.0 * runge_kutta / verlet), 1.0, 0.03, next);
}

/// Expected cheapest method, and the range of the ratio of the next method's evaluations to its own.
struct Advantage {
  const char* method;
  double minimum, maximum;
  const char* why;
};

Advantage expected_cheapest(const SceneCurves& all) {
  const bool closed_form = std::any_of(all.curves.begin(), all.curves.end(), [](const WorkCurve& each) {
    return each.method == "exact" && !each.points.empty();
  });
  if (closed_form) {
    return {"exact", 10.0, 50.0,
            "one evaluation per segment between events, where the next method restarts with order 1 and takes 10 to 50 "
            "for 1e-6"};
  }
  if (all.scene->runs > 1) {  // events
    return {
        "stormer_cowell", 4.0, 30.0,
        "step control without located events halves its steps about ten times at each event, with six or more stages "
        "per attempt, and increases them again: 60 to 200 evaluations where a located event takes 10 to 20 to restart"};
  }
  return {"stormer_cowell", 1.1, 4.0,
          "one evaluation per step of order 12, compared with two of order 8 or six of order 4"};
}

/// Checks that the expected method is the cheapest to 1e-6.
void check_cheapest(const SceneCurves& all, Findings& findings) {
  const Advantage expected = expected_cheapest(all);
  const WorkScene& scene = *all.scene;
  const auto claim = findings.in(fmt::format("integrator.{}", expected.method));
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    double others = std::numeric_limits<double>::infinity();
    for (const WorkCurve& other : all.curves) {
      if (other.method != expected.method) others = std::min(others, cost_of(other, q, 1e-6));
    }
    findings.expect_between(fmt::format("cheapest to 1e-6, {}: evaluations of the next over its, {}{}", expected.method,
                                        scene.name, scene.quantities.size() > 1 ? ", " + scene.quantities[q] : ""),
                            others / cost_of(curve(all, expected.method), q, 1e-6), expected.minimum, expected.maximum,
                            expected.why);
  }
}

/// Evaluations on the smooth motions known beforehand from other programs.
struct Known {
  const char* scene;
  double verlet;     ///< velocity Verlet, to 1e-6
  double odeint[3];  ///< best of odeint's steppers, to 1e-4, 1e-6, 1e-9
};
constexpr Known knowns[] = {{"pendulum, 90 degrees", 111780.0, {934.0, 1694.0, 5460.0}},
                            {"pendulum, 170 degrees", 144800.0, {3934.0, 6814.0, 14814.0}},
                            {"two cables", 56040.0, {454.0, 1134.0, 2854.0}}};

Cheapest best_of_odeint(const SceneCurves& all, double error) {
  SceneCurves only{all.scene, {}};
  for (const WorkCurve& each : all.curves) {
    if (each.method.starts_with("odeint_")) only.curves.push_back(each);
  }
  return cheapest(only, 0, error);
}

void compare_with_known(const SceneCurves& all, Findings& findings, Table& table) {
  for (const Known& known : knowns) {
    if (known.scene != all.scene->name) continue;
    const double verlet = cost_of(curve(all, "velocity_verlet"), 0, 1e-6);
    findings.expect_between(
        fmt::format("evaluations of velocity_verlet to 1e-6 over the known number, {}", known.scene),
        verlet / known.verlet, 0.9, 1.02,
        "the same formula; the known number is that of the first run of this accuracy, up to a tenth more than the "
        "value interpolated between two runs; 2 % for the interpolation");
    std::vector<std::string> row{known.scene, fmt::format("{:.0f} ({:.0f})", verlet, known.verlet)};
    const double errors[] = {1e-4, 1e-6, 1e-9};
    for (std::size_t i = 0; i < 3; ++i) {
      const Cheapest best = best_of_odeint(all, errors[i]);
      row.push_back(fmt::format("{:.0f} {} ({:.0f})", best.evaluations, best.method.substr(7), known.odeint[i]));
      findings.expect_between(
          fmt::format("evaluations of the best of odeint's steppers to {:.0e} over the known number, {}", errors[i],
                      known.scene),
          best.evaluations / known.odeint[i], 0.6, 1.5,
          "the same formulas; start-up of the multistep method, tested steps and tolerances, and interpolation differ: "
          "50 % more in either direction");
    }
    for (const double error : errors)
      row.push_back(evaluations_text(cost_of(curve(all, "stormer_cowell"), 0, error)));
    table.rows.push_back(row);
  }
}

/// Checks and notes the errors of the fence at the step of 1993.
void report_step_of_1993(const WorkScene& fence, Findings& findings) {
  constexpr double step = 2e-6;
  const long steps = std::lround(fence.duration / (static_cast<double>(fence.spans) * step));
  const WorkRun run = fence.measure(make_integrator("central_difference"), steps, 0, findings);
  findings.expect_between("fence, exit speed at the step of 1993: relative error", run.errors[0], 1e-4, 1e-2,
                          "w h = 0.016, of which a jump leaves a tenth: three digits are expected; a single run with "
                          "77 events may deviate by a factor of ten in either direction");
  findings.note(
      fmt::format("With the 2e-6 s of 1993 the scheme takes {:.0f} evaluations to 0.2 s; the relative error of the "
                  "rock's speed is {:.1e}, that of the largest tension {:.1e}.",
                  run.evaluations, run.errors[0], run.errors[1]));
}

void check_bounce(const SceneCurves& all, Findings& findings) {
  if (all.scene->name != "damped bounce") return;
  const Convergence found = between_errors(curve(all, "velocity_verlet"), 0, 1e-9, 0.2);
  findings.expect_order({"integrator.velocity_verlet", "order of velocity_verlet, damped bounce"}, found, 0.5, 1.4,
                        "13 contacts, each with a jump: order 1. The error of the first affects all later ones and the "
                        "times of touch, so that an error above 0.1 is no longer proportional to the step");
  findings.expect_between(
      "damped bounce: evaluations of velocity_verlet to 2e-2 over those of stormer_cowell",
      cost_of(curve(all, "velocity_verlet"), 0, 2e-2) / cost_of(curve(all, "stormer_cowell"), 0, 2e-2), 5.0, 100.0,
      "about 15 to 30 evaluations for each of 13 contacts, compared with w t/(w h) = 300/(w h) steps: each contact "
      "causes an error of 0.13 w h of the speed, which its effect on later touches multiplies by up to ten: 2,000 to "
      "20,000 steps for 2e-2");
}

void run(Findings& findings, const Setup& setup) {
  const std::vector<WorkScene> scenes = work_scenes(setup, !setup.coarse);
  std::vector<SceneCurves> all;
  std::vector<TimedPoint> timed;
  Table known{
      .name = "known",
      .caption = "Evaluations on the smooth motions; in brackets the numbers known beforehand from other programs.",
      .columns = {"motion", "verlet 1e-6", "odeint 1e-4", "odeint 1e-6", "odeint 1e-9", "stormer 1e-4", "stormer 1e-6",
                  "stormer 1e-9"}};
  for (const WorkScene& scene : scenes) {
    if (!setup.needs(scene.name)) continue;
    all.push_back(curves_of(scene, setup, findings));
    check_orders(all.back(), findings, setup);
    if (scene.name == "wall, damped") check_constants(all.back(), findings);
    check_cheapest(all.back(), findings);
    check_bounce(all.back(), findings);
    if (!setup.coarse) compare_with_known(all.back(), findings, known);
    if (scene.name == "fence") report_step_of_1993(scene, findings);
    if (setup.tier == Tier::full && !setup.coarse) {
      const std::vector<TimedPoint> points = timed_points(all.back());
      timed.insert(timed.end(), points.begin(), points.end());
    }
  }
  if (setup.coarse) return;
  const DataFile data = work_data(all);
  std::vector<Figure> figures = work_figures(data);
  std::rotate(figures.begin(), figures.end() - 2, figures.end());  // the fence first, because the page shows it
  for (Figure& figure : figures)
    findings.figure(std::move(figure));
  findings.data(data);
  findings.table(cheapest_table(all));
  findings.table(known);
  for (const Table& table : cost_tables(all))
    findings.table(table);
  if (timed.empty()) return;
  const DataFile times = timing_data(timed, setup.machine);
  for (const Figure& figure : timing_figures(times, setup.machine))
    findings.figure(figure);
  findings.data(times);
}

}  // namespace

Case definition() {
  const std::string equal_work = "rk4_over_verlet";
  return {.id = "work_precision",
          .title = "Work-precision diagrams of all integrators",
          .family = "speed and accuracy",
          .requirements = {},
          .main_checks = {"order of velocity_verlet, wall, damped", "order of velocity_verlet, wall, undamped",
                          equal_work, "order of blanes_moan4, two cables",
                          "cheapest to 1e-6, stormer_cowell: evaluations of the next over its, pendulum, 90 degrees",
                          "cheapest to 1e-6, stormer_cowell: evaluations of the next over its, fence, exit speed"},
          .source =
              "Swope et al. 1982; Blanes & Moan 2002; Krogh 1974; Hairer, Lubich & Wanner 2006; Ahnert & Mulansky 2011",
          .faults = {{"other_amplitude", "a pendulum released 0.001 rad higher",
                      "order of velocity_verlet, pendulum, 90 degrees"},
                     {"commensurate", "steps that divide the contact time", "order of velocity_verlet, wall, undamped"},
                     {"stages_not_counted", "steps of rk4 counted instead of its evaluations", equal_work},
                     {"late_events", "Dormand-Prince with step control instead of stormer_cowell",
                      "cheapest to 1e-6, stormer_cowell: evaluations of the next over its, pinned column"}},
          .seconds = 4.0,
          .full_seconds = 59.0,
          .run = run};
}

}  // namespace talus::verification::problems::work_precision
