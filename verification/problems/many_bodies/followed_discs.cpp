#include "verification/problems/many_bodies/followed_discs.hpp"

#include <cmath>
#include <numbers>

#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems {

LatchingSpring latching_contact(double stiffness_ratio, double contact_time, double mass) {
  const double w = 0.5 * std::numbers::pi * (1.0 + std::sqrt(stiffness_ratio)) / contact_time;
  const double k = 0.5 * mass * w * w;
  return {k, k / stiffness_ratio, 0.0};
}

LinearSpringDashpot dashpot_contact(double restitution, double contact_time, double mass) {
  const double xi = reference::damping_ratio(restitution, reference::EndRule::clamped);
  const double w = 2.0 * reference::contact_angle(xi) / contact_time, reduced = 0.5 * mass;
  return {reduced * w * w, 2.0 * xi * reduced * w, EndRule::clamped};
}

}  // namespace talus::verification::problems
