#include "solver/scenes/fence_scene.hpp"
#include "verification/problems/fence/fence_layouts.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_layouts {
namespace {

/// Displacement along x, along y and rotation.
using Motion = std::array<double, 3>;

double turned(const Pose& pose) { return std::atan2(pose.R_WB.sine, pose.R_WB.cosine); }

/// Motion of a rock from rest by constant forces, which touches nothing, for a time.
Motion motion_of(const scenes::Fence& fence, double end, Findings& findings) {
  const Scene scene = scenes::fence_scene(fence).scene;
  const BodyId rock = *find_body(scene.model, "rock2");
  const Pose before = pose(scene.model, scene.initial, rock);
  const RunEnd run = run_scene(scene, VelocityVerlet{}, {0.1 * end, end, end, false}, findings);
  const Pose after = pose(scene.model, run.state, rock);
  return {after.p_WB.x - before.p_WB.x, after.p_WB.y - before.p_WB.y, turned(after) - turned(before)};
}

}  // namespace

void check_held_elements(Findings& findings, const Setup& setup) {
  constexpr double end = 1e-3;
  const Vec2 force{900.0, 500.0}, fixed{0.3, -0.4};
  constexpr double moment = 120.0;
  double worst = 0.0;
  for (const int sign : {-1, 1}) {
    // A rock that is held in all three is refused.
    for (int which = 0; which < 7; ++which) {
      scenes::Fence fence = fence_of_today();
      fence.gravity_sign = sign;
      // Another rock moves, by whose speed the contacts are calibrated.
      fence.rocks[0].position = {6.0, 30.0};
      scenes::FenceElement& rock = fence.rocks.emplace_back(fence.rocks[0]);
      rock.position = {6.0, 3.0}, rock.velocity = {}, rock.spin = 0.0;
      rock.force = force, rock.moment = moment, rock.fixed_point = fixed;
      rock.held = {(which & 1) != 0, (which & 2) != 0, (which & 4) != 0};
      const auto [x, y, turn] = rock.held;
      const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(rock.a, 3) * rock.density,
                   inertia = 0.4 * mass * rock.a * rock.a;
      const Vec2 total = force + mass * Vec2{0.0, (setup.has("gravity_down") ? -1 : sign) * fence.gravity};
      // Accelerations: each free coordinate for itself, or about the fixed point, whose x or y or both are held.
      std::array<double, 3> exact{x ? 0.0 : total.x / mass, y ? 0.0 : total.y / mass, turn ? 0.0 : moment / inertia};
      if ((x || y) && !turn) {
        const double about = inertia + mass * ((x ? fixed.y * fixed.y : 0.0) + (y ? fixed.x * fixed.x : 0.0));
        const double spin = (moment + (x ? fixed.y * total.x : 0.0) - (y ? fixed.x * total.y : 0.0)) / about;
        exact = {x ? spin * fixed.y : total.x / mass, y ? -spin * fixed.x : total.y / mass, spin};
      }
      const double scale = 0.5 * end * end;
      const Motion found = motion_of(fence, end, findings);
      for (std::size_t i = 0; i < exact.size(); ++i)
        keep_worst(worst, (found[i] / scale - exact[i]) / (norm(total) / mass));
    }
  }
  findings.expect(
      {"held_elements",
       "accelerations of rocks that are held in x, y and rotation, worst error over the "
       "acceleration of a free one"},
      worst, 0.0,
      Tolerance::truncation(2.5e-5, 1.0,
                            "at 50 rad/s^2 a rock turns by 2.5e-5 rad in 1 ms, and the arm of its fixed point "
                            "with it; positions of 6 ft that move by 1e-5 ft are rounded to 1e-10 of that"));
}

}  // namespace talus::verification::problems::fence_layouts
