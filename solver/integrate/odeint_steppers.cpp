#include "solver/integrate/odeint_steppers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/adams_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/integrate/internal_steps.hpp"

namespace talus {
namespace {

namespace odeint = boost::numeric::odeint;
using Vector = OdeintStepper::Vector;

bool is_finite(const Vector& x) {
  return std::all_of(x.begin(), x.end(), [](double number) { return std::isfinite(number); });
}

/// odeint's error measure of a step; infinite if some error is not finite. odeint finds the largest by `<`, which loses
/// a NaN, and would accept a step so long that its stages overflow.
class ErrorChecker : public odeint::default_error_checker<double, odeint::range_algebra, odeint::default_operations> {
 public:
  using default_error_checker::default_error_checker;

  double error(odeint::range_algebra& algebra, const Vector& x, const Vector& dxdt, Vector& errors, double dt) const {
    const double largest = default_error_checker::error(algebra, x, dxdt, errors, dt);
    return is_finite(errors) ? largest : std::numeric_limits<double>::infinity();
  }
};

template <class Stepper>
using Controlled = odeint::controlled_runge_kutta<Stepper, ErrorChecker>;

using Dopri5 = odeint::runge_kutta_dopri5<Vector>;
using CashKarp54 = odeint::runge_kutta_cash_karp54<Vector>;
using Fehlberg78 = odeint::runge_kutta_fehlberg78<Vector>;

/// odeint's bulirsch_stoer, which also accepts steps that overflow: they are repeated with a fifth of the length, as
/// for the other steppers.
class BulirschStoer {
 public:
  explicit BulirschStoer(double tolerance) : stepper_{tolerance, tolerance} {}

  template <class System>
  odeint::controlled_step_result try_step(System system, Vector& x, double& t, double& dt) {
    before_ = x;
    const double begin = t, length = dt;
    const odeint::controlled_step_result result = stepper_.try_step(system, x, t, dt);
    if (result == odeint::fail || is_finite(x)) return result;
    x = before_, t = begin, dt = 0.2 * length;
    stepper_.reset();
    return odeint::fail;
  }
  void reset() { stepper_.reset(); }

 private:
  odeint::bulirsch_stoer<Vector> stepper_;
  Vector before_;
};

/// Adams predictor and corrector with eight values, combined as in odeint's adams_bashforth_moulton<8>; not that class,
/// because it does not expose the derivatives that it stores.
class Adams8 {
 public:
  template <class System>
  void do_step(System system, Vector& x, double t, double h) {
    // Eight derivatives are stored; the first seven steps use the starting method.
    kept_ = std::min(kept_ + 1, maximum);
    if (!predictor_.is_initialized()) return predictor_.do_step(system, x, t, h);
    predicted_.resize(x.size());
    predictor_.do_step(system, x, t, predicted_, h);
    corrector_.do_step(system, x, predicted_, t + h, x, h, predictor_.step_storage());
  }

  void serialize(Archive& archive, std::size_t size) {
    long kept = kept_;
    archive.count("stored_derivatives", kept);
    if (archive.is_loading()) {
      if (kept > maximum)
        throw InputError{fmt::format("stored_derivatives: found {}; it must be at most {}", kept, maximum)};
      count_steps(kept, size);
    }
    for (long i = 0; i < kept_; ++i)
      archive.numbers(fmt::format("derivative_{}", i), predictor_.step_storage()[static_cast<std::size_t>(i)].m_v);
  }

 private:
  static constexpr long maximum = 8;
  // Started by Fehlberg 7(8): odeint's default, rk4, causes an error of h^5 that persists during the whole run.
  using Predictor = odeint::adams_bashforth<8, Vector, double, Vector, double, odeint::range_algebra,
                                            odeint::default_operations, odeint::initially_resizer, Fehlberg78>;
  using Corrector = odeint::adams_moulton<8, Vector, double, Vector, double, odeint::range_algebra>;

  /// Restores the predictor's internal count of steps, which nothing but steps advances.
  void count_steps(long steps, std::size_t size) {
    const auto at_rest = [](const Vector&, Vector& dxdt, double) { std::fill(dxdt.begin(), dxdt.end(), 0.0); };
    Vector zeros(size, 0.0);
    predictor_ = Predictor{};
    for (kept_ = 0; kept_ < steps; ++kept_)
      predictor_.do_step(at_rest, zeros, 0.0, 1.0);
  }

  /// A corrector refers to an algebra: this static one, so that a copy does not refer to a member of the original.
  static inline odeint::range_algebra algebra_{};

  Predictor predictor_;
  Corrector corrector_{algebra_};
  Vector predicted_;
  long kept_{0};
};

using AnyStepper = std::variant<Dopri5, CashKarp54, Fehlberg78, Adams8, Controlled<Dopri5>, Controlled<CashKarp54>,
                                Controlled<Fehlberg78>, BulirschStoer>;

template <class Stepper>
Controlled<Stepper> controlled(double tolerance) {
  return Controlled<Stepper>{ErrorChecker{tolerance, tolerance}};
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
      return BulirschStoer{tolerance};
  }
  std::abort();
}

/// True if the last stage of a step is the first of the next.
template <class Stepper>
constexpr bool keeps_derivative = std::is_same_v<Stepper, Dopri5> || std::is_same_v<Stepper, Controlled<Dopri5>>;

/// Minimum internal step as a fraction of the interval: below it a run has failed, not merely slowed down.
constexpr double minimum_ratio = 1e-12;

}  // namespace

struct OdeintStepper::Method {
  AnyStepper stepper;
  double internal_step{};    ///< the step that step control would take next; 0 before the first
  Vector last_derivative{};  ///< of a method whose last stage is the first of its next step; empty before the first
  double tolerance{};        ///< relative and absolute error of a step; 0: fixed steps
};

namespace {

/// Advances over the interval h with step control; returns the error message if it cannot reach its end, or an empty
/// string. `Method` is OdeintStepper::Method.
template <class Stepper, class Method>
std::string controlled_steps(Stepper& stepper, Method& method, const OdeintStepper::Derivative& derivative,
                             const OdeintStepper::Accepted& accepted, const OdeintStepper::Longest& longest, Vector& x,
                             double t, double h) {
  const auto try_step = [&](double& attempt) {
    if constexpr (keeps_derivative<Stepper>) {
      return stepper.try_step(std::cref(derivative), x, method.last_derivative, t, attempt) == odeint::success;
    } else {
      return stepper.try_step(std::cref(derivative), x, t, attempt) == odeint::success;
    }
  };
  // Its order is private to odeint and could not be restored from a checkpoint, so each interval restarts.
  if constexpr (std::is_same_v<Stepper, BulirschStoer>) stepper.reset();
  const double end = t + h;
  double dt = method.internal_step == 0.0 ? h : std::min(method.internal_step, h);
  double maximum = 0.0;  // longest step from the state accepted last; 0: not evaluated
  for (long steps = 0; t < end; ++steps) {
    if (steps == maximum_internal_steps) return internal_steps_failure(t);
    if (maximum == 0.0) maximum = longest(end - t);
    const double next = std::min(dt, maximum);
    const bool last = t + next * (1.0 + 1e-12) >= end;
    double attempt = last ? end - t : next;
    const double wanted = attempt;
    if (try_step(attempt)) {
      if (last) t = end;
      // A step cut short by the end of the interval or by a contact to come is no reason to shorten the next one.
      dt = last || next < dt ? std::max(dt, attempt) : attempt;
      accepted(x, t);
      maximum = 0.0;
    } else {
      dt = attempt;
    }
    if (dt < minimum_ratio * h || !std::isfinite(wanted)) return short_step_failure(method.tolerance, t);
  }
  method.internal_step = dt;
  return {};
}

}  // namespace

OdeintStepper::OdeintStepper(OdeintMethod method, double tolerance)
    : method_{std::make_unique<Method>(Method{.stepper = make_stepper(method, tolerance), .tolerance = tolerance})} {}
OdeintStepper::~OdeintStepper() = default;
OdeintStepper::OdeintStepper(const OdeintStepper& other) : method_{std::make_unique<Method>(*other.method_)} {}
OdeintStepper& OdeintStepper::operator=(const OdeintStepper& other) {
  method_ = std::make_unique<Method>(*other.method_);
  return *this;
}
OdeintStepper::OdeintStepper(OdeintStepper&&) noexcept = default;
OdeintStepper& OdeintStepper::operator=(OdeintStepper&&) noexcept = default;

std::string OdeintStepper::advance(const Derivative& derivative, const Accepted& accepted, const Longest& longest,
                                   Vector& x, double t, double h) {
  return std::visit(
      [&]<class Stepper>(Stepper& stepper) -> std::string {
        if constexpr (keeps_derivative<Stepper>) {
          if (method_->last_derivative.empty()) {
            method_->last_derivative.resize(x.size());
            derivative(x, method_->last_derivative, t);
          }
        }
        if constexpr (requires(Vector & v, double& time, double& dt) {
                        stepper.try_step(std::cref(derivative), v, time, dt);
                      }) {
          return controlled_steps(stepper, *method_, derivative, accepted, longest, x, t, h);
        } else {
          if constexpr (keeps_derivative<Stepper>) {
            stepper.do_step(std::cref(derivative), x, method_->last_derivative, t, h);
          } else {
            stepper.do_step(std::cref(derivative), x, t, h);
          }
          accepted(x, t + h);
          return {};
        }
      },
      method_->stepper);
}

void OdeintStepper::serialize(Archive& archive, std::size_t size) {
  archive.number("internal_step", method_->internal_step);
  std::visit(
      [&]<class Stepper>(Stepper& stepper) {
        if constexpr (keeps_derivative<Stepper>) {
          method_->last_derivative.resize(size);
          archive.numbers("last_derivative", method_->last_derivative);
        } else if constexpr (std::is_same_v<Stepper, Adams8>) {
          stepper.serialize(archive, size);
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

/// Packs q and the rest of a state, or dq/dt and the rest of the rates.
template <class Part>
void pack(const std::vector<double>& first, const Part& part, OdeintStepper::Vector& x) {
  x.clear();
  append(x, first, 1.0);
  append(x, part.v, 1.0);
  append(x, part.z, 1.0);
  append(x, part.work, riding_scale);
  append(x, part.impulse, riding_scale);
}

}  // namespace

void pack(const State& state, OdeintStepper::Vector& x) { pack(state.q, state, x); }

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

void pack(const State& state, const Rates& rates, OdeintStepper::Vector& dxdt) { pack(state.v, rates, dxdt); }

}  // namespace talus
