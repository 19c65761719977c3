#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/integrate/blanes_moan4.hpp"
#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/integrate/exact.hpp"
#include "solver/integrate/lagged_central_difference.hpp"
#include "solver/integrate/odeint_steppers.hpp"
#include "solver/integrate/runge_kutta4.hpp"
#include "solver/integrate/stormer_cowell.hpp"
#include "solver/integrate/taylor.hpp"
#include "solver/integrate/velocity_verlet.hpp"

namespace talus {

/// Any of the integrators; its base class is their closed list. One entry here makes a method selectable, tested and
/// documented, and lets it step discs if it can (see DiscMethod).
class Integrator
    : public std::variant<CentralDifference, LaggedCentralDifference, VelocityVerlet, EulerCromer, Euler, Taylor,
                          RungeKutta4, BlanesMoan4, Odeint<OdeintMethod::dopri5>, Odeint<OdeintMethod::cash_karp54>,
                          Odeint<OdeintMethod::fehlberg78>, Odeint<OdeintMethod::adams_bashforth_moulton8>,
                          Odeint<OdeintMethod::bulirsch_stoer>, StormerCowell, Exact> {
 public:
  using List = variant;
  using variant::variant;
};

/// Names of all integrators, in the list's order.
[[nodiscard]] std::vector<std::string> integrator_names();

/// Makes the integrator with this name; `tolerance` > 0 selects step control.
/// Errors: InputError for an unknown name, a tolerance for a method without step control, or none for one that needs
/// it.
[[nodiscard]] Integrator make_integrator(std::string_view name, double tolerance = 0.0);

/// Properties of the method with this name, also the source of the next four. Errors: InputError for an unknown name.
[[nodiscard]] const IntegratorTraits& integrator_traits(std::string_view name);
/// True if the method always chooses its steps by a tolerance and has none of fixed length.
[[nodiscard]] bool needs_tolerance(std::string_view name);
/// True if the method requires motion that is linear between events.
[[nodiscard]] bool needs_closed_form(std::string_view name);
/// True if the method can choose its steps by a tolerance.
[[nodiscard]] bool has_step_control(std::string_view name);
/// Largest stable omega h of the method on an oscillator of damping ratio xi, with dashpot velocities as the method
/// evaluates them. Leapfrog methods: 2 (sqrt(1 + xi^2) - xi), half of that for the lagged one if xi > 0. euler: 2 xi,
/// or 2/(xi + sqrt(xi^2 - 1)) for xi > 1; taylor: 4 xi, or 1/xi for xi > 1/2; both grow at any step without damping.
/// rk4: where |R(z)| = 1 (2.828 at xi = 0). blanes_moan4: where the spectral radius of its map first exceeds 1 (3.16 at
/// xi = 0). Empty for other methods. It limits growth, not error, and one-sided contacts gain energy well below it.
[[nodiscard]] std::optional<double> linear_limit(std::string_view name, double damping_ratio);

/// Properties that an integrator declares.
[[nodiscard]] const IntegratorTraits& traits(const Integrator& integrator);
/// Name and order on smooth motion of an integrator.
[[nodiscard]] std::string_view name(const Integrator& integrator);
[[nodiscard]] int order(const Integrator& integrator);

/// Tolerance of an integrator's step control; 0 if it has none or takes fixed steps.
[[nodiscard]] double tolerance(const Integrator& integrator);

/// True if an integrator chooses its steps; the step of a plan is then the interval between two outputs.
[[nodiscard]] bool chooses_steps(const Integrator& integrator);

/// Number of events located since the start of the run; empty for an integrator that locates none.
[[nodiscard]] std::optional<long> located_events(const Integrator& integrator);

}  // namespace talus
