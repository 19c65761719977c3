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

template <class Stepper>
using Controlled = odeint::controlled_runge_kutta<Stepper>;

using Dopri5 = odeint::runge_kutta_dopri5<Vector>;
using CashKarp54 = odeint::runge_kutta_cash_karp54<Vector>;
using Fehlberg78 = odeint::runge_kutta_fehlberg78<Vector>;
// Started by Fehlberg 7(8): odeint's default start, rk4, leaves an error of h^5 that the whole run keeps.
using Adams8 = odeint::adams_bashforth_moulton<8, Vector, double, Vector, double, odeint::range_algebra,
                                               odeint::default_operations, odeint::initially_resizer, Fehlberg78>;
using BulirschStoer = odeint::bulirsch_stoer<Vector>;
using AnyStepper = std::variant<Dopri5, CashKarp54, Fehlberg78, Adams8, Controlled<Dopri5>, Controlled<CashKarp54>,
                                Controlled<Fehlberg78>, BulirschStoer>;

template <class Stepper>
Controlled<Stepper> controlled(double tolerance) {
  return Controlled<Stepper>{typename Controlled<Stepper>::error_checker_type{tolerance, tolerance}};
}

AnyStepper make_stepper(OdeintMethod method, double tolerance) {
  const bool fixed = tolerance == 0.0;
  switch (method) {
    case OdeintMethod::dopri5:
      if (fixed) return Dopri5{};
      return controlled<Dopri5>(tolerance);
    case OdeintMethod::cash_karp54:
      if (fixed) return CashKarp54{};
      return controlled<CashKarp54>(tolerance);
    case OdeintMethod::fehlberg78:
      if (fixed) return Fehlberg78{};
      return controlled<Fehlberg78>(tolerance);
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

OdeintStepper::OdeintStepper(OdeintMethod method, double tolerance)
    : method_{std::make_unique<Method>(Method{make_stepper(method, tolerance)})} {}
OdeintStepper::~OdeintStepper() = default;
OdeintStepper::OdeintStepper(const OdeintStepper& other) : method_{std::make_unique<Method>(*other.method_)} {}
OdeintStepper& OdeintStepper::operator=(const OdeintStepper& other) {
  method_ = std::make_unique<Method>(*other.method_);
  return *this;
}
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

namespace {

constexpr double riding_scale = 0x1p-200;

void append(OdeintStepper::Vector& x, const auto& numbers, double scale) {
  for (const double number : numbers)
    x.push_back(scale * number);
}

}  // namespace

void pack(const State& state, OdeintStepper::Vector& x) {
  x.clear();
  append(x, state.q, 1.0);
  append(x, state.v, 1.0);
  append(x, state.z, 1.0);
  append(x, state.work, riding_scale);
  append(x, state.impulse, riding_scale);
}

void unpack(const OdeintStepper::Vector& x, State& state) {
  auto from = x.begin();
  const auto take = [&from](auto& to, double scale) {
    for (double& number : to)
      number = scale * *from++;
  };
  take(state.q, 1.0);
  take(state.v, 1.0);
  take(state.z, 1.0);
  take(state.work, 1.0 / riding_scale);
  take(state.impulse, 1.0 / riding_scale);
}

void pack(const State& state, const Rates& rates, OdeintStepper::Vector& dxdt) {
  dxdt.clear();
  append(dxdt, state.v, 1.0);
  append(dxdt, rates.v, 1.0);
  append(dxdt, rates.z, 1.0);
  append(dxdt, rates.work, riding_scale);
  append(dxdt, rates.impulse, riding_scale);
}

}  // namespace talus
