#pragma once

#include <string>

#include "solver/integrate/integrator_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/model/model.hpp"
#include "solver/run/run_plan.hpp"

namespace talus {

/// All that a run needs: what exists, how it starts, and by which method and plan it goes on.
struct Scene {
  std::string title{};
  Model model{};
  State initial{};
  Integrator integrator{};
  RunPlan plan{};
};

}  // namespace talus
