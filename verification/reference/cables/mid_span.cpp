#include "verification/reference/cables/mid_span.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "verification/reference/cables/two_cable.hpp"

namespace talus::verification::reference {
namespace {

// (Gamma(3/4)/Gamma(1/4))^2
double gamma_ratio_squared() {
  const double ratio = boost::math::tgamma(0.75) / boost::math::tgamma(0.25);
  return ratio * ratio;
}

}  // namespace

double mid_span_force(const MidSpan& span, double w) {
  const double whole = std::hypot(span.length, w);
  return 2.0 * span.stiffness * w * (w / whole) * (w / (whole + span.length));
}

double mid_span_period(const MidSpan& span, double amplitude) {
  const double stretch = amplitude * amplitude / (std::hypot(span.length, amplitude) + span.length);
  const TwoCable cables{.stiffness = span.stiffness, .length = span.length, .mass = span.mass};
  // Energy: m v^2/2 = 2 k s^2/2 when the mass passes the middle.
  return 4.0 * TwoCableMotion{cables, stretch * std::sqrt(2.0 * span.stiffness / span.mass)}.time_to_turning();
}

double cubic_period(const MidSpan& span, double amplitude) {
  const double gamma = boost::math::tgamma(0.25);
  return gamma * gamma * span.length * std::sqrt(span.mass / span.stiffness) /
         (std::sqrt(std::numbers::pi) * amplitude);
}

double longer_by_amplitude(const MidSpan& span, double amplitude) {
  const double ratio = amplitude / span.length;
  return (0.125 + 1.5 * gamma_ratio_squared()) * ratio * ratio;
}

double longer_by_steps(const MidSpan& span, double amplitude, double step) {
  const double ratio = amplitude / span.length;
  return (1.0 - 12.0 * gamma_ratio_squared()) / 24.0 * span.stiffness / span.mass * ratio * ratio * step * step;
}

}  // namespace talus::verification::reference
