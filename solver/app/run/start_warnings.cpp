#include "solver/app/run/start_warnings.hpp"

#include <fmt/format.h>

#include "solver/scenes/fence_plausibility.hpp"
#include "solver/stability/inertia_bound.hpp"
#include "solver/stability/missing_contacts.hpp"
#include "solver/stability/start_overlaps.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {

std::string step_warning(std::string_view verdict, std::string_view command) {
  return fmt::format("{}; the answer may grow without bound; `{}` chooses its own steps", verdict, command);
}

std::vector<std::string> start_warnings(const SceneFile& file, const Dynamics& dynamics) {
  std::vector<std::string> warnings{overlap_warning(start_overlaps(dynamics, file.scene.initial), file.scene.model),
                                    inertia_warning(file.scene.model), output_warning(file.scene, dynamics)};
  std::erase(warnings, "");
  return warnings;
}

std::vector<std::string> missing_contact_warnings(const Scene& scene, const Dynamics& dynamics) {
  if (scene.plan.watch.missing_contacts == CheckAction::off) return {};
  const std::string overlap = missing_contact_warning(dynamics, scene.initial);
  if (overlap.empty()) return {};
  return {overlap};
}

std::vector<std::string> geometry_warnings(const SceneFile& file) {
  if (!file.fence) return {};
  return scenes::implausible_geometry(file.fence->fence, file.fence->made);
}

}  // namespace talus::app
