#include "verification/problems/fence/rock_passages.hpp"

#include <cmath>
#include <numbers>

#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

using scenes::RockPassage;
using scenes::Verdict;

/// A light rock that does not turn, in front of the middle of a full fence.
scenes::Fence fence_with_light_rock() {
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.options = scenes::current_options();
  fence.options.symmetry = scenes::FenceSymmetry::full;
  fence.options.integrator = "velocity_verlet", fence.options.tolerance = 0.0;
  fence.rocks[0].density *= 0.05, fence.rocks[0].spin = 0.0;
  return fence;
}

/// Runs a fence, with the passage of its rock after each step.
template <class Look>
RockPassage passage_of(const scenes::Fence& fence, double step, double end, Findings& findings, const Look& look) {
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const Dynamics dynamics{made.scene.model};
  scenes::FenceMonitor watch{fence, made, dynamics};
  (void)run_scene(made.scene, VelocityVerlet{}, {step, end, end, false}, findings,
                  [&](const Snapshot& seen, const StepInfo& info) {
                    watch(seen, info);
                    look(watch.summary().rocks[0]);
                  });
  return watch.summary().rocks[0];
}

/// The same rock from behind the fence: all numbers are mirrored.
void check_mirrored(Findings& findings, const Setup& setup) {
  constexpr double step = 2e-5, end = 5e-3;
  scenes::Fence fence = fence_with_light_rock();
  fence.rocks[0].spin = 20.0, fence.friction = 0.3;
  const auto nothing = [](const RockPassage&) {};
  const RockPassage front = passage_of(fence, step, end, findings, nothing);
  scenes::FenceElement& rock = fence.rocks[0];
  rock.position.x = 2.0 * fence.column.position.x - rock.position.x;
  rock.velocity.x *= -1.0, rock.spin *= setup.has("spin_not_mirrored") ? 1.0 : -1.0;
  const RockPassage behind = passage_of(fence, step, end, findings, nothing);
  double worst = 0.0;
  const auto compare = [&](double a, double b, double scale) { keep_worst(worst, (a - b) / scale); };
  const double speed = norm(rock.velocity);
  compare(front.touch_time, behind.touch_time, end), compare(front.exit_time, behind.exit_time, end);
  compare(front.braking_time, behind.braking_time, end), compare(front.travel, behind.travel, rock.a);
  compare(front.exit_velocity.x, -behind.exit_velocity.x, speed);
  compare(front.exit_velocity.y, behind.exit_velocity.y, speed);
  compare(front.exit_spin, -behind.exit_spin, 20.0);
  compare(front.exit_energy, behind.exit_energy, front.approach_energy);
  compare(front.distance, behind.distance, rock.a), compare(front.highest, behind.highest, rock.a);
  findings.expect_round_off(
      {"from_behind", "passage of a rock from behind and of its mirror image, worst difference"}, worst, 0.0, 1e-11,
      "the same sums with other signs: 250 steps, each with errors of 1e-16 of lengths and speeds, "
      "which a contact of 3 ms amplifies a thousandfold at most");
  findings.expect_true("verdict on rocks from both sides: stopped, turned and left",
                       front.verdict == Verdict::stopped && behind.verdict == Verdict::stopped && front.turned &&
                           behind.turned && front.left && behind.left && behind.braking_time > 0.0 &&
                           behind.travel > 0.0,
                       "the rock has a sixteenth of the mass of the column that it hits");
}

/// A rock that falls along the fence and touches it, on either side: it comes from the side on which it is.
void check_falling(Findings& findings) {
  double stopped = 0.0;
  for (const double side : {1.0, -1.0}) {
    scenes::Fence fence = fence_with_light_rock();
    scenes::FenceElement& rock = fence.rocks[0];
    rock.position.x = fence.column.position.x + side * (fence.column.a + rock.a - 0.01);
    rock.velocity = {0.0, -20.0};
    stopped +=
        passage_of(fence, 2e-5, 5e-3, findings, [](const RockPassage&) {}).verdict == Verdict::stopped ? 1.0 : 0.0;
  }
  findings.expect_exact("falling rocks that touch the fence in front and behind, and are stopped", stopped, 2.0,
                        "both are pushed away from the fence");
}

/// The verdict after each step of a head-on impact, by its definition.
void check_creeping(Findings& findings) {
  double wrong = 0.0, creeping = 0.0;
  const scenes::Fence fence = fence_with_light_rock();
  (void)passage_of(fence, 1e-6, 2e-3, findings, [&](const RockPassage& rock) {
    const bool back = rock.end_velocity.x >= 0.0;
    const bool still = rock.end_energy <= 1e-4 * rock.approach_energy;
    const bool stopped = rock.touched && (back || still);
    creeping += rock.touched && still && !back ? 1.0 : 0.0;
    wrong += rock.verdict == (stopped ? Verdict::stopped : Verdict::undecided) ? 0.0 : 1.0;
  });
  findings.expect_exact("steps of an impact with another verdict than by its definition", wrong, 0.0,
                        "stopped: touched, and turned back or with a ten-thousandth of the energy; else undecided");
  findings.expect_between("steps at which the rock advances with less than a hundredth of its speed", creeping, 2.0,
                          50.0,
                          "at its turning point its deceleration is 65 ft/s in 1 to 2 ms: a hundredth of the speed is "
                          "lost in 7 to 30 us, steps of 1 us");
}

/// A rock that a moment turns on its way to the fence: the approach spin is that of the last step before the touch.
void check_turning(Findings& findings) {
  constexpr double step = 2e-5, end = 0.012, spin = 20.0, moment = 500.0;  // [s], [s], [rad/s], [lbf ft]
  scenes::Fence fence = fence_with_light_rock();
  scenes::FenceElement& rock = fence.rocks[0];
  rock.position.x += 0.5, rock.spin = spin, rock.moment = moment;
  const RockPassage found = passage_of(fence, step, end, findings, [](const RockPassage&) {});
  // A constant moment on a sphere, I = 2/5 m r^2.
  const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(rock.a, 3) * rock.density;
  const double exact = spin + moment / (0.4 * mass * rock.a * rock.a) * (found.touch_time - step);
  findings.expect("approach spin of a rock that a moment turns on its way to the fence",
                  found.touched ? found.approach_spin : NAN, exact,
                  Tolerance::round_off(1.5e-13,
                                       "two half kicks in each of 400 steps, which the moment makes exact: 800 "
                                       "roundings of 1.1e-16 of the spin, and 400 of the time, if all have the same "
                                       "sign")
                      .relative(),
                  "rad/s");
}

}  // namespace

void check_passages(Findings& findings, const Setup& setup) {
  check_mirrored(findings, setup);
  check_falling(findings);
  check_creeping(findings);
  check_turning(findings);
}

}  // namespace talus::verification::problems
