#include "verification/problems/friction/late_slip.hpp"
#include "verification/study/scenes/turned_pair.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::turning_pair {
namespace {

using namespace turned_pair;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Turn turned_pair_of(long steps, const Setup& setup) {
  const turned_pair::Faults given{setup.has("one_disc_that_does_not_spin"), setup.has("spring_left_behind")};
  return setup.has("late_slip") ? turned<LateSlipSystem>(steps, given) : turned<RigidBodySystem>(steps, given);
}

void check_turn(Findings& findings, const Setup& setup) {
  constexpr long sampled = 256;
  const Turn one = turned_pair_of(sampled, setup);
  const double exact = exact_drift(sampled);
  const char* counted =
      "512 steps, each with a dozen roundings of positions of up to 2, most of them of random sign: sqrt(512) x 12 x "
      "2.2e-16, times the stiffness for a force";
  constexpr double roundings = 22.6 * 12.0 * epsilon;
  findings.expect_round_off({"spurious_stretch", "spurious stretch in a full rotation of 256 steps"}, one.stretch,
                            exact, roundings, counted, "m");
  findings.expect_round_off("stretch after a full rotation forth and back", one.stretch_back, 0.0, roundings, counted,
                            "m");
  findings.expect_round_off({"normal_force", "normal force in co-rotating directions, largest change"}, one.force, 0.0,
                            2.0 * normal_stiffness * 12.0 * epsilon,
                            "a dozen roundings of the current positions, times the stiffness", "N");
  findings.expect_round_off(
      {"friction_force", "friction force in co-rotating directions, largest change beyond that of the stretch"},
      one.drag, 0.0, 4.0 * 12.0 * epsilon, "a dozen roundings of a force of 4 N and of its directions", "N");
  const double stored = 0.5 * slip_stiffness * exact * (2.0 * first_stretch + exact);
  findings.expect_round_off({"spurious_energy", "spurious stored energy in a full rotation of 256 steps"}, one.energy,
                            stored, 4.0 * 12.0 * epsilon + 0.25 * roundings,
                            "the normal force of 4 N times the roundings of a position, the friction force of 0.25 N "
                            "times those of the stretch",
                            "J");
  const PredictedErrors drift = predicted_errors(doublings(16.0, setup.coarse ? 3 : 6), [&](double n) {
    return std::array{2.0 * std::numbers::pi / n, turned_pair_of(std::lround(n), setup).stretch,
                      2.0 / 3.0 * std::pow(std::numbers::pi, 3.0) * distance / (n * n)};
  });
  findings.expect_order(
      {"order_of_stretch", "order of the spurious stretch in a full rotation"}, drift.found(),
      setup.coarse ? 1.996 : 1.9985, 2.0,
      "2 minus the effect of the next term, 1 - pi^2/(10 n^2), which is 0.004 at 16 steps and falls to a quarter with "
      "each doubling: it tilts the line by 0.002 (from 16 to 64 steps) or 0.001 (to 512)");
  if (setup.coarse) return;
  findings.figure({.name = "turn",
                   .title = "Spurious stretch of a sticking pair in a full rotation",
                   .caption = "Spurious stretch of the tangential spring in a full rotation against the angle per "
                              "step. Line: prediction, no constant fitted.",
                   .x = {"angle per step", "rad", true},
                   .y = {"spurious stretch", "m", true},
                   .series = {drift.points("solver"), drift.line("2/3 pi^3 D/n^2")}});
}

using Coordinates = std::array<double, 3>;  // x, y, angle

/// A disc pressed on a plane and drawn along straight lines; all numbers are sums of few powers of two.
class DrawnDisc {
 public:
  explicit DrawnDisc(double friction) : dynamics_{model(friction)}, system_{dynamics_} {
    record_use(dynamics_.model());
    state_ = rest_state(dynamics_.model());
    state_.q = {0.0, radius - first_overlap, 0.0};
    system_.begin(state_);
    force_ = force();
  }

  /// Draws the disc to a pose, given relative to its start.
  void draw(const Coordinates& to) {
    constexpr int steps = 64;
    const Coordinates start{0.0, radius - first_overlap, 0.0};
    for (std::size_t i = 0; i < 3; ++i)
      state_.v[i] = to[i] + start[i] - state_.q[i];
    for (int n = 0; n < steps; ++n) {
      system_.drift(state_, 1.0 / steps);
      const Coordinates now = force();
      for (std::size_t i = 0; i < 3; ++i)
        work_ -= 0.5 * (force_[i] + now[i]) * state_.v[i] / steps;
      force_ = now;
    }
  }

  double work() const { return work_; }
  double stretch() const { return state_.z[0]; }
  double lost() const { return state_.work[static_cast<std::size_t>(Mechanism::friction)]; }

  static constexpr double radius = 1.0, first_overlap = 0.0625, stiffness = 64.0;

 private:
  static Model model(double friction) {
    SceneBuilder builder;
    const BodyId plane = builder.add_fixed("plane", HalfPlane{});
    const BodyId disc = builder.add_free("disc", 1.0, 1.0, Circle{radius}, {0.0, radius});
    builder.add_contact("touch", disc, plane, LinearSpringDashpot{1024.0, 0.0}, CoulombFriction{friction, stiffness});
    return builder.build();
  }

  /// Forces and moment on the disc, equal to its accelerations (unit mass and inertia).
  Coordinates force() {
    Rates rates{state_};
    system_.evaluate(state_, rates);
    return {rates.v[0], rates.v[1], rates.v[2]};
  }

  Dynamics dynamics_;
  RigidBodySystem system_;
  State state_;
  Coordinates force_{};
  double work_{};
};

void check_loops(Findings& findings, const Setup& setup) {
  const char* dyadic =
      "all positions and forces are small multiples of powers of two, and so are their sums and products; along a "
      "straight line at constant overlap or constant angle, the force is linear and the sum exact";
  const double friction = setup.has("friction_that_slips") ? 0.03125 : 8.0;
  DrawnDisc slid{friction};
  for (const Coordinates& to :
       {Coordinates{0.0625, 0.0, 0.0}, Coordinates{0.0625, -0.03125, 0.0}, Coordinates{-0.03125, -0.03125, 0.0},
        Coordinates{-0.03125, 0.015625, 0.0}, Coordinates{0.0, 0.015625, 0.0}, Coordinates{0.0, 0.0, 0.0}})
    slid.draw(to);
  findings.expect_exact({"work_xy", "work of a closed path in x and y"}, slid.work(), 0.0, dyadic, "J");
  findings.expect_exact({"stretch_xy", "stretch after a closed path in x and y"}, slid.stretch(), 0.0, dyadic, "m");
  findings.expect_exact("friction work of a closed path in x and y", slid.lost(), 0.0, "the contact sticks throughout",
                        "J");

  DrawnDisc rolled{friction};
  for (const Coordinates& to : {Coordinates{0.0625, 0.0, 0.0}, Coordinates{0.0625, 0.0, -0.0625},
                                Coordinates{0.0, 0.0, -0.0625}, Coordinates{}})
    rolled.draw(to);
  findings.expect_exact({"work_xa", "work of a closed path in x and the angle"}, rolled.work(), 0.0, dyadic, "J");

  constexpr double low = -0.03125, turn = 0.5;
  DrawnDisc turned{friction};
  const std::array<Coordinates, 4> corners{Coordinates{0.0, 0.0, turn}, Coordinates{0.0, low, turn},
                                           Coordinates{0.0, low, 0.0}, Coordinates{}};
  for (const Coordinates& to : corners)
    turned.draw(to);
  const double left = 0.5 * turn * low;
  findings.expect_exact({"stretch_ya", "stretch after a closed path in y and the angle"}, turned.stretch(), left,
                        dyadic, "m");
  findings.expect_exact({"work_ya", "work of a closed path in y and the angle"}, turned.work(),
                        0.5 * DrawnDisc::stiffness * left * left, dyadic, "J");
  for (const Coordinates& to : {corners[2], corners[1], corners[0], corners[3]})
    turned.draw(to);
  findings.expect_exact("work of a closed path in y and the angle and of the same path back", turned.work(), 0.0,
                        dyadic, "J");
}

void run(Findings& findings, const Setup& setup) {
  check_turn(findings, setup);
  check_loops(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "turning_pair",
      .title = "Rigid rotation and closed paths of a sticking contact",
      .requirements = {{"C8",
                        {"spurious_stretch", "stretch after a full rotation forth and back", "normal_force",
                         "friction_force", "spurious_energy", "order_of_stretch"}},
                       {"C9",
                        {"work_xy", "stretch_xy", "friction work of a closed path in x and y", "work_xa", "stretch_ya",
                         "work_ya", "work of a closed path in y and the angle and of the same path back"}},
                       {"Eq. 18", {"friction_force", "work_xy", "work_xa", "work_ya"}},
                       {"shape.circle",
                        {"spurious_stretch", "spurious_energy", "order_of_stretch", "work_xy", "stretch_xy", "work_xa",
                         "stretch_ya", "work_ya"}},
                       {"shape.half_plane", {"work_xy", "stretch_xy", "work_xa", "stretch_ya", "work_ya"}},
                       {"law.linear_spring_dashpot", {"normal_force", "work_xy", "work_xa", "work_ya"}}},
      .main_checks = {"spurious_stretch", "order_of_stretch", "friction_force", "work_xy", "work_ya"},
      .source = "Derived here; Cundall & Strack 1979; Vyas et al. 2025, arXiv 2410.14798",
      .faults = {{"late_slip", "slip from half-step velocities along the directions at the end of the step",
                  "spurious_stretch"},
                 {"spring_left_behind", "forces evaluated in world directions", "normal_force"},
                 {"one_disc_that_does_not_spin", "spin of the larger disc only", "order_of_stretch"},
                 {"friction_that_slips", "a coefficient of friction too small to stick", "work_xy"}},
      .run = run};
}

}  // namespace talus::verification::problems::turning_pair
