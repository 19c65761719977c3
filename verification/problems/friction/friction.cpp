#include "verification/problems/friction/friction_findings.hpp"
#include "verification/study/sliding_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::friction {
namespace {

constexpr double loop_friction = 0.25, loop_stiffness = 64.0, loop_normal = 4.0, loop_amplitude = 0.0625;

/// A block of unit mass, pressed by a constant force and drawn along a path; all numbers are powers of two.
class DrawnBlock {
 public:
  explicit DrawnBlock(double friction)
      : scene_{oblique_scene({.normal = {normal_stiffness, 0.0, 1.0, 1.0},
                              .tangential_stiffness = loop_stiffness,
                              .friction = friction,
                              .mobility = 1.0,
                              .slip_rate = 0.0},
                             EndRule::clamped)},
        dynamics_{scene_.model},
        system_{dynamics_},
        state_{scene_.initial} {
    state_.q[1] -= loop_normal / normal_stiffness;
    state_.v = {0.0, 0.0};
    force_ = drag();
  }

  /// Draws the block to x = `to` at unit speed, and adds the drawing forces on the way to `loop`.
  void draw(double to, Series& loop) {
    constexpr double step = 0x1p-12;
    const double direction = to > state_.q[0] ? 1.0 : -1.0;
    state_.v[0] = direction;
    for (long count = std::lround(std::abs(to - state_.q[0]) / step); count > 0; --count) {
      system_.drift(state_, step);
      const double now = drag();
      work_ -= 0.5 * (force_ + now) * direction * step;
      force_ = now;
      if (count % 16 != 0) continue;
      loop.add(state_.q[0], -force_);
    }
  }

  double work() const { return work_; }  ///< of the drawing force so far [J]
  double lost() const { return state_.work[static_cast<std::size_t>(Mechanism::friction)]; }

 private:
  static constexpr double normal_stiffness = 1024.0;

  /// Tangential force on the block, equal to its acceleration (unit mass).
  double drag() {
    Rates rates{state_};
    system_.evaluate(state_, rates);
    return rates.v[0];
  }

  Scene scene_;
  Dynamics dynamics_;
  RigidBodySystem system_;
  State state_;
  double force_{}, work_{};
};

Figure loop_figure(const Series& loop) {
  const double limit = loop_friction * loop_normal, turn = 2.0 * limit / loop_stiffness, reach = loop_amplitude;
  return {.name = "loop",
          .title = "Hysteresis loop of a block moved back and forth",
          .caption =
              "Force against position over two cycles of $\\pm A$ after the first displacement from 0: the solver "
              "(points) and the exact parallelogram (line), whose area is $4\\mu N(A - \\mu N/k_s)$.",
          .x = {.label = "position", .unit = "m"},
          .y = {.label = "driving force", .unit = "N"},
          .series = {{"exact",
                      {0.0, 0.5 * turn, reach, reach - turn, -reach, -reach + turn, reach},
                      {0.0, limit, limit, -limit, -limit, limit, limit},
                      Style::lines},
                     loop}};
}

}  // namespace

void check_shear_loop(Findings& findings, const Setup& setup) {
  DrawnBlock block{setup.has("friction_halved") ? 0.5 * loop_friction : loop_friction};
  Series loop{"solver", {}, {}, Style::points};
  block.draw(loop_amplitude, loop);
  const double work = block.work(), lost = block.lost();
  for (int half = 0; half < 4; ++half)
    block.draw(half % 2 == 0 ? -loop_amplitude : loop_amplitude, loop);
  const double limit = loop_friction * loop_normal;
  const double exact = 4.0 * limit * (loop_amplitude - limit / loop_stiffness);
  findings.expect_exact(
      "area of the shear loop", (block.work() - work) / 2.0, exact,
      "all lengths and forces are small multiples of powers of two, and so are their sums and products", "J");
  findings.expect_exact("friction work in a shear loop", (block.lost() - lost) / 2.0, exact,
                        "equal to the area; a closed path leaves the spring unchanged", "J");
  if (!setup.coarse) findings.figure(loop_figure(loop));
}

namespace {

void run(Findings& findings, const Setup& setup) {
  if (!setup.coarse) check_rolling(findings, setup);
  check_slopes(findings, setup);
  check_oblique_impacts(findings, setup);
  check_shear_loop(findings, setup);
  if (setup.coarse) return;
  check_rebounds(findings, setup);
  check_grazing(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "friction",
      .title = "Friction by spring and slider",
      .requirements =
          {{"Eq. 18",
            {"start time of rolling over that of the reference",
             "start time of rolling over u0/(3 mu g)",
             "energy lost by the slider, over a third of that at the start",
             "energy balance error, disc from sliding to rolling",
             "acceleration of a disc on slopes, largest relative error against the reference",
             "acceleration of a block on slopes, largest relative error against the reference",
             "acceleration of a disc on slopes, largest relative difference of reference and rigid disc",
             "below_threshold",
             "above_threshold",
             "-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error",
             "order of the tangential speed, sliding throughout, velocity_verlet",
             "order of the tangential speed, sliding throughout, central_difference",
             "order of the tangential speed, sticking, then sliding, velocity_verlet",
             "order of the tangential speed, sticking, then sliding, central_difference",
             "order of the energy balance error, sliding impact",
             "energy balance error over its prediction, sliding impact",
             "sliding impact: tangential over mu times normal speed change, largest error over 64 phases",
             "sliding impact: rim speed gained over twice the tangential speed lost, largest error over 64 phases",
             "rms error of the tangential speed lost by sliding over its prediction",
             "tangential speed lost by sliding, e = 0.5, over that of a rigid impact, mu (1 + e) v_n",
             "rms error of the tangential speed lost by sliding, e = 0.5, over its prediction",
             "area of the shear loop",
             "friction work in a shear loop",
             "rms error of the slip rate after the impact, largest of 4 stiffnesses x 6 obliquities"}},
           {"C1", {"start time of rolling over that of the reference", "start time of rolling over u0/(3 mu g)"}},
           {"C2",
            {"acceleration of a disc on slopes, largest relative error against the reference",
             "acceleration of a disc on slopes, largest relative difference of reference and rigid disc",
             "friction work at 0.999 of the slip threshold, disc",
             "friction work at 1.001 of the slip threshold, disc"}},
           {"C3",
            {"friction work at 0.999 of the slip threshold, block",
             "friction work at 1.001 of the slip threshold, block"}},
           {"C4",
            {"order of the tangential speed, sliding throughout, velocity_verlet",
             "order of the tangential speed, sliding throughout, central_difference",
             "order of the energy balance error, sliding impact",
             "energy balance error over its prediction, sliding impact",
             "sliding impact: tangential over mu times normal speed change, largest error over 64 phases",
             "sliding impact: rim speed gained over twice the tangential speed lost, largest error over 64 phases",
             "rms error of the tangential speed lost by sliding over its prediction",
             "tangential speed lost by sliding, e = 0.5, over that of a rigid impact, mu (1 + e) v_n",
             "rms error of the tangential speed lost by sliding, e = 0.5, over its prediction"}},
           {"C5", {"-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error"}},
           {"C6", {"rms error of the slip rate after the impact, largest of 4 stiffnesses x 6 obliquities"}},
           {"C7",
            {"no energy gain in grazing impacts of 60 to 88 degrees, mu = 0.01 to 1",
             "energy after a grazing impact, largest error over (w h)^2 times the initial energy"}},
           {"C10", {"area of the shear loop", "friction work in a shear loop"}},
           {"C12", {"order_of_speed"}},
           {"law.linear_spring_dashpot",
            {"-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error",
             "order of the tangential speed, sliding throughout, velocity_verlet",
             "order of the tangential speed, sliding throughout, central_difference",
             "energy lost at release of a contact with a dashpot, rms relative error",
             "no energy gain in grazing impacts of 60 to 88 degrees, mu = 0.01 to 1",
             "energy after a grazing impact, largest error over (w h)^2 times the initial energy"}},
           {"end_rule.clamped",
            {"tangential speed lost by sliding, e = 0.5, over that of a rigid impact, mu (1 + e) v_n",
             "rms error of the tangential speed lost by sliding, e = 0.5, over its prediction",
             "energy lost at release of a contact with a dashpot, rms relative error"}},
           {"mechanism.contact_damping", {"energy dissipated by the dashpot of a contact, rms relative error"}},
           {"mechanism.contact_release", {"energy lost at release of a contact with a dashpot, rms relative error"}},
           {"method.resultant",
            {"order_of_speed", "rms error of the tangential speed, sticking throughout, over its prediction",
             "rms error of the slip rate after the impact, largest of 4 stiffnesses x 6 obliquities"}},
           {"shape.circle",
            {"start time of rolling over that of the reference", "start time of rolling over u0/(3 mu g)",
             "sliding impact: rim speed gained over twice the tangential speed lost, largest error over 64 phases"}},
           {"shape.half_plane",
            {"start time of rolling over that of the reference", "start time of rolling over u0/(3 mu g)",
             "acceleration of a disc on slopes, largest relative error against the reference",
             "acceleration of a block on slopes, largest relative error against the reference",
             "acceleration of a disc on slopes, largest relative difference of reference and rigid disc"}},
           {"mechanism.friction",
            {"energy lost by the slider, over a third of that at the start",
             "energy balance error, disc from sliding to rolling", "below_threshold", "above_threshold",
             "energy balance error over its prediction, sliding impact", "friction work in a shear loop"}},
           {"integrator.velocity_verlet",
            {"order of the tangential speed, sliding throughout, velocity_verlet",
             "order of the tangential speed, sticking throughout, velocity_verlet",
             "order of the tangential speed, sticking, then sliding, velocity_verlet"}},
           {"integrator.central_difference",
            {"order of the tangential speed, sliding throughout, central_difference",
             "order of the tangential speed, sticking throughout, central_difference",
             "order of the tangential speed, sticking, then sliding, central_difference"}},
           {"regime.friction.sticking",
            {"-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error",
             "order of the tangential speed, sticking throughout, velocity_verlet",
             "order of the tangential speed, sticking throughout, central_difference",
             "rms error of the tangential speed, sticking throughout, over its prediction"}},
           {"regime.friction.slipping_forward",
            {"order of the tangential speed, sliding throughout, velocity_verlet",
             "order of the tangential speed, sliding throughout, central_difference", "area of the shear loop",
             "friction work in a shear loop"}},
           {"regime.friction.slipping_backward", {"area of the shear loop", "friction work in a shear loop"}},
           {"pair.circle.half_plane",
            {"start time of rolling over that of the reference", "start time of rolling over u0/(3 mu g)",
             "acceleration of a disc on slopes, largest relative error against the reference",
             "acceleration of a disc on slopes, largest relative difference of reference and rigid disc"}}},
      .main_checks = {"start time of rolling over u0/(3 mu g)", "friction work at 0.999 of the slip threshold, disc",
                      "friction work at 1.001 of the slip threshold, disc",
                      "-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error",
                      "order of the tangential speed, sticking, then sliding, velocity_verlet",
                      "area of the shear loop"},
      .source = "Mustoe & Huttelmaier 1993, section 3.5, Eq. 18; Cundall & Strack 1979",
      .faults = {{"friction_halved", "half the coefficient of friction", "area of the shear loop"},
                 {"disc_that_cannot_spin", "a particle instead of the disc",
                  "acceleration of a disc on slopes, largest relative error against the reference"},
                 {"slope_too_flat", "slopes 0.2 % flatter", "friction work at 1.001 of the slip threshold, disc"},
                 {"slope_too_steep", "slopes 0.2 % steeper", "friction work at 0.999 of the slip threshold, block"},
                 {"slip_stiffness_doubled", "twice the tangential stiffness",
                  "-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error"},
                 {"commensurate_step", "a step that divides the contact time",
                  "order of the tangential speed, sticking throughout, velocity_verlet"},
                 {"slider_without_account", "friction work left out of the energy balance",
                  "energy balance error over its prediction, sliding impact"}},
      .run = run};
}

}  // namespace talus::verification::problems::friction
