#include "verification/problems/founding/pivoted_swing.hpp"

#include "solver/run/simulate.hpp"
#include "solver/run/turning_point.hpp"
#include "verification/problems/founding/leapfrog_swing.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/impacts/pivoted_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

const reference::PivotedCylinder pivoted{};
constexpr double swing_time = 1.2;  // [s]: nearly half a period; the rock has long fallen past the column

double small_frequency() {
  return std::sqrt(0.5 * pivoted.mass * pivoted.gravity * pivoted.length / reference::inertia_about_pin(pivoted));
}

/// Exact pendulum motion through a state of the column: its rate at the bottom follows from energy, and it reaches the
/// state's angle the time `since` after the bottom.
struct SwingThrough {
  reference::PendulumMotion motion;
  double since{};

  explicit SwingThrough(double angle, double rate)
      : motion{reference::swing(
            pivoted, std::sqrt(rate * rate + std::pow(2.0 * small_frequency() * std::sin(0.5 * angle), 2)))} {
    since = angle / rate;
    // Newton: the angle is a few hundredths of the largest, and 6 steps are twice as many as needed.
    for (int i = 0; i < 6; ++i)
      since += (angle - motion.at(since).angle) / motion.at(since).rate;
  }
};

/// Angle and rate of the column and speed of the rock over time.
struct Track {
  std::vector<double> t, angle, rate, rock;
  double turned{};  ///< largest angle, interpolated between steps
};

/// Largest error of the angle over the swing with this step, relative to the exact motion through `start`.
double largest_angle_error(const PivotedRun& run, const State& start, double step, const Setup& setup,
                           Findings& findings) {
  const SwingThrough exact{start.q[0], start.v[0]};
  double largest = 0.0;
  const Integrator method = setup.has("euler_cromer") ? Integrator{EulerCromer{}} : Integrator{VelocityVerlet{}};
  Scene scene = scene_of(run, setup);
  scene.initial = start;
  const Watcher watch = [&](const State& seen, const StepInfo&) {
    keep_largest(largest, seen.q[0] - exact.motion.at(exact.since + seen.t - start.t).angle);
  };
  const RunEnd end = run_scene(scene, method, {step, swing_time, swing_time, false}, findings, watch);
  return end.finished ? largest : std::nan("");
}

/// Predicted largest error of the angle by velocity Verlet from the state `start` until `swing_time`, over (w0 h)^2
/// [rad].
///
/// The steps lie on the motion of H + (w0 h)^2 D (leapfrog_swing.hpp), in units w0 = 1, D = p^2 cos x/12 - sin^2 x/24,
/// from the same x and p. To first order their difference (a, b) from the exact motion satisfies
///   a' = b + dD/dp = b + p cos x/6,   b' = -cos(x) a - dD/dx = -cos(x) a + (p^2 + cos x) sin x/12,   a = b = 0 at
///   the start.
double predicted_error_constant(const State& start) {
  using Vector = std::array<double, 4>;  // x, p, a, b
  const auto rates = [](const Vector& y) {
    const double sine = std::sin(y[0]), cosine = std::cos(y[0]);
    return Vector{y[1], -sine, y[3] + y[1] * cosine / 6.0, -cosine * y[2] + (y[1] * y[1] + cosine) * sine / 12.0};
  };
  const auto moved = [](Vector y, const Vector& rate, double h) {
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += h * rate[i];
    return y;
  };
  constexpr int steps = 1000;  // of Runge-Kutta 4, each 3e-3 long: error 1e-10
  const double h = (swing_time - start.t) * small_frequency() / steps;
  Vector y{start.q[0], start.v[0] / small_frequency(), 0.0, 0.0};
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Vector k1 = rates(y), k2 = rates(moved(y, k1, 0.5 * h)), k3 = rates(moved(y, k2, 0.5 * h)),
                 k4 = rates(moved(y, k3, h));
    y = moved(moved(moved(moved(y, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0);
    keep_largest(largest, y[2]);
  }
  return largest;
}

void check_order(const PivotedRun& run, const State& start, double production_step, Findings& findings,
                 const Setup& setup) {
  Convergence errors;
  for (const double n : doublings(20.0, setup.coarse ? 3 : 5))
    errors.add(swing_time / (n + 0.38), largest_angle_error(run, start, swing_time / (n + 0.38), setup, findings));
  findings.expect_order({"order_after_impact", "order of the motion after the impact"}, errors, 1.98, 2.02,
                        "smooth motion with velocity Verlet: even powers of the step only");
  if (setup.coarse) return;
  findings.expect(
      {"swing_error/production", "largest error of the angle after the impact, production step"},
      largest_angle_error(run, start, production_step, setup, findings),
      predicted_error_constant(start) * std::pow(small_frequency() * production_step, 2),
      Tolerance::model(1.5e-5,
                       "predicted from velocity Verlet's modified Hamiltonian, without fitting; the next even power of "
                       "the step is 1e-6 of it, and 4600 roundings of 1e-16 accumulate to 1e-5 of it")
          .relative(),
      "rad");
  findings.expect({"swing_error/160", "largest error of the angle after the impact, 160 steps"}, errors.errors()[3],
                  predicted_error_constant(start) * std::pow(small_frequency() * errors.steps()[3], 2),
                  Tolerance::model(1e-3,
                                   "the same prediction; the next even power is (w0 h)^2 = 3e-4 of it, and the largest "
                                   "error lies between two steps")
                      .relative(),
                  "rad");
}

/// Runs central difference from touch to `swing_time`; records every step until `dense`, then every 40th.
Track whole_run(const PivotedRun& run, double step, double dense, const Setup& setup, Findings& findings) {
  Track track;
  TurningPointFinder finder{0};
  const Watcher watch = [&](const State& seen, const StepInfo& info) {
    finder(seen, info);
    if (seen.t >= dense && info.step % 40 != 0) return;
    track.t.push_back(seen.t);
    track.angle.push_back(seen.q[0]);
    track.rate.push_back(seen.v[0]);
    track.rock.push_back(seen.v[1]);
  };
  const RunPlan plan{step, swing_time, swing_time, false};
  const RunEnd end = run_scene(scene_of(run, setup), CentralDifference{}, plan, findings, watch);
  track.turned = end.finished && finder.found() ? finder.found()->value : std::nan("");
  return track;
}

/// Figure of the speeds of the rock and of the column's centre until `end`, with every fourth sample of the solver.
Figure velocities(const std::string& name, const std::string& title, const std::string& caption, double end,
                  const Track& track, const reference::PivotedSoftImpact& soft) {
  const reference::PivotedImpact rigid = reference::rigid_impact(pivoted);
  Figure figure{.name = name,
                .title = title,
                .caption = caption,
                .x = {.label = "time", .unit = "s", .min = 0.0, .max = end},
                .y = {.label = "horizontal velocity", .unit = "ft/s"},
                .series = {{"column, soft reference", {}, {}, Style::lines},
                           {"rock, soft reference", {}, {}, Style::lines},
                           {"column, solver", {}, {}, Style::points},
                           {"rock, solver", {}, {}, Style::points}},
                .lines = {{'y', rigid.column, "4.857"}, {'y', rigid.rock, "2.357"}}};
  const double h = 0.5 * pivoted.length;
  const auto add = [&figure](std::size_t series, double t, double value) { figure.series[series].add(t, value); };
  for (std::size_t i = 0; i < track.t.size() && track.t[i] <= end; ++i) {
    add(0, track.t[i], h * soft.samples[i].rate * std::cos(soft.samples[i].angle));
    add(1, track.t[i], soft.samples[i].rock_vx);
    if (i % 4 != 0) continue;
    add(2, track.t[i], h * track.rate[i] * std::cos(track.angle[i]));
    add(3, track.t[i], track.rock[i]);
  }
  return figure;
}

/// Predicted errors of the production run due to the step.
struct Expected {
  reference::PivotedContact contact;
  double error_of_v1{};     ///< largest [ft/s]
  double error_of_angle{};  ///< largest [rad]
  std::string why;
};

/// Compares the whole run with the soft reference, and draws its figures. `end` is the state after the contact, `exact`
/// the motion through it.
void compare_over_time(Findings& findings, const Track& track, const State& end, const SwingThrough& exact,
                       const Expected& expected) {
  const reference::PivotedSoftImpact soft = reference::soft_impact(pivoted, expected.contact, track.t);
  double worst_angle = 0.0, worst_rate = 0.0;
  Series exact_angle{.label = "elliptic functions", .style = Style::lines};
  Series angle{.label = "solver", .style = Style::points};
  for (std::size_t i = 0; i < track.t.size(); ++i) {
    keep_largest(worst_angle, track.angle[i] - soft.samples[i].angle);
    if (track.t[i] < end.t) continue;
    keep_largest(worst_rate, track.rate[i] - soft.samples[i].rate);
    exact_angle.add(track.t[i], exact.motion.at(exact.since + track.t[i] - end.t).angle);
    if (i % 4 != 0) continue;
    angle.add(track.t[i], track.angle[i]);
  }
  findings.expect_truncation({"soft_angle", "largest difference of the angle from the soft reference over 1.2 s"},
                             worst_angle, 0.0, expected.error_of_angle, 1.0,
                             expected.why +
                                 "; before the turning point an error of the angular velocity causes no larger error "
                                 "than that of the largest angle",
                             "rad");
  findings.expect_truncation(
      {"soft_rate", "largest difference of the angular velocity from the soft reference after the contact"}, worst_rate,
      0.0, expected.error_of_v1 / (0.5 * pivoted.length), 1.0, expected.why + ", over l/2", "rad/s");
  const std::string lines =
      "Points: central difference at 100 steps per contact; lines: soft reference; dashed: velocities after the rigid "
      "impact.";
  findings.figure(velocities("velocities", "Horizontal velocities of rock and column",
                             "Corresponds to Fig. 11 of the report. " + lines, 0.7, track, soft));
  findings.figure(
      velocities("contact", "Horizontal velocities during the contact, enlarged", lines, 0.05, track, soft));
  findings.figure(
      {.name = "angle",
       .title = "Angle of the column after the impact",
       .caption =
           "Solver (points) and the elliptic functions through the solver's state at the end of the contact (line).",
       .x = {.label = "time", .unit = "s"},
       .y = {.label = "angle", .unit = "rad"},
       .series = {exact_angle, angle},
       .lines = {{'y', exact.motion.amplitude(), "largest angle"}}});
}

}  // namespace

void check_swing(Findings& findings, const Setup& setup) {
  const PivotedRun run;
  const reference::PivotedContact contact = contact_of(run);
  const reference::PivotedSoftImpact first = reference::soft_impact(pivoted, contact);
  const double step = incommensurate_step(first.at_end.t, 100.0);
  const AfterImpact after = impact(run, CentralDifference{}, step, setup, findings);
  const SwingThrough exact{after.at_end.q[0], after.at_end.v[0]};

  // Largest errors at 100 steps per contact: the run starts at touch, so only the end's jump, +-1/2 of 2 xi w h e, and
  // the lag remain.
  const double xi = contact.damping / (2.0 * std::sqrt(contact.stiffness * impact_mass()));
  const double wh = std::sqrt(run.stiffness / impact_mass()) * step;
  const double error_of_e =
      pivoted.restitution * wh * (xi + std::abs(leapfrog_restitution_shift(xi, reference::EndRule::attractive)));
  const double error_of_v1 =
      error_of_e * pivoted.approach_speed * impact_mass() / reference::effective_column_mass(pivoted);
  const std::string why =
      "largest first-order error of e at 100 steps per contact from the onset: half the jump at the end and the lag";
  findings.expect_truncation({"production/v1", "v1, production run"}, after.column, first.column_speed, error_of_v1,
                             1.0, why, "ft/s");
  findings.expect_truncation({"production/V1", "V1, production run"}, after.rock, first.at_end.rock_vx,
                             error_of_v1 * reference::effective_column_mass(pivoted) / pivoted.rock_mass, 1.0, why,
                             "ft/s");

  const Track track = whole_run(run, step, 2.0 * first.at_end.t, setup, findings);
  const double turned = track.turned;
  // From energy, w1 dw1 = w0^2 sin(A) dA: dA = dw1/(w0 cos(A/2)).
  const double error_of_angle =
      error_of_v1 / (0.5 * pivoted.length) / (small_frequency() * std::cos(0.5 * first.largest_angle));
  findings.expect_truncation({"largest_angle_swing/production", "largest angle after the impact, production run"},
                             turned, first.largest_angle, error_of_angle, 1.0,
                             why + "; converted to the angle by conservation of energy", "rad");
  findings.expect_truncation(
      {"elliptic_functions", "largest angle against elliptic functions through the solver's state after the contact"},
      turned, exact.motion.amplitude(),
      std::pow(small_frequency() * step, 2) * std::tan(0.5 * exact.motion.amplitude()) *
          std::abs(verlet_energy_swing(exact.motion.amplitude())) / (1.0 - std::cos(exact.motion.amplitude())),
      3.0,
      "the energy of the numerical solution oscillates by h^2 (sin^2 A/24 + (1 - cos A)/6) w0^2; the error of the "
      "angle is this over sin A",
      "rad");
  check_order(run, after.at_end, step, findings, setup);
  if (setup.coarse) return;

  compare_over_time(findings, track, after.at_end, exact, {contact, error_of_v1, error_of_angle, why});
}

}  // namespace talus::verification::problems
