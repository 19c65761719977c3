#include "verification/reference/cables/two_cable.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

/// The free motion in the notation of the header.
template <class Real>
struct Free {
  Real k, l, m, v1, s_max, x_max;

  Free(const TwoCable& p, double launch_speed) : k(p.stiffness), l(p.length), m(p.mass), v1(launch_speed) {
    using std::sqrt;
    s_max = v1 * sqrt(m / (2 * k));
    x_max = sqrt(s_max * (s_max + 2 * l));
  }

  // s = sqrt(l^2 + x^2) - l without cancellation.
  [[nodiscard]] Real stretch(const Real& x) const {
    using std::sqrt;
    return x * x / (sqrt(l * l + x * x) + l);
  }

  // Uses s_max - s = (x_max - x)(x_max + x)/(L_max + L).
  [[nodiscard]] Real speed(const Real& x) const {
    using std::sqrt;
    const Real s = stretch(x);
    const Real rest = (x_max - x) * (x_max + x) / (s_max + s + 2 * l);
    return rest <= 0 ? Real(0) : Real(v1 * sqrt(rest * (s_max + s)) / s_max);
  }

  // f(u) = dt/du at x = x_max sin u.
  [[nodiscard]] Real pace(const Real& u) const {
    using std::sin;
    using std::sqrt;
    const Real s = stretch(Real(x_max * sin(u)));
    return sqrt(s_max * (s_max + s + 2 * l) / (1 + s / s_max)) / v1;
  }

  [[nodiscard]] Real time(const Real& u) const {
    if (u == 0) return Real(0);
    const auto f = [this](const Real& a) { return pace(a); };
    // The rule stops on its 15-point error estimate; the 31-point value is then far more accurate, except for
    // round-off.
    const Real tolerance = 4096 * std::numeric_limits<Real>::epsilon();
    return boost::math::quadrature::gauss_kronrod<Real, 31>::integrate(f, Real(0), u, 12, tolerance);
  }
};

template <class Real>
Real half_pi() {
  return boost::math::constants::half_pi<Real>();
}

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace

TwoCableImpact rigid_impact(const TwoCable& problem) {
  const double total = problem.striker_mass + problem.mass;
  demand(problem.mass > 0.0 && problem.striker_mass > 0.0, "TwoCable: masses must be > 0");
  return {problem.striker_mass * (1.0 + problem.restitution) * problem.approach_speed / total,
          (problem.striker_mass - problem.restitution * problem.mass) * problem.approach_speed / total};
}

TwoCableMotion::TwoCableMotion(const TwoCable& problem, double launch_speed)
    : problem_(problem), launch_speed_(launch_speed), quarter_period_(0.0L) {
  demand(problem.stiffness > 0.0 && problem.length > 0.0 && problem.mass > 0.0 && launch_speed > 0.0,
         "TwoCableMotion: stiffness, length, mass and launch speed must be > 0");
  quarter_period_ = Free<long double>(problem_, launch_speed_).time(half_pi<long double>());
}

double TwoCableMotion::largest_distance() const { return nearest(Free<Real50>(problem_, launch_speed_).x_max); }

double TwoCableMotion::largest_angle() const {
  const Free<Real50> motion(problem_, launch_speed_);
  return nearest(atan(motion.x_max / motion.l));
}

double TwoCableMotion::speed_at_distance(double x) const {
  return nearest(Free<Real50>(problem_, launch_speed_).speed(Real50(x)));
}

double TwoCableMotion::speed_at_angle(double theta) const {
  // Eq. 27 as printed, at 50 digits.
  const Real50 cosine = cos(Real50(theta));
  const Real50 stretch = Real50(problem_.length) * (1 - cosine) / cosine;
  const Real50 square =
      Real50(launch_speed_) * launch_speed_ - 2 * Real50(problem_.stiffness) * stretch * stretch / problem_.mass;
  return square <= 0 ? 0.0 : nearest(sqrt(square));
}

double TwoCableMotion::time_to_distance(double x) const {
  const Free<Real50> motion(problem_, launch_speed_);
  const Real50 sine = Real50(x) / motion.x_max;
  // x_max is not a double: its rounded value may lie beyond it.
  demand(x >= 0.0 && sine <= 1 + 4 * std::numeric_limits<double>::epsilon(), "TwoCableMotion: x outside [0, x_max]");
  return nearest(motion.time(sine >= 1 ? half_pi<Real50>() : Real50(asin(sine))));
}

double TwoCableMotion::time_to_turning() const {
  return nearest(Free<Real50>(problem_, launch_speed_).time(half_pi<Real50>()));
}

std::string TwoCableMotion::time_to_turning_40_digits() const {
  return Free<Real50>(problem_, launch_speed_).time(half_pi<Real50>()).str(40);
}

TwoCableMotion::State TwoCableMotion::at(double t) const {
  demand(t >= 0.0, "TwoCableMotion: t must be >= 0");
  const Free<long double> motion(problem_, launch_speed_);
  // t = q quarters + rest; in odd quarters the motion is reversed, after two it is on the other side.
  const long double quarters = std::floor(static_cast<long double>(t) / quarter_period_);
  const long double rest = static_cast<long double>(t) - quarters * quarter_period_;
  const int quarter = static_cast<int>(std::fmod(quarters, 4.0L));
  const long double target = quarter % 2 == 0 ? rest : quarter_period_ - rest;
  long double u = 0.0L;
  if (target > 0.0L) {
    const auto late = [&](long double a) { return motion.time(a) - target; };
    const long double top = half_pi<long double>();
    std::uintmax_t evaluations = 200;
    const boost::math::tools::eps_tolerance<long double> close(std::numeric_limits<long double>::digits - 2);
    const long double end = quarter_period_ - target;
    if (end <= 0.0L) {
      u = top;
    } else {
      const auto bracket = boost::math::tools::toms748_solve(late, 0.0L, top, -target, end, close, evaluations);
      u = bracket.first + (bracket.second - bracket.first) / 2.0L;
    }
  }
  const long double side = quarter < 2 ? 1.0L : -1.0L;
  const long double sign = quarter == 0 || quarter == 3 ? 1.0L : -1.0L;
  const long double x = motion.x_max * std::sin(u);
  // v = x_max cos u/f(u): cos u keeps the digits that x_max - x would lose at the turning point.
  return {static_cast<double>(side * x), static_cast<double>(sign * motion.x_max * std::cos(u) / motion.pace(u))};
}

double cable_tension(const TwoCable& problem, double x) {
  return problem.stiffness * x * x / (std::sqrt(problem.length * problem.length + x * x) + problem.length);
}

}  // namespace talus::verification::reference
