#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/spans.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/geometry/gap.hpp"

namespace talus {

/// Depths of up to node_block consecutive nodes of an array, computed side by side: in the box around an outline, or of
/// balls in a half-plane [L].
inline constexpr std::size_t node_block = 64;
class NodeDepths {
 public:
  template <class Array>
  NodeDepths(const Array& array, std::size_t first, std::size_t count, const Placement& A_in_B) {
    if constexpr (BoxedRule<typename Array::ShapeB>)
      box_depths(array.node_x, array.node_y, first, count, A_in_B, array.shapes_b[first].outline, depths_.data());
    else
      plane_depths(array.node_x, array.node_y, array.radius, first, count, A_in_B, depths_.data());
  }
  double operator[](std::size_t i) const { return depths_[i]; }

 private:
  std::array<double, node_block + pack_size> depths_;  // only the required elements are written
};

/// Largest overlap of consecutive instances, whose gaps are known [L].
[[nodiscard]] inline double largest_depth(const Workspace& work, std::size_t first, std::size_t last) {
  double largest = work.gaps[first].depth;
  for (std::size_t i = first + 1; i < last; ++i)
    largest = std::max(largest, work.gaps[i].depth);
  return largest;
}

/// Computes the gaps of those groups of one array that are within reach. For a ball out of the reach of its law that
/// does not act (`state` given), computes only the depth: nothing else of it is used.
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

  void update(const ContactGroup& group) const {
    const Pose A = work_.poses[index(group.a)], B = work_.poses[index(group.b)];
    [[maybe_unused]] const Placement A_in_B = placement(A, B);
    if constexpr (boxed || over_plane) {
      if (state_) return update_nodes(group, A, B, A_in_B);
    }
    for (std::size_t i = group.first; i < group.last; ++i)
      update(i, A, B, A_in_B);
  }
  /// First computes the depths of all nodes, of points in the box or of balls in a half-plane: few are inside.
  void update_nodes(const ContactGroup& group, const Pose& A, const Pose& B, const Placement& A_in_B) const {
    for (std::size_t first = group.first; first < group.last; first += node_block) {
      const std::size_t count = std::min(node_block, group.last - first);
      const NodeDepths depths{array_, first, count, A_in_B};
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
  /// True if a ball of this depth is out of the reach of its law and does not act; then stores the depth in its gap.
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

/// Largest depth of a group out of the reach of its law, none of which acts, without computing gaps [L].
template <class Array>
[[nodiscard]] double largest_far_depth(const Array& array, const ContactGroup& group, const Workspace& work) {
  using ShapeB = typename Array::ShapeB;
  constexpr bool are_balls = std::is_same_v<typename Array::ShapeA, Ball>;
  const Pose A = work.poses[index(group.a)], B = work.poses[index(group.b)];
  const std::size_t first = group.first, count = group.last - first;
  if constexpr (BoxedRule<ShapeB>) {
    // No node is in the box around an outline, because a side of it separates them: the depths are those in the box.
    return largest_box_depth(array.node_x, array.node_y, first, count, placement(A, B), array.shapes_b[first].outline);
  } else if constexpr (are_balls && std::is_same_v<ShapeB, HalfPlane>) {
    return largest_plane_depth(array.node_x, array.node_y, array.radius, first, count, placement(A, B));
  } else if constexpr (are_balls && std::is_same_v<ShapeB, Circle>) {
    return largest_circle_depth(array.node_x, array.node_y, array.radius, first, count, placement(A, B),
                                array.shapes_b[first]);
  } else {
    const auto depth = [&](std::size_t i) {
      if constexpr (are_balls)
        return ball_depth(array.shapes_a[i], placement(A, B), array.shapes_b[i]).depth;
      else
        return gap(array.shapes_a[i], A, array.shapes_b[i], B).depth;
    };
    double largest = depth(first);
    for (std::size_t i = first + 1; i < group.last; ++i)
      largest = std::max(largest, depth(i));
    return largest;
  }
}

}  // namespace talus
