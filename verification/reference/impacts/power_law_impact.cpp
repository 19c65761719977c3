#include "verification/reference/impacts/power_law_impact.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"
#include "verification/reference/mathematics/trajectory.hpp"

namespace talus::verification::reference {
namespace {

/// Integrates y = (position, speed, time) until the guard falls; `depth` is the overlap of a position.
template <class Depth>
ScaledEvents events(const Rates& rates, const Guard& at_end, Depth&& depth) {
  const Guard turning = [](const Coordinates& y) { return y[1]; };
  Trajectory path{rates, {0.0L, 1.0L, 0.0L}, 0.0L, 0.02L};
  ScaledEvents found;
  for (const Guard& guard : {turning, at_end}) {
    if (!path.advance_until(std::array{guard}, path.time() + 1000.0L))
      throw std::invalid_argument("power_law_impact: the contact does not end");
    if (found.largest_depth == 0.0) found.largest_depth = static_cast<double>(depth(path.coordinates()[0]));
  }
  found.restitution = static_cast<double>(-path.coordinates()[1]);
  found.contact_time = static_cast<double>(path.coordinates()[2]);
  return found;
}

/// Bisection of a function that is negative at `low` and positive at `high`, to the digits of Real50.
template <class Function>
double root(Real50 low, Real50 high, const Function& function) {
  for (int pass = 0; pass < 180; ++pass) {
    const Real50 middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return nearest(low);
}

/// ln((1 + a)/(1 - a e)) - a (1 + e).
Real50 balance(const Real50& a, const Real50& e) { return log((1 + a) / (1 - a * e)) - a * (1 + e); }

}  // namespace

ScaledEvents constant_dashpot_events(double g, EndRule end) {
  if (!(g >= 0.0)) throw std::invalid_argument("power_law_impact: needs g >= 0");
  const long double c = g;
  const auto force = [c](const Coordinates& y) { return y[0] * y[0] * y[0] + c * y[1]; };
  const Rates rates = [force](const Coordinates& y, Coordinates& dydt) {
    dydt = {y[1], -2.0L * y[0] * force(y), 2.0L * y[0]};
  };
  const Guard parts = [](const Coordinates& y) { return y[0]; };
  const bool parts_first = end == EndRule::attractive || g == 0.0;
  return events(rates, parts_first ? parts : Guard{force}, [](long double z) { return z * z; });
}

ScaledEvents hunt_crossley_events(double a, double n) {
  if (!(a >= 0.0 && (n == 1.0 || n == 1.5 || n == 2.0)))
    throw std::invalid_argument("power_law_impact: needs a >= 0 and n = 1, 3/2 or 2");
  const long double hysteresis = a;
  const Guard parts = [](const Coordinates& y) { return y[0]; };
  if (n == 1.5) {
    const Rates rates = [hysteresis](const Coordinates& y, Coordinates& dydt) {
      dydt = {y[1], -2.0L * y[0] * y[0] * y[0] * y[0] * (1.0L + hysteresis * y[1]), 2.0L * y[0]};
    };
    return events(rates, parts, [](long double z) { return z * z; });
  }
  const bool square = n == 2.0;
  const Rates rates = [hysteresis, square](const Coordinates& y, Coordinates& dydt) {
    dydt = {y[1], -y[0] * (square ? y[0] : 1.0L) * (1.0L + hysteresis * y[1]), 1.0L};
  };
  return events(rates, parts, [](long double x) { return x; });
}

double hunt_crossley_restitution(double a) {
  if (!(a > 0.0)) throw std::invalid_argument("power_law_impact: needs a > 0");
  const Real50 number{a}, pole = 1 / number;
  // At e = 0 the balance is ln(1 + a) - a < 0; it grows towards the pole, and is positive at e = 1 if that is before
  // it.
  return root(0, pole < 1 ? pole : Real50{1}, [&](const Real50& e) { return balance(number, e); });
}

double hunt_crossley_number(double e) {
  if (!(e > 0.0 && e < 1.0)) throw std::invalid_argument("power_law_impact: needs 0 < e < 1");
  const Real50 restitution{e}, first = Real50(3) / 2 * (1 - restitution * restitution) / (1 + pow(restitution, 3));
  // For small a the balance is -a^2 (1 - e^2)/2 + a^3 (1 + e^3)/3 < 0.
  return root(first / 4, 1 / restitution, [&](const Real50& a) { return balance(a, restitution); });
}

}  // namespace talus::verification::reference
