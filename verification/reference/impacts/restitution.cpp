#include "verification/reference/impacts/restitution.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("restitution: ") + what);
}

// acos(xi) loses digits near xi = 1 and asin(s) near s = 1; with s^2 = (1 - xi)(1 + xi), whose factors are exact or
// nearly so, one of the two is always accurate. asin(s)/s and asinh(s)/s are well conditioned at s -> 0.
template <class T>
T angle(const T& xi) {
  using std::acos;
  using std::asin;
  using std::asinh;
  using std::sqrt;
  if (xi < T(0.5)) return T(acos(xi) / sqrt((1 - xi) * (1 + xi)));
  const T s = sqrt(xi < 1 ? T((1 - xi) * (1 + xi)) : T((xi - 1) * (xi + 1)));
  if (s == 0) return T(1);
  return xi < 1 ? T(asin(s) / s) : T(asinh(s) / s);
}

double attractive_restitution(double xi) {
  return xi < 1.0 ? std::exp(-std::numbers::pi * xi / std::sqrt((1.0 - xi) * (1.0 + xi))) : 0.0;
}

// 2 xi A(xi) rises from 0 at xi = 0 through 2 at xi = 1; for xi > 1, xi/s > 1 makes it larger than 2 asinh(s), so
// s <= sinh(L/2), that is xi <= cosh(L/2).
Real50 clamped_ratio(const Real50& logarithm) {
  if (logarithm == 0) return Real50(0);
  const auto excess = [&](const Real50& xi) { return Real50(2 * xi * angle(xi) - logarithm); };
  const Real50 low = logarithm < 2 ? Real50(0) : Real50(1);
  const Real50 high = logarithm < 2 ? Real50(1) : Real50(cosh(logarithm / 2));
  if (excess(low) == 0) return low;
  std::uintmax_t evaluations = 300;
  const auto close = [](const Real50& a, const Real50& b) { return abs(a - b) <= 1e-48 * abs(b); };
  const auto bracket = boost::math::tools::toms748_solve(excess, low, high, close, evaluations);
  return (bracket.first + bracket.second) / 2;
}

double largest_force(const Impact& impact, double xi, double w) {
  // With xi = cos f, s = sin f and u = w t, each derivative of exp(-xi u) sin(s u) with respect to u adds pi - f to the
  // phase. So d''' vanishes at s u = 3 f - pi (the first, if f > pi/3, that is xi < 1/2) and s u = 3 f; F = -m d'' is
  // largest at the first, where it is m w v0 exp(-xi u). For xi >= 1/2 the force decreases from touch on.
  if (xi >= 0.5) return impact.damping * impact.approach_speed;
  const double s = std::sqrt((1.0 - xi) * (1.0 + xi));
  const double phase = (3.0 * std::acos(xi) - std::numbers::pi) / s;
  return impact.effective_mass * w * impact.approach_speed * std::exp(-xi * phase);
}

}  // namespace

double contact_angle(double xi) {
  demand(xi >= 0.0 && std::isfinite(xi), "the damping ratio must be >= 0 and finite");
  return angle(xi);
}

double restitution(double xi, EndRule end) {
  const double a = contact_angle(xi);
  return end == EndRule::attractive ? attractive_restitution(xi) : std::exp(-2.0 * xi * a);
}

double damping_ratio(double e, EndRule end) {
  demand(e > 0.0 && e <= 1.0, "e must lie in (0, 1]");
  const Real50 logarithm = -log(Real50(e));
  if (end == EndRule::clamped) return nearest(clamped_ratio(logarithm));
  const Real50 pi = boost::math::constants::pi<Real50>();
  return nearest(logarithm / sqrt(pi * pi + logarithm * logarithm));
}

double eq_21_damping(double e, double stiffness, double effective_mass) {
  demand(stiffness > 0.0 && effective_mass > 0.0, "stiffness and effective mass must be > 0");
  return 2.0 * damping_ratio(e, EndRule::attractive) * std::sqrt(stiffness * effective_mass);
}

ImpactEvents impact_events(const Impact& impact, EndRule end) {
  demand(impact.stiffness > 0.0 && impact.damping >= 0.0 && impact.effective_mass > 0.0 && impact.approach_speed > 0.0,
         "an impact needs k > 0, c >= 0, m > 0 and v0 > 0");
  const double w = std::sqrt(impact.stiffness / impact.effective_mass);
  const double xi = impact.damping / (2.0 * std::sqrt(impact.stiffness * impact.effective_mass));
  const double a = contact_angle(xi);
  ImpactEvents events;
  events.damping_ratio = xi;
  events.frequency = w;
  events.restitution = restitution(xi, end);
  events.largest_depth = impact.approach_speed / w * std::exp(-xi * a);
  events.largest_depth_time = a / w;
  events.force_at_touch = impact.damping * impact.approach_speed;
  events.largest_force = largest_force(impact, xi, w);
  const double exit_speed = events.restitution * impact.approach_speed;
  if (end == EndRule::clamped) {
    events.contact_time = 2.0 * a / w;
    events.depth_at_end = 2.0 * xi * exit_speed / w;
  } else {
    events.contact_time = xi < 1.0 ? std::numbers::pi / (w * std::sqrt((1.0 - xi) * (1.0 + xi)))
                                   : std::numeric_limits<double>::infinity();
    events.force_at_end = -impact.damping * exit_speed;
  }
  return events;
}

DepthState depth_at(const Impact& impact, double t) {
  const Real50 w = sqrt(Real50(impact.stiffness) / impact.effective_mass);
  const Real50 xi = Real50(impact.damping) / (2 * w * impact.effective_mass);
  const Real50 s = sqrt(abs((1 - xi) * (1 + xi)));
  const Real50 u = w * t;
  const Real50 v0 = impact.approach_speed;
  // S = sin(s u)/s, C = cos(s u) and their hyperbolic and limiting forms: d = v0 e^(-xi u) S/w, d' = v0 e^(-xi
  // u)(C - xi S).
  const Real50 sine = s == 0 ? u : xi < 1 ? Real50(sin(s * u) / s) : Real50(sinh(s * u) / s);
  const Real50 cosine = s == 0 ? Real50(1) : xi < 1 ? Real50(cos(s * u)) : Real50(cosh(s * u));
  const Real50 decay = v0 * exp(-xi * u);
  return {nearest(decay * sine / w), nearest(decay * (cosine - xi * sine))};
}

double free_mobility(double mass, double inertia, double arm) {
  demand(mass > 0.0, "the mass must be > 0");
  demand(arm == 0.0 || inertia > 0.0, "an off-centre contact needs an inertia > 0");
  return 1.0 / mass + (arm == 0.0 ? 0.0 : arm * arm / inertia);
}

double pivoted_mobility(double inertia_about_pivot, double arm) {
  demand(inertia_about_pivot > 0.0, "the inertia about the pivot must be > 0");
  return arm * arm / inertia_about_pivot;
}

double effective_mass(double mobility_a, double mobility_b) {
  demand(mobility_a >= 0.0 && mobility_b >= 0.0 && mobility_a + mobility_b > 0.0,
         "two immovable bodies cannot collide");
  return 1.0 / (mobility_a + mobility_b);
}

}  // namespace talus::verification::reference
