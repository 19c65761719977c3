#include "solver/dynamics/runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "solver/base/pack.hpp"

namespace talus {
namespace {

/// Those of eight lanes whose number is from .. to - 1; numbers may be below nought. From a table, and choices are made
/// between whole numbers: gcc 12 makes a jump for each lane of compares of packs and of choices between them.
constexpr std::array<std::int64_t, 2 * pack_size> ones_then_noughts{-1, -1, -1, -1, -1, -1, -1, -1};
[[gnu::always_inline]] inline void between(Sizes& is, std::ptrdiff_t from, std::ptrdiff_t to) {
  constexpr auto size = static_cast<std::ptrdiff_t>(pack_size);
  const auto below = [&](Sizes& lanes, std::ptrdiff_t end) {
    std::memcpy(&lanes, ones_then_noughts.data() + size - std::clamp(end, std::ptrdiff_t{0}, size), sizeof lanes);
  };
  Sizes early;
  below(is, to), below(early, from);
  is &= ~early;
}

/// Lanes that are true become those of another pack.
[[gnu::always_inline]] inline void choose(Pack& pack, const Sizes& is, const Pack& other) {
  Sizes bits, others;
  std::memcpy(&bits, &pack, sizeof bits), std::memcpy(&others, &other, sizeof others);
  bits = (bits & ~is) | (others & is);
  std::memcpy(&pack, &bits, sizeof bits);
}

/// Lanes that are true get new numbers, the others keep what is there.
[[gnu::always_inline]] inline void put(double* row, const Sizes& is, const Pack& numbers) {
  Pack there;
  load(there, row);
  choose(there, is, numbers);
  store(there, row);
}

/// Calls visit(lane) for each lane; visits must not depend on each other.
template <class Visit>
[[gnu::always_inline]] inline void for_lanes(Visit&& visit) {
#pragma omp simd
  for (std::size_t lane = 0; lane < pack_size; ++lane)
    visit(lane);
}

/// Numbers of eight neighbours by lanes.
struct alignas(sizeof(Pack)) Lanes {
  std::array<double, pack_size> number;

  [[gnu::always_inline]] double operator[](std::size_t lane) const { return number[lane]; }
  [[gnu::always_inline]] double& operator[](std::size_t lane) { return number[lane]; }
  [[gnu::always_inline]] void get(Pack& pack) const { load(pack, number.data()); }
  [[gnu::always_inline]] void set(const Pack& pack) { store(pack, number.data()); }
};

/// Of eight lanes, those for which ask(lane) is so.
template <class Ask>
[[gnu::always_inline]] inline void ask_lanes(Sizes& is, Ask&& ask) {
  alignas(sizeof(Pack)) std::array<std::int64_t, pack_size> answer;
  for_lanes([&](std::size_t lane) { answer[lane] = ask(lane) ? -1 : 0; });
  std::memcpy(&is, answer.data(), sizeof is);
}

/// From (x, y, angle) of eight bodies, one after the other, to eight of each.
[[gnu::always_inline]] inline void part(const double* threes, Pack& x, Pack& y, Pack& angle) {
  Pack a, b, c;
  load(a, threes), load(b, threes + 8), load(c, threes + 16);
  const Pack x_ab = __builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
  const Pack y_ab = __builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
  const Pack angle_ab = __builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
  x = __builtin_shufflevector(x_ab, c, 0, 1, 2, 3, 4, 5, 10, 13);
  y = __builtin_shufflevector(y_ab, c, 0, 1, 2, 3, 4, 8, 11, 14);
  angle = __builtin_shufflevector(angle_ab, c, 0, 1, 2, 3, 4, 9, 12, 15);
}

/// The other way round.
[[gnu::always_inline]] inline void join(const Pack& x, const Pack& y, const Pack& angle, double* threes) {
  const Pack first = __builtin_shufflevector(x, y, 0, 8, 0, 1, 9, 0, 2, 10);
  const Pack middle = __builtin_shufflevector(x, y, 0, 3, 11, 0, 4, 12, 0, 5);
  const Pack last = __builtin_shufflevector(x, y, 13, 0, 6, 14, 0, 7, 15, 0);
  store(__builtin_shufflevector(first, angle, 0, 1, 8, 3, 4, 9, 6, 7), threes);
  store(__builtin_shufflevector(middle, angle, 10, 1, 2, 11, 4, 5, 12, 7), threes + 8);
  store(__builtin_shufflevector(last, angle, 0, 13, 2, 3, 14, 5, 6, 15), threes + 16);
}

/// Accelerations of eight free bodies, at `place` among them.
[[gnu::always_inline]] inline void accelerate_eight(std::size_t place, std::size_t body, const BodyConstants& constants,
                                                    const Wrenches& wrenches, double* a) {
  Pack inverse_mass, inverse_inertia, load_x, load_y, applied, x, y, moment;
  load(inverse_mass, constants.inverse_mass.at(place)), load(inverse_inertia, constants.inverse_inertia.at(place));
  load(load_x, constants.load_x.at(place)), load(load_y, constants.load_y.at(place));
  load(applied, constants.moment.at(place));
  load(x, wrenches.x.at(body)), load(y, wrenches.y.at(body)), load(moment, wrenches.moment.at(body));
  join(inverse_mass * (x + load_x), inverse_mass * (y + load_y), inverse_inertia * (moment + applied), a);
}

/// Places of eight bodies, or of as many as there are.
[[gnu::always_inline]] inline void place_eight(const double* q, std::size_t body, const Sizes& are, Poses& poses) {
  Pack x, y, angle;
  part(q, x, y, angle);
  put(poses.x.at(body), are, x), put(poses.y.at(body), are, y);
  Lanes angles, cosine, sine;
  angles.set(angle);
  Sizes beyond, lost{};
  ask_lanes(beyond, [&](std::size_t i) { return !within_series(angles[i]); });
  beyond &= are;
  if (any(beyond)) {
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
  if (!any(lost)) return;
  for (std::size_t i = 0; i < pack_size; ++i) {
    if (lost[i] == 0) continue;
    const Rotation turned = rotation_by_any_angle(angles[i]);
    poses.cosine[body + i] = turned.cosine, poses.sine[body + i] = turned.sine;
  }
}

/// Calls visit(threes, body, are) for each eight of neighbouring bodies, with their three numbers each, and which of
/// the eight there are. Some may be visited twice.
template <class Visit>
[[gnu::always_inline]] inline void for_eights(const BodyRun& run, const double* threes, Visit&& visit) {
  if (run.count < pack_size) {
    // Behind the last body nothing may be read.
    std::array<double, 3 * pack_size> few{};
    std::copy_n(threes, 3 * run.count, few.begin());
    Sizes are;
    between(are, 0, static_cast<std::ptrdiff_t>(run.count));
    return visit(few.data(), run.body, are);
  }
  constexpr Sizes all{-1, -1, -1, -1, -1, -1, -1, -1};
  std::size_t i = 0;
  for (; i + pack_size <= run.count; i += pack_size)
    visit(threes + 3 * i, run.body + i, all);
  if (i == run.count) return;
  i = run.count - pack_size;
  visit(threes + 3 * i, run.body + i, all);
}

/// Eight joints of a row: where they are and, if that is asked for, how they move.
struct Eight {
  Pack x, y, vx, vy;
  Pack arm_x, arm_y;
  Sizes on_body;
};

/// Those of a row from its joint `first` on; those that are on no body stay where they are.
template <bool told, class Joints>
[[gnu::always_inline]] inline void place_eight(Eight& at, const CableRun& run, std::size_t first,
                                               const CableConstants& constants, const Poses& poses, Joints& joints) {
  const auto from = static_cast<std::ptrdiff_t>(run.from), to = static_cast<std::ptrdiff_t>(run.to);
  const auto begin = static_cast<std::ptrdiff_t>(first);
  Sizes& on_body = at.on_body;
  between(on_body, from - begin, to - begin);
  // A lane before the first body reads the room before it.
  const std::ptrdiff_t body = run.body + begin;
  const std::size_t joint = run.a + first;
  Pack x, y, cosine, sine, p_x, p_y;
  load(x, poses.x.at(body)), load(y, poses.y.at(body));
  load(cosine, poses.cosine.at(body)), load(sine, poses.sine.at(body));
  load(p_x, constants.body_x.at(joint)), load(p_y, constants.body_y.at(joint));
  const Pack dx = cosine * p_x - sine * p_y;
  const Pack dy = sine * p_x + cosine * p_y;
  at.arm_x = dx, at.arm_y = dy;
  load(at.x, joints.x.at(joint)), load(at.y, joints.y.at(joint));
  choose(at.x, on_body, x + dx), choose(at.y, on_body, y + dy);
  if constexpr (told) {
    Pack vx, vy, w;
    load(vx, poses.vx.at(body)), load(vy, poses.vy.at(body)), load(w, poses.w.at(body));
    load(at.vx, joints.vx.at(joint)), load(at.vy, joints.vy.at(joint));
    choose(at.vx, on_body, vx - w * dy), choose(at.vy, on_body, vy + w * dx);
    put(joints.arm_x.at(joint), on_body, dx), put(joints.arm_y.at(joint), on_body, dy);
    store(at.x, joints.x.at(joint)), store(at.y, joints.y.at(joint));
    store(at.vx, joints.vx.at(joint)), store(at.vy, joints.vy.at(joint));
  }
}

/// Each lane's next; of the last, the first of the pack after.
[[gnu::always_inline]] inline void ahead(Pack& next, const Pack& pack, const Pack& after) {
  next = __builtin_shufflevector(pack, after, 1, 2, 3, 4, 5, 6, 7, 8);
}

/// All in one pass, in registers from the poses to the pulls: written and read again between one stage and the next,
/// each stage would wait for the one before. `told`: what comes of joints and cables is written down, too.
template <bool told, class Joints>
[[gnu::always_inline]] inline bool pull(const CableRun& run, const CableConstants& constants, const CableLines& lines,
                                        const Poses& poses, Joints& joints, Paths* paths, Wrenches& pulls) {
  const auto count = static_cast<std::ptrdiff_t>(run.count);
  Sizes left{};
  Pack before_x{}, before_y{};  // what the cables before pull at their ends B
  Eight here;
  place_eight<told>(here, run, 0, constants, poses, joints);
  for (std::ptrdiff_t block = 0; block <= count; block += pack_size) {
    Eight next{};
    const auto first = static_cast<std::size_t>(block);
    if (block + static_cast<std::ptrdiff_t>(pack_size) <= count)
      place_eight<told>(next, run, first + pack_size, constants, poses, joints);
    const std::size_t cable = run.cable + first, joint = run.a + first;
    Sizes is;
    between(is, 0, count - block);
    Pack x, y, vx, vy;
    ahead(x, here.x, next.x), ahead(y, here.y, next.y);
    Lanes dx, dy, dvx{}, dvy{}, across, length, rate, pull_x, pull_y;
    Pack pack;
    dx.set(x - here.x), dy.set(y - here.y);
    if constexpr (told) {
      ahead(vx, here.vx, next.vx), ahead(vy, here.vy, next.vy);
      dvx.set(vx - here.vx), dvy.set(vy - here.vy);
    }
    load(pack, constants.across_squared.at(cable)), across.set(pack);
    for_lanes([&](std::size_t i) {
      const Path line = path(dx[i], dy[i], dvx[i], dvy[i], across[i]);
      length[i] = line.length, rate[i] = line.length_rate;
      pull_x[i] = line.pull_A.x, pull_y[i] = line.pull_A.y;
    });
    Pack rest, stiffness, natural, low, high, lengths, pulls_x, pulls_y;
    load(rest, constants.rest_length.at(cable));
    load(stiffness, lines.stiffness.at(cable)), load(natural, lines.natural.at(cable));
    load(low, lines.low.at(cable)), load(high, lines.high.at(cable));
    length.get(lengths), pull_x.get(pulls_x), pull_y.get(pulls_y);
    const Pack extent = lengths - rest;
    const Pack tension = stiffness * (extent - natural);
    Lanes extents, lows, highs;
    extents.set(extent), lows.set(low), highs.set(high);
    Sizes off;
    ask_lanes(off, [&](std::size_t i) { return !(extents[i] > lows[i] && extents[i] < highs[i]); });
    left |= off & is;
    if constexpr (told) {
      rate.get(pack);
      put(paths->length.at(cable), is, lengths), put(paths->length_rate.at(cable), is, pack);
      put(paths->pull_x.at(cable), is, pulls_x), put(paths->pull_y.at(cable), is, pulls_y);
      put(paths->tension.at(cable), is, tension);
    }
    // Joint i takes the pull of cable i and of the one before it.
    Pack force_x{}, force_y{};
    choose(force_x, is, tension * pulls_x), choose(force_y, is, tension * pulls_y);
    Pack share_a, share_b;
    load(share_a, constants.share_a.at(cable)), load(share_b, constants.share_b.at(cable));
    const Pack end_x = share_b * force_x, end_y = share_b * force_y;
    const Pack x_B = __builtin_shufflevector(before_x, end_x, 7, 8, 9, 10, 11, 12, 13, 14);
    const Pack y_B = __builtin_shufflevector(before_y, end_y, 7, 8, 9, 10, 11, 12, 13, 14);
    const Pack joint_x = share_a * force_x - x_B, joint_y = share_a * force_y - y_B;
    if constexpr (told) {
      between(is, 0, count + 1 - block);
      put(joints.force_x.at(joint), is, joint_x), put(joints.force_y.at(joint), is, joint_y);
    }
    const std::ptrdiff_t body = run.body + block;
    Pack sum_x, sum_y, sum;
    load(sum_x, pulls.x.at(body)), load(sum_y, pulls.y.at(body)), load(sum, pulls.moment.at(body));
    choose(sum_x, here.on_body, sum_x + joint_x), choose(sum_y, here.on_body, sum_y + joint_y);
    choose(sum, here.on_body, sum + (here.arm_x * joint_y - here.arm_y * joint_x));
    store(sum_x, pulls.x.at(body)), store(sum_y, pulls.y.at(body)), store(sum, pulls.moment.at(body));
    before_x = end_x, before_y = end_y;
    here = next;
  }
  return !any(left);
}

}  // namespace

TALUS_CLONES void place_bodies(const BodyRun& run, const double* q, Poses& poses) {
  for_eights(
      run, q, [&](const double* threes, std::size_t body, const Sizes& are) __attribute__((always_inline)) {
        place_eight(threes, body, are, poses);
      });
}

TALUS_CLONES void place_velocities(const BodyRun& run, const double* v, Poses& poses) {
  for_eights(
      run, v, [&](const double* threes, std::size_t body, const Sizes& are) __attribute__((always_inline)) {
        Pack vx, vy, w;
        part(threes, vx, vy, w);
        put(poses.vx.at(body), are, vx), put(poses.vy.at(body), are, vy), put(poses.w.at(body), are, w);
      });
}

TALUS_CLONES bool have_moved(const Poses& poses, const Places& places, const Leeways& leeways) {
  const auto change = [](Pack& size, const Row& now, const Row& then, std::size_t i) {
    Pack there;
    load(size, now.at(i)), load(there, then.at(i));
    size -= there;
    Sizes bits{};
    raise(bits, size);
    std::memcpy(&size, &bits, sizeof size);
  };
  // Sizes are ordered as their bits are, as whole numbers, in which what is not a number is above all others: of the
  // greater less the smaller the sign is set.
  Sizes moved{};
  for (std::size_t i = leeways.first; i < leeways.last; i += pack_size) {
    Pack x, y, cosine, sine, radius;
    change(x, poses.x, places.x, i), change(y, poses.y, places.y, i);
    change(cosine, poses.cosine, places.cosine, i), change(sine, poses.sine, places.sine, i);
    load(radius, leeways.radius.at(i));
    Sizes most, way{};
    std::memcpy(&most, leeways.way.at(i), sizeof most);
    raise(way, x + y + radius * (cosine + sine));
    moved |= most - way;
  }
  return any_bit(moved & std::numeric_limits<std::int64_t>::min());
}

TALUS_CLONES void accelerate_bodies(const BodyRun& run, const BodyConstants& constants, const Wrenches& wrenches,
                                    double* a) {
  if (run.count < pack_size) {
    std::array<double, 3 * pack_size> few;
    accelerate_eight(run.place, run.body, constants, wrenches, few.data());
    std::copy_n(few.begin(), 3 * run.count, a);
    return;
  }
  // The last eight first, some of which come once more: who reads the packs from the start finds each as it was stored.
  const std::size_t last = run.count - pack_size;
  if (last % pack_size != 0) accelerate_eight(run.place + last, run.body + last, constants, wrenches, a + 3 * last);
  for (std::size_t i = 0; i + pack_size <= run.count; i += pack_size)
    accelerate_eight(run.place + i, run.body + i, constants, wrenches, a + 3 * i);
}

TALUS_CLONES void clear(Wrenches& wrenches, std::size_t count) {
  // Whole packs, without a look at what is there: what contacts added one by one would be waited for.
  for (std::size_t i = 0; i < count; i += pack_size) {
    for (Row* const row : {&wrenches.x, &wrenches.y, &wrenches.moment})
      store(Pack{}, row->at(i));
  }
}

TALUS_CLONES void copy(const Wrenches& from, std::size_t count, Wrenches& to) {
  for (std::size_t i = 0; i < count; i += pack_size) {
    Pack x, y, moment;
    load(x, from.x.at(i)), load(y, from.y.at(i)), load(moment, from.moment.at(i));
    store(x, to.x.at(i)), store(y, to.y.at(i)), store(moment, to.moment.at(i));
  }
}

void place_joints(const JointRun& run, const Row& p_x, const Row& p_y, const Poses& poses, JointPoints& joints) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::size_t body = run.body + i, joint = run.joint + i;
    const double cosine = poses.cosine[body], sine = poses.sine[body], w = poses.w[body];
    const double dx = cosine * p_x[joint] - sine * p_y[joint];
    const double dy = sine * p_x[joint] + cosine * p_y[joint];
    joints.arm_x[joint] = dx, joints.arm_y[joint] = dy;
    joints.x[joint] = poses.x[body] + dx, joints.y[joint] = poses.y[body] + dy;
    joints.vx[joint] = poses.vx[body] - w * dy, joints.vy[joint] = poses.vy[body] + w * dx;
  }
}

TALUS_CLONES bool lay_row(const CableRun& run, const CableConstants& constants, const CableLines& lines,
                          const Poses& poses, JointPoints& joints, Paths& paths, Wrenches& pulls) {
  return pull<true>(run, constants, lines, poses, joints, &paths, pulls);
}

TALUS_CLONES bool pull_row(const CableRun& run, const CableConstants& constants, const CableLines& lines,
                           const Poses& poses, const JointPoints& joints, Wrenches& pulls) {
  return pull<false>(run, constants, lines, poses, joints, nullptr, pulls);
}

TALUS_CLONES bool stay_straight(std::size_t first, std::size_t count, const Row& rest_length, const CableLines& lines,
                                const Paths& paths, double ahead) {
  Sizes left{};
  for (std::size_t i = 0; i < count; i += pack_size) {
    const std::size_t cable = first + i;
    const double *const length = paths.length.at(cable), *const rest = rest_length.at(cable);
    const double* const rate = paths.length_rate.at(cable);
    const double *const low = lines.low.at(cable), *const high = lines.high.at(cable);
    Sizes off, is;
    ask_lanes(off, [&](std::size_t l) {
      const double extent = length[l] - rest[l], way = ahead * std::abs(rate[l]);
      return !((extent - low[l] > way) & (high[l] - extent > way));
    });
    between(is, 0, static_cast<std::ptrdiff_t>(count - i));
    left |= off & is;
  }
  return !any(left);
}

TALUS_CLONES void box_depths(const Row& x, const Row& y, std::size_t first, std::size_t count, const Placement& A_in_B,
                             const Superquadric& outline, double* depths) {
  const Rotation R = A_in_B.R;
  const Vec2 p = A_in_B.p;
  for (std::size_t i = 0; i < count; i += pack_size) {
    const double *const x_A = x.at(first + i), *const y_A = y.at(first + i);
    Lanes depth;
    for_lanes([&](std::size_t l) { depth[l] = box_depth(outline, p + R * Vec2{x_A[l], y_A[l]}); });
    Pack pack;
    depth.get(pack);
    store(pack, depths + i);
  }
}

TALUS_CLONES void load_bodies(const JointRun& run, const JointPoints& joints, Wrenches& wrenches) {
  for (std::size_t i = 0; i < run.count; i += pack_size) {
    const std::size_t joint = run.joint + i, body = run.body + i;
    Pack force_x, force_y, arm_x, arm_y, x, y, moment;
    load(force_x, joints.force_x.at(joint)), load(force_y, joints.force_y.at(joint));
    load(arm_x, joints.arm_x.at(joint)), load(arm_y, joints.arm_y.at(joint));
    load(x, wrenches.x.at(body)), load(y, wrenches.y.at(body)), load(moment, wrenches.moment.at(body));
    Sizes are;
    between(are, 0, static_cast<std::ptrdiff_t>(run.count - i));
    put(wrenches.x.at(body), are, x + force_x), put(wrenches.y.at(body), are, y + force_y);
    put(wrenches.moment.at(body), are, moment + (arm_x * force_y - arm_y * force_x));
  }
}

}  // namespace talus
