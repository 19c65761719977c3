#include "solver/integrate/odeint_steppers.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdlib>
#include <variant>

#include "solver/base/error.hpp"

namespace talus {
namespace {

namespace odeint = boost::numeric::odeint;
using Vector = OdeintStepper::Vector;

/// odeint's default error measure, |error_i| / (tolerance + tolerance (|x_i| + |h dx_i/dt|)), over the first
/// `controlled` numbers only.
class LeadingErrorChecker {
 public:
  using value_type = double;
  using algebra_type = odeint::range_algebra;
  using operations_type = odeint::default_operations;

  LeadingErrorChecker() = default;
  LeadingErrorChecker(double tolerance, std::size_t controlled) : tolerance_{tolerance}, controlled_{controlled} {}

  template <class State, class Deriv, class Err, class Time>
  double error(algebra_type&, const State& x, const Deriv& dxdt, Err& err, Time dt) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < controlled_; ++i) {
      const double scale = tolerance_ * (1.0 + std::abs(x[i]) + std::abs(dt * dxdt[i]));
      largest = std::max(largest, std::abs(err[i]) / scale);
      if (!std::isfinite(err[i])) largest = 1e300;
    }
    return largest;
  }

  template <class State, class Deriv, class Err, class Time>
  double error(const State& x, const Deriv& dxdt, Err& err, Time dt) const {
    algebra_type algebra;
    return error(algebra, x, dxdt, err, dt);
  }

 private:
  double tolerance_{1e-6};
  std::size_t controlled_{};
};

template <class Stepper>
using Controlled = odeint::controlled_runge_kutta<Stepper, LeadingErrorChecker>;

using Dopri5 = odeint::runge_kutta_dopri5<Vector>;
using CashKarp54 = odeint::runge_kutta_cash_karp54<Vector>;
using Fehlberg78 = odeint::runge_kutta_fehlberg78<Vector>;
// Started by Fehlberg 7(8): odeint's default start, rk4, leaves an error of h^5 that the whole run keeps.
using Adams8 = odeint::adams_bashforth_moulton<8, Vector, double, Vector, double, odeint::range_algebra,
                                               odeint::default_operations, odeint::initially_resizer, Fehlberg78>;
using BulirschStoer = odeint::bulirsch_stoer<Vector>;
using AnyStepper = std::variant<Dopri5, CashKarp54, Fehlberg78, Adams8, Controlled<Dopri5>, Controlled<CashKarp54>,
                                Controlled<Fehlberg78>, BulirschStoer>;

AnyStepper make_stepper(OdeintMethod method, double tolerance, std::size_t controlled) {
  const LeadingErrorChecker checker{tolerance, controlled};
  const bool fixed = tolerance == 0.0;
  switch (method) {
    case OdeintMethod::dopri5:
      if (fixed) return Dopri5{};
      return Controlled<Dopri5>{checker};
    case OdeintMethod::cash_karp54:
      if (fixed) return CashKarp54{};
      return Controlled<CashKarp54>{checker};
    case OdeintMethod::fehlberg78:
      if (fixed) return Fehlberg78{};
      return Controlled<Fehlberg78>{checker};
    case OdeintMethod::adams_bashforth_moulton8:
      TALUS_DEMAND(fixed);
      return Adams8{};
    case OdeintMethod::bulirsch_stoer:
      TALUS_DEMAND(!fixed);
      return BulirschStoer{tolerance, tolerance};
  }
  std::abort();
}

/// The least internal step, as a share of the interval: below it a run has failed, not merely slowed down.
constexpr double least_share = 1e-12;

}  // namespace

struct OdeintStepper::Method {
  AnyStepper stepper;
  double internal_step{};  ///< the step that step control would take next; 0 before the first
};

OdeintStepper::OdeintStepper(OdeintMethod method, double tolerance, std::size_t controlled)
    : method_{std::make_unique<Method>(Method{make_stepper(method, tolerance, controlled)})} {}
OdeintStepper::~OdeintStepper() = default;
OdeintStepper::OdeintStepper(OdeintStepper&&) noexcept = default;
OdeintStepper& OdeintStepper::operator=(OdeintStepper&&) noexcept = default;

void OdeintStepper::advance(const Derivative& derivative, const Accepted& accepted, Vector& x, double t, double h) {
  const auto one_step = [&](auto& stepper) {
    stepper.do_step(std::cref(derivative), x, t, h);
    accepted(x, t + h);
  };
  const auto controlled_steps = [&](auto& stepper) {
    const double end = t + h;
    double dt = method_->internal_step == 0.0 ? h : std::min(method_->internal_step, h);
    while (t < end) {
      const bool last = t + dt * (1.0 + 1e-12) >= end;
      double attempt = last ? end - t : dt;
      const double wanted = attempt;
      if (stepper.try_step(std::cref(derivative), x, t, attempt) == odeint::success) {
        if (last) t = end;
        // A step cut short by the end of the interval says nothing against the longer one.
        dt = last ? std::max(dt, attempt) : attempt;
        accepted(x, t);
      } else {
        dt = attempt;
      }
      if (dt < least_share * h || !std::isfinite(wanted)) {
        x.assign(x.size(), std::nan(""));  // the run is over: the caller sees a state that is not finite
        accepted(x, end);
        return;
      }
    }
    method_->internal_step = dt;
  };
  std::visit(
      [&](auto& stepper) {
        if constexpr (requires(Vector & v, double& time, double& dt) {
                        stepper.try_step(std::cref(derivative), v, time, dt);
                      }) {
          controlled_steps(stepper);
        } else {
          one_step(stepper);
        }
      },
      method_->stepper);
}

void pack(const State& state, OdeintStepper::Vector& x) {
  x.clear();
  x.insert(x.end(), state.q.begin(), state.q.end());
  x.insert(x.end(), state.v.begin(), state.v.end());
  x.insert(x.end(), state.z.begin(), state.z.end());
  x.insert(x.end(), state.work.begin(), state.work.end());
  x.insert(x.end(), state.impulse.begin(), state.impulse.end());
}

void unpack(const OdeintStepper::Vector& x, State& state) {
  auto from = x.begin();
  const auto take = [&from](auto& to) {
    const auto end = from + static_cast<std::ptrdiff_t>(to.size());
    std::copy(from, end, to.begin());
    from = end;
  };
  take(state.q);
  take(state.v);
  take(state.z);
  take(state.work);
  take(state.impulse);
}

void pack(const State& state, const Rates& rates, OdeintStepper::Vector& dxdt) {
  dxdt.clear();
  dxdt.insert(dxdt.end(), state.v.begin(), state.v.end());
  dxdt.insert(dxdt.end(), rates.v.begin(), rates.v.end());
  dxdt.insert(dxdt.end(), rates.z.begin(), rates.z.end());
  dxdt.insert(dxdt.end(), rates.work.begin(), rates.work.end());
  dxdt.insert(dxdt.end(), rates.impulse.begin(), rates.impulse.end());
}

}  // namespace talus
