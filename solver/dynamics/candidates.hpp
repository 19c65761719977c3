#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "solver/base/ids.hpp"
#include "solver/dynamics/spans.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// Bounding box of a shape, with sides along the axes of the body; the box of a circle does not turn.
struct Bounds {
  double half_width{};   ///< [L]
  double half_height{};  ///< [L]
  bool round{};
  bool plane{};  ///< a half-plane: no box, but everything below the x axis of the body
};

[[nodiscard]] Bounds bounds(const Shape& shape);

/// True for ground, which extends without bound.
[[nodiscard]] inline bool is_unbounded(const Bounds& bounds) { return bounds.plane || bounds.half_width > 1e100; }

/// Half the smallest width [L]; infinite for ground.
[[nodiscard]] inline double minimum_half_width(const Bounds& bounds) {
  return is_unbounded(bounds) ? std::numeric_limits<double>::infinity()
                              : std::min(bounds.half_width, bounds.half_height);
}

/// Upper bound of the distance of any point of the shape from the centre of mass [L]; zero for ground, which does not
/// turn.
[[nodiscard]] inline double furthest(const Bounds& bounds) {
  if (is_unbounded(bounds)) return 0.0;
  return bounds.round ? bounds.half_width : bounds.half_width + bounds.half_height;
}

/// Two bodies that may touch, and their law instances in the state.
struct Candidate {
  BodyId a{};
  BodyId b{};
  Bounds bounds_a;
  Bounds bounds_b;
  std::size_t first{};  ///< first mode slot of the contact
  std::size_t last{};   ///< one past its last
  double reach{};       ///< largest distance of the surfaces at which the law acts [L]
};

/// Half the smallest width of the smaller of the two bodies [L].
[[nodiscard]] double smaller_size(const Candidate& pair);

/// True if a side of one of the boxes separates the two shapes by more than the reach of the law and a margin [L] >= 0
/// (half-plane: if the box of the other lies above it). Never true for bodies in contact.
[[nodiscard]] bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B, double margin = 0.0);

/// Upper bound of the speed at which any point of one of the two bodies approaches the other [L/T].
[[nodiscard]] inline double largest_closing_speed(const Candidate& pair, const Pose& A, const Pose& B) {
  return norm(B.v_WB - A.v_WB) + std::abs(A.w_WB) * furthest(pair.bounds_a) +
         std::abs(B.w_WB) * furthest(pair.bounds_b);
}

/// Cheap upper bound of largest_closing_speed() [L/T].
[[nodiscard]] inline double closing_speed_bound(const Candidate& pair, const Poses& poses) {
  const std::size_t a = index(pair.a), b = index(pair.b);
  return std::abs(poses.vx[b] - poses.vx[a]) + std::abs(poses.vy[b] - poses.vy[a]) +
         std::abs(poses.w[a]) * furthest(pair.bounds_a) + std::abs(poses.w[b]) * furthest(pair.bounds_b);
}

/// Largest relative displacement of the two bodies in a step that cannot miss a contact between them [L].
[[nodiscard]] inline double tunnelling_distance(const Candidate& pair) {
  return 0.5 * (minimum_half_width(pair.bounds_a) + minimum_half_width(pair.bounds_b));
}

/// True if two bodies, neither of them ground, that approach by a displacement [L] >= 0 can neither act on each other
/// nor tunnel, judged by circles around them: a cheap test that is true for most pairs.
[[nodiscard]] inline bool cannot_touch(const Candidate& pair, const Poses& poses, double displacement) {
  const std::size_t a = index(pair.a), b = index(pair.b);
  const double x = poses.x[b] - poses.x[a], y = poses.y[b] - poses.y[a];
  const double reach = furthest(pair.bounds_a) + furthest(pair.bounds_b) + pair.reach + displacement;
  return displacement <= tunnelling_distance(pair) && x * x + y * y > reach * reach;
}

/// Range of a swept body along x [L].
struct XRange {
  double low{};
  double high{};
};

/// Scratch memory of the contact search, which the caller owns from one evaluation to the next.
struct Sweep {
  std::vector<std::size_t> order;  ///< indices of the swept bodies, sorted by their smallest x
  std::vector<XRange> ranges;      ///< one for each swept body
  std::vector<std::size_t> close;  ///< pairs closer than reach plus skin
  Positions positions;             ///< positions of the bodies when the list was made
};

/// Finds the pairs within reach of each other, among a list of close pairs that is made with a skin around each body
/// (Verlet 1967). The list is valid until a point of a body has moved by its skin, whatever evaluation the poses are
/// from. To make a list, the bodies are swept in the order of their smallest x (Baraff 1992), which changes little from
/// one list to the next.
class ContactSearch {
 public:
  void add(const Candidate& pair) { pairs_.push_back(pair); }
  /// Prepares the search after the last add(); `bodies`: number of bodies of the model.
  void prepare(std::size_t bodies);

  const std::vector<Candidate>& pairs() const { return pairs_; }

  /// True while the list of close pairs of `sweep` is valid for these poses; false if `sweep` is empty.
  bool is_current(const Poses& poses, const Sweep& sweep) const {
    return sweep.positions.x.size() != 0 && !any_exceeded_skin(poses, sweep.positions, skin_limits_);
  }
  /// Marks the pairs within reach in `found`, which must be all zero. Pairs that are apart may be omitted though
  /// out_of_reach() is false for them; which ones depends on when the list was made. True if there are any pairs.
  /// `sweep`: empty, or as this function left it.
  bool find(const Poses& poses, std::vector<char>& found, Sweep& sweep) const;

 private:
  /// A body in the sweep.
  struct Swept {
    BodyId body{};
    Bounds bounds;
    double reach{};  ///< half of the largest reach of its contacts [L]
  };
  void list_close(const Poses& poses, Sweep& sweep) const;

  std::vector<Candidate> pairs_;
  std::vector<std::size_t> single_;  ///< pairs that are not swept: with ground, a second contact of the
                                     ///< same two bodies, or all if there are too many bodies
  std::vector<Swept> swept_;
  std::vector<std::size_t> swept_pairs_;  ///< pair of each two swept bodies, row by row; the number of pairs if none
  SkinLimits skin_limits_;
};

}  // namespace talus
