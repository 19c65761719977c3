#include "solver/app/check/scene_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solver/app/run/start_warnings.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/run_plan.hpp"

namespace talus::app {
namespace {

/// Step over the linear limit of the scene's method for a contact with its smallest effective mass alone; zero if no
/// limit is known.
double step_over_limit(const Scene& scene, const ContactRange& range) {
  const auto limit = step_limit({{range.highest_frequency, range.damping_ratio}}, name(scene.integrator));
  return limit && !chooses_steps(scene.integrator) ? scene.plan.step / limit->step : 0.0;
}

/// SceneCheck::lighter.
std::vector<ContactRange> lighter_contacts(const Scene& scene, const Dynamics& dynamics, const StepAdvice& advice) {
  std::vector<ContactRange> lighter;
  std::size_t instance = 0;
  for (const ContactRange& range : contact_ranges(dynamics)) {
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < dynamics.layout().contact_instances[index(range.contact)]; ++i)
      minimum = std::min(minimum, advice.springs[instance++].spring.effective_mass);
    if (range.smallest_mass < 0.99 * minimum) lighter.push_back(range);
  }
  std::ranges::stable_sort(lighter, {}, &ContactRange::shortest_time);
  const auto worst =
      std::ranges::max_element(lighter, {}, [&](const ContactRange& range) { return step_over_limit(scene, range); });
  if (worst != lighter.end()) std::rotate(lighter.begin(), worst, worst + 1);
  return lighter;
}

/// Adds the warning about a step that is within its linear limit at the start, but not for a contact with its smallest
/// effective mass: the first of `lighter`.
void warn_of_lighter_contacts(const Scene& scene, const std::vector<ContactRange>& lighter,
                              std::vector<std::string>& warnings) {
  if (lighter.empty() || !(step_over_limit(scene, lighter.front()) > 1.0)) return;
  const ContactRange& worst = lighter.front();
  warnings.push_back(fmt::format(
      "contact '{}' can act with an effective mass of {:.4g} {}, less than at the start: the step is then {:.3g} times "
      "the linear limit of {}",
      scene.model.contacts[index(worst.contact)].name, worst.smallest_mass, symbol(scene.model.units, dimension::mass),
      step_over_limit(scene, worst), name(scene.integrator)));
}

/// Adds the warning that a run prints about its step, if the step is beyond the linear limit. Returns whether it is.
bool warn_of_step(const Scene& scene, const StepAdvice& advice, const std::string& command,
                  std::vector<std::string>& warnings) {
  const auto verdict = step_verdict(scene, advice);
  if (!verdict || !verdict->is_beyond) return false;
  warnings.push_back(step_warning(verdict->text, command));
  if (scene.initial.q.size() > maximum_watched_coordinates) {
    warnings.push_back(
        fmt::format("talus run does not give that warning: it computes frequencies up to {} degrees of "
                    "freedom, here are {}",
                    maximum_watched_coordinates, scene.initial.q.size()));
  }
  return true;
}

}  // namespace

SceneCheck check_scene(const SceneFile& file, const Dynamics& dynamics, const std::string& command) {
  const Scene& scene = file.scene;
  SceneCheck found;
  bool is_beyond = false;
  if (scene.initial.q.size() <= maximum_checked_coordinates) {
    const StepAdvice& advice = found.advice.emplace(advise_step(dynamics, scene.initial));
    found.lighter = lighter_contacts(scene, dynamics, advice);
    found.limit = step_limit(advice.modes, name(scene.integrator));
    found.shortest_contact = advice.shortest_contact;
    for (const ContactRange& range : found.lighter)
      found.shortest_contact = std::min(found.shortest_contact, range.shortest_time);
    is_beyond = warn_of_step(scene, advice, command, found.warnings);
    if (!is_beyond) warn_of_lighter_contacts(scene, found.lighter, found.warnings);
  }
  const std::vector<std::string> missing = missing_contact_warnings(scene, dynamics);
  for (const auto& more : {start_warnings(file, dynamics), missing, geometry_warnings(file)})
    found.warnings.insert(found.warnings.end(), more.begin(), more.end());
  const MonitorRules& rules = scene.plan.watch;
  found.is_unusable = (is_beyond && rules.quality == CheckAction::error) ||
                      (!missing.empty() && rules.missing_contacts == CheckAction::error);
  return found;
}

}  // namespace talus::app
