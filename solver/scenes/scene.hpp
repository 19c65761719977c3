#pragma once

#include <optional>
#include <string>
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

/// All that a run needs: what exists, how it starts, and by which method and plan it goes on.
struct Scene {
  std::string title{};
  Model model{};
  State initial{};
  Integrator integrator{};
  RunPlan plan{};
  std::optional<EarlyEnd> early_end{};
};

}  // namespace talus
