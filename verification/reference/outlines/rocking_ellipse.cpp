#include "verification/reference/outlines/rocking_ellipse.hpp"

#include <cmath>
#include <numbers>

namespace talus::verification::reference {
namespace {

using Long = long double;

Long support(const RockingEllipse& e, Long q) {
  const Long a = e.a * std::sin(q), b = e.b * std::cos(q);
  return std::sqrt(a * a + b * b);
}

Long gyration(const RockingEllipse& e) { return (Long{e.a} * e.a + Long{e.b} * e.b) / 4; }

constexpr int pieces = 400;

}  // namespace

double small_rocking_frequency(const RockingEllipse& e) {
  return static_cast<double>(std::sqrt(e.gravity * (Long{e.a} * e.a / e.b - e.b) / (Long{e.b} * e.b + gyration(e))));
}

double centre_height(const RockingEllipse& e, double angle) { return static_cast<double>(support(e, angle)); }

double centre_displacement(const RockingEllipse& e, double angle) {
  // Simpson's rule: h is smooth, and there are many intervals.
  const Long step = Long{angle} / pieces;
  Long sum = support(e, 0) + support(e, angle);
  for (int i = 1; i < pieces; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * support(e, i * step);
  return static_cast<double>(-sum * step / 3);
}

double rocking_period(const RockingEllipse& e, double amplitude) {
  const Long top = amplitude, squares = Long{e.a} * e.a - Long{e.b} * e.b, half_turn = std::numbers::pi_v<Long>;
  Long sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const Long u = (i + Long{0.5}) / pieces * half_turn / 2;
    const Long q = top * std::sin(u), left = top * (1 - std::sin(u));
    const Long h = support(e, q), slope = squares * std::sin(q) * std::cos(q) / h;
    // h(top) - h(q) = (a^2 - b^2)(sin^2 top - sin^2 q)/(h(top) + h(q)), without cancellation.
    const Long fall = squares * std::sin(top + q) * std::sin(left) / (support(e, top) + h);
    sum += top * std::cos(u) * std::sqrt((gyration(e) + h * h + slope * slope) / (2 * e.gravity * fall));
  }
  return static_cast<double>(4 * sum * half_turn / 2 / pieces);
}

double frequency_shift(const RockingEllipse& e, double mass, double normal_stiffness, double shear_stiffness) {
  const Long w = small_rocking_frequency(e), b = e.b;
  return static_cast<double>((b * e.gravity / normal_stiffness - b * b * w * w / shear_stiffness) * mass /
                             (2 * (b * b + gyration(e))));
}

}  // namespace talus::verification::reference
