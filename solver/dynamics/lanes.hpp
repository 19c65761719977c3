#pragma once

#include <algorithm>
#include <boost/align/aligned_allocator.hpp>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include "solver/base/pack.hpp"
#include "solver/base/vec.hpp"
#include "solver/geometry/path.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// Numbers of many bodies, joints or cables, one array for each number, so that neighbours are computed side by side
/// in the lanes of a processor. Where one is asked for it is put together.

/// One number of each, with room for a pack before the first and behind the last: whole packs can be loaded from any
/// place and, their other lanes as they were, be stored there. A store of less than a pack, read at once, costs more.
class Row {
 public:
  explicit Row(std::size_t count = 0, double value = 0.0) : numbers_(count + 2 * pack_size, value) {}

  std::size_t size() const { return numbers_.size() - 2 * pack_size; }
  double& operator[](std::size_t i) { return numbers_[pack_size + i]; }
  double operator[](std::size_t i) const { return numbers_[pack_size + i]; }
  /// To a number, or to room before the first or behind the last.
  template <std::integral Place>
  double* at(Place i) {
    return numbers_.data() + room + static_cast<std::ptrdiff_t>(i);
  }
  template <std::integral Place>
  const double* at(Place i) const {
    return numbers_.data() + room + static_cast<std::ptrdiff_t>(i);
  }
  void clear(std::size_t first, std::size_t count) { std::fill_n(at(first), count, 0.0); }
  void push_back(double number) {
    numbers_.push_back(0.0);
    (*this)[size() - 1] = number;
  }

 private:
  static constexpr auto room = static_cast<std::ptrdiff_t>(pack_size);

  std::vector<double, boost::alignment::aligned_allocator<double, sizeof(Pack)>> numbers_;
};

/// Where the bodies are and how they move.
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

/// Where the bodies are.
struct Places {
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

/// The points of bodies, or of the world, at which cables end.
struct JointPoints {
  Row x, y;              ///< [L]
  Row arm_x, arm_y;      ///< from the body's centre of mass [L]
  Row vx, vy;            ///< [L/T]
  Row force_x, force_y;  ///< sum of the pulls of all cables that end here [F]

  explicit JointPoints(std::size_t count = 0)
      : x(count), y(count), arm_x(count), arm_y(count), vx(count), vy(count), force_x(count), force_y(count) {}

  std::size_t size() const { return x.size(); }
  Vec2 p_WP(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 v_WP(std::size_t i) const { return {vx[i], vy[i]}; }
  Vec2 force(std::size_t i) const { return {force_x[i], force_y[i]}; }
  void clear_forces(std::size_t first, std::size_t count) { force_x.clear(first, count), force_y.clear(first, count); }
  void add_force(std::size_t i, Vec2 force) { force_x[i] += force.x, force_y[i] += force.y; }
  /// Moves a point that is on no body.
  void place(std::size_t i, Vec2 p, Vec2 v) {
    x[i] = p.x, y[i] = p.y;
    vx[i] = v.x, vy[i] = v.y;
    arm_x[i] = arm_y[i] = 0.0;
  }
};

/// The straight lines of the cables, and their tensions.
struct Paths {
  Row length;          ///< [L]
  Row length_rate;     ///< [L/T], > 0 while lengthening
  Row pull_x, pull_y;  ///< in-plane part of the unit vector from end A to end B
  Row tension;         ///< [F]; of runs that are not quiet once they were summed at the joints

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

/// The straight lines of the cables' laws, each kept as long as the cable's mode and memory are those that it was
/// computed for.
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

/// Neighbours in an array whose counterparts elsewhere are neighbours, too.
struct BodySpan {
  std::size_t place{};  ///< of the first in the array of free bodies
  std::size_t body{};   ///< and in the model, whose coordinates follow one another
  std::size_t count{};
  bool goes_on(const BodySpan& next) const { return next.place == place + count && next.body == body + count; }
};

/// Joints that are on bodies, each on the one after its neighbour's; or joints that are on none.
struct JointSpan {
  std::size_t joint{};
  std::size_t body{};
  std::size_t count{};
  bool on_body{};
  bool in_row{};  ///< placed with the row of cables that they are in
  bool goes_on(const JointSpan& next) const {
    return next.joint == joint + count && next.on_body == on_body && next.in_row == in_row &&
           (!on_body || next.body == body + count);
  }
};

/// Cables of one law, each from where the one before it ends to the joint after. Neighbours in the model, they have
/// their modes and memories side by side in the state.
struct CableSpan {
  std::size_t place{};  ///< of the first among the cables of its law
  std::size_t cable{};  ///< and in the model
  std::size_t a{};      ///< joint at its end A
  std::size_t b{};      ///< and at its end B: if there is another cable, the joint after
  std::size_t count{};
  /// In a row no other cable ends at its joints a, a + 1 .. a + count, and all of them, or all but one at either end,
  /// are on neighbouring bodies: those from .. to - 1.
  bool row{};
  std::size_t from{};       ///< counted from a
  std::size_t to{};         ///< counted from a
  std::ptrdiff_t body{};    ///< that joint a is on, or would be on
  bool on_linear_branch{};  ///< of a row, as last laid: each cable stays on the straight line of its mode
  bool goes_on(const CableSpan& next) const {
    return b == a + 1 && next.a == a + count && next.b == b + count && next.place == place + count &&
           next.cable == cable + count;
  }
};

/// Lengthens the last run by one, or begins another.
template <class Run>
void append(std::vector<Run>& runs, const Run& one) {
  if (!runs.empty() && runs.back().goes_on(one)) {
    ++runs.back().count;
  } else {
    runs.push_back(one);
  }
}

}  // namespace talus
