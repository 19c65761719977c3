#include "solver/dynamics/starting_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace talus {
namespace {

/// Speed at which the bodies of one impact separate for a unit impulse at another [1/M]: summed over the bodies that
/// both have; the impulse acts on A against the normal and on B along it.
double coupling(const PointMobility& mobility, const Workspace& work, const StartingImpact& one,
                const StartingImpact& other) {
  const Gap &here = work.gaps[one.instance], &there = work.gaps[other.instance];
  double sum = 0.0;
  for (const auto& [body, sign] : {std::pair{one.group->a, 1.0}, {one.group->b, -1.0}}) {
    for (const auto& [same, same_sign, weight] : {std::tuple{other.group->a, 1.0, other.group->symmetry_weight_a},
                                                  {other.group->b, -1.0, other.group->symmetry_weight_b}}) {
      if (body != same) continue;
      sum += sign * same_sign * weight *
             mobility.between(body, work.poses[index(body)], {here.p_WC, here.n_AB}, {there.p_WC, there.n_AB});
    }
  }
  return sum;
}

/// Impulses that stop the closing speeds of the coupled impacts together: A p = u. False if A is singular.
bool stopping_impulses(const PointMobility& mobility, const Workspace& work, const StartingImpacts& impacts,
                       std::array<double, StartingImpacts::capacity>& p) {
  std::array<std::size_t, StartingImpacts::capacity> of{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < impacts.count; ++i)
    if (impacts.each[i].coupled) of[n++] = i;
  std::array<std::array<double, StartingImpacts::capacity + 1>, StartingImpacts::capacity> a{};
  double largest = 0.0;  // on the diagonal
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      a[i][j] = coupling(mobility, work, impacts.each[of[i]], impacts.each[of[j]]);
    a[i][n] = impacts.each[of[i]].closing;
    largest = std::max(largest, a[i][i]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    if (!(std::abs(a[k][k]) > 1e-12 * largest)) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= n; ++j)
        a[i][j] -= factor * a[k][j];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = a[i][n];
    for (std::size_t j = i + 1; j < n; ++j)
      sum -= a[i][j] * p[of[j]];
    p[of[i]] = sum / a[i][i];
  }
  return true;
}

}  // namespace

double single_mass(const PointMobility& mobility, const Workspace& work, const StartingImpact& impact) {
  const double own = coupling(mobility, work, impact, impact);
  return own > 0.0 ? 1.0 / own : 0.0;
}

void find_masses(const PointMobility& mobility, const Workspace& work, StartingImpacts& impacts) {
  for (std::size_t i = 0; i < impacts.count; ++i) {
    StartingImpact& impact = impacts.each[i];
    impact.mass = single_mass(mobility, work, impact);
    impact.coupled = impact.mass > 0.0 && impact.closing > 0.0;
  }
  // An impact that is stopped by the others needs no impulse itself: it has the mass of a single impact.
  for (bool all = false; !all;) {
    std::array<double, StartingImpacts::capacity> p{};
    if (!stopping_impulses(mobility, work, impacts, p)) return;
    all = true;
    for (std::size_t i = 0; i < impacts.count; ++i) {
      if (impacts.each[i].coupled && !(p[i] > 0.0)) impacts.each[i].coupled = all = false;
    }
    for (std::size_t i = 0; all && i < impacts.count; ++i)
      if (impacts.each[i].coupled) impacts.each[i].mass = p[i] / impacts.each[i].closing;
  }
}

}  // namespace talus
