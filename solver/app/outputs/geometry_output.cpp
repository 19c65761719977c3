#include "solver/app/outputs/geometry_output.hpp"

#include <algorithm>

#include "solver/run/simulate.hpp"

namespace talus::app {

long steps_between_states(const SceneFile& file, long frames) {
  constexpr long usual_frames = 100;
  if (frames == 0 && file.fence) return file.fence->fence.print_every;
  return std::max(1L, step_count(file.scene.plan) / (frames == 0 ? usual_frames : frames));
}

}  // namespace talus::app
