#include "solver/dynamics/cable_runs.hpp"

#include <limits>

namespace talus {

void place_joints(const JointRun& run, const double* p_x, const double* p_y, const Poses& poses, JointPoints& joints) {
  const std::size_t count = run.count, body = run.body, joint = run.joint;
  const double *const x = &poses.x[body], *const y = &poses.y[body];
  const double *const cosine = &poses.cosine[body], *const sine = &poses.sine[body];
  const double *const vx = &poses.vx[body], *const vy = &poses.vy[body], *const w = &poses.w[body];
  double *const arm_x = &joints.arm_x[joint], *const arm_y = &joints.arm_y[joint];
  double *const joint_x = &joints.x[joint], *const joint_y = &joints.y[joint];
  double *const joint_vx = &joints.vx[joint], *const joint_vy = &joints.vy[joint];
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = cosine[i] * p_x[i] - sine[i] * p_y[i];
    const double dy = sine[i] * p_x[i] + cosine[i] * p_y[i];
    arm_x[i] = dx, arm_y[i] = dy;
    joint_x[i] = x[i] + dx, joint_y[i] = y[i] + dy;
    joint_vx[i] = vx[i] - w[i] * dy, joint_vy[i] = vy[i] + w[i] * dx;
  }
}

void lay_paths(const CableRun& run, const double* across_squared, const JointPoints& joints, Paths& paths) {
  const std::size_t count = run.count;
  const double *const x_A = &joints.x[run.a], *const y_A = &joints.y[run.a];
  const double *const vx_A = &joints.vx[run.a], *const vy_A = &joints.vy[run.a];
  const double *const x_B = &joints.x[run.b], *const y_B = &joints.y[run.b];
  const double *const vx_B = &joints.vx[run.b], *const vy_B = &joints.vy[run.b];
  double *const length = &paths.length[run.cable], *const length_rate = &paths.length_rate[run.cable];
  double *const pull_x = &paths.pull_x[run.cable], *const pull_y = &paths.pull_y[run.cable];
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const Path line = path(x_B[i] - x_A[i], y_B[i] - y_A[i], vx_B[i] - vx_A[i], vy_B[i] - vy_A[i], across_squared[i]);
    length[i] = line.length;
    length_rate[i] = line.length_rate;
    pull_x[i] = line.pull_A.x, pull_y[i] = line.pull_A.y;
  }
}

bool pull_straight(const CableRun& run, const double* rest_length, const CableLines& lines, Paths& paths) {
  const std::size_t count = run.count;
  const double *const stiffness = &lines.stiffness[run.cable], *const natural = &lines.natural[run.cable];
  const double *const low = &lines.low[run.cable], *const high = &lines.high[run.cable];
  const double* const length = &paths.length[run.cable];
  double* const tension = &paths.tension[run.cable];
  double room = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : room)
  for (std::size_t i = 0; i < count; ++i) {
    const double extent = length[i] - rest_length[i];
    tension[i] = stiffness[i] * (extent - natural[i]);
    // Room left on the line: > 0 while the mode lasts.
    const double before = extent - low[i], behind = high[i] - extent;
    const double here = before < behind ? before : behind;
    room = here < room ? here : room;
  }
  return room > 0.0;
}

void sum_pulls(const CableRun& run, const double* share_a, const double* share_b, const Paths& paths,
               JointPoints& joints) {
  const std::size_t count = run.count;
  const double* const tension = &paths.tension[run.cable];
  const double *const pull_x = &paths.pull_x[run.cable], *const pull_y = &paths.pull_y[run.cable];
  double *const x_A = &joints.force_x[run.a], *const y_A = &joints.force_y[run.a];
  Vec2 before;  // what the cable before pulls at the joint where the next begins
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 pull = tension[i] * Vec2{pull_x[i], pull_y[i]};
    x_A[i] += before.x + share_a[i] * pull.x;
    y_A[i] += before.y + share_a[i] * pull.y;
    before = -share_b[i] * pull;
  }
  joints.force_x[run.b + count - 1] += before.x;
  joints.force_y[run.b + count - 1] += before.y;
}

void load_bodies(const JointRun& run, const JointPoints& joints, Wrenches& wrenches) {
  const std::size_t count = run.count;
  const double *const force_x = &joints.force_x[run.joint], *const force_y = &joints.force_y[run.joint];
  const double *const arm_x = &joints.arm_x[run.joint], *const arm_y = &joints.arm_y[run.joint];
  double *const x = &wrenches.x[run.body], *const y = &wrenches.y[run.body];
  double* const moment = &wrenches.moment[run.body];
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    x[i] += force_x[i], y[i] += force_y[i];
    moment[i] += cross(Vec2{arm_x[i], arm_y[i]}, Vec2{force_x[i], force_y[i]});
  }
}

}  // namespace talus
