#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/integrate/concepts.hpp"

namespace talus {

/// Steppers of Boost.odeint that scenes can name.
enum class OdeintMethod { dopri5, cash_karp54, fehlberg78, adams_bashforth_moulton8, bulirsch_stoer };

/// Constants that a stepper declares as an integrator (see IntegratorFor); `additions` are upper bounds.
struct OdeintTraits {
  std::string_view name;
  int order;
  StepControl step_control;
  int evaluations;
  int additions;
};
constexpr OdeintTraits odeint_traits(OdeintMethod method) {
  switch (method) {
    case OdeintMethod::dopri5:  // the last of its seven stages is the first of the next step
      return {"odeint_dopri5", 5, StepControl::fixed_or_tolerance, 6, 10};
    case OdeintMethod::cash_karp54:
      return {"odeint_cash_karp54", 5, StepControl::fixed_or_tolerance, 6, 10};
    case OdeintMethod::fehlberg78:
      return {"odeint_fehlberg78", 8, StepControl::fixed_or_tolerance, 13, 10};
    case OdeintMethod::adams_bashforth_moulton8:  // predictor and corrector
      return {"odeint_abm8", 8, StepControl::fixed, 2, 16};
    case OdeintMethod::bulirsch_stoer:
      break;
  }
  return {"odeint_bulirsch_stoer", 8, StepControl::tolerance, 0, 20};
}

/// Common interface to odeint's steppers, for states packed into one vector. Has value semantics: a copy continues as
/// the original would.
class OdeintStepper {
 public:
  using Vector = std::vector<double>;
  /// Writes dx/dt at (x, t) to the second argument.
  using Derivative = std::function<void(const Vector& x, Vector& dxdt, double t)>;
  /// Called after each accepted internal step with the vector and its time; may change the vector.
  using Accepted = std::function<void(Vector& x, double t)>;
  /// Longest internal step from the state accepted last, at most `horizon` [T]: step control does not see a contact
  /// that begins and ends between two of its evaluations.
  using Longest = std::function<double(double horizon)>;

  /// tolerance > 0: relative and absolute error allowed in each step, with step control; 0: steps of fixed length. The
  /// caller must ensure that the method supports this (see odeint_traits).
  OdeintStepper(OdeintMethod method, double tolerance);
  ~OdeintStepper();
  OdeintStepper(const OdeintStepper&);
  OdeintStepper& operator=(const OdeintStepper&);
  OdeintStepper(OdeintStepper&&) noexcept;
  OdeintStepper& operator=(OdeintStepper&&) noexcept;

  /// Advances x from t to t + h, in one step or as many as step control needs; returns the error message, or an empty
  /// string.
  [[nodiscard]] std::string advance(const Derivative& derivative, const Accepted& accepted, const Longest& longest,
                                    Vector& x, double t, double h);

  /// Serializes what is carried to the next advance(), for vectors of `size` numbers.
  void serialize(Archive& archive, std::size_t size);

 private:
  struct Method;
  std::unique_ptr<Method> method_;
};

/// Packs a state into one vector for odeint: q, v, z, then work and impulse. The last two are excluded from step
/// control: they are scaled by 2^-200, which loses no bit and makes their errors negligible.
void pack(const State& state, OdeintStepper::Vector& x);
void unpack(const OdeintStepper::Vector& x, State& state);
/// dx/dt in the same order: v, rates.v, rates.z, rates.work, rates.impulse.
void pack(const State& state, const Rates& rates, OdeintStepper::Vector& dxdt);

/// One of odeint's steppers as a Talus integrator. With tolerance > 0 the step h is the interval between outputs and
/// the stepper chooses its internal steps; with tolerance 0 each step has length h.
template <OdeintMethod method>
class Odeint {
 public:
  static constexpr std::string_view name = odeint_traits(method).name;
  static constexpr int order = odeint_traits(method).order;
  static constexpr StepControl step_control = odeint_traits(method).step_control;
  static constexpr int evaluations = odeint_traits(method).evaluations;
  static constexpr int additions = odeint_traits(method).additions;

  double tolerance{};  ///< relative and absolute error of a step; 0: fixed steps

  template <Differentiable System>
  void start(System& system, State& state, double) {
    system.update_modes(state);
    prepare(state);
  }

  template <Differentiable System>
  void step(System& system, State& state, double h) {
    pack(state, x_);
    const auto derivative = [&](const OdeintStepper::Vector& x, OdeintStepper::Vector& dxdt, double) {
      unpack(x, scratch_);
      scratch_.mode = state.mode;
      system.evaluate(scratch_, rates_);
      pack(scratch_, rates_, dxdt);
    };
    const auto accepted = [&](OdeintStepper::Vector& x, double t) {
      unpack(x, state);
      state.t = t;
      system.update_modes(state);
      pack(state, x);
    };
    // Passed by reference: copies of functions with this many captures would allocate at each step.
    const auto longest = [&](double horizon) {
      if constexpr (requires { system.safe_step(state, horizon); }) return system.safe_step(state, horizon);
      return horizon;
    };
    failure_ = stepper_->advance(std::cref(derivative), std::cref(accepted), std::cref(longest), x_, state.t, h);
  }

  /// Why the method cannot continue; empty while it can.
  const std::string& failure() const { return failure_; }

  void serialize(Archive& archive, const State& like) {
    if (archive.is_loading()) prepare(like);
    stepper_->serialize(archive, x_.size());
  }

 private:
  void prepare(const State& like) {
    stepper_.emplace(method, tolerance);
    failure_.clear();
    scratch_ = like;
    rates_ = Rates{like};
    pack(like, x_);
  }

  std::optional<OdeintStepper> stepper_;
  State scratch_;
  Rates rates_;
  OdeintStepper::Vector x_;
  std::string failure_;
};

}  // namespace talus
