#include "verification/problems/founding/work_precision_findings.hpp"

#include "verification/study/runs/swing.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double amplitude = 60.0 * degree;

/// The oscillation that all methods integrate.
struct Swing {
  Scene scene;
  reference::PendulumMotion motion{bob_motion(amplitude)};
  double duration{0.8 * motion.period()};

  SwingError error(const Integrator& integrator, long steps) const {
    return swing_error(scene, integrator, duration, steps, bob_frequency(), motion);
  }
};

/// Checks the order of one method; returns its error against force evaluations.
Series study(const MethodRange& method, const Swing& swing, Findings& findings, const Setup& setup) {
  const Integrator integrator = method.name == "velocity_verlet" ? verlet(setup) : make_integrator(method.name);
  Convergence convergence;
  Series series{.label = std::string(method.name)};
  const double ratio = setup.coarse ? 8.0 : std::pow(2.0, method.order() < 3 ? 1.0 : 0.5);
  // A coarse run uses only three steps, four times shorter, at which the tilt is a sixteenth.
  for (double n = static_cast<double>(method.first) * (setup.coarse ? 4.0 : 0.125); n < 2.5e5; n *= ratio) {
    const long steps = std::lround(n);
    if (steps < 5) continue;
    const SwingError run = swing.error(integrator, steps);
    findings.count(run.evaluations);
    if (steps >= method.first && steps <= method.last) convergence.add(1.0 / static_cast<double>(steps), run.error);
    if (!(run.error > 1.0)) {
      series.add(static_cast<double>(run.evaluations), run.error);
    }
    if (run.evaluations > 170000 || run.error < 2e-14 || (setup.coarse && steps >= 4096)) break;
  }
  const auto claim = findings.in(fmt::format("integrator.{}", method.name));
  findings.expect_order({"order", "order of " + std::string(method.name)}, convergence,
                        method.order() - method.admitted(), method.order() + method.admitted(),
                        fmt::format("declared order {}; the next two terms of the expansion, determined from the "
                                    "errors at three coarser steps, tilt the line fitted between {} and {} steps by "
                                    "{:+.2g}: 1.5 times this is allowed in either direction, for the higher terms",
                                    method.order(), method.first, method.last, method.tilt));
  return series;
}

/// A method without a fixed step: the finest tolerance whose error is above round-off, and the range allowed for the
/// order of the error in the tolerance.
struct ToleranceRange {
  const char* name;
  double finest;
  double low, high;
  const char* why;
};

/// Checks the error of a method against its tolerance; returns it against force evaluations.
Series study_tolerance(const ToleranceRange& method, const Swing& swing, Findings& findings) {
  Series stepless{.label = method.name};
  Convergence kept;
  for (double tolerance = 1e-3; tolerance > 0.5 * method.finest; tolerance *= 0.1) {
    const SwingError run = swing.error(make_integrator(method.name, tolerance), 1);
    kept.add(tolerance, run.error);
    stepless.add(static_cast<double>(run.evaluations), run.error);
  }
  findings.in(fmt::format("integrator.{}", method.name))
      ->expect_order(fmt::format("order of the error of {} in the tolerance", method.name), kept, method.low,
                     method.high, method.why);
  return stepless;
}

constexpr ToleranceRange bulirsch_stoer_range{
    "odeint_bulirsch_stoer", 1e-13, 0.8, 1.2,
    "order and step are chosen so that the error of a step stays below the tolerance: the global "
    "error is proportional to it, with scatter from these choices"};
constexpr ToleranceRange stormer_cowell_range{
    "stormer_cowell", 1e-12, 0.9, 1.4,
    "the tolerance bounds the error of the prediction; the corrected value is more accurate by one order, so that the "
    "global error has the order 1 + 1/k in the tolerance, with k terms, 4 to 12; scatter from the choice of k"};

/// Empty chart of error against force evaluations.
Figure chart(const char* name, const char* title, const std::string& caption) {
  return {.name = name,
          .title = title,
          .caption = "Error after 0.8 periods (60 degrees) against force evaluations, " + caption +
                     " Dashed: the declared orders. Horizontal line: half an ulp of the angle; the round-off of n "
                     "steps accumulates above it.",
          .x = {"force evaluations", "1", true},
          .y = {"error", "rad", true},
          .series = {},
          .slopes = {},
          .lines = {{'y', 0.5 * epsilon, "round-off of one operation"}}};
}

/// Position at which the slope of a method's order is drawn for comparison, so that slopes and labels do not overlap
/// the curves.
struct SlopeMark {
  double fraction;  ///< fraction of the curve's points before it
  double height;    ///< ratio to the curve there; 0: the method has no slope
};
SlopeMark slope_mark(std::string_view method) {
  if (method == "euler_cromer") return {0.75, 0.2};
  if (method == "velocity_verlet") return {0.95, 0.1};
  if (method == "rk4") return {0.75, 0.1};
  if (method == "odeint_dopri5") return {0.5, 20.0};
  return {0.5, method == "odeint_fehlberg78" ? 0.05 : 0.0};
}

/// Adds a method's curve to a chart of error against work and, for some methods, the slope of its order.
void draw(const MethodRange& method, const Series& series, Figure& chart) {
  chart.series.push_back(series);
  const SlopeMark mark = slope_mark(method.name);
  if (mark.height == 0.0 || series.x.empty()) return;
  const auto at = static_cast<std::size_t>(mark.fraction * static_cast<double>(series.x.size()));
  chart.slopes.push_back({-static_cast<double>(method.order()), series.x[at], mark.height * series.y[at],
                          fmt::format("order {}", method.order())});
}

}  // namespace

void check_work_and_precision(Findings& findings, const Setup& setup) {
  const Swing swing{.scene = scenes::pendulum(bob(setup, amplitude))};
  Figure own =
      chart("work_precision", "Work and precision on a smooth motion: the solver's methods",
            "for the solver's methods: from point to point the step is halved for orders 1 and 2, and divided "
            "by the square root of 2 for order 4; the tolerance of stormer_cowell is divided by ten. The next figure "
            "shows odeint's steppers.");
  Figure odeint = chart("work_precision_odeint", "Work and precision on a smooth motion: odeint's steppers",
                        "for odeint's steppers, with rk4 for comparison: from point to point the step is divided by "
                        "the square root of 2, and for odeint_bulirsch_stoer, which has no fixed step, the tolerance "
                        "by ten. Charts against computing time, and other scenes: case `work_precision`.");
  Series rk4;
  for (const auto& method : method_ranges) {
    if (setup.coarse && method.name != "velocity_verlet") continue;
    const Series series = study(method, swing, findings, setup);
    // Its curve is that of central_difference.
    if (method.name != "lagged_central_difference") draw(method, series, method.is_odeint() ? odeint : own);
    if (method.name == "rk4") rk4 = series;
  }
  if (setup.coarse) return;
  own.series.push_back(study_tolerance(stormer_cowell_range, swing, findings));
  odeint.series.push_back(study_tolerance(bulirsch_stoer_range, swing, findings));
  rk4.style = Style::lines;
  odeint.series.push_back(rk4);
  findings.figure(own);
  findings.figure(odeint);
}

}  // namespace talus::verification::problems
