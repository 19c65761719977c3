#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/runs.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/geometry/gap.hpp"

namespace talus {

/// Computes the gaps of one array's groups that are within reach. Of a ball out of its law's reach that does not act
/// (`state` given) only the depth: nothing else is asked of it.
template <class Array>
class GapUpdate {
 public:
  GapUpdate(const Array& array, const State* state, Workspace& work) : array_{array}, state_{state}, work_{work} {}

  void run() const {
    for (const ContactGroup& group : array_.groups) {
      if (work_.near[group.candidate] == Workspace::wanted) update(group);
    }
  }

 private:
  static constexpr bool are_balls = std::is_same_v<typename Array::ShapeA, Ball>;
  static constexpr bool boxed = BoxedRule<typename Array::ShapeB>;
  static constexpr bool over_plane = are_balls && std::is_same_v<typename Array::ShapeB, HalfPlane>;
  static constexpr std::size_t block = 64;

  void update(const ContactGroup& group) const {
    const Pose A = work_.poses[index(group.a)], B = work_.poses[index(group.b)];
    [[maybe_unused]] const Placement A_in_B = placement(A, B);
    if constexpr (boxed || over_plane) {
      if (state_) return update_nodes(group, A, B, A_in_B);
    }
    for (std::size_t i = group.first; i < group.last; ++i)
      update(i, A, B, A_in_B);
  }
  /// Of nodes, which are points, the depths in the box at once, of balls those in a half-plane: few are in it.
  void update_nodes(const ContactGroup& group, const Pose& A, const Pose& B, const Placement& A_in_B) const {
    std::array<double, block + pack_size> depths;
    for (std::size_t first = group.first; first < group.last; first += block) {
      const std::size_t count = std::min(block, group.last - first);
      if constexpr (boxed)
        box_depths(array_.node_x, array_.node_y, first, count, A_in_B, array_.shapes_b[first].outline, depths.data());
      else
        plane_depths(array_.node_x, array_.node_y, array_.radius, first, count, A_in_B, depths.data());
      for (std::size_t i = 0; i < count; ++i) {
        if (!is_idle(first + i, depths[i])) update(first + i, A, B, A_in_B);
      }
    }
  }
  void update(std::size_t i, const Pose& A, const Pose& B, [[maybe_unused]] const Placement& A_in_B) const {
    const std::size_t instance = array_.slots[i].mode;
    if constexpr (are_balls) {
      const Depth found = ball_depth(array_.shapes_a[i], A_in_B, array_.shapes_b[i]);
      if (is_idle(i, found.depth)) return;
      work_.gaps[instance] = ball_gap(array_.shapes_a[i], A, found, B);
    } else {
      work_.gaps[instance] = gap(array_.shapes_a[i], A, array_.shapes_b[i], B);
    }
    work_.rates[instance] = depth_rate(work_.gaps[instance], A, B);
  }
  /// Whether a ball of that depth is out of the law's reach and does not act; then that is its gap's.
  bool is_idle(std::size_t i, double depth) const {
    const std::size_t instance = array_.slots[i].mode;
    if (!(depth < -reach(array_.laws[i]) && state_ && state_->mode[instance] == 0)) return false;
    work_.gaps[instance].depth = depth;
    return true;
  }

  const Array& array_;
  const State* state_;
  Workspace& work_;
};

}  // namespace talus
