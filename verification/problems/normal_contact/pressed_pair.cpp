#include "verification/reference/many_bodies/pressed_discs.hpp"
#include "verification/study/impacts/plane_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::pressed_pair {
namespace {

constexpr double stiffness = 1024.0, squeeze = 0.125, end_time = 1.0;

struct Pair {
  double above{1.0};
  double lag{};
  double gravity{};
  reference::PressedPair exact() const { return {1.0, above, stiffness, lag, gravity}; }
};

constexpr reference::PressedPairState start{{0.03125, -0.015625}, {0.0, 0.0}};

Scene pair_scene(const Pair& pair, const Setup& setup) {
  SceneBuilder builder;
  builder.gravity({0.0, -pair.gravity});
  const LinearSpringDashpot law{stiffness, pair.lag * stiffness, EndRule::attractive};
  const double first = 1.0 - squeeze, second = first + 2.0 - squeeze, top = second + 1.0 - squeeze;
  const auto add_disc = [&](const char* name, double mass, double y) {
    return builder.add(
        Body{.name = name, .mobility = Mobility::particle, .mass = mass, .shape = Circle{1.0}, .p_WB = {0.0, y}});
  };
  const double above = setup.has("upper_heavier") ? 1.01 * pair.above : pair.above;
  const BodyId floor = builder.add_fixed("floor", HalfPlane{});
  const BodyId ceiling = builder.add_fixed("ceiling", HalfPlane{}, {0.0, top}, std::numbers::pi);
  const BodyId lower = add_disc("lower", 1.0, first + start.height[0]);
  const BodyId upper = add_disc("upper", above, second + start.height[1]);
  LinearSpringDashpot middle = law;
  if (setup.has("dashpot_between_off")) middle.damping = 0.0;
  builder.add_contact("on_floor", floor, lower, law);
  builder.add_contact("between", lower, upper, middle);
  builder.add_contact("on_ceiling", ceiling, upper, law);
  return builder.at_rest("Two discs between walls");
}

/// Largest difference of both heights from `expected(t)` over the run, relative to the first displacement.
template <class Expected>
double largest_error(const Pair& pair, const Integrator& method, long steps, const Expected& expected,
                     Findings& findings, const Setup& setup, Series* heights = nullptr) {
  double largest = 0.0;
  const double lower = 1.0 - squeeze, upper = 3.0 - 2.0 * squeeze;
  const Watcher observer = [&](const State& state, const StepInfo&) {
    const auto exact = expected(state.t);
    const double error =
        std::max(std::abs(state.q[1] - lower - exact[0]), std::abs(state.q[3] - upper - exact[1])) / start.height[0];
    keep_worst(largest, error);
    if (!heights) return;
    heights[0].add(state.t, state.q[1] - lower);
    heights[1].add(state.t, state.q[3] - upper);
  };
  const RunEnd end =
      run_steps(pair_scene(pair, setup), method, end_time / static_cast<double>(steps), steps, findings, observer);
  return std::isfinite(end.state.q[1]) ? largest : NAN;
}

/// Heights of the undamped pair from rest as velocity Verlet computes them: each mode at its numerical frequency.
auto leapfrog_heights(const Pair& pair, double step) {
  const auto modes = reference::pair_frequencies(pair.exact());
  const auto rest = reference::pair_at_rest(pair.exact());
  return [=](double t) {
    std::array<double, 2> found = rest;
    for (const double w : modes) {
      const double mass = pair.above, p0 = stiffness, p1 = 2.0 * stiffness - w * w;
      const double q =
          (p0 * (start.height[0] - rest[0]) + mass * p1 * (start.height[1] - rest[1])) / (p0 * p0 + mass * p1 * p1);
      const double turned = q * std::cos(2.0 / step * std::asin(0.5 * w * step) * t);
      found[0] += p0 * turned;
      found[1] += p1 * turned;
    }
    return found;
  };
}

/// Predicted error of the heights, relative to the first displacement: velocity Verlet's dashpot uses the velocity of
/// half a step earlier. In each mode the frequency and the damping ratio grow by the fraction xi w h/2, to first order
/// in the step; the largest difference from the exact motion is the predicted error.
double predicted_damped_error(const Pair& pair, double step) {
  const auto modes = reference::pair_frequencies(pair.exact());
  const auto rest = reference::pair_at_rest(pair.exact());
  double largest = 0.0;
  for (double t = 0.0; t <= end_time; t += 1e-3) {
    std::array<double, 2> change{};
    for (const double w : modes) {
      const double mass = pair.above, p0 = stiffness, p1 = 2.0 * stiffness - w * w;
      const double q =
          (p0 * (start.height[0] - rest[0]) + mass * p1 * (start.height[1] - rest[1])) / (p0 * p0 + mass * p1 * p1);
      // x'' (1 - xi w h) + 2 xi w x' + w^2 x = 0 against h = 0, both from rest.
      const auto swing = [&](double h) {
        const double xi = 0.5 * pair.lag * w, softening = 1.0 - xi * w * h;
        const double frequency = w / std::sqrt(softening), ratio = xi / std::sqrt(softening);
        const double s = std::sqrt(1.0 - ratio * ratio), angle = s * frequency * t;
        return std::exp(-ratio * frequency * t) * (std::cos(angle) + ratio / s * std::sin(angle));
      };
      const double difference = q * (swing(step) - swing(0.0));
      change[0] += p0 * difference;
      change[1] += p1 * difference;
    }
    keep_largest(largest, change[0]), keep_largest(largest, change[1]);
  }
  return largest / start.height[0];
}

std::string name_of(const Pair& pair) {
  return fmt::format("{}{}", pair.above == 1.0 ? "equal discs" : "dissimilar discs with weight",
                     pair.lag > 0.0 ? ", damped" : "");
}

auto exact_heights(const Pair& pair) {
  return [pair](double t) { return reference::pair_at(pair.exact(), start, t).height; };
}

constexpr Pair undamped_pairs[] = {{1.0, 0.0, 0.0}, {0.5, 0.0, 9.81}};
constexpr Pair damped_pairs[] = {{1.0, 1.0 / 256.0, 0.0}, {0.5, 1.0 / 256.0, 9.81}};

void check_undamped(Figure& figure, Findings& findings, const Setup& setup) {
  for (const Pair& pair : undamped_pairs) {
    const long steps = 400;
    const double found = largest_error(pair, VelocityVerlet{}, steps,
                                       leapfrog_heights(pair, end_time / static_cast<double>(steps)), findings, setup);
    findings.expect_round_off(
        {"heights", "heights against the exact leapfrog solution, " + name_of(pair)}, found, 0.0, 3.5e-13,
        "400 steps that round heights of 1 and 3 by 1.3e-16 rms; in an oscillation these errors add up as a random "
        "walk: sqrt(400) x 1.3e-16/0.03 = 9e-14, four times that for the worst of 400 steps");
    Convergence order;
    for (const double n : doublings(200.0, setup.coarse ? 2 : 4))
      order.add(end_time / n,
                largest_error(pair, VelocityVerlet{}, std::lround(n), exact_heights(pair), findings, setup));
    findings.expect_order({"order", "order of the error of the heights, " + name_of(pair)}, order, 1.99, 2.01,
                          "no contact opens: the order is that of the method; the next power, (w h)^2 = 0.08 at 200 "
                          "steps, tilts the line by 0.005");
    figure.series.push_back({name_of(pair), order.steps(), order.errors(), Style::points});
  }
}

void check_damped(Figure& figure, Findings& findings, const Setup& setup) {
  for (const Pair& pair : damped_pairs) {
    PredictedErrors errors;
    for (const double n : doublings(800.0, setup.coarse ? 2 : 4)) {
      errors.add(end_time / n,
                 largest_error(pair, VelocityVerlet{}, std::lround(n), exact_heights(pair), findings, setup),
                 predicted_damped_error(pair, end_time / n));
    }
    findings.expect_model(
        {"error_at_finest_step", "error of the heights over the predicted, finest step, " + name_of(pair)},
        errors.last_ratio(), 1.0, setup.coarse ? 0.1 : 0.02,
        "the next power of the step: ratio of w h^2 t/24 to xi h/2");
    findings.expect_order({"order", "order of the error of the heights, " + name_of(pair)}, errors.found(), 0.9, 1.1,
                          "the dashpot's velocity is half a step late; the next power of the step tilts the line");
    figure.series.push_back(errors.points(name_of(pair)));
    figure.series.push_back(errors.line(name_of(pair) + ", predicted"));
  }
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "error",
      .title = "Error of the heights against the step",
      .caption =
          "Largest error over the run, relative to the initial displacement. Lines: predicted from the dashpot's lag.",
      .x = {.label = "step", .log = true},
      .y = {.label = "error / y1(0)", .log = true},
      .series = {},
      .slopes = {{2.0, 2e-3, 2e-3, "h^2"}, {1.0, 5e-4, 1.5e-2, "h"}}};
  check_undamped(figure, findings, setup);
  check_damped(figure, findings, setup);
  findings.figure(figure);
  if (setup.coarse) return;
  const Pair pair = damped_pairs[1];
  Series heights[2] = {{"lower, solver", {}, {}, Style::points}, {"upper, solver", {}, {}, Style::points}};
  (void)largest_error(pair, VelocityVerlet{}, 150, exact_heights(pair), findings, setup, heights);
  Series exact[2] = {{"lower", {}, {}, Style::lines}, {"upper", {}, {}, Style::lines}};
  for (double t = 0.0; t <= end_time; t += 0.004) {
    const auto height = exact_heights(pair)(t);
    for (std::size_t i = 0; i < 2; ++i)
      exact[i].add(t, height[i]);
  }
  findings.figure({.name = "heights",
                   .title = "Two discs between walls",
                   .caption = "Heights of the dissimilar damped pair under its weight, measured from where the contact "
                              "forces are equal; 150 steps.",
                   .x = {.label = "time"},
                   .y = {.label = "height"},
                   .series = {exact[0], exact[1], heights[0], heights[1]}});
}

}  // namespace

Case definition() {
  return {.id = "pressed_pair",
          .title = "Two discs pressed between walls",
          .requirements = {{"B10", {"heights", "order"}},
                           {"law.linear_spring_dashpot", {"error_at_finest_step"}},
                           {"end_rule.attractive", {"order of the error of the heights, equal discs, damped"}},
                           {"shape.circle, shape.half_plane", {"heights"}},
                           {"integrator.velocity_verlet", {"order"}},
                           {"pair.circle.circle, pair.circle.half_plane", {"heights"}}},
          .main_checks = {"heights against the exact leapfrog solution, equal discs",
                          "order of the error of the heights, equal discs",
                          "error of the heights over the predicted, finest step, dissimilar discs with weight, damped"},
          .source = "Textbook vibrations; the setting of MFiX's verification case DEM03",
          .faults = {{"upper_heavier", "the upper disc is 1 % heavier",
                      "heights against the exact leapfrog solution, dissimilar discs with weight"},
                     {"dashpot_between_off", "no dashpot between the discs",
                      "error of the heights over the predicted, finest step, equal discs, damped"}},
          .run = run};
}

}  // namespace talus::verification::problems::pressed_pair
