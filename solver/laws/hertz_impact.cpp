#include "solver/laws/hertz_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/laws/restitution.hpp"

namespace talus {
namespace {

/// Root q = X^(1/4) of the overlap, its speed w = X' and the time. With the variable s, dt = 4 q^3 ds, the equations
/// with g = sqrt(5) xi are polynomials, so that touch and end are regular points:
///   dq/ds = w,   dw/ds = -4 q^3 (q^6 + g q^(4p) w),   dt/ds = 4 q^3
using Point = std::array<double, 3>;

class Motion {
 public:
  Motion(double xi, HertzDashpot dashpot) : g_{std::sqrt(5.0) * xi}, tsuji_{dashpot == HertzDashpot::tsuji} {}

  void operator()(const Point& at, Point& rate, double /* s */) const {
    const double q3 = at[0] * at[0] * at[0];
    rate = {at[1], -4.0 * q3 * force(at), 4.0 * q3};
  }
  double force(const Point& at) const {
    const double q3 = at[0] * at[0] * at[0];
    return q3 * q3 + g_ * (tsuji_ ? at[0] : 1.0) * at[1];
  }
  /// Positive until the contact ends. (By Tsuji's dashpot the force is zero at touch as well: a factor q is left out.)
  double guard(const Point& at, EndRule rule) const {
    if (rule == EndRule::attractive || g_ == 0.0) return at[0];
    // With a constant dashpot the force is zero at an overlap that may be too small to be seen between two steps.
    return tsuji_ ? std::pow(at[0], 5) + g_ * at[1] : std::min(at[0], force(at));
  }
  /// Whether a body that moves apart creeps to X = 0 without reaching it, under the attractive rule and with the
  /// constant dashpot. With r = |w|/(g X) and b = X^(1/2)/g^2, dr/d(-ln X) = r - 1 + b/r: from r < 1/2 and b < 1/100
  /// on, r decreases.
  bool creeps(const Point& at) const {
    const double x = std::pow(at[0], 4);
    return !tsuji_ && at[1] < 0.0 && -at[1] < 0.5 * g_ * x && at[0] * at[0] < 0.01 * g_ * g_;
  }
  /// Largest rate of the motion in s: of the spring, of the dashpot, and of q near q = 0, where the dashpot balances
  /// the inertia at q^5 = |w| (tsuji) and q^4 = |w| (constant).
  double rate(const Point& at) const {
    const double q3 = at[0] * at[0] * at[0], speed = std::abs(at[1]);
    return std::max({4.0 * q3 * at[0], 4.0 * q3 * g_ * (tsuji_ ? at[0] : 1.0), std::pow(speed, tsuji_ ? 0.8 : 0.75)});
  }

 private:
  double g_;
  bool tsuji_;
};

/// The impact under the clamped rule for g -> infinity. The dashpot alone stops it, at X_m = ((1 + p)/g)^(1/(1 + p)).
/// There its coefficient is k = g X_m^p, and the speed decays like
///
///   X' = C exp(-k t) - X_m^(3/2)/k,     ln C = -gamma - psi(1/(1 + p))   (k t = integral of s^(-p/(1 + p))/(1 - s) ds)
///
/// to that at which both balance. The force k C exp(-k t) - (3/2 - p) X_m^(2 - 2 p)/g^2 then ends; its second
/// term is the acceleration of the balanced motion. Relative errors are of the order of the restitution.
HertzImpact strong_impact(double g, double p) {
  const double rest = std::pow((1.0 + p) / g, 1.0 / (1.0 + p)), k = g * std::pow(rest, p);
  const double log_c = -boost::math::constants::euler<double>() - boost::math::digamma(1.0 / (1.0 + p));
  const double log_end = std::log((1.5 - p) / k) + (2.0 - 2.0 * p) * std::log(rest) - 2.0 * std::log(g);
  return {std::pow(rest, 1.5) / k, (log_c - log_end) / k, rest};
}
/// Restitution below which the integration would lose its digits: spring and dashpot nearly cancel.
constexpr double strong = 2e-11;

}  // namespace

HertzImpact hertz_impact(double damping_ratio, HertzDashpot dashpot, EndRule rule) {
  const double xi = damping_ratio;
  TALUS_DEMAND(xi >= 0.0);
  const double infinite = std::numeric_limits<double>::infinity();
  const bool is_attractive = rule == EndRule::attractive;
  if (dashpot == HertzDashpot::tsuji && restitution(xi, rule) < 1e-150) {
    // Overdamped, or q^9 would underflow at the end. The largest overlap is that of the linear spring in y, with
    // y^2 = 4/5 X^(5/2): y = exp(-xi acos(xi)/sqrt(1 - xi^2)), whose square is the restitution of the clamped rule.
    return {0.0, infinite, std::pow(1.25 * restitution(xi, EndRule::clamped), 0.4)};
  }
  if (xi > 1.0) {
    HertzImpact limit = strong_impact(std::sqrt(5.0) * xi, dashpot == HertzDashpot::tsuji ? 0.25 : 0.0);
    if (limit.restitution < strong && is_attractive) return {0.0, infinite, limit.largest_overlap};
    if (limit.restitution < strong) {
      if (dashpot == HertzDashpot::tsuji) limit.restitution = restitution(xi, rule);
      return limit;
    }
  }
  const Motion motion{xi, dashpot};
  boost::numeric::odeint::runge_kutta_fehlberg78<Point> method;
  Point now{0.0, 1.0, 0.0}, next;
  double step{};
  const auto moved = [&](double by) {
    Point to;
    method.do_step(motion, now, 0.0, to, by);
    return to;
  };
  /// Fraction of a step at which `function` of the point is zero: > 0 now, <= 0 after the step.
  const auto located = [&](const auto& function) {
    std::uintmax_t maximum = 100;
    const auto [below, above] =
        boost::math::tools::toms748_solve([&](double by) { return function(moved(by)); }, 0.0, step, function(now),
                                          function(next), boost::math::tools::eps_tolerance<double>(50), maximum);
    return moved(0.5 * (below + above));
  };
  HertzImpact found;
  for (;; now = next) {
    step = 0.02 / motion.rate(now);
    next = moved(step);
    if (now[1] > 0.0 && next[1] <= 0.0)
      found.largest_overlap = std::pow(located([](const Point& at) { return at[1]; })[0], 4);
    if (next[1] >= 0.0) continue;
    const auto guard = [&](const Point& at) { return motion.guard(at, rule); };
    if (guard(next) <= 0.0) {
      const Point end = located(guard);
      found.restitution = -end[1], found.contact_time = end[2];
      break;
    }
    if (is_attractive && motion.creeps(next)) return {0.0, infinite, found.largest_overlap};
  }
  if (dashpot == HertzDashpot::tsuji) found.restitution = restitution(xi, rule);
  return found;
}

double hertz_damping_ratio(double e, HertzDashpot dashpot, EndRule rule) {
  if (dashpot == HertzDashpot::tsuji) return damping_ratio(e, rule);
  constexpr double minimum = 1e-6;
  if (!(e >= minimum && e <= 1.0))
    throw InputError{fmt::format("restitution is {}; it must be in [{}, 1]", e, minimum)};
  if (e == 1.0) return 0.0;
  const auto excess = [&](double xi) { return hertz_impact(xi, dashpot, rule).restitution - e; };
  double high = 1.0;
  while (excess(high) > 0.0)
    high *= 2.0;
  std::uintmax_t maximum = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(excess, 0.0, high, 1.0 - e, excess(high),
                                                                boost::math::tools::eps_tolerance<double>(48), maximum);
  return 0.5 * (below + above);
}

}  // namespace talus
