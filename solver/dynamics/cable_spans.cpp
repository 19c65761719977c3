#include <cstddef>

#include "solver/dynamics/lane_masks.hpp"
#include "solver/dynamics/spans.hpp"

namespace talus {
namespace {

/// A pack of joints of a row: positions and, if `recorded`, velocities.
struct PackOfJoints {
  Pack x, y, vx, vy;
  Pack arm_x, arm_y;
  Sizes on_body;
};

/// Computes the joints of a row from its joint `first` on; joints that are on no body remain unchanged.
template <bool recorded>
[[gnu::always_inline]] inline void set_joints(PackOfJoints& at, const CableSpan& span, std::size_t first,
                                              const CableConstants& constants, const Poses& poses,
                                              JointPoints& joints) {
  const auto from = static_cast<std::ptrdiff_t>(span.from), to = static_cast<std::ptrdiff_t>(span.to);
  const auto begin = static_cast<std::ptrdiff_t>(first);
  Sizes& on_body = at.on_body;
  between(on_body, from - begin, to - begin);
  // A lane before the first body reads the room in front of the array.
  const std::ptrdiff_t body = span.body + begin;
  const std::size_t joint = span.a + first;
  Pack x, y, cosine, sine, p_x, p_y;
  load(x, poses.x.at(body)), load(y, poses.y.at(body));
  load(cosine, poses.cosine.at(body)), load(sine, poses.sine.at(body));
  load(p_x, constants.body_x.at(joint)), load(p_y, constants.body_y.at(joint));
  const Pack dx = cosine * p_x - sine * p_y;
  const Pack dy = sine * p_x + cosine * p_y;
  at.arm_x = dx, at.arm_y = dy;
  load(at.x, joints.x.at(joint)), load(at.y, joints.y.at(joint));
  choose(at.x, on_body, x + dx), choose(at.y, on_body, y + dy);
  if constexpr (recorded) {
    Pack vx, vy, w;
    load(vx, poses.vx.at(body)), load(vy, poses.vy.at(body)), load(w, poses.w.at(body));
    load(at.vx, joints.vx.at(joint)), load(at.vy, joints.vy.at(joint));
    choose(at.vx, on_body, vx - w * dy), choose(at.vy, on_body, vy + w * dx);
    put(joints.arm_x.at(joint), on_body, dx), put(joints.arm_y.at(joint), on_body, dy);
    store(at.x, joints.x.at(joint)), store(at.y, joints.y.at(joint));
    store(at.vx, joints.vx.at(joint)), store(at.vy, joints.vy.at(joint));
  }
}

/// Tension of a cable of a fence [F]: k (e - p) on the linear branch of its mode, which linear_branch() of its law
/// gives: UnilateralSpring, also of TensionOnly, where it acts; ElasticPlastic where it loads or unloads. A slack cable
/// has k = 0. (The tension of a cable off its linear branch is computed by CableForces::sum_pulls(), which calls the
/// law itself.)
[[gnu::always_inline]] inline void line_tension(Pack& tension, const Pack& stiffness, const Pack& deformation,
                                                const Pack& natural) {
  tension = stiffness * (deformation - natural);
}

/// Shifts a pack by one lane; the last lane becomes the first of the pack after.
[[gnu::always_inline]] inline void shift_lanes(Pack& next, const Pack& pack, const Pack& after) {
  next = __builtin_shufflevector(pack, after, 1, 2, 3, 4);
}

/// Evaluates a row in one pass, in registers from the poses to the forces: if results were written and read again
/// between stages, each stage would wait for the one before. `recorded`: stores the results for joints and cables, too.
/// Otherwise whole packs of forces are stored at the joints: each later row replaces those at its joints.
template <bool recorded>
[[gnu::always_inline]] inline bool pull(const CableSpan& span, const CableConstants& constants,
                                        const CableLinearization& lines, const Poses& poses, JointPoints& joints,
                                        Paths* paths, Wrenches& pulls) {
  const auto count = static_cast<std::ptrdiff_t>(span.count);
  Sizes left{};
  Pack before_x{}, before_y{};  // forces of the preceding cables at their ends B
  PackOfJoints here;
  set_joints<recorded>(here, span, 0, constants, poses, joints);
  for (std::ptrdiff_t block = 0; block <= count; block += pack_size) {
    PackOfJoints next{};
    const auto first = static_cast<std::size_t>(block);
    if (block + static_cast<std::ptrdiff_t>(pack_size) <= count)
      set_joints<recorded>(next, span, first + pack_size, constants, poses, joints);
    const std::size_t cable = span.cable + first, joint = span.a + first;
    Sizes is;
    between(is, 0, count - block);
    Pack x, y, vx, vy;
    shift_lanes(x, here.x, next.x), shift_lanes(y, here.y, next.y);
    Lanes dx, dy, dvx{}, dvy{}, across, length, rate, pull_x, pull_y;
    Pack pack;
    dx.set(x - here.x), dy.set(y - here.y);
    if constexpr (recorded) {
      shift_lanes(vx, here.vx, next.vx), shift_lanes(vy, here.vy, next.vy);
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
    const Pack deformation = lengths - rest;
    Pack tension;
    line_tension(tension, stiffness, deformation, natural);
    Lanes deformations, lows, highs;
    deformations.set(deformation), lows.set(low), highs.set(high);
    Sizes off;
    ask_lanes(off, [&](std::size_t i) { return !(deformations[i] > lows[i] && deformations[i] < highs[i]); });
    left |= off & is;
    if constexpr (recorded) {
      rate.get(pack);
      put(paths->length.at(cable), is, lengths), put(paths->length_rate.at(cable), is, pack);
      put(paths->pull_x.at(cable), is, pulls_x), put(paths->pull_y.at(cable), is, pulls_y);
      put(paths->tension.at(cable), is, tension);
    }
    // Joint i receives the forces of cable i and of the one before it.
    Pack force_x{}, force_y{};
    choose(force_x, is, tension * pulls_x), choose(force_y, is, tension * pulls_y);
    Pack symmetry_weight_a, symmetry_weight_b;
    load(symmetry_weight_a, constants.symmetry_weight_a.at(cable)),
        load(symmetry_weight_b, constants.symmetry_weight_b.at(cable));
    const Pack end_x = symmetry_weight_b * force_x, end_y = symmetry_weight_b * force_y;
    const Pack x_B = __builtin_shufflevector(before_x, end_x, 3, 4, 5, 6);
    const Pack y_B = __builtin_shufflevector(before_y, end_y, 3, 4, 5, 6);
    const Pack joint_x = symmetry_weight_a * force_x - x_B, joint_y = symmetry_weight_a * force_y - y_B;
    if constexpr (recorded) {
      between(is, 0, count + 1 - block);
      put(joints.force_x.at(joint), is, joint_x), put(joints.force_y.at(joint), is, joint_y);
    } else {
      store(joint_x, joints.force_x.at(joint)), store(joint_y, joints.force_y.at(joint));
    }
    const std::ptrdiff_t body = span.body + block;
    Pack sum_x, sum_y, sum;
    load(sum_x, pulls.x.at(body)), load(sum_y, pulls.y.at(body)), load(sum, pulls.moment.at(body));
    choose(sum_x, here.on_body, sum_x + joint_x), choose(sum_y, here.on_body, sum_y + joint_y);
    choose(sum, here.on_body, sum + (here.arm_x * joint_y - here.arm_y * joint_x));
    store(sum_x, pulls.x.at(body)), store(sum_y, pulls.y.at(body)), store(sum, pulls.moment.at(body));
    before_x = end_x, before_y = end_y;
    here = next;
  }
  return !any_bit(left);
}

}  // namespace

TALUS_CLONES void clear(Wrenches& wrenches, std::size_t count) {
  // Stores whole packs without reading what is there: a read would wait for the forces that contacts added one by one.
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

void set_joints(const JointSpan& span, const Row& p_x, const Row& p_y, const Poses& poses, JointPoints& joints) {
  for (std::size_t i = 0; i < span.count; ++i) {
    const std::size_t body = span.body + i, joint = span.joint + i;
    const double cosine = poses.cosine[body], sine = poses.sine[body], w = poses.w[body];
    const double dx = cosine * p_x[joint] - sine * p_y[joint];
    const double dy = sine * p_x[joint] + cosine * p_y[joint];
    joints.arm_x[joint] = dx, joints.arm_y[joint] = dy;
    joints.x[joint] = poses.x[body] + dx, joints.y[joint] = poses.y[body] + dy;
    joints.vx[joint] = poses.vx[body] - w * dy, joints.vy[joint] = poses.vy[body] + w * dx;
  }
}

TALUS_CLONES bool evaluate_chain(const CableSpan& span, const CableConstants& constants,
                                 const CableLinearization& lines, const Poses& poses, JointPoints& joints, Paths& paths,
                                 Wrenches& pulls) {
  return pull<true>(span, constants, lines, poses, joints, &paths, pulls);
}

TALUS_CLONES bool chain_wrenches(const CableSpan& span, const CableConstants& constants,
                                 const CableLinearization& lines, const Poses& poses, JointPoints& joints,
                                 Wrenches& pulls) {
  return pull<false>(span, constants, lines, poses, joints, nullptr, pulls);
}

TALUS_CLONES double add_line_energies(double sum, const CableSpan& span, const CableConstants& constants,
                                      const CableLinearization& lines, const Paths& paths) {
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t cable = span.cable + i;
    Pack length, rest, natural, stiffness, multiplicity;
    load(length, paths.length.at(cable)), load(rest, constants.rest_length.at(cable));
    load(natural, lines.natural.at(cable)), load(stiffness, lines.stiffness.at(cable));
    load(multiplicity, constants.multiplicity.at(cable));
    const Pack elastic = (length - rest) - natural;
    add_lanes(sum, multiplicity * (0.5 * stiffness * elastic * elastic), span.count - i);
  }
  return sum;
}

TALUS_CLONES bool remains_linear(std::size_t first, std::size_t count, const Row& rest_length,
                                 const CableLinearization& lines, const Paths& paths, double horizon) {
  Sizes left{};
  for (std::size_t i = 0; i < count; i += pack_size) {
    const std::size_t cable = first + i;
    const double *const length = paths.length.at(cable), *const rest = rest_length.at(cable);
    const double* const rate = paths.length_rate.at(cable);
    const double *const low = lines.low.at(cable), *const high = lines.high.at(cable);
    Sizes off, is;
    ask_lanes(off, [&](std::size_t l) {
      const double deformation = length[l] - rest[l], change = horizon * std::abs(rate[l]);
      return !((deformation - low[l] > change) & (high[l] - deformation > change));
    });
    between(is, 0, static_cast<std::ptrdiff_t>(count - i));
    left |= off & is;
  }
  return !any_bit(left);
}

TALUS_CLONES void load_bodies(const JointSpan& span, const JointPoints& joints, Wrenches& wrenches) {
  for (std::size_t i = 0; i < span.count; i += pack_size) {
    const std::size_t joint = span.joint + i, body = span.body + i;
    Pack force_x, force_y, arm_x, arm_y, x, y, moment;
    load(force_x, joints.force_x.at(joint)), load(force_y, joints.force_y.at(joint));
    load(arm_x, joints.arm_x.at(joint)), load(arm_y, joints.arm_y.at(joint));
    load(x, wrenches.x.at(body)), load(y, wrenches.y.at(body)), load(moment, wrenches.moment.at(body));
    Sizes are;
    between(are, 0, static_cast<std::ptrdiff_t>(span.count - i));
    put(wrenches.x.at(body), are, x + force_x), put(wrenches.y.at(body), are, y + force_y);
    put(wrenches.moment.at(body), are, moment + (arm_x * force_y - arm_y * force_x));
  }
}

}  // namespace talus
