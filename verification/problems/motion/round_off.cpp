#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <stdexcept>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/integrate/lagged_central_difference.hpp"
#include "solver/integrate/runge_kutta4.hpp"
#include "solver/integrate/velocity_verlet.hpp"
#include "verification/reference/integration/stepped_swing.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::round_off {
namespace {

/// One body on a spring and a dashpot, x'' = -x - c x', in numbers of any type: the smallest system that the solver's
/// integrators accept. Planted fault: accelerations are rounded to a coarser type, `Force`.
template <class Scalar, class Force = Scalar>
class SwingingBody {
 public:
  explicit SwingingBody(const Scalar& damping) : damping_{damping} { rates_.v.resize(1); }

  void drift(StateOf<Scalar>& state, const Scalar& h) { drift_coordinates(state, h); }
  void kick(StateOf<Scalar>& state, const Scalar& h) {
    evaluate(state, rates_);
    kick_velocities(state, rates_, h);
  }
  void update_modes(StateOf<Scalar>&) {}
  void derivative(const StateOf<Scalar>& state, RatesOf<Scalar>& out) {
    ++evaluations_;
    const Scalar acceleration = -state.q[0] - damping_ * state.v[0];
    out.v[0] = static_cast<Scalar>(static_cast<Force>(acceleration));
  }
  void evaluate(StateOf<Scalar>& state, RatesOf<Scalar>& out) { derivative(state, out); }

  /// Number of force evaluations so far.
  long evaluations() const { return evaluations_; }

 private:
  Scalar damping_;
  RatesOf<Scalar> rates_;
  long evaluations_{0};
};

static_assert(Splittable<SwingingBody<float>, StateOf<float>> && Differentiable<SwingingBody<float>, StateOf<float>>);

/// Type to which accelerations are rounded; planted faults except `exact`.
enum class Forces { exact, in_double, in_float };

struct SwingRun {
  reference::Parts position{};  ///< final x, synchronised
  std::uint64_t evaluations{};  ///< number of force evaluations
};

using Quadruple = boost::multiprecision::cpp_bin_float_quad;
using reference::SteppedSwing;
using reference::SwingMethod;

/// The number as a sum of doubles: each part is the remainder, rounded to double.
template <class Scalar>
reference::Parts parts(Scalar number) {
  reference::Parts made{};
  for (double& part : made) {
    part = static_cast<double>(number);
    number -= static_cast<Scalar>(part);
  }
  return made;
}

template <class Scalar, class Force>
SwingRun swung(auto method, const SteppedSwing& swing) {
  record_use(fmt::format("integrator.{}", decltype(method)::name));
  SwingingBody<Scalar, Force> body{static_cast<Scalar>(swing.damping)};
  StateOf<Scalar> state;
  state.q = {Scalar{1}};
  state.v = {Scalar{0}};
  const Scalar h = static_cast<Scalar>(swing.step);
  method.start(body, state, h);
  for (std::int64_t i = 0; i < swing.steps; ++i)
    method.step(body, state, h);
  const StateOf<Scalar> end = synchronized(method, body, state, h);
  return {parts(end.q[0]), static_cast<std::uint64_t>(body.evaluations())};
}

template <class Scalar, class Force>
SwingRun swung(const SteppedSwing& swing) {
  switch (swing.method) {
    case SwingMethod::euler_cromer:
      return swung<Scalar, Force>(EulerCromerOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::central_difference:
      return swung<Scalar, Force>(CentralDifferenceOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::lagged_central_difference:
      return swung<Scalar, Force>(LaggedCentralDifferenceOf<StateOf<Scalar>>{}, swing);
    case SwingMethod::velocity_verlet:
      return swung<Scalar, Force>(VelocityVerletOf<StateOf<Scalar>>{}, swing);
    default:
      return swung<Scalar, Force>(RungeKutta4Of<StateOf<Scalar>>{}, swing);
  }
}

template <class Scalar>
SwingRun swung(const SteppedSwing& swing, Forces forces) {
  if (forces == Forces::in_float) return swung<Scalar, float>(swing);
  if (forces == Forces::in_double) return swung<Scalar, double>(swing);
  return swung<Scalar, Scalar>(swing);
}

/// Runs `swing` with the solver's integrator in numbers of `bits` bits. Step and damping must be numbers of 24 bits, so
/// that all types run the same problem. Errors: std::invalid_argument for other bits.
SwingRun swing_in_numbers(const SteppedSwing& swing, int bits, Forces forces = Forces::exact) {
  switch (bits) {
    case 24:
      return swung<float, float>(swing);
    case 53:
      return swung<double>(swing, forces);
    case 64:
      return swung<long double>(swing, forces);
    case 113:
      return swung<Quadruple>(swing, forces);
    default:
      throw std::invalid_argument("swing_in_numbers: numbers have 24, 53, 64 or 113 bits");
  }
}

struct Method {
  SwingMethod method;
  const char* name;
  int order;
  int additions;  ///< to x or v per step; two that round alike count as four
};

constexpr std::array methods{Method{SwingMethod::central_difference, "central_difference", 2, 2},
                             Method{SwingMethod::lagged_central_difference, "lagged_central_difference", 2, 2},
                             Method{SwingMethod::velocity_verlet, "velocity_verlet", 2, 5},
                             Method{SwingMethod::euler_cromer, "euler_cromer", 1, 2},
                             Method{SwingMethod::runge_kutta, "rk4", 4, 8}};
constexpr std::array all_bits{24, 53, 64, 113};

/// Step of a run, a number of 24 bits. The end times of the runs are spread over half a period from 10 on.
double step_of(int run, int runs, long steps) {
  const double time = 10.0 + std::numbers::pi * (run + 0.5) / runs;
  return static_cast<double>(static_cast<float>(time / static_cast<double>(steps)));
}

/// Contribution of one step to the mean square of the rounding error: each of the step's additions has the mean square
/// w^2/12, w the last place of cos t (u where |cos t| > 1/2, u/2 above 1/4, ...); half of it enters the final x.
double rounding_of_a_step(const Method& method, int bits) {
  double sum = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double top = std::ldexp(1.0, -k);
    sum += top * top * (std::acos(0.5 * top) - std::acos(top)) * 2.0 / std::numbers::pi;
  }
  return method.additions * sum / 24.0 * std::ldexp(1.0, -2 * bits);
}

/// Leading term of the method's truncation error at t.
double truncation(const Method& method, double t, double h) {
  if (method.order == 1) return 0.5 * h * std::sin(t);
  return method.order == 2 ? t * h * h / 24.0 * std::sin(t) : t * std::pow(h, 4) / 120.0 * std::sin(t);
}

Forces forces_of(const Setup& setup) {
  if (setup.has("forces_in_float")) return Forces::in_float;
  return setup.has("forces_in_double") ? Forces::in_double : Forces::exact;
}

/// Root mean square of the rounding error over the runs, for each number of bits.
std::array<double, 4> rounding(Findings& findings, const Method& method, long steps, int runs, Forces forces) {
  std::array<double, 4> squares{};
  for (int i = 0; i < runs; ++i) {
    const SteppedSwing swing{method.method, 0.0, step_of(i, runs, steps), steps};
    std::vector<reference::Parts> positions;
    for (const int bits : all_bits) {
      const SwingRun run = swing_in_numbers(swing, bits, forces);
      findings.count(run.evaluations);
      positions.push_back(run.position);
    }
    const std::vector<double> errors = reference::rounding_errors(swing, positions);
    for (std::size_t k = 0; k < errors.size(); ++k)
      squares[k] += errors[k] * errors[k] / runs;
  }
  for (double& square : squares)
    square = std::sqrt(square);
  return squares;
}

/// Checks a method against its own map in 113 bits, with a dashpot, so that the velocity used by the dashpot matters.
void check_map(Findings& findings, const Method& method, Forces forces) {
  const long steps = 100;
  const SteppedSwing swing{method.method, 0.125, 0.125, steps};
  const SwingRun run = swing_in_numbers(swing, 113, forces);
  const auto claim = findings.in(fmt::format("integrator.{}", method.name));
  findings.count(run.evaluations);
  findings.expect_round_off(
      {"distance_from_map", fmt::format("distance from the method's map in 113 bits, dashpot, {}", method.name)},
      reference::rounding_errors(swing, {run.position})[0], 0.0,
      std::sqrt(static_cast<double>(method.additions * steps)) * 0x1p-113,
      "each addition rounds by at most half a unit in the last place of numbers up to 1, at random: sqrt(n) of these");
}

/// Error over the runs at one step size.
struct ErrorAt {
  double step{};       ///< mean
  double whole{};      ///< root mean square
  double predicted{};  ///< from truncation and rounding
};

ErrorAt error_at(Findings& findings, const Method& method, int bits, long steps, int runs, double damping) {
  ErrorAt sum;
  for (int i = 0; i < runs; ++i) {
    const SteppedSwing swing{method.method, 0.0, step_of(i, runs, steps), steps};
    SteppedSwing stepped = swing;
    stepped.damping = damping;
    const SwingRun run = swing_in_numbers(stepped, bits);
    findings.count(run.evaluations);
    const double n = static_cast<double>(steps);
    sum.step += swing.step / runs;
    sum.whole += std::pow(reference::whole_error(swing, run.position), 2) / runs;
    sum.predicted +=
        (std::pow(truncation(method, swing.step * n, swing.step), 2) + n * rounding_of_a_step(method, bits)) / runs;
  }
  return {sum.step, std::sqrt(sum.whole), std::sqrt(sum.predicted)};
}

/// Step of minimum error: 2 p (truncation error)^2 = (rounding error)^2, both as means over half a period about
/// t = 10 + pi/2.
double best_step(const Method& method, int bits) {
  const double t = 10.0 + 0.5 * std::numbers::pi;
  const double constant = truncation(method, t, 1.0) / std::sin(t) * std::sqrt(0.5);
  return std::pow(rounding_of_a_step(method, bits) * t / (2.0 * method.order * constant * constant),
                  1.0 / (2.0 * method.order + 1.0));
}

/// Numbers of steps, doubled from `first` to `last`: the error is truncation alone up to `method_last`, rounding alone
/// from `rounding_first` on.
struct Range {
  long first, method_last, rounding_first, last;
  int runs;
};

struct Fall {
  Convergence method, rounding;
  std::vector<ErrorAt> all;
};

Fall measured(Findings& findings, const Method& method, int bits, const Range& range, double damping) {
  Fall fall;
  for (long steps = range.first; steps <= range.last; steps *= 2) {
    const ErrorAt now = error_at(findings, method, bits, steps, range.runs, damping);
    if (steps <= range.method_last) fall.method.add(now.step, now.whole);
    if (steps >= range.rounding_first) fall.rounding.add(now.step, now.whole);
    fall.all.push_back(now);
  }
  return fall;
}

/// Largest deviations over all methods and number types.
struct Furthest {
  double slope{};  ///< of the rounding error against the step, minus -1/2
  double step{};   ///< of minimum error: log2 of its ratio to the prediction
};

void check_fall(Findings& findings, const Method& method, int bits, const Fall& fall, Furthest& furthest,
                Figure& figure, Table& table) {
  const std::string of = fmt::format("{}, {} bits", method.name, bits);
  const auto claim = findings.in(fmt::format("integrator.{}", method.name));
  findings.expect_order({"error_against_step", fmt::format("order of the truncation error, {}", of)}, fall.method,
                        method.order - 0.15, method.order + 0.35,
                        "the order of the method; the next term of its error adds to it");
  if (fall.rounding.size() == 0) return;
  keep_worst(furthest.slope, fall.rounding.fit().order + 0.5);
  const auto minimum = std::min_element(fall.all.begin(), fall.all.end(),
                                        [](const ErrorAt& a, const ErrorAt& b) { return a.whole < b.whole; });
  keep_worst(furthest.step, std::log2(minimum->step / best_step(method, bits)));
  findings.expect_between({"minimum_error", fmt::format("minimum error over its prediction, {}", of)},
                          minimum->whole / minimum->predicted, 0.65, 1.5,
                          "rounding errors of similar runs are not independent, nor are those of successive steps");
  table.rows.push_back(cells("{} | {} | {:.1e} | {:.1e} | {:.1e}", method.name, bits, best_step(method, bits),
                             minimum->step, minimum->whole));
  // Without damping, the lagged central difference equals the central difference.
  if (method.method == SwingMethod::lagged_central_difference) return;
  Series points{of, {}, {}, Style::points}, line{of + ", predicted", {}, {}, Style::lines};
  for (const ErrorAt& at : fall.all) {
    points.add(at.step, at.whole);
    line.add(at.step, at.predicted);
  }
  figure.series.push_back(points);
  figure.series.push_back(line);
}

std::optional<Range> range_of(const Method& method, int bits, Tier tier) {
  const bool full = tier == Tier::full;
  if (bits == 24) {
    if (method.order == 4) return Range{16, 64, 512, 4096, 64};
    if (method.order == 2) return Range{64, 512, 8192, 32768, 64};
    return Range{128, 1024, 4096, 1024, 64};
  }
  if (method.order == 4 && bits == 53 && full) return Range{64, 2048, 65536, 524288, 16};
  if (method.order == 4 && bits == 64 && full) return Range{64, 8192, 524288, 2097152, 8};
  if (method.method == SwingMethod::velocity_verlet && bits == 53 && full)
    return Range{1024, 65536, 16777216, 67108864, 4};
  return std::nullopt;
}

/// Checks the rounding error after 500 steps in numbers of 24 to 113 bits against its prediction, and each method
/// against its own map in 113 bits.
void check_numbers(Findings& findings, const Setup& setup) {
  const Forces forces = forces_of(setup);
  for (const Method& method : methods)
    check_map(findings, method, forces);
  const long steps = 500;
  const int runs = setup.coarse ? 16 : 32;
  Table table{.name = "numbers",
              .caption = "Rounding error after 500 steps over its prediction, root mean square of 32 runs.",
              .columns = {"method", "24 bits", "53 bits", "64 bits", "113 bits"}};
  double furthest = 0.0;
  for (const Method& method : methods) {
    if (setup.coarse && method.order == 4) continue;
    const std::array<double, 4> left = rounding(findings, method, steps, runs, forces);
    std::vector<std::string> row{method.name};
    for (std::size_t k = 0; k < left.size(); ++k) {
      const double ratio = left[k] / std::sqrt(steps * rounding_of_a_step(method, all_bits[k]));
      keep_worst(furthest, std::log2(ratio));
      row.push_back(fmt::format("{:.2f}", ratio));
    }
    table.rows.push_back(row);
  }
  findings.expect_between(
      {"rounding_error", "log2 of the rounding error over its prediction, worst of all methods and number formats"},
      furthest, -0.6, 0.6, "32 runs determine a root mean square to one eighth if independent, to two eighths if not");
  if (!setup.coarse) findings.table(table);
}

/// Checks the total error against the step: it decreases at the method's order, has its minimum where predicted, and
/// increases below by rounding.
void check_best_steps(Findings& findings, const Setup& setup) {
  Figure figure{.name = "least",
                .title = "Step of minimum error",
                .caption =
                    "Error of the position after 10 to 13 time units, relative to the amplitude: root mean square of "
                    "the runs, and the prediction from truncation and rounding.",
                .x = {.label = "step", .unit = "s", .log = true},
                .y = {.label = "error / amplitude", .log = true}};
  Table table{.name = "best_steps",
              .caption = "Step of minimum error; any smaller step makes the result worse.",
              .columns = {"method", "bits", "predicted", "measured", "minimum error"}};
  const double damping = setup.has("dashpot_left_on") ? 0x1p-10 : 0.0;
  Furthest furthest;
  for (const Method& method : methods) {
    for (const int bits : all_bits) {
      std::optional<Range> range = range_of(method, bits, setup.tier);
      if (!range || (setup.coarse && (bits != 24 || method.order != 4))) continue;
      check_fall(findings, method, bits, measured(findings, method, bits, *range, damping), furthest, figure, table);
    }
  }
  findings.expect_between(
      {"slope_of_rounding", "slope of the rounding error against the step, deviation from -1/2, worst of all"},
      furthest.slope, -0.2, 0.2,
      "a random walk grows with the square root of the number of steps; a tenth of the steps, which round alike, adds "
      "to it");
  findings.expect_between({"best_step", "log2 of the step of minimum error over its prediction, worst of all"},
                          furthest.step, -1.1, 1.1,
                          "steps are sampled at factors of two, and the sum of both errors is flat near its minimum");
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

constexpr int runs = 16;
constexpr double middle = 1.5, swing = 0.25;

Scene swing_scene(const Setup& setup) {
  const double origin = setup.has("far_from_the_origin") ? 4096.0 : 0.0;
  SceneBuilder builder{si};
  const BodyId mass = builder.add(Body{.name = "mass",
                                       .mobility = Mobility::sliding_x,
                                       .mass = 1.0,
                                       .p_WB = {origin + middle + swing, 0.0},
                                       .force = {middle - 1.0, 0.0}});
  builder.add_cable("cable", {mass, {}}, {std::nullopt, {origin, 0.0, 0.0}}, 1.0,
                    TensionOnly{setup.has("stiffness_off") ? 1.0 + 1e-12 : 1.0, 0.0});
  return builder.at_rest("Mass on a taut cable");
}

Integrator integrator_of(SwingMethod method) {
  return method == SwingMethod::velocity_verlet ? Integrator{VelocityVerlet{}} : Integrator{RungeKutta4{}};
}

/// Final position in the solver, relative to the centre of the oscillation, over its amplitude.
double solver_position(SwingMethod method, double step, long steps, const Setup& setup, Findings& findings) {
  const Scene scene = swing_scene(setup);
  const RunEnd run = run_steps(scene, integrator_of(method), step, steps, findings);
  return (run.state.q[0] - (scene.initial.q[0] - swing)) / swing;
}

/// Root mean square over the runs of the rounding error after `steps` steps.
double solver_rounding(SwingMethod method, long steps, const Setup& setup, Findings& findings) {
  double sum = 0.0;
  for (int i = 0; i < runs; ++i) {
    const double step = (10.0 + std::numbers::pi * (i + 0.5) / runs) / static_cast<double>(steps);
    const double error = solver_position(method, step, steps, setup, findings) -
                         reference::unrounded_position({method, 0.0, step, steps});
    sum += error * error;
  }
  return std::sqrt(sum / runs);
}

/// Checks the rounding error of the complete solver on a scene.
void check_scene(Findings& findings, const Setup& setup, SwingMethod method) {
  const bool verlet = method == SwingMethod::velocity_verlet;
  const long steps = 2000;
  // One addition to x, or four with rk4; additions to v are of numbers eight times smaller.
  const double predicted = std::sqrt(static_cast<double>(steps) * (verlet ? 1.0 : 4.0) / 6.0) * 0x1p-53 / swing;
  const double left = solver_rounding(method, steps, setup, findings);
  const auto claim = findings.in(verlet ? "integrator.velocity_verlet" : "integrator.rk4");
  findings.expect_between(
      {"rounding_of_scene",
       fmt::format("rounding error of a scene over its prediction, {}", verlet ? "velocity_verlet" : "rk4")},
      left / predicted, 0.5, 2.0, "16 runs determine a root mean square to one fifth; the force is rounded, too");
}

void run(Findings& findings, const Setup& setup) {
  check_scene(findings, setup, SwingMethod::velocity_verlet);
  check_scene(findings, setup, SwingMethod::runge_kutta);
  check_numbers(findings, setup);
  check_best_steps(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "round_off",
      .title = "Round-off: growth over long runs",
      .requirements = {{"A8",
                        {"rounding_of_scene", "distance_from_map", "rounding_error", "error_against_step",
                         "minimum_error", "slope_of_rounding", "best_step"}},
                       {"law.tension_only", {"rounding_of_scene"}}},
      .main_checks = {"rounding error of a scene over its prediction, velocity_verlet", "rounding_error", "best_step"},
      .source = "Henrici 1962, chapter 1; Hairer, Lubich & Wanner 2006, section VIII.5",
      .faults = {{"far_from_the_origin", "the scene is 4096 lengths from the origin of coordinates",
                  "rounding error of a scene over its prediction, velocity_verlet"},
                 {"stiffness_off", "the stiffness is too large by 1e-12",
                  "rounding error of a scene over its prediction, rk4"},
                 {"forces_in_double", "accelerations in 113 bits are rounded to double",
                  "distance from the method's map in 113 bits, dashpot, rk4"},
                 {"forces_in_float", "accelerations in double are rounded to float", "rounding_error"},
                 {"dashpot_left_on", "a dashpot of 2^-10, whose error no smaller step reduces",
                  "order of the truncation error, rk4, 24 bits"}},
      .full_seconds = 32.0,
      .run = run};
}

}  // namespace talus::verification::problems::round_off
