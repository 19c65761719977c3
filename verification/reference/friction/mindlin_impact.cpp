#include "verification/reference/friction/mindlin_impact.hpp"

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

using Real = long double;
/// y = X^(1/4), w, T, u, and the time.
using Values = std::array<Real, 5>;
enum : std::size_t { root, speed, force, slip, time };

class Path {
 public:
  explicit Path(const MindlinImpact& impact)
      : kappa_{impact.stiffness_ratio},
        mu_{impact.friction},
        n_{impact.mobility},
        g_{impact.dashpot},
        c_{impact.shear_dashpot},
        at_{0.0L, 1.0L, 0.0L, impact.slip_rate, 0.0L} {
    if (!(kappa_ > 0.0L && mu_ >= 0.0L && n_ >= 1.0L && g_ >= 0.0L && c_ >= 0.0L))
      throw std::invalid_argument("mindlin_impact: needs kappa > 0, mu >= 0, n >= 1, g >= 0, c >= 0");
    // A dashpot's force grows like t^(1/4), faster than the friction's t^(3/2): its contacts stick at first.
    if (g_ == 0.0L && c_ == 0.0L && std::abs(at_[slip]) > first_stick_ratio(impact)) slips_ = at_[slip] > 0.0L ? 1 : -1;
  }

  MindlinRebound solve() {
    MindlinRebound found;
    found.phases.push_back({0.0, slips_});
    while (!advance()) {
      if (found.phases.back().slips == slips_) continue;
      found.phases.push_back({static_cast<double>(at_[time]), slips_});
      if (found.phases.size() > maximum_phases) throw std::runtime_error("mindlin_impact: stick and slip without end");
    }
    found.slip_rate = static_cast<double>(at_[slip]);
    found.separation = static_cast<double>(-at_[speed]);
    found.contact_time = static_cast<double>(at_[time]);
    return found;
  }

 private:
  static constexpr Real step = 0.01L;
  static constexpr std::size_t maximum_phases = 50;
  /// Stick begins with equal rates of force and limit: less than this is rounding, not another event.
  static constexpr Real noise = 1e-14L;

  static Real fifth(Real y) { return y * y * (y * y) * y; }
  Real normal(const Values& x) const { return fifth(x[root]) * x[root] + g_ * x[root] * x[speed]; }
  Real viscous(const Values& x) const { return c_ * x[root] * x[slip]; }
  Real tangential(const Values& x) const {
    return slips_ == 0 ? x[force] + viscous(x) : Real(slips_) * mu_ * normal(x);
  }
  /// dT/ds while sticking, and dN/ds.
  Real sticking_rate(const Values& x, Real t) const {
    const Real grown = 4.0L * kappa_ * fifth(x[root]) * x[slip];
    return separates_ && x[root] > 0.0L ? grown + 2.0L * t * x[speed] / x[root] : grown;
  }
  Real normal_rate(const Values& x) const {
    const Real accelerated = -4.0L * (x[root] * x[root] * x[root]) * normal(x);
    return (6.0L * fifth(x[root]) + g_ * x[speed]) * x[speed] + g_ * x[root] * accelerated;
  }

  Values advanced(Real by) const {
    Values x = at_;
    boost::numeric::odeint::runge_kutta_fehlberg78<Values, Real, Values, Real> method;
    const auto rates = [this](const Values& of, Values& out, Real) {
      const Real cube = 4.0L * of[root] * of[root] * of[root];
      const Real t = tangential(of);
      out = {of[speed], -cube * normal(of),
             slips_ == 0 ? sticking_rate(of, of[force]) : normal_rate(of) * mu_ * Real(slips_), -n_ * cube * t, cube};
    };
    method.do_step(rates, x, 0.0L, by);
    return x;
  }

  /// Positive until the contact ends, the overlap is largest, or stick or slip ends.
  Real end_guard(const Values& x) const { return x[speed] > 0.0L ? 1.0L : fifth(x[root]) + g_ * x[speed]; }
  Real turn_guard(const Values& x) const { return separates_ ? 1.0L : x[speed]; }
  Real mode_guard(const Values& x) const {
    if (slips_ == 0) return mu_ * normal(x) * (1.0L + noise) - std::abs(tangential(x));
    const Real sticks = Real(slips_) * sticking_rate(x, tangential(x)), slips = mu_ * normal_rate(x);
    return sticks - slips + noise * (std::abs(sticks) + std::abs(slips));
  }
  bool lasts(const Values& x) const { return end_guard(x) > 0.0L && turn_guard(x) > 0.0L && mode_guard(x) >= 0.0L; }

  /// Advances by a step or to the next event; true at the end of the contact.
  bool advance() {
    Values next = advanced(step);
    if (lasts(next)) {
      at_ = next;
      return false;
    }
    Real low = 0.0L, high = step;
    for (int i = 0; i < 64; ++i) {
      const Real middle = 0.5L * (low + high);
      (lasts(advanced(middle)) ? low : high) = middle;
    }
    next = advanced(high);
    const bool ends = !(end_guard(next) > 0.0L), turns = !(turn_guard(next) > 0.0L), changes = mode_guard(next) < 0.0L;
    at_ = next;
    at_[force] = slips_ == 0 ? next[force] : tangential(next) - viscous(next);
    if (ends) return true;
    if (turns) separates_ = true;
    if (changes) slips_ = slips_ != 0 ? 0 : tangential(next) > 0.0L ? 1 : -1;
    return false;
  }

  Real kappa_, mu_, n_, g_, c_;
  Values at_;
  int slips_{};
  bool separates_{};
};

}  // namespace

MindlinRebound rebound(const MindlinImpact& impact) {
  MindlinRebound found = Path{impact}.solve();
  found.speed_lost = (impact.slip_rate - found.slip_rate) / impact.mobility;
  return found;
}

double first_stick_ratio(const MindlinImpact& impact) { return 1.5 * impact.friction / impact.stiffness_ratio; }

}  // namespace talus::verification::reference
