#include "verification/reference/motion/damped_oscillator.hpp"

#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {

OscillatorState state_at(const DampedOscillator& oscillator, double t) {
  const double w0 = oscillator.frequency, xi = oscillator.damping_ratio;
  if (!(w0 > 0.0 && xi >= 0.0 && xi < 1.0 && t >= 0.0))
    throw std::invalid_argument("damped oscillator: frequency > 0, 0 <= damping ratio < 1 and t >= 0 are required");
  const double a = xi * w0, w = w0 * std::sqrt(1.0 - xi * xi);
  const double y0 = oscillator.displacement, v0 = oscillator.velocity;
  // v = exp(-a t) [v0 cos(w t) + s sin(w t)]; v^2 has a steady part and a part at twice the frequency.
  const double s = -(a * v0 + w0 * w0 * y0) / w;
  const double decay = std::exp(-a * t), cosine = std::cos(w * t), sine = std::sin(w * t);
  const double twice_cosine = std::cos(2.0 * w * t), twice_sine = std::sin(2.0 * w * t), square = decay * decay;
  const double steady = a > 0.0 ? -std::expm1(-2.0 * a * t) / (2.0 * a) : t;
  const double of_cosine = (square * (w * twice_sine - a * twice_cosine) + a) / (2.0 * w0 * w0);
  const double of_sine = (w - square * (a * twice_sine + w * twice_cosine)) / (2.0 * w0 * w0);
  return {
      .displacement = decay * (y0 * cosine + (v0 + a * y0) / w * sine),
      .velocity = decay * (v0 * cosine + s * sine),
      .squared_velocity = 0.5 * (v0 * v0 + s * s) * steady + 0.5 * (v0 * v0 - s * s) * of_cosine + v0 * s * of_sine};
}

}  // namespace talus::verification::reference
