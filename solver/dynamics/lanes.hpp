#pragma once

#include <algorithm>
#include <boost/align/aligned_allocator_adaptor.hpp>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "solver/base/pack.hpp"
#include "solver/base/vec.hpp"
#include "solver/geometry/path.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// Data of many bodies, joints or cables, one array for each number, so that neighbours are computed side by side in
/// the lanes of a processor. Access to one element assembles it from the arrays.

/// One number for each element, with room for a pack before the first and behind the last: a whole pack can be loaded
/// at any index and stored there with its other lanes unchanged. A store of less than a pack that is read at once costs
/// more.
class Row {
 public:
  Row() : Row(0) {}
  explicit Row(std::size_t count, double value = 0.0) : numbers_(count + 2 * pack_size, value) {}

  std::size_t size() const { return numbers_.size() - 2 * pack_size; }
  double& operator[](std::size_t i) { return numbers_[pack_size + i]; }
  double operator[](std::size_t i) const { return numbers_[pack_size + i]; }
  /// Pointer to a number, or to the room before the first or behind the last.
  template <std::integral Index>
  double* at(Index i) {
    return numbers_.data() + room + static_cast<std::ptrdiff_t>(i);
  }
  template <std::integral Index>
  const double* at(Index i) const {
    return numbers_.data() + room + static_cast<std::ptrdiff_t>(i);
  }
  void clear(std::size_t first, std::size_t count) { std::fill_n(at(first), count, 0.0); }
  void push_back(double number) {
    numbers_.push_back(0.0);
    (*this)[size() - 1] = number;
  }

 private:
  static constexpr auto room = static_cast<std::ptrdiff_t>(pack_size);

  // The adaptor aligns memory of the usual allocator. A workspace has some forty rows, and the functions of the C
  // library for aligned memory take four times as long.
  std::vector<double, boost::alignment::aligned_allocator_adaptor<std::allocator<double>, sizeof(Pack)>> numbers_;
};

/// Positions, orientations and velocities of the bodies.
struct Poses {
  Row x, y;          ///< centre of mass [L]
  Row cosine, sine;  ///< orientation
  Row vx, vy;        ///< velocity of the centre of mass [L/T]
  Row w;             ///< angular velocity [rad/T], counter-clockwise > 0

  explicit Poses(std::size_t count = 0)
      : x(count), y(count), cosine(count, 1.0), sine(count), vx(count), vy(count), w(count) {}

  std::size_t size() const { return x.size(); }
  Pose operator[](std::size_t i) const { return {{x[i], y[i]}, {cosine[i], sine[i]}, {vx[i], vy[i]}, w[i]}; }
  void set(std::size_t i, const Pose& pose) {
    x[i] = pose.p_WB.x, y[i] = pose.p_WB.y;
    cosine[i] = pose.R_WB.cosine, sine[i] = pose.R_WB.sine;
    vx[i] = pose.v_WB.x, vy[i] = pose.v_WB.y;
    w[i] = pose.w_WB;
  }
};

/// Positions and orientations of the bodies.
struct Positions {
  Row x, y;          ///< centre of mass [L]
  Row cosine, sine;  ///< orientation
};

/// Force and moment on a body about its centre of mass, world components.
struct Wrench {
  Vec2 force;       ///< [F]
  double moment{};  ///< [F L], counter-clockwise > 0
};

/// Wrenches of the bodies.
struct Wrenches {
  Row x, y;    ///< force [F]
  Row moment;  ///< [F L]

  explicit Wrenches(std::size_t count = 0) : x(count), y(count), moment(count) {}

  Wrench operator[](std::size_t i) const { return {{x[i], y[i]}, moment[i]}; }
  /// Adds a force [F] that acts at world point p_WP to the wrench of a body whose centre of mass is at p_WB.
  void add(std::size_t i, Vec2 p_WB, Vec2 p_WP, Vec2 force) {
    x[i] += force.x;
    y[i] += force.y;
    moment[i] += cross(p_WP - p_WB, force);
  }
};

/// Points of bodies, or of the world, at which cables end.
struct JointPoints {
  Row x, y;              ///< [L]
  Row arm_x, arm_y;      ///< from the body's centre of mass [L]
  Row vx, vy;            ///< [L/T]
  Row force_x, force_y;  ///< sum of the forces of all cables that end here [F]

  explicit JointPoints(std::size_t count = 0)
      : x(count), y(count), arm_x(count), arm_y(count), vx(count), vy(count), force_x(count), force_y(count) {}

  std::size_t size() const { return x.size(); }
  Vec2 p_WP(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 v_WP(std::size_t i) const { return {vx[i], vy[i]}; }
  Vec2 force(std::size_t i) const { return {force_x[i], force_y[i]}; }
  void clear_forces(std::size_t first, std::size_t count) { force_x.clear(first, count), force_y.clear(first, count); }
  void add_force(std::size_t i, Vec2 force) { force_x[i] += force.x, force_y[i] += force.y; }
  /// Moves a point that is on no body.
  void set(std::size_t i, Vec2 p, Vec2 v) {
    x[i] = p.x, y[i] = p.y;
    vx[i] = v.x, vy[i] = v.y;
    arm_x[i] = arm_y[i] = 0.0;
  }
};

/// Straight paths of the cables, and their tensions.
struct Paths {
  Row length;          ///< [L]
  Row length_rate;     ///< [L/T], > 0 while lengthening
  Row pull_x, pull_y;  ///< in-plane part of the unit vector from end A to end B
  Row tension;         ///< [F]; of spans off their linear branches valid once summed at the joints

  explicit Paths(std::size_t count = 0)
      : length(count), length_rate(count), pull_x(count), pull_y(count), tension(count) {}

  std::size_t size() const { return length.size(); }
  Path operator[](std::size_t i) const { return {length[i], length_rate[i], pull(i)}; }
  Vec2 pull(std::size_t i) const { return {pull_x[i], pull_y[i]}; }
  void set(std::size_t i, const Path& path) {
    length[i] = path.length, length_rate[i] = path.length_rate;
    pull_x[i] = path.pull_A.x, pull_y[i] = path.pull_A.y;
  }
};

/// Linear branches of the laws of the cables, each valid as long as the mode and memory of the cable are those for
/// which it was computed.
struct CableLinearization {
  std::vector<Mode> mode;
  std::vector<double> memory;
  Row stiffness, natural, low, high;  ///< as in LinearBranch

  explicit CableLinearization(std::size_t count = 0)
      : mode(count, std::numeric_limits<Mode>::max()),
        memory(count),
        stiffness(count),
        natural(count),
        low(count),
        high(count) {}

  void set(std::size_t i, const LinearBranch& piece) {
    stiffness[i] = piece.stiffness, natural[i] = piece.natural;
    low[i] = piece.low, high[i] = piece.high;
  }
};

/// Span of consecutive free bodies that are also consecutive in the model.
struct BodySpan {
  std::size_t index{};  ///< index of the first in the array of free bodies
  std::size_t body{};   ///< index of the first in the model; the coordinates are consecutive
  std::size_t count{};
  bool continues(const BodySpan& next) const { return next.index == index + count && next.body == body + count; }
};

/// Span of joints on consecutive bodies, or of joints on no body.
struct JointSpan {
  std::size_t joint{};
  std::size_t body{};
  std::size_t count{};
  bool on_body{};
  bool in_row{};  ///< placed together with its row of cables
  bool continues(const JointSpan& next) const {
    return next.joint == joint + count && next.on_body == on_body && next.in_row == in_row &&
           (!on_body || next.body == body + count);
  }
};

/// Span of cables of one law, each from the joint at which the one before it ends to the next joint. The cables are
/// consecutive in the model, so that their modes and memories are consecutive in the state.
struct CableSpan {
  std::size_t index{};  ///< index of the first among the cables of its law
  std::size_t cable{};  ///< index of the first in the model
  std::size_t a{};      ///< joint at end A of the first cable
  std::size_t b{};      ///< joint at end B of the first cable: a + 1 if there is another cable
  std::size_t count{};
  /// True for a row: no other cable ends at the joints a, a + 1 .. a + count, and all these joints, or all but one at
  /// either end, are on consecutive bodies: those from .. to - 1.
  bool row{};
  std::size_t from{};       ///< counted from a
  std::size_t to{};         ///< counted from a
  std::ptrdiff_t body{};    ///< on which joint a is, or would be
  bool on_linear_branch{};  ///< of a row, in the last evaluation: each cable is on the linear branch of its mode
  bool continues(const CableSpan& next) const {
    return b == a + 1 && next.a == a + count && next.b == b + count && next.index == index + count &&
           next.cable == cable + count;
  }
};

/// Extends the last span by one element, or begins another.
template <class Span>
void append(std::vector<Span>& spans, const Span& one) {
  if (!spans.empty() && spans.back().continues(one)) {
    ++spans.back().count;
  } else {
    spans.push_back(one);
  }
}

}  // namespace talus
