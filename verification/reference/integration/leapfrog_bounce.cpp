#include "verification/reference/integration/leapfrog_bounce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {

LeapfrogBounce leapfrog_bounce(double eta, double theta) {
  if (!(eta > 0.0 && eta < 2.0 && theta > 0.0 && theta <= 1.0)) {
    throw std::invalid_argument("leapfrog_bounce: needs 0 < eta < 2 and 0 < theta <= 1");
  }
  // Lengths in v0 h. x(n) = a sin(n p) + b cos(n p) through x(0) = theta - 1 and x(1) = theta.
  const double p = 2.0 * std::asin(0.5 * eta);
  const double b = theta - 1.0, a = (theta - b * std::cos(p)) / std::sin(p);
  const double before = std::atan2(-b, a);  // phase of the sine at its start
  // First integer n > 0 at which n p - before >= pi, or the next one because of rounding.
  long n = std::max(2L, static_cast<long>(std::floor((std::numbers::pi + before) / p)));
  const auto x = [&](long i) {
    const double angle = static_cast<double>(i) * p;
    return a * std::sin(angle) + b * std::cos(angle);
  };
  while (x(n) > 0.0)
    ++n;
  const double inside = x(n - 1), displacement = inside - x(n);
  return {displacement, 1.0 - inside / displacement, n - 1};
}

LeapfrogGain leapfrog_gain(double eta, int phases) {
  LeapfrogGain gain{.minimum = std::numeric_limits<double>::infinity()};
  const double weight = 1.0 / phases;
  for (int i = 0; i < phases; ++i) {
    const double e = leapfrog_bounce(eta, (i + 0.5) * weight).ratio;
    gain.minimum = std::min(gain.minimum, e);
    gain.maximum = std::max(gain.maximum, e);
    gain.mean += weight * e;
    gain.mean_ln += weight * std::log(e);
    gain.mean_square += weight * (e * e - 1.0);
    gain.variance += weight * (e * e - 1.0) * (e * e - 1.0);
    gain.inverse_square += weight / (e * e);
  }
  return gain;
}

double small_step_heating(double eta) {
  const double steps = std::numbers::pi / (2.0 * std::asin(0.5 * eta));
  const double delta = steps - std::floor(steps);
  return std::pow(eta, 4) * delta * delta * (1.0 - delta) * (1.0 - delta) / 12.0;
}

}  // namespace talus::verification::reference
