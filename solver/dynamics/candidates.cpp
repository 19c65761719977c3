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
/// Of ground that goes on for ever no side of a box separates anything.
Bounds box(const Terrain&) { return {1e150, 1e150, true, false}; }

/// Half extents of the box along the axes of a frame in which it stands at R.
Vec2 extent(const Bounds& bounds, Rotation R) {
  if (bounds.round) return {bounds.half_width, bounds.half_height};
  const double c = std::abs(R.cosine), s = std::abs(R.sine);
  return {c * bounds.half_width + s * bounds.half_height, s * bounds.half_width + c * bounds.half_height};
}

/// Whether box A lies beyond a side of box B: the test of separating axes with B's axes.
bool beyond(const Bounds& a, const Pose& A, const Bounds& b, const Pose& B) {
  const Placement seen = placement(A, B);
  const Vec2 reach = extent(a, seen.R);
  return std::abs(seen.p.x) > b.half_width + reach.x || std::abs(seen.p.y) > b.half_height + reach.y;
}

bool above(const Bounds& bounds, const Pose& body, const Pose& plane) {
  const Vec2 n = plane.R_WB * Vec2{0.0, 1.0};
  const Vec2 reach = extent(bounds, body.R_WB);
  return dot(body.p_WB - plane.p_WB, n) > std::abs(n.x) * reach.x + std::abs(n.y) * reach.y;
}

}  // namespace

Bounds bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return box(s); }, shape);
}

bool endless(const Bounds& bounds) { return bounds.plane || bounds.half_width > 1e100; }

bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B) {
  if (pair.bounds_b.plane) return above(pair.bounds_a, A, B);
  if (pair.bounds_a.plane) return above(pair.bounds_b, B, A);
  if (pair.bounds_b.round) return beyond(pair.bounds_b, B, pair.bounds_a, A);
  return beyond(pair.bounds_a, A, pair.bounds_b, B) ||
         (!pair.bounds_a.round && beyond(pair.bounds_b, B, pair.bounds_a, A));
}

namespace {

/// Below so many pairs a sweep costs more than it spares (measured: make bench).
constexpr std::size_t worth_a_sweep = 64;

/// Range along x, a little wider than the box.
struct Range1 {
  double low{};
  double high{};
};
Range1 range(const Bounds& bounds, const Pose& pose) {
  const double reach = extent(bounds, pose.R_WB).x * (1.0 + 1e-12) + 1e-12 * std::abs(pose.p_WB.x);
  return {pose.p_WB.x - reach, pose.p_WB.x + reach};
}

}  // namespace

void ContactSearch::prepare(std::size_t bodies) { prepare(bodies, pairs_.size() > worth_a_sweep); }

void ContactSearch::prepare(std::size_t bodies, bool sweep) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place(bodies, none);
  const auto swept = [&](BodyId body, const Bounds& bounds) {
    if (place[index(body)] == none) {
      place[index(body)] = swept_.size();
      swept_.push_back({body, bounds, {}});
    }
    return place[index(body)];
  };
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const Candidate& pair = pairs_[p];
    if (!sweep || endless(pair.bounds_a) || endless(pair.bounds_b)) {
      single_.push_back(p);
      continue;
    }
    const std::size_t a = swept(pair.a, pair.bounds_a), b = swept(pair.b, pair.bounds_b);
    swept_[a].partners.push_back({b, p});
    swept_[b].partners.push_back({a, p});
  }
  for (Swept& body : swept_)
    std::stable_sort(body.partners.begin(), body.partners.end(),
                     [](const auto& one, const auto& two) { return one.other < two.other; });
}

void ContactSearch::find(const std::vector<Pose>& poses, std::vector<char>& near,
                         std::vector<std::size_t>& order) const {
  const auto look = [&](std::size_t p) {
    const Candidate& pair = pairs_[p];
    near[p] = !out_of_reach(pair, poses[index(pair.a)], poses[index(pair.b)]);
  };
  for (const std::size_t p : single_)
    look(p);
  if (swept_.empty()) return;
  if (order.size() != swept_.size()) {
    order.resize(swept_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  std::vector<Range1> ranges;
  for (const Swept& body : swept_) {
    ranges.push_back(range(body.bounds, poses[index(body.body)]));
    for (const auto& partner : body.partners)
      near[partner.pair] = 0;
  }
  // By insertion: nearly in order already. Of equal ones the first in the model comes first.
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t moved = order[i];
    std::size_t to = i;
    for (; to > 0; --to) {
      const std::size_t before = order[to - 1];
      if (ranges[before].low < ranges[moved].low || (ranges[before].low == ranges[moved].low && before < moved)) break;
      order[to] = before;
    }
    order[to] = moved;
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Swept& body = swept_[order[i]];
    for (std::size_t j = i + 1; j < order.size() && ranges[order[j]].low <= ranges[order[i]].high; ++j) {
      auto partner = std::lower_bound(body.partners.begin(), body.partners.end(), order[j],
                                      [](const auto& one, std::size_t other) { return one.other < other; });
      for (; partner != body.partners.end() && partner->other == order[j]; ++partner)
        look(partner->pair);
    }
  }
}

}  // namespace talus
