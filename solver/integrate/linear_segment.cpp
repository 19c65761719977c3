#include "solver/integrate/linear_segment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace talus {

double fastest_rate(const LinearSegment& piece, std::span<const double> lengths) {
  std::vector<double> stiffness(lengths.size()), damping(lengths.size());
  for (const LinearSegment::Term& term : piece.terms) {
    const double size = lengths[term.row] / lengths[term.column];
    stiffness[term.row] += std::abs(term.stiffness) * size;
    damping[term.row] += std::abs(term.damping) * size;
  }
  double fastest = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    fastest = std::max(fastest, std::sqrt(stiffness[i]) + damping[i]);
  return fastest;
}

bool AffineSolver::group(const LinearSegment& piece, std::size_t coordinates) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> root(coordinates);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&root](std::size_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  std::vector<char> coupled(coordinates);
  for (const LinearSegment::Term& term : piece.terms) {
    coupled[term.row] = coupled[term.column] = 1;
    const std::size_t a = find(term.row), b = find(term.column);
    root[std::max(a, b)] = std::min(a, b);
  }
  groups_.clear();
  indices_.assign(coordinates, {none, 0});
  std::vector<std::size_t> group_of(coordinates, none);
  for (std::size_t i = 0; i < coordinates; ++i) {
    if (!coupled[i]) continue;
    std::size_t& group = group_of[find(i)];
    if (group == none) group = groups_.size(), groups_.emplace_back();
    indices_[i] = {group, groups_[group].coordinates.size()};
    groups_[group].coordinates.push_back(i);
  }
  return std::all_of(groups_.begin(), groups_.end(),
                     [](const Group& group) { return group.coordinates.size() <= largest_group; });
}

bool AffineSolver::factorise(const LinearSegment& piece, double b) {
  for (Group& group : groups_) {
    const std::size_t n = group.coordinates.size();
    group.lu.assign(n * n, 0.0);
    group.pivots.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      group.lu[i * n + i] = 1.0;
  }
  for (const LinearSegment::Term& term : piece.terms) {
    const GroupIndex row = indices_[term.row];
    Group& group = groups_[row.group];
    group.lu[row.index * group.coordinates.size() + indices_[term.column].index] +=
        b * term.damping + b * b * term.stiffness;
  }
  return std::all_of(groups_.begin(), groups_.end(), [](Group& group) { return factorise(group); });
}

bool AffineSolver::factorise(Group& group) {
  const std::size_t n = group.coordinates.size();
  double* const lu = group.lu.data();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(lu[i * n + k]) > std::abs(lu[pivot * n + k])) pivot = i;
    }
    group.pivots[k] = pivot;
    if (!(std::abs(lu[pivot * n + k]) > 0.0)) return false;
    if (pivot != k) std::swap_ranges(lu + k * n, lu + (k + 1) * n, lu + pivot * n);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = lu[i * n + k] /= lu[k * n + k];
      if (factor == 0.0) continue;
      for (std::size_t j = k + 1; j < n; ++j)
        lu[i * n + j] -= factor * lu[k * n + j];
    }
  }
  return true;
}

void AffineSolver::solve(std::vector<double>& x) const {
  for (const Group& group : groups_) {
    const std::size_t n = group.coordinates.size();
    gathered_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      gathered_[i] = x[group.coordinates[i]];
    // The factorisation exchanged whole rows, so all exchanges are applied to the right-hand side before it is used.
    for (std::size_t k = 0; k < n; ++k)
      std::swap(gathered_[k], gathered_[group.pivots[k]]);
    for (std::size_t i = 1; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j)
        gathered_[i] -= group.lu[i * n + j] * gathered_[j];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j)
        gathered_[i] -= group.lu[i * n + j] * gathered_[j];
      gathered_[i] /= group.lu[i * n + i];
    }
    for (std::size_t i = 0; i < n; ++i)
      x[group.coordinates[i]] = gathered_[i];
  }
}

}  // namespace talus
