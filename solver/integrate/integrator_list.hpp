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

/// Any of the integrators; its base is their closed list. One line here makes a method selectable, tested and documented,
/// and lets it step discs if it can (see DiscMethod).
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

/// The integrator of that name; `tolerance` > 0 asks for step control.
/// Errors: InputError for an unknown name, a tolerance where the method has no step control, none where it needs one.
[[nodiscard]] Integrator make_integrator(std::string_view name, double tolerance = 0.0);

/// What the method of that name declares; the next four are read from it. Errors: InputError for an unknown name.
[[nodiscard]] const IntegratorTraits& integrator_traits(std::string_view name);
/// Whether the method chooses its steps by a tolerance and has none of fixed length.
[[nodiscard]] bool needs_tolerance(std::string_view name);
/// Whether the method is only for motion in linear pieces.
[[nodiscard]] bool needs_closed_form(std::string_view name);
/// Whether the method can choose its steps by a tolerance.
[[nodiscard]] bool has_step_control(std::string_view name);
/// Largest stable h omega of the method on a damped oscillator of damping ratio xi, dashpot velocities taken as the
/// method takes them: 2 (sqrt(1 + xi^2) - xi) for the leapfrog methods, half of that for the lagged one if xi > 0; 2
/// xi, beyond xi = 1 2/(xi + sqrt(xi^2 - 1)), for euler and 4 xi, beyond xi = 1/2 1/xi, for taylor, which both grow at
/// any step where nothing damps; for rk4 where |R(z)| = 1 (2.828 at xi = 0); for blanes_moan4 where the spectral radius
/// of its map first passes 1 (3.16 at xi = 0). Empty for other methods. It is a limit of growth, not of accuracy, and
/// one-sided contacts gain energy well below it.
[[nodiscard]] std::optional<double> linear_limit(std::string_view name, double damping_ratio);

/// What an integrator declares.
[[nodiscard]] const IntegratorTraits& traits(const Integrator& integrator);
/// Name and order on smooth motion of an integrator.
[[nodiscard]] std::string_view name(const Integrator& integrator);
[[nodiscard]] int order(const Integrator& integrator);

/// Tolerance of an integrator's step control; 0 where it has none or takes fixed steps.
[[nodiscard]] double tolerance(const Integrator& integrator);

/// Whether an integrator chooses its own steps, so that the step of a plan is the time between two outputs.
[[nodiscard]] bool chooses_steps(const Integrator& integrator);

/// Events that an integrator has located since the run's start; nothing of one that locates none.
[[nodiscard]] std::optional<long> located_events(const Integrator& integrator);

}  // namespace talus
