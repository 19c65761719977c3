#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/mathematics/hurwitz_zeta.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/impacts/plane_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::hertz {
namespace {

constexpr double modulus = 0.75, radius = 4.0, stiffness = 2.0, production_steps = 100.0;

/// An impact with unit mass: the law given to the solver, and the exact events.
struct Ball {
  double xi{}, speed{1.0};
  EndRule rule{EndRule::attractive};
  ContactLaw law;
  reference::HertzEvents exact;
};

Ball ball(double xi, EndRule rule, const Setup& setup) {
  Ball made{.xi = xi, .rule = rule, .law = {}, .exact = {}};
  made.exact = reference::hertz_events({stiffness, xi, 1.0, 1.0}, same(rule));
  const double damping =
      (setup.has("constant_of_linear_dashpot") ? 2.0 : std::sqrt(5.0)) * xi * std::sqrt(4.0 / 3.0 * modulus * radius);
  const double given = setup.has("radius_forgotten") ? 1.0 : radius;
  made.law = Hertz{modulus, given, damping * std::pow(given / radius, 0.25), rule};
  if (setup.has("linear_spring")) made.law = LinearSpringDashpot{stiffness, 0.0, rule};
  return made;
}

/// Relative errors of one impact.
struct ImpactError {
  double restitution{}, contact_time{}, largest{};
};

/// Relative change of e per unit of step caused by the dashpot's velocity of half a step earlier: the equations in y
/// and u with forces larger by the fraction xi du/dt h, integrated by a separate fourth-order method. Only the end
/// requires care: the last step is interpolated linearly to y = 0 or y + 2 xi x' = 0.
double lag_shift(const Ball& b) {
  const double unit = std::sqrt(1.25 * stiffness) * std::pow(1.25 / stiffness, 0.1);
  const auto exit = [&](double h) {
    double y = 0.0, v = b.speed;
    constexpr double du = 1e-3;
    const auto rate = [&](double at, double speed) {
      const double grown = 1.0 + b.xi * h * unit * std::pow(std::max(at, 0.0), 0.2);
      return -(at + 2.0 * b.xi * speed) * grown;
    };
    const auto end = [&](double at, double speed) { return b.rule == EndRule::clamped ? at + 2.0 * b.xi * speed : at; };
    for (;;) {
      const double k1 = rate(y, v), v2 = v + 0.5 * du * k1, k2 = rate(y + 0.5 * du * v, v2);
      const double v3 = v + 0.5 * du * k2, k3 = rate(y + 0.5 * du * v2, v3);
      const double v4 = v + du * k3, k4 = rate(y + du * v3, v4);
      const double next_y = y + du / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
      const double next_v = v + du / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      if (v < 0.0 && end(next_y, next_v) <= 0.0)
        return v + (next_v - v) * end(y, v) / (end(y, v) - end(next_y, next_v));
      y = next_y;
      v = next_v;
    }
  };
  return std::log(exit(1e-3) / exit(-1e-3)) / 2e-3;
}

ImpactError predicted_error(const Ball& b, double shift, double step, double phase) {
  const double touch = 1.0 - phase;
  const double end = fraction(phase + b.exact.contact_time / step);
  const double turn = fraction(phase + 0.5 * b.exact.contact_time / step + 0.5);
  const double per_depth = b.speed * step / b.exact.largest_depth;
  ImpactError error;
  error.largest = 0.625 * per_depth * per_depth * (turn * (1.0 - turn) - 1.0 / 6.0);
  error.contact_time = -5.0 / 64.0 * std::beta(0.6, 0.5) / std::beta(0.4, 0.5) * per_depth * per_depth;
  const auto zeta = [](double p, double u) { return reference::hurwitz_zeta_of_minus(p, u); };
  if (b.xi == 0.0) {
    const double begins = stiffness * std::sqrt(b.speed) * std::pow(step, 2.5);
    error.restitution = begins * (zeta(1.5, end) - zeta(1.5, touch));
    error.largest -= 0.8 * begins * zeta(1.5, touch);  // x_max grows with the speed to the power 4/5
    return error;
  }
  const auto begins = [&](double speed, double offset) {
    return 2.0 * b.xi * std::sqrt(1.25 * stiffness) * std::pow(speed * step, 0.25) * step * zeta(0.25, offset);
  };
  error.restitution = shift * step - begins(b.speed, touch);
  if (b.rule == EndRule::attractive) error.restitution -= begins(b.exact.restitution * b.speed, end);
  return error;
}

ImpactError impact_error(const Ball& b, double step, double phase, Findings& findings) {
  const PlaneRebound seen =
      plane_rebound(b.law, {b.speed, 8.0, step, phase, 3.0 * b.exact.contact_time + 4.0 * step}, findings);
  if (!seen.ended()) return {NAN, NAN, NAN};
  const std::size_t last = seen.depth.size() - 1;
  const double end = seen.time[last - 1] + step * seen.depth[last - 1] / (seen.depth[last - 1] - seen.depth[last]);
  return {seen.speed / (b.exact.restitution * b.speed) - 1.0, end / b.exact.contact_time - 1.0,
          *std::max_element(seen.depth.begin(), seen.depth.end()) / b.exact.largest_depth - 1.0};
}

struct ImpactErrors {
  PhaseError restitution, contact_time, largest;
  double mean_time{};  ///< mean contact time, relative to the exact one
  void add(const ImpactError& error) {
    restitution.add(error.restitution);
    contact_time.add(error.contact_time);
    largest.add(error.largest);
    mean_time += (1.0 + error.contact_time) / static_cast<double>(fewest_phases);
  }
};
struct Comparison {
  ImpactErrors found, predicted;
};

Comparison compare(const Ball& b, double steps, Findings& findings) {
  Comparison all;
  const double shift = b.xi > 0.0 ? lag_shift(b) : 0.0;
  for (const auto& [i, step, phase] : offset_phases(b.exact.contact_time, steps)) {
    all.found.add(impact_error(b, step, phase, findings));
    all.predicted.add(predicted_error(b, shift, step, phase));
  }
  return all;
}

PredictedErrors errors(const Ball& b, Findings& findings, const Setup& setup) {
  return predicted_errors(doublings(16.0, setup.coarse ? 3 : 6), [&](double n) {
    const Comparison c = compare(b, n, findings);
    return std::array{1.0 / n, c.found.restitution.rms(), c.predicted.restitution.rms()};
  });
}

void check_undamped(Findings& findings, const Setup& setup) {
  const Comparison c = compare(ball(0.0, EndRule::attractive, setup), production_steps, findings);
  const auto expect = [&](const char* name, const PhaseError& found, const PhaseError& predicted, const char* why) {
    findings.expect_model({"undamped_impacts", fmt::format("rms error of {}, undamped, over the predicted", name)},
                          found.rms() / predicted.rms(), 1.0, 0.005, why);
  };
  const char* next =
      "predicted impact by impact; the next power of the step is (v h/x_max)^2 of it, v h/x_max = 0.03, and the bound "
      "is a few times that";
  expect("e", c.found.restitution, c.predicted.restitution, next);
  expect("the contact time", c.found.contact_time, c.predicted.contact_time, next);
  expect("the largest overlap", c.found.largest, c.predicted.largest, next);
}

void check_damped(Findings& findings, const Setup& setup) {
  Table table{
      .name = "damped",
      .caption = "Relative error of $e$ with the dashpot, 100 steps per contact: root mean square over 64 phases.",
      .columns = {"end rule", "xi", "e", "error of e", "predicted"}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const char* word = rule == EndRule::attractive ? "attractive" : "clamped";
    double worst = 1.0;
    for (const double xi : {0.05, 0.2, 0.5}) {
      const Ball b = ball(xi, rule, setup);
      const Comparison c = compare(b, production_steps, findings);
      const double found = c.found.restitution.rms(), predicted = c.predicted.restitution.rms();
      worst = worst_ratio(worst, found / predicted);
      table.rows.push_back(
          cells("{} | {:g} | {:.4f} | {:.2e} | {:.2e}", word, xi, b.exact.restitution, found, predicted));
    }
    findings.expect_model(
        {"damped_impacts", fmt::format("rms error of e over the predicted, worst of three damping ratios, {}", word)},
        worst, 1.0, 0.06,
        "effects of lag and onset predicted impact by impact; the next powers of the step, 3/2 and 2, are 3 % of it at "
        "100 steps");
  }
  findings.table(table);
}

void check_orders(Findings& findings, const Setup& setup) {
  const PredictedErrors elastic = errors(ball(0.0, EndRule::attractive, setup), findings, setup);
  findings.expect_order(
      {"order_elastic", "order of the error of e, undamped"}, elastic.found(), 2.4, 2.6,
      "the force begins like t^(3/2), which gives an error of h^(5/2); 64 uneven phases of the end tilt the line");
  const PredictedErrors damped = errors(ball(0.2, EndRule::attractive, setup), findings, setup);
  const std::string pulls = "xi = 0.2, attractive";
  findings.figure(
      {.name = "error_of_e",
       .title = "Error of the restitution against the step",
       .caption = "Root mean square over 64 phases, each with a different step. Lines: predicted, nothing is fitted. "
                  "Undamped, the order is 5/2, between that of a kink (2) and of a smooth force. With the dashpot it "
                  "changes from 5/4 (its onset) to 1 (its velocity half a step late).",
       .x = {.label = "step / contact time", .log = true},
       .y = {.label = "relative error of e", .log = true},
       .series = {elastic.points("undamped"), elastic.line("undamped, predicted"), damped.points(pulls),
                  damped.line(pulls + ", predicted")},
       .slopes = {{2.5, 1.0 / 64.0, 2e-6, "h^(5/2)"}, {1.0, 1.0 / 64.0, 2e-3, "h"}}});
}

/// Checks that e is the same to the last bit at all speeds: a speed times 2^5 multiplies overlaps by 2^4 and times by
/// 2^-1.
void check_speeds(Findings& findings) {
  const auto rebound = [&](int j) {
    const double speed = std::ldexp(1.0, 5 * j), depth = std::ldexp(1.0, 4 * j);
    Ball b = ball(0.2, EndRule::clamped, {});
    const double step = std::ldexp(b.exact.contact_time / 50.4, -j);
    return plane_rebound(b.law, {speed, 8.0 * depth, step, 0.25, 3.0 * 50.4 * step}, findings).speed / speed;
  };
  double change = 0.0;
  for (int j = -3; j <= 3; ++j)
    keep_largest(change, rebound(j) - rebound(0));
  findings.expect_exact("change of e with the dashpot, speeds 2^-15 ... 2^15", change, 0.0,
                        "all scale factors and their roots are powers of two: every operation rounds alike");
}

void show_contact_times(Findings& findings, const Setup& setup) {
  Series points{"solver, mean of 64 phases", {}, {}, Style::points}, line{"closed form", {}, {}, Style::lines};
  for (const double speed : {0.01, 0.1, 1.0, 10.0}) {
    Ball b = ball(0.0, EndRule::attractive, setup);
    b.speed = speed;
    b.exact = reference::hertz_events({stiffness, 0.0, 1.0, speed}, reference::EndRule::attractive);
    const Comparison c = compare(b, production_steps, findings);
    points.add(speed, b.exact.contact_time * c.found.mean_time);
    line.add(speed, b.exact.contact_time);
  }
  findings.figure(
      {.name = "contact_times",
       .title = "Contact time decreases with speed",
       .caption = "Contact time against speed: it decreases like $v^{-1/5}$; with a linear spring it would not.",
       .x = {.label = "speed of approach", .log = true},
       .y = {.label = "contact time", .log = true},
       .series = {line, points}});
}

void run(Findings& findings, const Setup& setup) {
  check_undamped(findings, setup);
  check_damped(findings, setup);
  check_orders(findings, setup);
  if (setup.coarse) return;
  check_speeds(findings);
  show_contact_times(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "hertz",
      .title = "Impact by Hertz's law",
      .family = "B: normal contact",
      .requirements =
          {{"law.hertz",
            {"undamped_impacts", "damped_impacts", "order_elastic",
             "change of e with the dashpot, speeds 2^-15 ... 2^15"}},
           {"method.resultant", {"undamped_impacts", "damped_impacts", "order_elastic"}},
           {"end_rule.attractive", {"rms error of e over the predicted, worst of three damping ratios, attractive"}},
           {"end_rule.clamped", {"rms error of e over the predicted, worst of three damping ratios, clamped"}},
           {"integrator.velocity_verlet", {"order_elastic"}},
           {"regime.hertz.touching", {"undamped_impacts", "order_elastic"}},
           {"regime.hertz.released", {"rms error of e over the predicted, worst of three damping ratios, clamped"}}},
      .main_checks = {"rms error of the contact time, undamped, over the predicted",
                      "rms error of the largest overlap, undamped, over the predicted", "order_elastic",
                      "rms error of e over the predicted, worst of three damping ratios, attractive"},
      .source = "Hertz 1882; Tsuji, Tanaka & Ishida 1992; Antypov & Elliott, EPL 94 (2011) 50004",
      .faults = {{"radius_forgotten", "the square root of the radius is omitted",
                  "rms error of the largest overlap, undamped, over the predicted"},
                 {"linear_spring", "a linear spring with the same numerical stiffness", "order_elastic"},
                 {"constant_of_linear_dashpot", "the dashpot constant of a linear spring",
                  "rms error of e over the predicted, worst of three damping ratios, attractive"}},
      .run = run};
}

}  // namespace talus::verification::problems::hertz
