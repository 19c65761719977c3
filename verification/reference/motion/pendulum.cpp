#include "verification/reference/motion/pendulum.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"
#include "verification/reference/mathematics/jacobi.hpp"

namespace talus::verification::reference {
namespace {

// k and k' of a libration from rest; both from the angle itself, so that k' keeps its digits up to 180 degrees.
template <class Real>
Modulus<Real> modulus_of_amplitude(double amplitude) {
  using std::cos;
  using std::sin;
  const Real half = Real(amplitude) / 2;
  return {sin(half), cos(half)};
}

// q = k below the separatrix, 1/k above it; q'^2 = (1 - q)(1 + q) with q = smaller/larger of rate and 2 w0.
template <class Real>
Modulus<Real> modulus_of_rate(double frequency, double rate) {
  using std::sqrt;
  const Real top = 2 * Real(frequency);
  const Real speed = rate;
  const Real low = speed < top ? speed : top;
  const Real high = speed < top ? top : speed;
  return {low / high, sqrt((high - low) * (high + low)) / high};
}

template <class Real>
Real quarter_period(const Modulus<Real>& modulus, const Real& pace) {
  return ArithmeticGeometricMean<Real>(modulus).complete().first / pace;
}

double rounded(long double value) { return static_cast<double>(value); }
double rounded(const Real50& value) { return nearest(value); }

}  // namespace

PendulumMotion::PendulumMotion(Start start, double frequency, double value)
    : start_(start), frequency_(frequency), value_(value) {
  if (!(frequency > 0.0) || !(value > 0.0)) {
    throw std::invalid_argument("PendulumMotion: frequency, amplitude and rate must be > 0");
  }
  if (start == Start::rest) {
    if (value >= std::numbers::pi) throw std::invalid_argument("PendulumMotion: the amplitude must be below pi");
    amplitude_ = value;
    const double sine = std::sin(value / 2.0);
    energy_ = 2.0 * frequency * frequency * sine * sine;
    quarter_period_ = quarter_period(modulus_of_amplitude<long double>(value), static_cast<long double>(frequency));
    return;
  }
  const double k = value / (2.0 * frequency);
  energy_ = value * value / 2.0;
  amplitude_ = k < 1.0 ? 2.0 * std::asin(k) : k > 1.0 ? std::numeric_limits<double>::infinity() : std::numbers::pi;
  if (value == 2.0 * frequency) {
    quarter_period_ = std::numeric_limits<long double>::infinity();
    return;
  }
  // A rotation completes half a turn in K(1/k) of its argument k w0 t, a full one in twice that: the "quarter" is K/2.
  const auto modulus = modulus_of_rate<long double>(frequency, value);
  const long double half_rate = static_cast<long double>(value) / 2.0L;
  quarter_period_ = k < 1.0 ? quarter_period(modulus, static_cast<long double>(frequency))
                            : quarter_period(modulus, half_rate) / 2.0L;
}

PendulumMotion PendulumMotion::from_rest(double frequency, double amplitude) {
  return {Start::rest, frequency, amplitude};
}

PendulumMotion PendulumMotion::from_bottom(double frequency, double rate) { return {Start::bottom, frequency, rate}; }

template <class Real>
PendulumState PendulumMotion::evaluate(double t) const {
  using std::asin;
  using std::atan;
  using std::cosh;
  using std::sinh;
  const Real w0 = frequency_;
  const Real u = w0 * Real(t);
  if (start_ == Start::rest) {
    const auto modulus = modulus_of_amplitude<Real>(value_);
    const auto f = ArithmeticGeometricMean<Real>(modulus).at(u);
    // sin(x/2) = k cn/dn and cos(x/2) = k'/dn give tan(x/2) = (k/k') cn, without loss near pi.
    return {rounded(Real(2 * atan(modulus.k / modulus.complement * f.cn))),
            rounded(Real(-2 * modulus.k * modulus.complement * w0 * f.sn / f.dn))};
  }
  if (value_ == 2.0 * frequency_) return {rounded(Real(2 * atan(sinh(u)))), rounded(Real(2 * w0 / cosh(u)))};
  const auto modulus = modulus_of_rate<Real>(frequency_, value_);
  const ArithmeticGeometricMean<Real> mean(modulus);
  if (value_ < 2.0 * frequency_) {
    const auto f = mean.at(u);
    return {rounded(Real(2 * atan(modulus.k * f.sn / f.dn))), rounded(Real(2 * modulus.k * w0 * f.cn))};
  }
  const auto f = mean.at(Real(value_) / 2 * Real(t));
  return {rounded(Real(2 * f.amplitude)), rounded(Real(Real(value_) * f.dn))};
}

PendulumState PendulumMotion::at(double t) const { return evaluate<long double>(t); }

PendulumState PendulumMotion::at_50_digits(double t) const { return evaluate<Real50>(t); }

std::string PendulumMotion::period_45_digits() const {
  if (std::isinf(quarter_period_)) return "inf";
  if (start_ == Start::rest) {
    return Real50(4 * quarter_period(modulus_of_amplitude<Real50>(value_), Real50(frequency_))).str(45);
  }
  const auto modulus = modulus_of_rate<Real50>(frequency_, value_);
  const bool swings = value_ < 2.0 * frequency_;
  const Real50 pace = swings ? Real50(frequency_) : Real50(value_) / 2;
  return Real50((swings ? 4 : 2) * quarter_period(modulus, pace)).str(45);
}

}  // namespace talus::verification::reference
