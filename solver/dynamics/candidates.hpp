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

/// A box around a shape, sides along the body's axes; around a circle it does not turn.
struct Bounds {
  double half_width{};   ///< [L]
  double half_height{};  ///< [L]
  bool round{};
  bool plane{};  ///< a half-plane: no box, all that lies below the body's x axis
};

[[nodiscard]] Bounds bounds(const Shape& shape);

/// Whether it is ground that goes on for ever.
[[nodiscard]] inline bool is_unbounded(const Bounds& bounds) { return bounds.plane || bounds.half_width > 1e100; }

/// Half the least width [L]; infinite of ground.
[[nodiscard]] inline double least_half_width(const Bounds& bounds) {
  return is_unbounded(bounds) ? std::numeric_limits<double>::infinity()
                              : std::min(bounds.half_width, bounds.half_height);
}

/// Distance of its furthest point from the centre of mass, or more [L]; of endless ground, which does not turn, zero.
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
  double reach{};       ///< how far apart the surfaces may be where the law acts [L]
};

/// Half the least width of the smaller of the two [L].
[[nodiscard]] double smaller_size(const Candidate& pair);

/// Whether a side of one of the boxes separates the two shapes by more than the law's reach and a margin [L] >= 0 (a
/// half-plane: whether the other's box lies above it). Never true of bodies in contact.
[[nodiscard]] bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B, double margin = 0.0);

/// No point of one of the two bodies nears the other faster than this [L/T].
[[nodiscard]] inline double largest_closing_speed(const Candidate& pair, const Pose& A, const Pose& B) {
  return norm(B.v_WB - A.v_WB) + std::abs(A.w_WB) * furthest(pair.bounds_a) +
         std::abs(B.w_WB) * furthest(pair.bounds_b);
}

/// No less than that, and sooner found [L/T].
[[nodiscard]] inline double closing_speed_bound(const Candidate& pair, const Poses& poses) {
  const std::size_t a = index(pair.a), b = index(pair.b);
  return std::abs(poses.vx[b] - poses.vx[a]) + std::abs(poses.vy[b] - poses.vy[a]) +
         std::abs(poses.w[a]) * furthest(pair.bounds_a) + std::abs(poses.w[b]) * furthest(pair.bounds_b);
}

/// How far one body can move past another in a step and still be seen [L].
[[nodiscard]] inline double tunnelling_distance(const Candidate& pair) {
  return 0.5 * (least_half_width(pair.bounds_a) + least_half_width(pair.bounds_b));
}

/// Whether two bodies, neither of them ground, that close by such a way [L] >= 0 neither act on nor pass each other
/// unseen, by circles around them: a cheap test that holds for most pairs.
[[nodiscard]] inline bool cannot_touch(const Candidate& pair, const Poses& poses, double way) {
  const std::size_t a = index(pair.a), b = index(pair.b);
  const double x = poses.x[b] - poses.x[a], y = poses.y[b] - poses.y[a];
  const double reach = furthest(pair.bounds_a) + furthest(pair.bounds_b) + pair.reach + way;
  return way <= tunnelling_distance(pair) && x * x + y * y > reach * reach;
}

/// Where a swept body lies along x [L].
struct Stretch {
  double low{};
  double high{};
};

/// Scratch of the contact search, kept by the caller from one evaluation to the next.
struct Sweep {
  std::vector<std::size_t> order;  ///< of the swept bodies, by their least x
  std::vector<Stretch> stretches;  ///< one for each swept body
  std::vector<std::size_t> close;  ///< pairs whose skins were within each other's reach
  Places places;                   ///< of the bodies, when these were listed
};

/// Finds the pairs within reach of each other, among those that were close when they were listed last: with a skin
/// around each body (Verlet 1967). The list stands until a point of a body has moved by its skin, wherever the poses
/// come from. For a list the bodies are swept in the order of their least x (Baraff 1992), which changes little from
/// one list to the next.
class ContactSearch {
 public:
  void add(const Candidate& pair) { pairs_.push_back(pair); }
  /// After the last add; `bodies`: of the model.
  void prepare(std::size_t bodies);

  const std::vector<Candidate>& pairs() const { return pairs_; }

  /// Marks in `found`, which is all zero, the pairs within reach. Of pairs that lie apart it may leave out some that
  /// out_of_reach would not, which depends on when they were listed. Whether there are any. The scratch: empty, or as
  /// this function left it.
  bool find(const Poses& poses, std::vector<char>& found, Sweep& sweep) const;

 private:
  /// A body that is swept.
  struct Swept {
    BodyId body{};
    Bounds bounds;
    double reach{};  ///< half of the largest reach of its contacts [L]
  };
  void list_close(const Poses& poses, Sweep& sweep) const;

  std::vector<Candidate> pairs_;
  std::vector<std::size_t> single_;  ///< pairs that are not swept: with ground, once more of the same two, or
                                     ///< of too many bodies
  std::vector<Swept> swept_;
  std::vector<std::size_t> swept_pairs_;  ///< of each two swept bodies, row by row; the number of pairs for none
  SkinLimits skin_limits_;
};

}  // namespace talus
