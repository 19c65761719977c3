#include "verification/reference/integration/pendulum_steppers.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

#include "verification/reference/motion/pendulum.hpp"

namespace talus::verification::reference {
namespace {

namespace odeint = boost::numeric::odeint;
using Phase = std::array<double, 2>;

struct Equation {
  double square;  // w0^2
  std::int64_t* evaluations;

  void operator()(const Phase& y, Phase& dydt, double) const {
    ++*evaluations;
    dydt = {y[1], -square * std::sin(y[0])};
  }
};

/// Compares each accepted point with the exact motion.
class Comparison {
 public:
  explicit Comparison(const PendulumRun& run)
      : exact_(PendulumMotion::from_rest(run.frequency, run.amplitude)), square_(run.frequency * run.frequency) {}

  void add(const Phase& y, double t, PendulumRunResult& result) const {
    result.angle = y[0];
    result.rate = y[1];
    result.angle_error = y[0] - exact_.at(t).angle;
    result.largest_angle_error = std::max(result.largest_angle_error, std::abs(result.angle_error));
    const double half = std::sin(y[0] / 2.0);
    const double energy = y[1] * y[1] / 2.0 + 2.0 * square_ * half * half;
    result.largest_energy_error = std::max(result.largest_energy_error, std::abs(energy / exact_.energy() - 1.0));
  }

 private:
  PendulumMotion exact_;
  double square_;
};

template <class Stepper>
PendulumRunResult fixed(Stepper stepper, const PendulumRun& run) {
  PendulumRunResult result;
  const Equation equation{run.frequency * run.frequency, &result.evaluations};
  const Comparison comparison(run);
  const double h = run.duration / run.steps;
  Phase y{run.amplitude, 0.0};
  for (int i = 0; i < run.steps; ++i) {
    stepper.do_step(equation, y, i * h, h);
    comparison.add(y, (i + 1) * h, result);
  }
  return result;
}

template <class Stepper>
PendulumRunResult controlled(Stepper stepper, const PendulumRun& run) {
  PendulumRunResult result;
  const Equation equation{run.frequency * run.frequency, &result.evaluations};
  const Comparison comparison(run);
  Phase y{run.amplitude, 0.0};
  double t = 0.0;
  double h = 0.01 / run.frequency;
  int rejected = 0;
  while (t < run.duration) {
    const bool last = t + h >= run.duration;
    double tried = last ? run.duration - t : h;
    if (stepper.try_step(equation, y, t, tried) == odeint::success) {
      rejected = 0;
      if (last) t = run.duration;
      comparison.add(y, t, result);
    } else if (++rejected > 100) {
      throw std::runtime_error("run_pendulum: no step meets the tolerance");
    }
    h = tried;
  }
  return result;
}

using CashKarp = odeint::runge_kutta_cash_karp54<Phase>;
using DormandPrince = odeint::runge_kutta_dopri5<Phase>;
using Fehlberg = odeint::runge_kutta_fehlberg78<Phase>;
using Adams = odeint::adams_bashforth_moulton<8, Phase, double, Phase, double, odeint::array_algebra,
                                              odeint::default_operations, odeint::initially_resizer, Fehlberg>;

PendulumRunResult run_fixed(const PendulumRun& run) {
  if (run.stepper == "rk4") return fixed(odeint::runge_kutta4<Phase>(), run);
  if (run.stepper == "cash_karp54") return fixed(CashKarp(), run);
  if (run.stepper == "dopri5") return fixed(DormandPrince(), run);
  if (run.stepper == "fehlberg78") return fixed(Fehlberg(), run);
  return fixed(Adams(), run);
}

PendulumRunResult run_controlled(const PendulumRun& run) {
  const double eps = run.tolerance;
  if (run.stepper == "cash_karp54") return controlled(odeint::make_controlled(eps, eps, CashKarp()), run);
  if (run.stepper == "dopri5") return controlled(odeint::make_controlled(eps, eps, DormandPrince()), run);
  if (run.stepper == "fehlberg78") return controlled(odeint::make_controlled(eps, eps, Fehlberg()), run);
  return controlled(odeint::bulirsch_stoer<Phase>(eps, eps), run);
}

}  // namespace

const std::vector<PendulumStepper>& pendulum_steppers() {
  static const std::vector<PendulumStepper> list{
      {"rk4", 4, true, false},
      {"cash_karp54", 5, true, true},
      {"dopri5", 5, true, true},
      {"fehlberg78", 8, true, true},
      {"adams_bashforth_moulton", 8, true, false},
      {"bulirsch_stoer", 0, false, true},
  };
  return list;
}

PendulumRunResult run_pendulum(const PendulumRun& run) {
  if (!(run.duration > 0.0)) throw std::invalid_argument("run_pendulum: the duration must be > 0");
  const auto& list = pendulum_steppers();
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.name == run.stepper; });
  if (found == list.end()) {
    std::string message = run.stepper + ": no such stepper; known:";
    for (const auto& s : list)
      message.append(1, ' ').append(s.name);
    throw std::invalid_argument(message);
  }
  const bool fixed_step = run.steps > 0;
  if (fixed_step && !found->fixed_step) {
    throw std::invalid_argument(run.stepper + ": this stepper has no fixed step");
  }
  if (!fixed_step && !(found->controlled && run.tolerance > 0.0)) {
    throw std::invalid_argument(run.stepper + ": this stepper cannot run under that tolerance");
  }
  return fixed_step ? run_fixed(run) : run_controlled(run);
}

}  // namespace talus::verification::reference
