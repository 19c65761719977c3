#include "solver/app/calibration/scene_calibration.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/app/calibration/law_options.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

ContactId contact_named(const Model& model, const std::string& name) {
  std::vector<std::string> known;
  for (const Contact& contact : model.contacts)
    known.push_back(contact.name);
  if (known.empty()) throw InputError{"--contact: the scene has no contact to calibrate"};
  if (name.empty()) throw unknown_name("--contact: contact", name, known);
  if (const auto found = find_contact(model, name)) return *found;
  throw unknown_name("--contact: contact", name, known);
}

/// Damping ratio of impacts on a contact's first law instance; none for laws of which an impact has none, or one that
/// depends on its speed.
std::optional<double> damping_ratio_of(const Scene& scene, ContactId contact) {
  const Dynamics dynamics{scene.model};
  const std::vector<std::size_t>& instances = dynamics.layout().contact_instances;
  const auto first = std::accumulate(instances.begin(), instances.begin() + static_cast<long>(index(contact)), 0UL);
  const double mass = advise_step(dynamics, scene.initial).springs[first].spring.effective_mass;
  return std::visit(
      [mass]<class L>(L law) -> std::optional<double> {
        if constexpr (HasDampingRatio<L>) {
          if (talus::restitution_varies(law)) return {};
          // The ratio is proportional to the dashpot: both are known for a restitution.
          constexpr double known = 0.5;
          const double damping = law.damping;
          law.set_restitution(known, mass, 1.0);
          const double known_damping = law.damping;
          law.set_every_restitution(known, 1.0);
          return law.damping_ratio * damping / known_damping;
        }
        return {};
      },
      scene.model.contacts[index(contact)].law);
}

/// The end rule of a law; empty for laws without one.
std::optional<EndRule> end_rule_of(const ContactLaw& contact_law) {
  return std::visit(
      []<class L>(const L& law) -> std::optional<EndRule> {
        if constexpr (HasEndRule<L>) return law.end_rule;
        return {};
      },
      contact_law);
}

/// Calibration of a contact of a scene, in the scene's units.
struct SceneCalibration {
  Calibration found;
  std::optional<double> damping_ratio;
  std::optional<EndRule> end_rule;
  bool is_of_speed{};     ///< the restitution depends on the speed
  std::string parameter;  ///< by which the law dissipates: damping or hysteresis
  Dimension dimension;    ///< of the parameter

  /// Steps of the scene from the last one before the contact to the first one after it.
  long contact_steps(const Scene& scene) const { return std::lround(found.impact.contact_time / scene.plan.step); }
};

SceneCalibration calibrated(const Scene& scene, ContactId contact, double restitution,
                            const std::function<void()>& progress = {}) {
  SceneCalibration result;
  result.found = calibrate(scene, contact, restitution, restitution_tolerance, progress);
  result.damping_ratio = damping_ratio_of(with_dissipation(scene, contact, result.found.dissipation), contact);
  const ContactLaw& law = scene.model.contacts[index(contact)].law;
  result.end_rule = end_rule_of(law);
  result.is_of_speed = restitution_varies(law);
  const LawParameter dissipation = dissipation_of(law);
  result.parameter = dissipation.name, result.dimension = dissipation.dimension;
  return result;
}

nlohmann::ordered_json json_of(const SceneCalibration& result, const Scene& scene, const std::string& contact) {
  const UnitSystem& units = scene.model.units;
  nlohmann::ordered_json json{
      {"contact", contact},
      {result.parameter, result.found.dissipation * si_size(units, result.dimension)},
      {"speed", result.found.impact.approach_speed * si_size(units, dimension::velocity)},
      {"contact_time", result.found.impact.contact_time},
      {"contact_steps", result.contact_steps(scene)},
      {"largest_overlap", result.found.impact.largest_overlap * si_size(units, dimension::length)},
      {"step", scene.plan.step},
      {"restitution", result.found.impact.restitution},
      {"runs", result.found.runs},
      {"units", "SI"}};
  if (result.damping_ratio) json["damping_ratio"] = *result.damping_ratio;
  if (result.end_rule) json["end_rule"] = name_of(*result.end_rule);
  return json;
}

void print_text(const SceneCalibration& result, const Scene& scene, const std::string& contact) {
  const UnitSystem& units = scene.model.units;
  const auto text = [&units](std::string_view what, double value, Dimension dimension) {
    return value_line(18, what, value, symbol(units, dimension));  // a value in units of the scene
  };
  const auto line = [&](std::string_view what, double value, Dimension dimension) {
    fmt::print("{}\n", text(what, value, dimension));
  };
  fmt::print("{}: contact '{}' calibrated by {} runs of the scene with {}\n", scene.title, contact, result.found.runs,
             name(scene.integrator));
  line(result.parameter == "damping" ? "damping c" : result.parameter, result.found.dissipation, result.dimension);
  if (result.damping_ratio) line("damping ratio xi", *result.damping_ratio, dimension::number);
  line("restitution", result.found.impact.restitution, dimension::number);
  line("speed of approach", result.found.impact.approach_speed, dimension::velocity);
  fmt::print("{}: {} steps, from the last one before the contact to the first one after it\n",
             text("contact time", result.found.impact.contact_time, dimension::time), result.contact_steps(scene));
  line("largest overlap", result.found.impact.largest_overlap, dimension::length);
  const std::string_view chosen = ": times at which the method gives states; it chooses shorter steps itself";
  fmt::print("{}, of the scene{}\n", text("step", scene.plan.step, dimension::time),
             chooses_steps(scene.integrator) ? chosen : "");
  if (result.is_of_speed) fmt::print("  the restitution holds at this speed: others are more or less elastic\n");
  fmt::print("in the scene:\n  {} = \"{} {}\"\n", result.parameter, result.found.dissipation,
             symbol(units, result.dimension));
  if (result.end_rule) fmt::print("  end_rule = \"{}\"\n", name_of(*result.end_rule));
}

}  // namespace

nlohmann::ordered_json scene_calibration(const Scene& scene, const std::string& contact, double restitution,
                                         const std::function<void()>& progress) {
  return json_of(calibrated(scene, contact_named(scene.model, contact), restitution, progress), scene, contact);
}

int calibrate_scene(const CalibrateOptions& options) {
  const Scene scene = read_scene(std::filesystem::path{options.scene});
  if (options.contact.empty()) throw InputError{"--contact: it is missing; name a contact of the scene"};
  const ContactId contact = contact_named(scene.model, options.contact);
  const SceneCalibration result = [&] {
    const ElapsedTime elapsed{"calibrating"};
    return calibrated(scene, contact, *options.restitution);
  }();
  if (options.json) {
    fmt::print("{}\n", json_of(result, scene, options.contact).dump(2));
  } else {
    print_text(result, scene, options.contact);
  }
  return ok;
}

}  // namespace talus::app
