#include "verification/reference/impacts/hertz_impact.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

/// Integral of y^(-1/5) over the angle from touch to end, y for v = 1. The integrand is singular where y = 0: the
/// quadrature passes the distance from the nearer end, so that y keeps its digits there.
double inverse_root_integral(double xi, EndRule end) {
  const double s = std::sqrt((1.0 - xi) * (1.0 + xi));
  const bool attractive = end == EndRule::attractive;
  const double last = attractive ? std::numbers::pi / s : 2.0 * contact_angle(xi);
  const auto integrand = [&](double x, double from_end) {
    // from_end: -1 - x where that is the nearer end, else 1 - x.
    const double u = 0.5 * last * (x < 0.0 ? -from_end : 1.0 + x);
    const double sine = attractive && x > 0.0 ? std::sin(0.5 * s * last * from_end) : std::sin(s * u);
    return 0.5 * last * std::pow(std::exp(-xi * u) * sine / s, -0.2);
  };
  boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(integrand, 1e-13);
}

}  // namespace

double hertz_time_factor() { return nearest(Real50(4) / 5 * boost::math::beta(Real50(2) / 5, Real50(1) / 2)); }

HertzEvents hertz_events(const HertzImpact& impact, EndRule end) {
  const double xi = impact.damping_ratio, k = impact.stiffness, m = impact.effective_mass, v = impact.approach_speed;
  if (!(k > 0.0 && m > 0.0 && v > 0.0 && xi >= 0.0 && xi < 1.0))
    throw std::invalid_argument("hertz_impact: needs k, m, v > 0 and 0 <= xi < 1");
  HertzEvents found;
  found.restitution = restitution(xi, end);
  const double largest = v * std::exp(-xi * contact_angle(xi));
  found.largest_depth = std::pow(1.25 * m * largest * largest / k, 0.4);
  if (xi == 0.0) {
    found.contact_time = hertz_time_factor() * found.largest_depth / v;
  } else {
    // du/dt = sqrt(5k/4m) x^(1/4) with x^(1/4) = (5m/4k)^(1/10) y^(1/5).
    const double unit = std::sqrt(1.25 * k / m) * std::pow(1.25 * m / k, 0.1) * std::pow(v, 0.2);
    found.contact_time = inverse_root_integral(xi, end) / unit;
  }
  return found;
}

}  // namespace talus::verification::reference
