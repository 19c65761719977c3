#include "solver/dynamics/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <variant>

namespace talus {
namespace {

Bounds box(const NoShape&) { return {}; }
Bounds box(const Circle& s) { return {s.radius, s.radius, true, false}; }
Bounds box(const Rectangle& s) { return {s.half_width, s.half_height, false, false}; }
Bounds box(const Superquadric& s) { return {s.half_width, s.half_height, false, false}; }
Bounds box(const HalfPlane&) { return {0.0, 0.0, false, true}; }
/// No side of a box separates anything from ground, which is unbounded.
Bounds box(const Terrain&) { return {1e150, 1e150, true, false}; }

/// Half widths of the box along the axes of a frame in which its orientation is R.
Vec2 half_size(const Bounds& bounds, Rotation R) {
  if (bounds.round) return {bounds.half_width, bounds.half_height};
  const double c = std::abs(R.cosine), s = std::abs(R.sine);
  return {c * bounds.half_width + s * bounds.half_height, s * bounds.half_width + c * bounds.half_height};
}

/// True if box A lies beyond a side of box B by more than a margin: the separating-axis test with the axes of B.
bool beyond(const Bounds& a, const Pose& A, const Bounds& b, const Pose& B, double margin) {
  const Placement seen = placement(A, B);
  const Vec2 reach = half_size(a, seen.R);
  return std::abs(seen.p.x) > b.half_width + reach.x + margin || std::abs(seen.p.y) > b.half_height + reach.y + margin;
}

bool above(const Bounds& bounds, const Pose& body, const Pose& plane, double margin) {
  const Vec2 n = plane.R_WB * Vec2{0.0, 1.0};
  const Vec2 reach = half_size(bounds, body.R_WB);
  return dot(body.p_WB - plane.p_WB, n) > std::abs(n.x) * reach.x + std::abs(n.y) * reach.y + margin;
}

}  // namespace

Bounds bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return box(s); }, shape);
}

double smaller_size(const Candidate& pair) {
  return std::min(minimum_half_width(pair.bounds_a), minimum_half_width(pair.bounds_b));
}

bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B, double margin) {
  margin += pair.reach;
  if (pair.bounds_b.plane) return above(pair.bounds_a, A, B, margin);
  if (pair.bounds_a.plane) return above(pair.bounds_b, B, A, margin);
  if (pair.bounds_b.round) return beyond(pair.bounds_b, B, pair.bounds_a, A, margin);
  return beyond(pair.bounds_a, A, pair.bounds_b, B, margin) ||
         (!pair.bounds_a.round && beyond(pair.bounds_b, B, pair.bounds_a, A, margin));
}

namespace {

/// Skin, relative to the smallest half width of a body: a rock of the fence of 1993 is listed again every few hundred
/// steps of its path. The step of Table 2 takes 0.151, 0.153, 0.156 and 0.157 us with 0.02, 0.05, 0.1 and 0.2, and that
/// of two layers 0.403, 0.384, 0.404 and 0.405 us.
constexpr double skin_ratio = 0.05;

/// Largest number of bodies in the sweep. Beyond it a table of all pairs takes more memory than a machine has to spare
/// (128 MB at this number), and the list is made by checking all pairs of the model.
constexpr std::size_t maximum_swept = 4000;

/// Range along x: the box, widened by the skin and slightly more.
XRange x_range(const Bounds& bounds, const Pose& pose, double skin) {
  const double reach = skin + half_size(bounds, pose.R_WB).x * (1.0 + 1e-12) + 1e-12 * std::abs(pose.p_WB.x);
  return {pose.p_WB.x - reach, pose.p_WB.x + reach};
}

/// Insertion sort, because the order is almost right already. Among equal ones the first in the model comes first.
void sort(std::vector<std::size_t>& order, const std::vector<XRange>& ranges) {
  const auto before = [&](std::size_t a, std::size_t b) {
    return ranges[a].low < ranges[b].low || (ranges[a].low == ranges[b].low && a < b);
  };
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t moved = order[i];
    std::size_t to = i;
    for (; to > 0 && before(moved, order[to - 1]); --to)
      order[to] = order[to - 1];
    order[to] = moved;
  }
}

}  // namespace

void ContactSearch::prepare(std::size_t bodies) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> swept_index(bodies, none);
  std::vector<std::size_t> sweepable;
  const auto swept = [&](BodyId body, const Bounds& bounds, double reach) {
    if (swept_index[index(body)] == none) {
      swept_index[index(body)] = swept_.size();
      swept_.push_back({body, bounds});
    }
    double& largest = swept_[swept_index[index(body)]].reach;
    largest = std::max(largest, 0.5 * reach);
  };
  skin_limits_ = {Row{bodies}, Row{bodies, std::numeric_limits<double>::infinity()}, bodies, 0};
  const auto bind = [this](BodyId body, const Bounds& bounds) {
    const std::size_t i = index(body);
    // Turning moves no point of the outline of a disc; ground does not move.
    skin_limits_.radius[i] = bounds.round ? 0.0 : furthest(bounds);
    skin_limits_.displacement[i] = is_unbounded(bounds) ? 0.0 : skin_ratio * minimum_half_width(bounds);
    skin_limits_.first = std::min(skin_limits_.first, i), skin_limits_.last = std::max(skin_limits_.last, i + 1);
  };
  for (const Candidate& pair : pairs_)
    bind(pair.a, pair.bounds_a), bind(pair.b, pair.bounds_b);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const Candidate& pair = pairs_[p];
    if (is_unbounded(pair.bounds_a) || is_unbounded(pair.bounds_b)) {
      single_.push_back(p);
      continue;
    }
    swept(pair.a, pair.bounds_a, pair.reach), swept(pair.b, pair.bounds_b, pair.reach);
    sweepable.push_back(p);
  }
  if (swept_.size() > maximum_swept) {
    swept_.clear();
    single_.insert(single_.end(), sweepable.begin(), sweepable.end());
    return;
  }
  swept_pairs_.assign(swept_.size() * swept_.size(), pairs_.size());
  for (const std::size_t p : sweepable) {
    const std::size_t a = swept_index[index(pairs_[p].a)], b = swept_index[index(pairs_[p].b)];
    std::size_t& entry = swept_pairs_[a * swept_.size() + b];
    if (entry != pairs_.size()) {
      single_.push_back(p);  // a second contact of the same two bodies
      continue;
    }
    entry = swept_pairs_[b * swept_.size() + a] = p;
  }
}

bool ContactSearch::find(const Poses& poses, std::vector<char>& found, Sweep& sweep) const {
  if (!is_current(poses, sweep)) list_close(poses, sweep);
  bool any = false;
  for (const std::size_t p : sweep.close) {
    const Candidate& pair = pairs_[p];
    found[p] = !out_of_reach(pair, poses[index(pair.a)], poses[index(pair.b)]);
    any = any || found[p];
  }
  return any;
}

void ContactSearch::list_close(const Poses& poses, Sweep& sweep) const {
  if (sweep.positions.x.size() == 0) {
    sweep.close.reserve(pairs_.size());
    sweep.order.resize(swept_.size());
    std::iota(sweep.order.begin(), sweep.order.end(), std::size_t{0});
    sweep.ranges.resize(swept_.size());
  }
  sweep.positions.x = poses.x, sweep.positions.y = poses.y;
  sweep.positions.cosine = poses.cosine, sweep.positions.sine = poses.sine;
  sweep.close.clear();
  const auto look = [&](std::size_t p) {
    const Candidate& pair = pairs_[p];
    const std::size_t a = index(pair.a), b = index(pair.b);
    if (!out_of_reach(pair, poses[a], poses[b], skin_limits_.displacement[a] + skin_limits_.displacement[b]))
      sweep.close.push_back(p);
  };
  for (const std::size_t p : single_)
    look(p);
  for (std::size_t i = 0; i < swept_.size(); ++i) {
    const auto& [body, bounds, reach] = swept_[i];
    sweep.ranges[i] = x_range(bounds, poses[index(body)], skin_limits_.displacement[index(body)] + reach);
  }
  sort(sweep.order, sweep.ranges);
  for (std::size_t i = 0; i < sweep.order.size(); ++i) {
    const double high = sweep.ranges[sweep.order[i]].high;
    const std::size_t* const pairs = &swept_pairs_[sweep.order[i] * swept_.size()];
    for (std::size_t j = i + 1; j < sweep.order.size() && !(sweep.ranges[sweep.order[j]].low > high); ++j) {
      const std::size_t p = pairs[sweep.order[j]];
      if (p != pairs_.size()) look(p);
    }
  }
}

}  // namespace talus
