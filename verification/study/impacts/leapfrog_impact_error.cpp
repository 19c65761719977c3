#include "verification/study/impacts/leapfrog_impact_error.hpp"

#include <cmath>
#include <numbers>

#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems {
namespace {

/// (A - xi)/(1 - xi^2), continued through xi = 1, where it is 2/3.
double depth_slope(double xi) {
  const double square = (1.0 - xi) * (1.0 + xi);
  return std::abs(square) < 1e-6 ? 2.0 / 3.0 : (reference::contact_angle(xi) - xi) / square;
}

}  // namespace

double leapfrog_restitution_shift(double xi, reference::EndRule end) {
  const double ratio_growth = 0.5 * xi * xi;
  if (end == reference::EndRule::clamped) return -2.0 * depth_slope(xi) * ratio_growth;
  return -std::numbers::pi / std::pow((1.0 - xi) * (1.0 + xi), 1.5) * ratio_growth;
}

ImpactError leapfrog_impact_error(double xi, reference::EndRule end) {
  const bool attractive = end == reference::EndRule::attractive;
  const double square = (1.0 - xi) * (1.0 + xi);
  const double jump = 2.0 * xi / std::sqrt(12.0);
  const double depth_shift = 0.5 * xi + 0.5 * xi * xi * depth_slope(xi);
  const double a = reference::contact_angle(xi);
  // A'(xi) = (xi A - 1)/s^2 = -1 + xi (A - xi)/s^2; the second form avoids 0/0 at xi = 1.
  const double angle_slope = xi * depth_slope(xi) - 1.0;
  const double time_shift =
      attractive ? (1.0 - 2.0 * xi * xi) / square * 0.5 * xi : 0.5 * xi * (1.0 - xi * angle_slope / a);
  return {std::hypot(leapfrog_restitution_shift(xi, end), attractive ? std::sqrt(2.0) * jump : jump),
          std::abs(time_shift), std::hypot(depth_shift, jump)};
}

}  // namespace talus::verification::problems
