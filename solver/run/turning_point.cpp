#include "solver/run/turning_point.hpp"

#include <cmath>

namespace talus {
namespace {

/// Turning point as a fraction of the step. For s in [0, 1], p = q1 - q0 and velocities scaled by the step, the
/// derivative of the Hermite cubic is
///   a s^2 + b s + v0 = 0,   a = 3 (v0 + v1) - 6 p,   b = 6 p - 4 v0 - 2 v1;
/// it is v0 > 0 at s = 0 and v1 <= 0 at s = 1, so that one root lies between; the form below has no cancellation for
/// a -> 0.
double turning_fraction(double p, double v0, double v1) {
  const double a = 3.0 * (v0 + v1) - 6.0 * p;
  const double b = 6.0 * p - 4.0 * v0 - 2.0 * v1;
  return 2.0 * v0 / (-b + std::sqrt(b * b - 4.0 * a * v0));
}

double hermite(double s, double q0, double q1, double v0, double v1) {
  const double p = q1 - q0;
  return q0 + s * (v0 + s * (3.0 * p - 2.0 * v0 - v1 + s * (v0 + v1 - 2.0 * p)));
}

}  // namespace

void TurningPointFinder::operator()(const State& state, const StepInfo& info) {
  const double q = state.q[coordinate_];
  const double v = state.v[coordinate_];
  if (!found_ && info.step > 0 && v_ > 0.0 && v <= 0.0) {
    const double h = state.t - t_;
    const double s = turning_fraction(q - q_, h * v_, h * v);
    found_ = TurningPoint{t_ + s * h, hermite(s, q_, q, h * v_, h * v)};
  }
  t_ = state.t, q_ = q, v_ = v;
}

}  // namespace talus
