#include "solver/scenes/scene.hpp"

#include <algorithm>

namespace talus {

bool reached(const EarlyEnd& end, const Model& model, const State& state) {
  return std::all_of(end.bodies.begin(), end.bodies.end(), [&](BodyId body) {
    const Pose at = pose(model, state, body);
    return end.x ? at.p_WB.x < *end.x : norm(at.v_WB) < end.speed;
  });
}

}  // namespace talus
