#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/base/vec.hpp"

namespace talus {

/// A planar rotation, stored as cosine and sine so that they are computed once per body and evaluation.
struct Rotation {
  double cosine{1.0};
  double sine{0.0};
};

/// Rotation by any angle [rad]; bit-identical to rotation_by_series() within its range.
[[nodiscard]] Rotation rotation_by_any_angle(double angle);

inline constexpr double eighth_of_a_turn = 0.78539816339744830962;

/// Rotation by an angle [rad] of at most an eighth of a turn; larger angles give meaningless results. Branch-free, so
/// that compilers can vectorise it.
///
/// The Taylor series
///   sin x = x - x^3/3! + ... + x^17/17!,   cos x = 1 - x^2/2 + ... + x^16/16!
/// are truncated below 2^-53 of their values. Their terms are summed in pairs, which a processor can evaluate in
/// parallel.
[[nodiscard]] inline Rotation rotation_by_series(double angle) {
  const double y = angle * angle, y2 = y * y, y4 = y2 * y2;
  const double sine_tail = ((-1.0 / 6.0 + y * (1.0 / 120.0)) + y2 * (-1.0 / 5040.0 + y * (1.0 / 362880.0))) +
                           y4 * ((-1.0 / 39916800.0 + y * (1.0 / 6227020800.0)) +
                                 y2 * (-1.0 / 1307674368000.0 + y * (1.0 / 355687428096000.0)));
  const double cosine_tail = ((1.0 / 24.0 + y * (-1.0 / 720.0)) + y2 * (1.0 / 40320.0 + y * (-1.0 / 3628800.0))) +
                             y4 * ((1.0 / 479001600.0 + y * (-1.0 / 87178291200.0)) + y2 * (1.0 / 20922789888000.0));
  // 1 - y/2 loses the rounding error of y/2; this error is added to the tail.
  const double half = 0.5 * y;
  const double head = 1.0 - half;
  return {head + (((1.0 - head) - half) + y2 * cosine_tail), angle + angle * (y * sine_tail)};
}

/// Whether the series is valid for this angle [rad].
[[nodiscard]] inline bool within_series(double angle) { return std::abs(angle) <= eighth_of_a_turn; }

/// Rotation by an angle, and whether it is valid.
struct Turned {
  Rotation rotation;
  bool found{};
};

/// Rotation by an angle [rad] beyond the range of the series, branch-free: the series of the angle minus the nearest
/// integer number k of quarter turns (Cody & Waite 1980). A quarter turn is the sum of three numbers, the first two of
/// 33 bits, so that their products with k are exact up to k = 2^20; the rounding error of the difference is carried to
/// first order. Not found beyond 1e5, or where rounding leaves slightly more than an eighth of a turn.
[[nodiscard]] inline Turned rotation_by_quarter_turns(double angle) {
  constexpr double quarter_1 = 0x1.921fb544p+0, quarter_2 = 0x1.0b4611a6p-34, quarter_3 = 0x1.3198a2e037073p-69;
  constexpr double to_whole = 0x1.8p+52;  // adding and subtracting it rounds to the nearest integer
  const double shifted = angle * 0x1.45f306dc9c883p-1 + to_whole, k = shifted - to_whole;
  const double first = angle - k * quarter_1;
  const double second = k * quarter_2;
  const double difference = first - second;
  const double lost = ((first - difference) - second) - k * quarter_3;
  const double rest = difference + lost;
  const double tail = (difference - rest) + lost;
  const Rotation near = rotation_by_series(rest);
  const double cosine = near.cosine - tail * near.sine;
  const double sine = near.sine + tail * near.cosine;
  // The lowest bits of the shifted number are those of k. If k is odd, sine and cosine are exchanged.
  const auto turns = std::bit_cast<std::uint64_t>(shifted), odd = std::uint64_t{0} - (turns & 1);
  const auto c = std::bit_cast<std::uint64_t>(cosine), s = std::bit_cast<std::uint64_t>(sine);
  const std::uint64_t x = ((c & ~odd) | (s & odd)) ^ (((turns + 1) & 2) << 62);
  const std::uint64_t y = ((s & ~odd) | (c & odd)) ^ ((turns & 2) << 62);
  // Branch-free, because SIMD lanes cannot branch separately.
  const unsigned in_series = within_series(rest), in_range = std::abs(angle) <= 1e5;
  return {{std::bit_cast<double>(x), std::bit_cast<double>(y)}, (in_series & in_range) != 0};
}

/// Rotation by `angle` [rad], counter-clockwise > 0. The only function in the solver that computes a sine, so that all
/// machines, compilers and build types execute the same operations. Error at most 1.2 units in the last place; at most
/// 1 up to an eighth of a turn, where most bodies of a scene are.
[[nodiscard]] inline Rotation rotation(double angle) {
  return within_series(angle) ? rotation_by_series(angle) : rotation_by_any_angle(angle);
}

constexpr Vec2 operator*(Rotation r, Vec2 a) { return {r.cosine * a.x - r.sine * a.y, r.sine * a.x + r.cosine * a.y}; }

/// Inverse rotation: components of a world vector in the body's frame.
constexpr Vec2 unrotate(Rotation r, Vec2 a) { return {r.cosine * a.x + r.sine * a.y, r.cosine * a.y - r.sine * a.x}; }

/// Position, orientation and velocity of a body B in the world frame W, at its centre of mass.
struct Pose {
  Vec2 p_WB;         ///< centre of mass [L]
  Rotation R_WB;     ///< orientation
  Vec2 v_WB;         ///< velocity of the centre of mass [L/T]
  double w_WB{0.0};  ///< angular velocity [rad/T], counter-clockwise > 0
};

/// Position and orientation of body A relative to body B: its centre of mass and rotation in B's frame.
struct Placement {
  Vec2 p;
  Rotation R;
};
constexpr Placement placement(const Pose& A, const Pose& B) {
  return {unrotate(B.R_WB, A.p_WB - B.p_WB),
          {B.R_WB.cosine * A.R_WB.cosine + B.R_WB.sine * A.R_WB.sine,
           B.R_WB.cosine * A.R_WB.sine - B.R_WB.sine * A.R_WB.cosine}};
}

/// World position of the point with body coordinates p_BP.
constexpr Vec2 world_point(const Pose& body, Vec2 p_BP) { return body.p_WB + body.R_WB * p_BP; }

/// World velocity of the material point of the body that is now at world position p_WP.
constexpr Vec2 velocity_at(const Pose& body, Vec2 p_WP) { return body.v_WB + cross(body.w_WB, p_WP - body.p_WB); }

}  // namespace talus
