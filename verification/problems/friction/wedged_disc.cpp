#include "verification/problems/friction/late_slip.hpp"
#include "verification/problems/friction/method_run.hpp"
#include "verification/reference/motion/held_body.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::wedged_disc {
namespace {

constexpr double squeeze = 0.25, end_time = 3.0;

reference::PressedDisc wedge(double ratio) {
  const double apart = ratio + 1.0 - squeeze, height = std::sqrt(apart * apart - ratio * ratio);
  return {.radius = 1.0,
          .mass = 1.0,
          .inertia = 0.5,
          .normal_stiffness = 100.0,
          .slip_stiffness = 60.0,
          .weight = 200.0 * squeeze * height / apart,
          .posts = {{-ratio, 0.0, ratio}, {ratio, 0.0, ratio}}};
}

double start_height(double ratio) {
  const double apart = ratio + 1.0 - squeeze;
  return std::sqrt(apart * apart - ratio * ratio);
}

reference::SmoothState exact_start(double ratio) { return {{0.0L, start_height(ratio), 0.0L}, {0.5L, 0.4L, 0.7L}, {}}; }

Scene wedge_scene(double ratio, const Setup& setup) {
  const reference::PressedDisc disc = wedge(ratio);
  SceneBuilder builder;
  builder.gravity({0.0, -disc.weight / disc.mass});
  const BodyId small = builder.add_free("small", disc.mass, setup.has("ring_for_disc") ? 1.0 : disc.inertia,
                                        Circle{disc.radius}, {0.0, start_height(ratio)});
  for (const reference::Post& post : disc.posts) {
    const bool left = post.x < 0.0;
    const BodyId large = builder.add_fixed(left ? "left" : "right", Circle{post.radius}, {post.x, post.y});
    builder.add_contact(left ? "on_left" : "on_right", small, large, LinearSpringDashpot{disc.normal_stiffness, 0.0},
                        CoulombFriction{20.0, disc.slip_stiffness});
  }
  Scene scene = builder.at_rest("Small disc between two large ones");
  scene.initial.v = {0.5, 0.4, 0.7};
  return scene;
}

/// Differences of two states in position, angle and history variables (all are lengths, as the radius is 1).
using Miss = std::array<double, 5>;

double size(const Miss& miss) {
  double sum = 0.0;
  for (const double part : miss)
    sum += part * part;
  return std::sqrt(sum);
}

Miss lengths(const reference::SmoothState& state) {
  Miss out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = static_cast<double>(state.q[i]);
  for (std::size_t i = 0; i < 2; ++i)
    out[3 + i] = static_cast<double>(state.z[i]);
  return out;
}

/// The wedge at one size ratio: exact final state and the solver's runs.
class Wedge {
 public:
  Wedge(double ratio, const Setup& setup)
      : ratio_{ratio},
        scene_{wedge_scene(ratio, setup)},
        late_{setup.has("late_slip")},
        exact_{lengths(reference::moved(reference::pressed_disc(wedge(ratio)), exact_start(ratio), end_time, 12000))} {}

  /// Distance of the solver's final state from the exact one.
  double error(const Integrator& method, long steps, bool late, Findings& findings) const {
    record_use(scene_.model);
    const Dynamics dynamics{scene_.model};
    const auto run = [&](auto system) {
      const State end = run_method(system, method, scene_.initial, end_time / static_cast<double>(steps), steps);
      findings.count(system.evaluations());
      return end;
    };
    const State end = late ? run(LateSlipSystem{dynamics}) : run(RigidBodySystem{dynamics, false});
    Miss missed{};
    for (std::size_t i = 0; i < 3; ++i)
      missed[i] = end.q[i] - exact_[i];
    for (std::size_t i = 0; i < 2; ++i)
      missed[3 + i] = end.z[i] - exact_[3 + i];
    return size(missed);
  }

  Convergence errors(const Integrator& method, double first, std::size_t count, bool late, Findings& findings) const {
    Convergence found;
    for (const double n : doublings(first, count))
      found.add(end_time / n, error(method, std::lround(n), late || late_, findings));
    return found;
  }

  /// Predicted distance divided by step^order.
  double constant(reference::Leapfrog method) const {
    return size(lengths(
        reference::leading_error(reference::pressed_disc(wedge(ratio_)), exact_start(ratio_), end_time, method, 1000)));
  }

  std::string name() const { return fmt::format("R/r = {:g}", ratio_); }

 private:
  double ratio_;
  Scene scene_;
  bool late_;
  Miss exact_;
};

struct Method {
  const char* name;
  reference::Leapfrog kind;
};

constexpr Method leapfrogs[] = {{"velocity_verlet", reference::Leapfrog::velocity_verlet},
                                {"central_difference", reference::Leapfrog::central_difference}};

void check_leapfrogs(const Wedge& wedge, Figure& figure, Findings& findings, const Setup& setup) {
  for (const Method& method : leapfrogs) {
    const std::string name = fmt::format("{}, {}", method.name, wedge.name());
    const auto claim = findings.in(fmt::format("integrator.{}", method.name));
    const Convergence found =
        wedge.errors(make_integrator(method.name), setup.coarse ? 512.0 : 2048.0, 3, false, findings);
    const double constant = wedge.constant(method.kind);
    expect_constant(findings.in("errors"), name, found, constant, 2, 2, 3e-6);
    if (method.kind != reference::Leapfrog::velocity_verlet) continue;
    const double admitted = setup.coarse ? 0.03 : 0.002;
    findings.expect_order(
        {"orders", "order, " + name}, found, 2.0 - admitted, 2.0 + admitted,
        "no contact is released or slips. The next power, (w h)^2 = 4e-4 at the largest step (coarse: 0.007), bends "
        "the line by up to four times as much where the leading term happens to be small");
    figure.series.push_back({"solver, " + wedge.name(), found.steps(), found.errors(), Style::points});
    figure.series.push_back(
        curve("predicted, " + wedge.name(), found.steps(), [&](double h) { return constant * h * h; }));
  }
}

void check_late(const Wedge& wedge, Figure& figure, Table& table, Findings& findings) {
  const double late = wedge.constant(reference::Leapfrog::late_slip);
  const double right = wedge.constant(reference::Leapfrog::velocity_verlet);
  table.rows.push_back(
      {wedge.name(), fmt::format("{:.3g}", right), fmt::format("{:.3g}", late), fmt::format("{:.2g}", late / right)});
  if (wedge.name() != "R/r = 1") return;
  const Convergence found = wedge.errors(VelocityVerlet{}, 4096.0, 4, true, findings);
  expect_constant(findings.in("errors"), "slip along end-of-step directions, " + wedge.name(), found, late, 1, 1, 3e-6);
  figure.series.push_back({"end-of-step directions, " + wedge.name(), found.steps(), found.errors(), Style::crosses});
  figure.series.push_back(
      curve("end-of-step directions, predicted", found.steps(), [&](double h) { return late * h; }));
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "error",
      .title = "Disc in a notch: error after seven oscillations",
      .caption =
          "Error of position, angle and both stretches, combined in quadrature, by velocity Verlet against the step. "
          "Lines: prediction, no constant fitted. Crosses: slip along the directions at the end of the step.",
      .x = {"step", "s", true},
      .y = {"error", "m", true}};
  Table table{.name = "late",
              .caption =
                  "Predicted errors of velocity Verlet at the end, over the power of the step: with the slip at "
                  "mid-step, as in the solver, and along the directions at the end of the step; and the step below "
                  "which the latter error is the larger.",
              .columns = {"size ratio", "error/h^2", "end-of-step: error/h", "equal at h"}};
  for (const double ratio : {1.0, 3.0, 10.0, 100.0}) {
    if (setup.coarse && ratio != 1.0) continue;
    const Wedge wedge{ratio, setup};
    check_leapfrogs(wedge, figure, findings, setup);
    if (setup.coarse) continue;
    check_late(wedge, figure, table, findings);
    if (ratio != 100.0) continue;
    findings.expect_order(
        {"integrator.rk4", "order, rk4, R/r = 100"}, wedge.errors(RungeKutta4{}, 256.0, 3, false, findings), 3.95, 4.05,
        "the motion is smooth: the declared order, and the next power of w h = 0.16 at the largest step");
  }
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace

Case definition() {
  return {.id = "wedged_disc",
          .title = "Wedged disc: three contacts with friction",
          .requirements = {{"C11", {"errors", "orders"}}, {"Eq. 18", {"errors"}}},
          .checks_of_runs = {"errors", "orders"},
          .main_checks = {"error over its prediction, velocity_verlet, R/r = 1",
                          "error over its prediction, velocity_verlet, R/r = 100", "order, velocity_verlet, R/r = 100",
                          "error over its prediction, slip along end-of-step directions, R/r = 1"},
          .source = "Vyas, Ottino, Lueptow & Umbanhowar 2025, Comput. Phys. Commun. 310, 109524 (arXiv 2410.14798)",
          .faults = {{"late_slip", "slip from half-step velocities along the directions at the end of the step",
                      "order, velocity_verlet, R/r = 1"},
                     {"ring_for_disc", "the moment of inertia of a ring",
                      "error over its prediction, velocity_verlet, R/r = 1"}},
          .run = run};
}

}  // namespace talus::verification::problems::wedged_disc
