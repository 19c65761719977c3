#include "solver/advise/method_ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "solver/dynamics/springs.hpp"

namespace talus {

RunMethod MethodLadder::at(double height, long outputs) const {
  // Two digits, so that the tolerance can be written in a scene.
  if (by_tolerance) return {integrator, std::stod(fmt::format("{:.1e}", std::pow(10.0, -1.0 - height))), outputs};
  return {integrator, 0.0, std::lround(static_cast<double>(coarsest) * std::exp2(height))};
}

double MethodLadder::top() const { return by_tolerance ? 12.0 : std::numeric_limits<double>::infinity(); }

std::vector<MethodLadder> method_ladders(const std::vector<std::string>& integrators, long resolving) {
  std::vector<MethodLadder> ladders;
  const long coarsest = std::max(8L, resolving / 8);
  for (const std::string& name : integrators) {
    if (!needs_tolerance(name)) ladders.push_back({name, false, coarsest});
    if (has_step_control(name)) ladders.push_back({name, true, coarsest});
  }
  return ladders;
}

double resolving_steps(const Dynamics& dynamics, const Scene& scene) {
  const double duration = scene.plan.end - scene.initial.t;
  double fastest = 0.0;
  for (const Spring& spring : springs(dynamics, scene.initial)) {
    if (std::isfinite(spring.effective_mass))
      fastest = std::max(fastest, std::sqrt(spring.stiffness / spring.effective_mass));
  }
  Workspace work = dynamics.workspace();
  dynamics.update_all(scene.initial, work);
  const double passing = duration / dynamics.longest_step(work);
  return std::ceil(std::max({64.0, 4.0 * duration * fastest / std::numbers::pi, passing}));
}

}  // namespace talus
