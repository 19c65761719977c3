#include "solver/laws/hunt_crossley_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// ln(1 + x) - x, which keeps its digits near x = 0; the lowest number at its pole.
double excess_of_log(double x) { return x > -1.0 ? boost::math::log1pmx(x) : std::numeric_limits<double>::lowest(); }

double root_between(const auto& function, double low, double high, double at_low, double at_high) {
  std::uintmax_t maximum = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(function, low, high, at_low, at_high,
                                                                boost::math::tools::eps_tolerance<double>(52), maximum);
  return 0.5 * (below + above);
}

/// ln(1 - a e). As ln(1 + x) - x is the same at x = a and x = -a e, g = 1 - a e is the other root of
/// ln g - g = ln(1 + a) - (1 + a).
double log_of_end_factor(double a) {
  if (a <= 1.0) return std::log1p(-a * hunt_crossley_restitution(a));
  // The fixed point contracts by g, which is at most 0.41.
  const double right = std::log1p(a) - (1.0 + a);
  double log_g = right;
  for (int pass = 0; pass < 100; ++pass)
    log_g = right + std::exp(log_g);
  return log_g;
}

/// Integral of (r(y) y)^(-n/(n+1)) f(y) over (0, last). In s with y = last s^(n+1) it has no singularity at 0; in y the
/// part below the smallest number of the rule, 1e-100, is 10^(-100/(n+1)) of the whole: a hundredth for n = 50.
double integral(const auto& ratio, const auto& factor, double n, double last) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const double scale = 0.5 * (n + 1.0) * std::pow(last, 1.0 / (n + 1.0));
  return rule.integrate(
      [&](double x, double nearer) {
        const double s = 0.5 * (x < 0.0 ? -nearer : 1.0 + x), y = last * std::pow(s, n + 1.0);
        return scale * std::pow(ratio(y), -n / (n + 1.0)) * factor(y);
      },
      1e-12);
}

}  // namespace

double hunt_crossley_restitution(double damping_number) {
  const double a = damping_number;
  TALUS_DEMAND(a >= 0.0);
  if (a < 1e-14) return 1.0 - 2.0 / 3.0 * a;
  if (a > 1.0) return -std::expm1(log_of_end_factor(a)) / a;
  const double wanted = excess_of_log(a);
  const auto function = [&](double e) { return excess_of_log(-a * e) - wanted; };
  return root_between(function, 0.0, 1.0, -wanted, function(1.0));
}

double hunt_crossley_damping_number(double e) {
  if (!(e > 0.0 && e <= 1.0)) throw InputError{fmt::format("restitution is {}; it must be in (0, 1]", e)};
  if (e == 1.0) return 0.0;
  // Divided by a^2, the difference of both sides is -(1 - e^2)/2 + a (1 + e^3)/3 - ... and has one root.
  const auto function = [e](double a) { return (excess_of_log(a) - excess_of_log(-a * e)) / (a * a); };
  const double first = 1.5 * (1.0 - e * e) / (1.0 + e * e * e), last = (1.0 - 0x1p-53) / e;
  double low = 0.5 * std::min(first, last);
  while (function(low) > 0.0)
    low *= 0.5;
  // For small e the root is 1/e to the last digit.
  if (!(function(last) > 0.0)) return last;
  return root_between(function, low, last, function(low), function(last));
}

HuntCrossleyImpact hunt_crossley_impact(double damping_number, double exponent) {
  const double a = damping_number, n = exponent;
  TALUS_DEMAND(a >= 0.0 && n >= 1.0);
  // Overlap at which the spring has stored this energy, in units of m v^2.
  const auto overlap = [n](double energy) { return std::pow((n + 1.0) * std::max(energy, 0.0), 1.0 / (n + 1.0)); };
  // Energy of the spring when the speed has fallen by `lost` from 1, over `lost`; 1/(1 + a) at its start.
  const auto loaded = [a](double lost) {
    if (a < 1e-14) return 1.0 - 0.5 * lost;
    const double later = a * lost / (1.0 + a);
    return later < 1e-300 ? 1.0 / (1.0 + a) : 1.0 / (1.0 + a) + excess_of_log(-later) / (a * a * lost);
  };
  HuntCrossleyImpact found{.restitution = hunt_crossley_restitution(a), .largest_overlap = overlap(loaded(1.0))};
  // The overlap to the power -n is that of (n + 1) times the energy to the power -n/(n + 1).
  const auto stored = [&](double lost) { return (n + 1.0) * loaded(lost); };
  found.contact_time = integral(
      stored, [&](double lost) { return 1.0 / (1.0 + a * (1.0 - lost)); }, n, 1.0);
  // The contact time depends on a by a relative amount of order a.
  if (a < 1e-14) {
    found.contact_time *= 2.0;
    return found;
  }
  // On the way back by y = ln((1 + a u)/(1 - a e)), because 1 + a u falls to 1 - a e, which may be tiny.
  const double log_g = log_of_end_factor(a), g = std::exp(log_g);
  const auto unloaded = [&](double y) {
    if (y < 1e-300) return (n + 1.0) * found.restitution / a;
    // g (1 + y - exp(y)): exp(y) may be beyond all numbers where g is below them.
    const double rest = y < 1.0 ? g * excess_of_log(std::expm1(y)) : g * (1.0 + y) - std::exp(y + log_g);
    return (n + 1.0) * std::max((found.restitution + rest / (a * y)) / a, 0.0);
  };
  found.contact_time += integral(
      unloaded, [a](double) { return 1.0 / a; }, n, -log_g);
  return found;
}

}  // namespace talus
