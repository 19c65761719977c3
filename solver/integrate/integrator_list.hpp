#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/integrate/blanes_moan4.hpp"
#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/integrate/exact.hpp"
#include "solver/integrate/lagged_central_difference.hpp"
#include "solver/integrate/odeint_steppers.hpp"
#include "solver/integrate/rk4.hpp"
#include "solver/integrate/stormer_cowell.hpp"
#include "solver/integrate/taylor.hpp"
#include "solver/integrate/velocity_verlet.hpp"

namespace talus {

/// The closed list of integrators. One line here makes a method selectable, tested and documented.
using Integrator =
    std::variant<CentralDifference, LaggedCentralDifference, VelocityVerlet, EulerCromer, Euler, Taylor, RungeKutta4,
                 BlanesMoan4, Odeint<OdeintMethod::dopri5>, Odeint<OdeintMethod::cash_karp54>,
                 Odeint<OdeintMethod::fehlberg78>, Odeint<OdeintMethod::adams_bashforth_moulton8>,
                 Odeint<OdeintMethod::bulirsch_stoer>, StormerCowell, Exact>;

/// Names of all integrators, in the list's order.
[[nodiscard]] std::vector<std::string> integrator_names();

/// The integrator of that name; `tolerance` > 0 asks for step control.
/// Errors: InputError for an unknown name, a tolerance where the method has no step control, none where it needs one.
[[nodiscard]] Integrator make_integrator(std::string_view name, double tolerance = 0.0);

/// Whether the method of that name chooses its steps by a tolerance and has none of fixed length.
/// Errors: InputError for an unknown name.
[[nodiscard]] bool needs_tolerance(std::string_view name);

/// Whether the method of that name is only for motion in linear pieces.
/// Errors: InputError for an unknown name.
[[nodiscard]] bool needs_closed_form(std::string_view name);

/// Whether the method of that name can choose its steps by a tolerance. Errors: InputError for an unknown name.
[[nodiscard]] bool has_step_control(std::string_view name);

/// Name and order on smooth motion of an integrator.
[[nodiscard]] std::string_view name(const Integrator& integrator);
[[nodiscard]] int order(const Integrator& integrator);

/// Tolerance of an integrator's step control; 0 where it has none or takes fixed steps.
[[nodiscard]] double tolerance(const Integrator& integrator);

/// Events that an integrator has located since the run's start; nothing of one that locates none.
[[nodiscard]] std::optional<long> located_events(const Integrator& integrator);

}  // namespace talus
