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

/// What ends a run before its plan's end.
struct EarlyEnd {
  std::vector<BodyId> bodies;  ///< all of them must have come so far
  std::optional<double> x{};   ///< behind this place: their x below it [L]
  double speed{};              ///< where no place is given: at rest, slower than this [L/T]
};

/// Whether the bodies have come so far.
[[nodiscard]] bool reached(const EarlyEnd& end, const Model& model, const State& state);

/// A method for a scene, and why it was chosen; no words where it was named.
struct IntegratorChoice {
  Integrator integrator{};
  std::string why{};
};

/// The name by which a scene leaves the choice of the method to choose_integrator().
inline constexpr std::string_view automatic_integrator = "auto";
/// Names of all integrators, and that one.
[[nodiscard]] std::vector<std::string> integrator_choices();

/// The tolerance of a method that needs one where none is given: the error of most scenes is then far below what their
/// numbers are known to, and a tenth of it costs an eighth more evaluations.
inline constexpr double usual_tolerance = 1e-10;

/// The integrator of that name for the motion of a model. "auto": `exact` where all motion between events has a closed
/// form, else `stormer_cowell` with the tolerance. Tolerance 0: none given.
/// Errors: InputError as make_integrator(), naming the obstacle if the motion has no closed form but must have one.
[[nodiscard]] IntegratorChoice choose_integrator(const Model& model, std::string_view name, double tolerance = 0.0);

/// All that a run needs: what exists, how it starts, and by which method and plan it goes on.
struct Scene {
  std::string title{};
  Model model{};
  State initial{};
  Integrator integrator{};
  std::string integrator_why{};  ///< where it was chosen automatically: why this one
  RunPlan plan{};
  std::optional<EarlyEnd> early_end{};
};

}  // namespace talus
