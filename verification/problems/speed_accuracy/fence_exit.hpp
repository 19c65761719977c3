#pragma once

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"

/// The fence of Table 2 hit by the rock of 600 lb, slack .5, as its deck in cases/fence has it: what the rock and the
/// cables have come to at a time.
namespace talus::verification::problems {

/// The scene, and which coordinate is the rock's way.
struct FenceHit {
  Scene scene;
  std::size_t rock{};
};

[[nodiscard]] FenceHit fence_hit();

struct FenceExit {
  double speed{};    ///< of the rock at the end [ft/s]; NaN if the run failed
  double tension{};  ///< largest of any cable at the compared times [lb]
  double evaluations{};
  long events{};  ///< located
};

/// Equal spans of time that a run is divided into, and the steps in each; of methods that choose their own steps, these
/// are the outputs. Compared is at the end of each span.
struct FenceSteps {
  double end{};  ///< of the run [s]
  long spans{};
  long steps{1};
};

[[nodiscard]] FenceExit run_fence(const FenceHit& hit, Integrator integrator, const FenceSteps& plan,
                                  Findings& findings);

}  // namespace talus::verification::problems
