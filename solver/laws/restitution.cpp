#include "solver/laws/restitution.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/base/error.hpp"

namespace talus {
namespace {

void demand_positive(const char* what, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) throw InputError{fmt::format("{} is {}; it must be > 0", what, value)};
}

/// 1/m of one body along the normal [1/M].
double mobility(const ContactSide& side) {
  if (side.inertia) demand_positive("moment of inertia", *side.inertia);
  if (side.pinned) {
    if (!side.inertia) throw InputError{"a pinned body needs its moment of inertia about the pin"};
    return side.arm * side.arm / *side.inertia;
  }
  demand_positive("mass", side.mass);
  return 1.0 / side.mass + (side.inertia ? side.arm * side.arm / *side.inertia : 0.0);
}

/// acos(xi)/sqrt(1 - xi^2), continued through xi = 1 (where it is 1) to acosh(xi)/sqrt(xi^2 - 1). Near 1 both forms are
/// 0/0; with u = 1 - xi the series is 1 + u/3 + 2 u^2/15 + 2 u^3/35 + ..., good to round-off for |u| <= 1e-4.
double angle_ratio(double xi) {
  const double u = 1.0 - xi;
  if (std::abs(u) < 1e-4) return 1.0 + u * (1.0 / 3.0 + u * (2.0 / 15.0 + u * (2.0 / 35.0)));
  return u > 0.0 ? std::acos(xi) / std::sqrt(u * (1.0 + xi)) : std::acosh(xi) / std::sqrt(-u * (1.0 + xi));
}

}  // namespace

double effective_mass(const ContactSide& a, const ContactSide& b) {
  const double sum = mobility(a) + mobility(b);
  if (sum == 0.0) throw InputError{"neither body can move along the contact's normal; one of them must"};
  return 1.0 / sum;
}

double restitution(double damping_ratio, EndRule rule) {
  const double xi = damping_ratio;
  if (!(xi >= 0.0)) throw InputError{fmt::format("damping ratio is {}; it must be >= 0", xi)};
  if (rule == EndRule::clamped) return std::exp(-2.0 * xi * angle_ratio(xi));
  return xi < 1.0 ? std::exp(-std::numbers::pi * xi / std::sqrt((1.0 - xi) * (1.0 + xi))) : 0.0;
}

double damping_ratio(double e, EndRule rule) {
  if (!(e > 0.0 && e <= 1.0)) throw InputError{fmt::format("restitution is {}; it must be in (0, 1]", e)};
  // For e below the smallest normal number the square of the clamped rule's damping ratio, about 1/(2 sqrt(e)),
  // overflows.
  if (!(e >= std::numeric_limits<double>::min()))
    throw InputError{
        fmt::format("restitution is {}; it must be at least {:.3g}", e, std::numeric_limits<double>::min())};
  const double wanted = -std::log(e);
  if (rule == EndRule::attractive) return wanted / std::sqrt(std::numbers::pi * std::numbers::pi + wanted * wanted);
  if (wanted == 0.0) return 0.0;
  // 2 xi angle_ratio(xi) grows from 0 without bound (it exceeds ln(2 xi) for xi > 1), so the bracket below always
  // contains a root.
  const auto excess = [wanted](double xi) { return 2.0 * xi * angle_ratio(xi) - wanted; };
  double high = 1.0;
  while (excess(high) < 0.0)
    high *= 2.0;
  std::uintmax_t maximum = 200;
  const auto [below, above] =
      boost::math::tools::toms748_solve(excess, 0.0, high, boost::math::tools::eps_tolerance<double>(52), maximum);
  return 0.5 * (below + above);
}

double damping(double damping_ratio, double stiffness, double effective_mass) {
  demand_positive("stiffness", stiffness);
  demand_positive("effective mass", effective_mass);
  return 2.0 * damping_ratio * std::sqrt(stiffness * effective_mass);
}

double damping_ratio_of(const Tangent& spring, double effective_mass) {
  return spring.damping / (2.0 * std::sqrt(spring.stiffness * effective_mass));
}

double contact_time(const Tangent& spring, EndRule rule, double effective_mass) {
  const double xi = damping_ratio_of(spring, effective_mass);
  const double w0 = std::sqrt(spring.stiffness / effective_mass);
  if (rule == EndRule::clamped) return 2.0 * angle_ratio(xi) / w0;
  return xi < 1.0 ? std::numbers::pi / (w0 * std::sqrt((1.0 - xi) * (1.0 + xi)))
                  : std::numeric_limits<double>::infinity();
}

double largest_overlap(const Tangent& spring, double effective_mass, double speed) {
  const double xi = damping_ratio_of(spring, effective_mass);
  return speed / std::sqrt(spring.stiffness / effective_mass) * std::exp(-xi * angle_ratio(xi));
}

}  // namespace talus
