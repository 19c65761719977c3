#include "solver/dynamics/runs.hpp"

#include <cmath>
#include <cstddef>

#include "solver/base/pack.hpp"

namespace talus {
namespace {

/// Calls visit(i) for i = 0 .. count - 1 in blocks of as many as the widest registers hold numbers. In the last block
/// the lanes beyond the end are masked out, so that a run of seven costs what one of eight does. Visits must not depend
/// on each other.
template <class Visit>
[[gnu::always_inline]] inline void for_lanes(std::size_t count, Visit&& visit) {
  for (std::size_t block = 0; block < count; block += 8) {
#pragma omp simd
    for (std::size_t lane = 0; lane < 8; ++lane) {
      if (block + lane < count) visit(block + lane);
    }
  }
}

/// The same; how many of the visits gave true.
template <class Visit>
[[gnu::always_inline]] inline std::size_t count_lanes(std::size_t count, Visit&& visit) {
  std::size_t found = 0;
  for (std::size_t block = 0; block < count; block += 8) {
#pragma omp simd reduction(+ : found)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      if (block + lane < count) found += visit(block + lane) ? 1 : 0;
    }
  }
  return found;
}

/// The lines of neighbouring cables; how many of them accept(i, length) turns down.
template <class Accept>
[[gnu::always_inline]] inline std::size_t lay(const CableRun& run, const double* across_squared,
                                              const JointPoints& joints, Paths& paths, Accept&& accept) {
  const double *const x_A = &joints.x[run.a], *const y_A = &joints.y[run.a];
  const double *const vx_A = &joints.vx[run.a], *const vy_A = &joints.vy[run.a];
  const double *const x_B = &joints.x[run.b], *const y_B = &joints.y[run.b];
  const double *const vx_B = &joints.vx[run.b], *const vy_B = &joints.vy[run.b];
  double *const length = &paths.length[run.cable], *const length_rate = &paths.length_rate[run.cable];
  double *const pull_x = &paths.pull_x[run.cable], *const pull_y = &paths.pull_y[run.cable];
  return count_lanes(run.count, [&](std::size_t i) {
    const Path line = path(x_B[i] - x_A[i], y_B[i] - y_A[i], vx_B[i] - vx_A[i], vy_B[i] - vy_A[i], across_squared[i]);
    length[i] = line.length;
    length_rate[i] = line.length_rate;
    pull_x[i] = line.pull_A.x, pull_y[i] = line.pull_A.y;
    return !accept(i, line.length);
  });
}

}  // namespace

TALUS_CLONES void place_bodies(const BodyRun& run, const double* q, const double* v, Poses& poses) {
  const std::size_t count = run.count;
  double *const x = &poses.x[run.body], *const y = &poses.y[run.body];
  double *const cosine = &poses.cosine[run.body], *const sine = &poses.sine[run.body];
  double *const vx = &poses.vx[run.body], *const vy = &poses.vy[run.body], *const w = &poses.w[run.body];
  for (std::size_t i = 0; i < count; ++i) {
    cosine[i] = q[3 * i + 2];  // the angle itself, until its series are worked out in lanes
    x[i] = q[3 * i], y[i] = q[3 * i + 1];
    vx[i] = v[3 * i], vy[i] = v[3 * i + 1], w[i] = v[3 * i + 2];
  }
  std::size_t beyond = count_lanes(count, [&](std::size_t i) {
    const double angle = cosine[i];
    const Rotation turned = rotation_by_series(angle);
    cosine[i] = turned.cosine, sine[i] = turned.sine;
    return !within_series(angle);
  });
  for (std::size_t i = 0; beyond > 0; ++i) {
    if (within_series(q[3 * i + 2])) continue;
    const Rotation turned = rotation_by_any_angle(q[3 * i + 2]);
    cosine[i] = turned.cosine, sine[i] = turned.sine;
    --beyond;
  }
}

TALUS_CLONES void place_joints(const JointRun& run, const double* p_x, const double* p_y, const Poses& poses,
                               JointPoints& joints) {
  const std::size_t count = run.count, body = run.body, joint = run.joint;
  const double *const x = &poses.x[body], *const y = &poses.y[body];
  const double *const cosine = &poses.cosine[body], *const sine = &poses.sine[body];
  const double *const vx = &poses.vx[body], *const vy = &poses.vy[body], *const w = &poses.w[body];
  double *const arm_x = &joints.arm_x[joint], *const arm_y = &joints.arm_y[joint];
  double *const joint_x = &joints.x[joint], *const joint_y = &joints.y[joint];
  double *const joint_vx = &joints.vx[joint], *const joint_vy = &joints.vy[joint];
  for_lanes(count, [&](std::size_t i) {
    const double dx = cosine[i] * p_x[i] - sine[i] * p_y[i];
    const double dy = sine[i] * p_x[i] + cosine[i] * p_y[i];
    arm_x[i] = dx, arm_y[i] = dy;
    joint_x[i] = x[i] + dx, joint_y[i] = y[i] + dy;
    joint_vx[i] = vx[i] - w[i] * dy, joint_vy[i] = vy[i] + w[i] * dx;
  });
}

TALUS_CLONES void lay_paths(const CableRun& run, const double* across_squared, const JointPoints& joints,
                            Paths& paths) {
  lay(run, across_squared, joints, paths, [](std::size_t, double) { return true; });
}

TALUS_CLONES bool pull_straight(const CableRun& run, const double* across_squared, const double* rest_length,
                                const CableLines& lines, const JointPoints& joints, Paths& paths) {
  const double *const stiffness = &lines.stiffness[run.cable], *const natural = &lines.natural[run.cable];
  const double *const low = &lines.low[run.cable], *const high = &lines.high[run.cable];
  double* const tension = &paths.tension[run.cable];
  const std::size_t left = lay(run, across_squared, joints, paths, [&](std::size_t i, double length) {
    const double extent = length - rest_length[i];
    tension[i] = stiffness[i] * (extent - natural[i]);
    return (extent > low[i]) & (extent < high[i]);
  });
  return left == 0;
}

TALUS_CLONES bool stays_straight(const CableRun& run, const double* rest_length, const CableLines& lines,
                                 const Paths& paths, double ahead) {
  const double *const low = &lines.low[run.cable], *const high = &lines.high[run.cable];
  const double *const length = &paths.length[run.cable], *const rate = &paths.length_rate[run.cable];
  const std::size_t left = count_lanes(run.count, [&](std::size_t i) {
    const double extent = length[i] - rest_length[i], way = ahead * std::abs(rate[i]);
    return !((extent - low[i] > way) & (high[i] - extent > way));
  });
  return left == 0;
}

TALUS_CLONES void sum_pulls(const CableRun& run, const double* share_a, const double* share_b, const Paths& paths,
                            JointPoints& joints) {
  const std::size_t count = run.count;
  const double* const tension = &paths.tension[run.cable];
  const double *const pull_x = &paths.pull_x[run.cable], *const pull_y = &paths.pull_y[run.cable];
  double *const x_A = &joints.force_x[run.a], *const y_A = &joints.force_y[run.a];
  double *const x_B = &joints.force_x[run.b], *const y_B = &joints.force_y[run.b];
  // Several are a chain; a single one may end anywhere.
  if (count == 1) {
    const double x = tension[0] * pull_x[0], y = tension[0] * pull_y[0];
    x_A[0] += share_a[0] * x, y_A[0] += share_a[0] * y;
    x_B[0] -= share_b[0] * x, y_B[0] -= share_b[0] * y;
    return;
  }
  // Joint i takes the pull of cable i and of the one before it.
  for_lanes(count + 1, [&](std::size_t i) {
    double x = 0.0, y = 0.0;
    if (i < count) {
      x = share_a[i] * (tension[i] * pull_x[i]);
      y = share_a[i] * (tension[i] * pull_y[i]);
    }
    if (i > 0) {
      x -= share_b[i - 1] * (tension[i - 1] * pull_x[i - 1]);
      y -= share_b[i - 1] * (tension[i - 1] * pull_y[i - 1]);
    }
    x_A[i] += x;
    y_A[i] += y;
  });
}

TALUS_CLONES void load_bodies(const JointRun& run, const JointPoints& joints, Wrenches& wrenches) {
  const std::size_t count = run.count;
  const double *const force_x = &joints.force_x[run.joint], *const force_y = &joints.force_y[run.joint];
  const double *const arm_x = &joints.arm_x[run.joint], *const arm_y = &joints.arm_y[run.joint];
  double *const x = &wrenches.x[run.body], *const y = &wrenches.y[run.body];
  double* const moment = &wrenches.moment[run.body];
  for_lanes(count, [&](std::size_t i) {
    x[i] += force_x[i], y[i] += force_y[i];
    moment[i] += cross(Vec2{arm_x[i], arm_y[i]}, Vec2{force_x[i], force_y[i]});
  });
}

}  // namespace talus
