#include "verification/problems/friction/friction_findings.hpp"
#include "verification/study/scenes/sliding_scenes.hpp"
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
      {"loop/area", "area of the shear loop"}, (block.work() - work) / 2.0, exact,
      "all lengths and forces are small multiples of powers of two, and so are their sums and products", "J");
  findings.expect_exact({"loop/work", "friction work in a shear loop"}, (block.lost() - lost) / 2.0, exact,
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
            {"rolling_start", "slider_loss", "sliding_balance", "slopes", "below_threshold", "above_threshold",
             "sticking_impact", "order_of_speed/sliding throughout", "order_of_speed/sticking, then sliding", "sliding",
             "loop", "slip_rates"}},
           {"C1", {"rolling_start"}},
           {"C2", {"slopes/disc", "slopes/rigid", "below_threshold/disc", "above_threshold/disc"}},
           {"C3", {"below_threshold/block", "above_threshold/block"}},
           {"C4", {"order_of_speed/sliding throughout", "sliding"}},
           {"C5", {"sticking_impact"}},
           {"C6", {"slip_rates"}},
           {"C7", {"grazing"}},
           {"C10", {"loop"}},
           {"C12", {"order_of_speed"}},
           {"law.linear_spring_dashpot",
            {"sticking_impact", "order_of_speed/sliding throughout", "release_loss", "grazing"}},
           {"end_rule.clamped", {"sliding/half_e_loss", "sliding/half_e_error", "release_loss"}},
           {"mechanism.contact_damping", {"dashpot_energy"}},
           {"mechanism.contact_release", {"release_loss"}},
           {"method.resultant", {"order_of_speed", "sticking_error", "slip_rates"}},
           {"shape.circle", {"rolling_start", "sliding/rim_speed"}},
           {"shape.half_plane", {"rolling_start", "slopes"}},
           {"mechanism.friction",
            {"slider_loss", "sliding_balance", "below_threshold", "above_threshold", "sliding/balance", "loop/work"}},
           {"integrator.velocity_verlet",
            {"order_of_speed/sliding throughout/velocity_verlet", "order_of_speed/sticking throughout/velocity_verlet",
             "order_of_speed/sticking, then sliding/velocity_verlet"}},
           {"integrator.central_difference",
            {"order_of_speed/sliding throughout/central_difference",
             "order_of_speed/sticking throughout/central_difference",
             "order_of_speed/sticking, then sliding/central_difference"}},
           {"regime.friction.sticking", {"sticking_impact", "order_of_speed/sticking throughout", "sticking_error"}},
           {"regime.friction.slipping_forward", {"order_of_speed/sliding throughout", "loop"}},
           {"regime.friction.slipping_backward", {"loop"}},
           {"pair.circle.half_plane", {"rolling_start", "slopes/disc", "slopes/rigid"}}},
      .main_checks = {"rolling_start/rigid", "below_threshold/disc", "above_threshold/disc", "sticking_impact",
                      "order_of_speed/sticking, then sliding/velocity_verlet", "loop/area"},
      .source = "Mustoe & Huttelmaier 1993, section 3.5, Eq. 18; Cundall & Strack 1979",
      .faults = {{"friction_halved", "half the coefficient of friction", "loop/area"},
                 {"disc_that_cannot_spin", "a particle instead of the disc", "slopes/disc"},
                 {"slope_too_flat", "slopes 0.2 % flatter", "above_threshold/disc"},
                 {"slope_too_steep", "slopes 0.2 % steeper", "below_threshold/block"},
                 {"slip_stiffness_doubled", "twice the tangential stiffness", "sticking_impact"},
                 {"commensurate_step", "a step that divides the contact time",
                  "order_of_speed/sticking throughout/velocity_verlet"},
                 {"slider_without_account", "friction work left out of the energy balance", "sliding/balance"}},
      .run = run};
}

}  // namespace talus::verification::problems::friction
