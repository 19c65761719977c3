#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "solver/dynamics/lane_masks.hpp"
#include "solver/dynamics/spans.hpp"

namespace talus {
namespace {

/// Splits (x, y, angle) of consecutive bodies into a pack of each.
[[gnu::always_inline]] inline void part(const double* threes, Pack& x, Pack& y, Pack& angle) {
  Pack a, b, c;
  load(a, threes), load(b, threes + pack_size), load(c, threes + 2 * pack_size);
  const Pack x_ab = __builtin_shufflevector(a, b, 0, 3, 6, 0);
  const Pack y_ab = __builtin_shufflevector(a, b, 1, 4, 7, 0);
  const Pack angle_ab = __builtin_shufflevector(a, b, 2, 5, 0, 0);
  x = __builtin_shufflevector(x_ab, c, 0, 1, 2, 5);
  y = __builtin_shufflevector(y_ab, c, 0, 1, 2, 6);
  angle = __builtin_shufflevector(angle_ab, c, 0, 1, 4, 7);
}

/// Inverse of part().
[[gnu::always_inline]] inline void join(const Pack& x, const Pack& y, const Pack& angle, double* threes) {
  const Pack first = __builtin_shufflevector(x, y, 0, 4, 0, 1);
  const Pack middle = __builtin_shufflevector(x, y, 5, 0, 2, 6);
  const Pack last = __builtin_shufflevector(x, y, 0, 3, 7, 0);
  store(__builtin_shufflevector(first, angle, 0, 1, 4, 3), threes);
  store(__builtin_shufflevector(middle, angle, 0, 5, 2, 3), threes + pack_size);
  store(__builtin_shufflevector(last, angle, 6, 1, 2, 7), threes + 2 * pack_size);
}

/// Computes the accelerations of a pack of free bodies, from index `index` among them.
[[gnu::always_inline]] inline void accelerate_pack(std::size_t index, std::size_t body, const BodyConstants& constants,
                                                   const Wrenches& wrenches, double* a) {
  Pack inverse_mass, inverse_inertia, load_x, load_y, applied, x, y, moment;
  load(inverse_mass, constants.inverse_mass.at(index)), load(inverse_inertia, constants.inverse_inertia.at(index));
  load(load_x, constants.load_x.at(index)), load(load_y, constants.load_y.at(index));
  load(applied, constants.moment.at(index));
  load(x, wrenches.x.at(body)), load(y, wrenches.y.at(body)), load(moment, wrenches.moment.at(body));
  join(inverse_mass * (x + load_x), inverse_mass * (y + load_y), inverse_inertia * (moment + applied), a);
}

/// Computes positions and orientations of a pack of bodies, in the lanes `are`.
[[gnu::always_inline]] inline void set_pack(const double* q, std::size_t body, const Sizes& are, Poses& poses) {
  Pack x, y, angle;
  part(q, x, y, angle);
  put(poses.x.at(body), are, x), put(poses.y.at(body), are, y);
  Lanes angles, cosine, sine;
  angles.set(angle);
  Sizes beyond, lost{};
  ask_lanes(beyond, [&](std::size_t i) { return !within_series(angles[i]); });
  beyond &= are;
  if (any_bit(beyond)) {
    ask_lanes(lost, [&](std::size_t i) {
      const Turned turned = rotation_by_quarter_turns(angles[i]);
      cosine[i] = turned.rotation.cosine, sine[i] = turned.rotation.sine;
      return !turned.found;
    });
    lost &= are;
  } else {
    for_lanes([&](std::size_t i) {
      const Rotation turned = rotation_by_series(angles[i]);
      cosine[i] = turned.cosine, sine[i] = turned.sine;
    });
  }
  Pack cosines, sines;
  cosine.get(cosines), sine.get(sines);
  put(poses.cosine.at(body), are, cosines), put(poses.sine.at(body), are, sines);
  if (!any_bit(lost)) return;
  for (std::size_t i = 0; i < pack_size; ++i) {
    if (lost[i] == 0) continue;
    const Rotation turned = rotation_by_any_angle(angles[i]);
    poses.cosine[body + i] = turned.cosine, poses.sine[body + i] = turned.sine;
  }
}

/// Calls visit(threes, body, are) for each pack of a span of bodies: their three numbers each, the first body, and the
/// lanes that are used. Some bodies may be visited twice.
template <class Visit>
[[gnu::always_inline]] inline void for_body_packs(const BodySpan& span, const double* threes, Visit&& visit) {
  if (span.count < pack_size) {
    // Memory behind the last body must not be read.
    std::array<double, 3 * pack_size> few{};
    std::copy_n(threes, 3 * span.count, few.begin());
    Sizes are;
    between(are, 0, static_cast<std::ptrdiff_t>(span.count));
    return visit(few.data(), span.body, are);
  }
  constexpr Sizes all{-1, -1, -1, -1};
  std::size_t i = 0;
  for (; i + pack_size <= span.count; i += pack_size)
    visit(threes + 3 * i, span.body + i, all);
  if (i == span.count) return;
  i = span.count - pack_size;
  visit(threes + 3 * i, span.body + i, all);
}

/// Depth of point i of A in the box around an outline of B.
[[gnu::always_inline]] inline auto depth_in_box(const double* x, const double* y, const Placement& A_in_B,
                                                const Superquadric& outline) {
  return [=](std::size_t i) __attribute__((always_inline)) {
    return box_depth(outline, A_in_B.p + A_in_B.R * Vec2{x[i], y[i]});
  };
}
/// Depth of ball i of A in the half-plane y < 0 of B.
[[gnu::always_inline]] inline auto depth_in_plane(const double* x, const double* y, const double* radius,
                                                  const Placement& A_in_B) {
  return [=](std::size_t i) __attribute__((always_inline)) {
    return radius[i] - (A_in_B.p + A_in_B.R * Vec2{x[i], y[i]}).y;
  };
}

template <class DepthOf>
[[gnu::always_inline]] inline void write_depths(std::size_t count, double* depths, DepthOf&& depth_of) {
  for (std::size_t i = 0; i < count; i += pack_size) {
    Lanes depth;
    for_lanes([&](std::size_t l) { depth[l] = depth_of(i + l); });
    Pack pack;
    depth.get(pack);
    store(pack, depths + i);
  }
}

template <class DepthOf>
[[gnu::always_inline]] inline double largest_depth(std::size_t count, DepthOf&& depth_of) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  Lanes largest{{none, none, none, none}};
  for (std::size_t i = 0; i < count; i += pack_size) {
    Lanes depth;
    for_lanes([&](std::size_t l) { depth[l] = depth_of(i + l); });
    Sizes is;
    between(is, 0, static_cast<std::ptrdiff_t>(count - i));
    Pack pack = Pack{} + none, depths;
    depth.get(depths), choose(pack, is, depths), depth.set(pack);
    for_lanes([&](std::size_t l) { largest[l] = std::max(largest[l], depth[l]); });
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

}  // namespace

TALUS_CLONES void set_body_poses(const BodySpan& span, const double* q, Poses& poses) {
  for_body_packs(
      span, q, [&](const double* threes, std::size_t body, const Sizes& are) __attribute__((always_inline)) {
        set_pack(threes, body, are, poses);
      });
}

TALUS_CLONES void set_body_velocities(const BodySpan& span, const double* v, Poses& poses) {
  for_body_packs(
      span, v, [&](const double* threes, std::size_t body, const Sizes& are) __attribute__((always_inline)) {
        Pack vx, vy, w;
        part(threes, vx, vy, w);
        put(poses.vx.at(body), are, vx), put(poses.vy.at(body), are, vy), put(poses.w.at(body), are, w);
      });
}

TALUS_CLONES bool any_exceeded_skin(const Poses& poses, const Positions& positions, const SkinLimits& limits) {
  const auto change = [](Pack& size, const Row& now, const Row& then, std::size_t i) {
    Pack there;
    load(size, now.at(i)), load(there, then.at(i));
    size -= there;
    Sizes bits{};
    raise(bits, size);
    std::memcpy(&size, &bits, sizeof size);
  };
  // Absolute values are ordered as their bits are, as integers, in which NaN is above all numbers: the sign bit of the
  // limit minus the displacement is set where the limit is exceeded.
  Sizes moved{};
  for (std::size_t i = limits.first; i < limits.last; i += pack_size) {
    Pack x, y, cosine, sine, radius;
    change(x, poses.x, positions.x, i), change(y, poses.y, positions.y, i);
    change(cosine, poses.cosine, positions.cosine, i), change(sine, poses.sine, positions.sine, i);
    load(radius, limits.radius.at(i));
    Sizes maximum, displacement{};
    std::memcpy(&maximum, limits.displacement.at(i), sizeof maximum);
    raise(displacement, x + y + radius * (cosine + sine));
    moved |= maximum - displacement;
  }
  return any_bit(moved & std::numeric_limits<std::int64_t>::min());
}

TALUS_CLONES void accelerate_bodies(const BodySpan& span, const BodyConstants& constants, const Wrenches& wrenches,
                                    double* a) {
  if (span.count < pack_size) {
    std::array<double, 3 * pack_size> few;
    accelerate_pack(span.index, span.body, constants, wrenches, few.data());
    std::copy_n(few.begin(), 3 * span.count, a);
    return;
  }
  // The last pack first; some of its bodies are computed again below, so that a reader that loads packs from the start
  // finds each as it was stored.
  const std::size_t last = span.count - pack_size;
  if (last % pack_size != 0) accelerate_pack(span.index + last, span.body + last, constants, wrenches, a + 3 * last);
  for (std::size_t i = 0; i + pack_size <= span.count; i += pack_size)
    accelerate_pack(span.index + i, span.body + i, constants, wrenches, a + 3 * i);
}

TALUS_CLONES void add_impulses(const BodySpan& span, const BodyConstants& constants, const Poses& poses,
                               Impulse<double>& sum) {
  auto [force_x, force_y, moment] = sum;
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t index = span.index + i, body = span.body + i, left = span.count - i;
    Pack multiplicity, load_x, load_y, applied, x, y;
    load(multiplicity, constants.multiplicity.at(index));
    load(load_x, constants.load_x.at(index)), load(load_y, constants.load_y.at(index));
    load(applied, constants.moment.at(index)), load(x, poses.x.at(body)), load(y, poses.y.at(body));
    add_lanes(force_x, multiplicity * load_x, left);
    add_lanes(force_y, multiplicity * load_y, left);
    add_lanes(moment, multiplicity * ((x * load_y - y * load_x) + applied), left);
  }
  sum = {force_x, force_y, moment};
}

TALUS_CLONES void add_energies(const BodySpan& span, const BodyWeights& weights, Vec2 gravity, const Poses& poses,
                               Energies& sum) {
  // Sums in registers: members of the result would be written and read again for each body.
  double kinetic = sum.kinetic, potential = sum.gravity;
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t index = span.index + i, body = span.body + i, left = span.count - i;
    Pack x, y, vx, vy, w, weight, half_mass, half_inertia;
    load(x, poses.x.at(body)), load(y, poses.y.at(body));
    load(vx, poses.vx.at(body)), load(vy, poses.vy.at(body)), load(w, poses.w.at(body));
    load(weight, weights.weight.at(index));
    load(half_mass, weights.kinetic.at(index)), load(half_inertia, weights.turning.at(index));
    Lanes moving, turning;
    moving.set(half_mass * (vx * vx + vy * vy)), turning.set(half_inertia * w * w);
    for (std::size_t lane = 0; lane < std::min(left, pack_size); ++lane)
      kinetic += moving[lane], kinetic += turning[lane];
    add_lanes(potential, -(weight * (gravity.x * x + gravity.y * y)), left);
  }
  sum.kinetic = kinetic, sum.gravity = potential;
}

TALUS_CLONES void add_applied(const BodySpan& span, const BodyWeights& weights, const double* q, const Poses& poses,
                              double& sum) {
  double potential = sum;
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t index = span.index + i, body = span.body + i, left = span.count - i;
    Lanes angles{};
    for (std::size_t lane = 0; lane < std::min(left, pack_size); ++lane)
      angles[lane] = q[weights.angle_coordinate[index + lane]];
    Pack x, y, angle, x0, y0, angle0, force_x, force_y, moment, multiplicity;
    load(x, poses.x.at(body)), load(y, poses.y.at(body)), angles.get(angle);
    load(x0, weights.reference_x.at(index)), load(y0, weights.reference_y.at(index)),
        load(angle0, weights.angle.at(index));
    load(force_x, weights.force_x.at(index)), load(force_y, weights.force_y.at(index));
    load(moment, weights.moment.at(index)), load(multiplicity, weights.multiplicity.at(index));
    const Pack along = force_x * (x - x0) + force_y * (y - y0);
    add_lanes(potential, -(multiplicity * (along + moment * (angle - angle0))), left);
  }
  sum = potential;
}

TALUS_CLONES void add_momenta(const BodySpan& span, const BodyWeights& weights, const Poses& poses, Momenta& sum) {
  double linear_x = sum.linear.x, linear_y = sum.linear.y, angular = sum.angular;
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t index = span.index + i, body = span.body + i, left = span.count - i;
    Pack x, y, vx, vy, w, weight, multiplicity, mass, inertia;
    load(x, poses.x.at(body)), load(y, poses.y.at(body));
    load(vx, poses.vx.at(body)), load(vy, poses.vy.at(body)), load(w, poses.w.at(body));
    load(weight, weights.weight.at(index)), load(multiplicity, weights.multiplicity.at(index));
    load(mass, weights.mass.at(index)), load(inertia, weights.inertia.at(index));
    add_lanes(linear_x, weight * vx, left);
    add_lanes(linear_y, weight * vy, left);
    add_lanes(angular, multiplicity * (mass * (x * vy - y * vx) + inertia * w), left);
  }
  sum = {{linear_x, linear_y}, angular};
}

TALUS_CLONES void box_depths(const Row& x, const Row& y, std::size_t first, std::size_t count, const Placement& A_in_B,
                             const Superquadric& outline, double* depths) {
  write_depths(count, depths, depth_in_box(x.at(first), y.at(first), A_in_B, outline));
}

TALUS_CLONES void plane_depths(const Row& x, const Row& y, const Row& radius, std::size_t first, std::size_t count,
                               const Placement& A_in_B, double* depths) {
  write_depths(count, depths, depth_in_plane(x.at(first), y.at(first), radius.at(first), A_in_B));
}

TALUS_CLONES double largest_box_depth(const Row& x, const Row& y, std::size_t first, std::size_t count,
                                      const Placement& A_in_B, const Superquadric& outline) {
  return largest_depth(count, depth_in_box(x.at(first), y.at(first), A_in_B, outline));
}

TALUS_CLONES double largest_plane_depth(const Row& x, const Row& y, const Row& radius, std::size_t first,
                                        std::size_t count, const Placement& A_in_B) {
  return largest_depth(count, depth_in_plane(x.at(first), y.at(first), radius.at(first), A_in_B));
}

TALUS_CLONES double largest_circle_depth(const Row& x, const Row& y, const Row& radius, std::size_t first,
                                         std::size_t count, const Placement& A_in_B, const Circle& circle) {
  const double *const x_A = x.at(first), *const y_A = y.at(first), *const r = radius.at(first);
  return largest_depth(
      count, [=](std::size_t i) __attribute__((always_inline)) {
        return r[i] + (circle.radius - norm(A_in_B.p + A_in_B.R * Vec2{x_A[i], y_A[i]}));
      });
}

}  // namespace talus
