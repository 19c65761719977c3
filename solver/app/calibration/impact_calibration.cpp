#include "solver/app/calibration/impact_calibration.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/impact_scene.hpp"
#include "solver/app/calibration/law_options.hpp"
#include "solver/app/calibration/rayleigh_times.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/calibrate/impact_range.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace {

/// Result of a calibration; all values in SI units.
struct ImpactCalibration {
  ContactLaw law;
  double effective_mass{};
  double speed{};
  double restitution{};  ///< requested, or in closed form
  KnownImpact known;
  double undamped_time{};  ///< contact time without the dashpot
  ImpactStep step;
  std::optional<RayleighTime> rayleigh;
};

ImpactCalibration calibrated(const CalibrateOptions& options) {
  ImpactCalibration found;
  const ContactLaw law = law_of_options(options);
  demand_masses(options);
  std::vector<Sphere> spheres;
  if (!options.spheres.empty()) {
    if (!options.pivot.empty() || !options.offset.empty()) throw InputError{spheres_are_central};
    spheres = spheres_of(round_bodies(options));
  }
  found.rayleigh = rayleigh_time(options, law, {}, spheres);
  found.effective_mass = effective_mass_of(options);
  found.speed = option_quantity("--speed", options.speed, dimension::velocity, si);
  found.law = damped_law(options, law, found.effective_mass, found.speed);
  found.known = known_impact(found.law, found.effective_mass, found.speed);
  found.undamped_time = known_impact(with_dissipation(found.law, 0.0), found.effective_mass, found.speed).contact_time;
  found.restitution = options.restitution.value_or(found.known.restitution);
  found.step = advise_impact_step(found.law, found.effective_mass, found.speed, options.bound,
                                  make_integrator(options.integrator));
  return found;
}

/// The damping ratio of the impact, for laws that have one.
std::optional<double> damping_ratio_of(const ImpactCalibration& found) {
  return std::visit(
      [&]<class L>(L law) -> std::optional<double> {
        if constexpr (HasDampingRatio<L>) {
          law.set_every_restitution(found.restitution, found.speed);
          return law.damping_ratio;
        }
        return {};
      },
      found.law);
}

nlohmann::ordered_json json_of(const ImpactCalibration& found, const CalibrateOptions& options) {
  nlohmann::ordered_json json{{"law", options.law}};
  for (const LawParameter& parameter : parameters_of(found.law))
    json[parameter.name] = parameter.value;
  for (const auto& [name, value] : choices_of(found.law))
    json[name] = value;
  if (const auto xi = damping_ratio_of(found)) json["damping_ratio"] = *xi;
  json["effective_mass"] = found.effective_mass;
  json["contact_time"] = found.known.contact_time;
  json["undamped_contact_time"] = found.undamped_time;
  json["speed"] = found.speed;
  json["largest_overlap"] = found.known.largest_overlap;
  json["exact_restitution"] = found.restitution;
  json["step"] = found.step.step;
  json["restitution"] = found.step.restitution;
  json["restitution_error"] = found.step.largest_error;
  add_rayleigh_time(json, found.rayleigh);
  json["units"] = "SI";
  return json;
}

void print_text(const ImpactCalibration& found, const CalibrateOptions& options) {
  const UnitSystem units = unit_system(options.units);
  const ValueLines line{32, units};
  const LawParameter dissipation = dissipation_of(found.law);
  if (options.restitution) {
    fmt::print("{} for a restitution of {} ({})\n", dissipation.name, *options.restitution, law_text(found.law));
  } else {
    fmt::print("restitution with this {} ({})\n", dissipation.name, law_text(found.law));
  }
  fmt::print("{}", bodies_text(options, units));
  line("effective mass", found.effective_mass, dimension::mass);
  line(dissipation.name == "damping" ? "damping c" : dissipation.name, dissipation.value, dissipation.dimension);
  if (const auto xi = damping_ratio_of(found)) line("damping ratio xi", *xi, dimension::number);
  line("restitution, exact", found.restitution, dimension::number);
  line("contact time", found.known.contact_time, dimension::time);
  line("undamped contact time", found.undamped_time, dimension::time);
  line("speed of approach", found.speed, dimension::velocity);
  line("largest overlap at that speed", found.known.largest_overlap, dimension::length);
  line("step", found.step.step, dimension::time);
  line("step over undamped contact time", found.step.step / found.undamped_time, dimension::number);
  print_rayleigh_time(found.rayleigh, found.step.step, line);
  line("restitution simulated with it", found.step.restitution, dimension::number);
  fmt::print("  simulated with {}; its error over all phases of the step is at most {:.3g}, required {:.3g}\n",
             options.integrator, found.step.largest_error, options.bound);
  if (restitution_varies(found.law))
    fmt::print("  the restitution holds at this speed: others are more or less elastic\n");
  fmt::print("in a scene, for these bodies and this line of impact:\n");
  fmt::print("{}", scene_lines(found.law, units));
  if (!options.restitution) return;
  const std::string at_speed =
      restitution_varies(found.law)
          ? fmt::format(", restitution_speed = \"{} {}\"", found.speed / si_size(units, dimension::velocity),
                        symbol(units, dimension::velocity))
          : "";
  fmt::print("for every impact, whatever the bodies: restitution = {}{} in place of {}\n", *options.restitution,
             at_speed, dissipation.name);
}

void write_scene(const ImpactCalibration& found, const CalibrateOptions& options) {
  const ImpactSceneRequest request{
      found.law,      found.speed, found.restitution, found.known.largest_overlap, found.known.contact_time,
      found.step.step};
  write_whole(options.written_scene, impact_scene(options, request, unit_system(options.units)));
  if (options.json) return;
  const std::filesystem::path file{options.written_scene};
  fmt::print("to check it by a run: talus run {} --impacts --out {}\n", shell_word(file.string()),
             shell_word((file.parent_path() / file.stem()).string()));
}

}  // namespace

ContactLaw damped_law(const CalibrateOptions& options, ContactLaw law, double effective_mass, double speed) {
  const bool is_given = gives_dissipation(options, law);
  if (is_given == options.restitution.has_value()) {
    throw InputError{fmt::format("--restitution: found {} of --restitution and {}; give one of the two",
                                 is_given ? "both" : "none", option_name(dissipation_of(law).name))};
  }
  if (is_given) return law;
  return with_dissipation(law, exact_dissipation({law, effective_mass, speed}, *options.restitution));
}

nlohmann::ordered_json impact_calibration(const CalibrateOptions& options) {
  return json_of(calibrated(options), options);
}

int calibrate_impact(const CalibrateOptions& options) {
  static_cast<void>(unit_system(options.units));
  const ImpactCalibration found = [&] {
    const ElapsedTime elapsed{"calibrating"};
    return calibrated(options);
  }();
  if (options.json) {
    fmt::print("{}\n", json_of(found, options).dump(2));
  } else {
    print_text(found, options);
  }
  if (!options.written_scene.empty()) write_scene(found, options);
  return ok;
}

}  // namespace talus::app
