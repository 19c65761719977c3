#pragma once

#include "verification/problems/speed_accuracy/work_points.hpp"
#include "verification/study/toolkit.hpp"

/// Scenes whose motion is known in closed form, segment by segment, and the error of a method on them.
namespace talus::verification::problems {

/// A coordinate and its velocity.
struct PositionAndVelocity {
  double position{};
  double velocity{};
};

/// One coordinate of a scene, and its exact motion at equally spaced times from the start to the end.
struct ExactMotion {
  const char* name;
  Scene scene;
  double duration{};
  std::size_t coordinate{};
  std::vector<PositionAndVelocity> exact;
};

/// Number of times after the start at which a motion is compared.
inline constexpr int compared_times = 20;

/// A pendulum from 90 and from 170 degrees, the particle of the 1993 report's problem 1 on its two cables, and a
/// damped disc that bounces under gravity.
[[nodiscard]] std::vector<ExactMotion> exact_motions();

/// Runs a motion with `steps` equal steps between two compared times; for methods that choose their own steps, these
/// are the outputs. Error: the largest over the compared times of position and velocity, each relative to the largest
/// of its exact values.
[[nodiscard]] WorkPoint run_motion(const ExactMotion& motion, Integrator integrator, long steps, Findings& findings);

}  // namespace talus::verification::problems
