#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/model/model.hpp"
#include "solver/run/run_plan.hpp"

namespace talus {

/// Condition that ends a run before the end of its plan.
struct EarlyEnd {
  std::vector<BodyId> bodies;  ///< all of them must meet the condition
  std::optional<double> x{};   ///< position to pass: their x is below it [L]
  double speed{};              ///< if x is not given: at rest, slower than this [L/T]
};

/// Whether all bodies meet the condition.
[[nodiscard]] bool reached(const EarlyEnd& end, const Model& model, const State& state);

/// An integrator for a scene, and the reason if it was chosen automatically (otherwise empty).
struct IntegratorChoice {
  Integrator integrator{};
  std::string why{};
};

/// Name with which a scene requests choose_integrator() to select the integrator.
inline constexpr std::string_view automatic_integrator = "auto";
/// Names of all integrators, and `auto`.
[[nodiscard]] std::vector<std::string> integrator_choices();

/// Default tolerance of integrators that need one. The error of most scenes is then far below the uncertainty of their
/// data; a tolerance ten times smaller costs an eighth more evaluations.
inline constexpr double usual_tolerance = 1e-10;

/// Errors: InputError with the obstacle, if the integrator needs motion that is linear between events and that of the
/// model is not.
void demand_closed_form(const Model& model, const Integrator& integrator);

/// The integrator with the given name for the motion of a model. "auto" selects `exact` if all motion between events
/// has a closed form, otherwise `stormer_cowell` with the tolerance. Tolerance 0 means that none is given. Errors:
/// InputError as make_integrator() and demand_closed_form().
[[nodiscard]] IntegratorChoice choose_integrator(const Model& model, std::string_view name, double tolerance = 0.0);

/// All data of a run: model, initial state, integrator and plan.
struct Scene {
  std::string title{};
  Model model{};
  State initial{};
  Integrator integrator{};
  std::string integrator_reason{};  ///< reason for an automatic choice
  RunPlan plan{};
  std::optional<EarlyEnd> early_end{};
};

}  // namespace talus
