#include "solver/app/calibration/oblique_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "solver/app/calibration/friction_options.hpp"
#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/impact_calibration.hpp"
#include "solver/app/calibration/law_options.hpp"
#include "solver/app/calibration/range_table.hpp"
#include "solver/app/calibration/rayleigh_times.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/calibrate/oblique_impact.hpp"
#include "solver/draw/range_drawing.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/parameter.hpp"

namespace talus::app {
namespace {

/// Result of the calibration; all values in SI units.
struct ObliqueCalibration {
  ObliqueImpact impact;                   ///< at --angle, or along the normal where it is absent
  std::string sought;                     ///< parameter of the friction that was found; empty: none
  std::optional<ObliqueRebound> rebound;  ///< at --angle
  std::vector<QuantityColumn> table;      ///< at --angles; may be empty
  /// Shortest contact time of these impacts without dashpot.
  double undamped_time{std::numeric_limits<double>::infinity()};
  StepOfImpact step;
  std::optional<RayleighTime> rayleigh;
};

/// Errors: InputError for options that oblique impacts do not use.
void refuse_others(const CalibrateOptions& options) {
  if (!options.pivot.empty() || !options.offset.empty())
    throw InputError{"--pivot and --offset: the bodies of an oblique impact are free and hit centrally; remove them"};
  if (options.angle.empty() && options.tangential_restitution)
    throw InputError{"--angle: it is missing; give the angle of --tangential-restitution, e.g. --angle \"10 deg\""};
  if (options.angles.empty() && !options.picture.folder.empty())
    throw InputError{"--out: only the table of several angles is written to files; give --angles"};
  if (const auto& e = options.tangential_restitution; e && !(*e > -1.0 && *e < 1.0))
    throw InputError{fmt::format("--tangential-restitution: found {}; it must be in (-1, 1)", *e)};
}

double checked_angle(const std::string& option, double angle) {
  if (angle > 0.0 && angle < 0.5 * std::numbers::pi) return angle;
  throw InputError{
      fmt::format("{}: found {:.6g} deg; it must be in (0, 90) deg", option, angle * 180.0 / std::numbers::pi)};
}

/// The table of the rebounds, and the step for all.
void add_angles(ObliqueCalibration& found, const std::vector<double>& angles, CommonStep& step,
                const Integrator& integrator) {
  QuantityColumn angle{"angle", dimension::angle}, approach{"approach_speed", dimension::velocity},
      time{"contact_time", dimension::time}, normal{"restitution", dimension::number},
      tangential{"tangential_restitution", dimension::number}, rotational{"rotational_restitution", dimension::number},
      rebound_angle{"rebound_angle", dimension::angle}, spin{"spin", dimension::angular_velocity},
      sticking{"sticking", dimension::number};
  for (const double each : angles) {
    ObliqueImpact impact = found.impact;
    impact.angle = each;
    const ObliqueRebound rebound = talus::rebound(impact);
    const double m = impact.effective_mass(), v = impact.approach_speed();
    angle.values.push_back(each), approach.values.push_back(v);
    time.values.push_back(known_impact(impact.law, m, v).contact_time);
    normal.values.push_back(rebound.restitution);
    tangential.values.push_back(rebound.tangential_restitution);
    rotational.values.push_back(rebound.rotational_restitution);
    rebound_angle.values.push_back(rebound.angle), spin.values.push_back(rebound.spin);
    sticking.values.push_back(rebound.sticking);
    static_cast<void>(step.require(rebound_error(impact, integrator), time.values.back()));
    found.undamped_time =
        std::min(found.undamped_time, known_impact(with_dissipation(impact.law, 0.0), m, v).contact_time);
  }
  found.table = {angle, approach, time, normal, tangential, rotational, rebound_angle, spin, sticking};
}

ObliqueCalibration calibrated_oblique(const CalibrateOptions& options) {
  const ElapsedTime elapsed{"calibrating"};
  refuse_others(options);
  std::vector<double> angles;
  if (!options.angles.empty()) angles = axis_of("--angles", options.angles, dimension::angle, Spacing::even);
  for (const double angle : angles)
    static_cast<void>(checked_angle("--angles", angle));
  static_cast<void>(poisson_ratio_of(options, !options.spheres.empty()));
  ObliqueCalibration found;
  ObliqueImpact& impact = found.impact;
  const std::vector<RoundBody> bodies = round_bodies(options);
  impact.second = bodies.back();
  if (bodies.size() == 2) impact.first = bodies.front();
  impact.speed = option_quantity("--speed", options.speed, dimension::velocity, si);
  if (!options.angle.empty())
    impact.angle = checked_angle("--angle", option_quantity("--angle", options.angle, dimension::angle, si, false));
  impact.law = damped_law(options, law_of_options(options), impact.effective_mass(), impact.approach_speed());
  const GivenFriction friction = friction_of_options(options, impact.law);
  impact.friction = friction.law, found.sought = friction.sought;
  const Integrator integrator = make_integrator(options.integrator);
  if (!found.sought.empty()) {
    try {
      const TangentialCalibration calibration =
          calibrate_tangential(impact, found.sought, *options.tangential_restitution);
      set_parameter(impact.friction, found.sought, calibration.value);
    } catch (const InputError& error) {
      throw InputError{fmt::format("--tangential-restitution: {}", error.what())};
    }
  }
  impact.friction = with_explicit_dashpot(impact.friction, impact.law);
  CommonStep step{options.bound};
  if (!options.angle.empty()) {
    const double m = impact.effective_mass(), v = impact.approach_speed();
    found.undamped_time = known_impact(with_dissipation(impact.law, 0.0), m, v).contact_time;
    found.rebound = rebound(impact);
    static_cast<void>(step.require(rebound_error(impact, integrator), known_impact(impact.law, m, v).contact_time));
  }
  if (!angles.empty()) add_angles(found, angles, step, integrator);
  found.step = step.found();
  if (!options.spheres.empty())
    found.rayleigh = rayleigh_time(options, impact.law, impact.friction, spheres_of(bodies));
  return found;
}

void print_json(const ObliqueCalibration& found, const CalibrateOptions& options) {
  const ObliqueImpact& impact = found.impact;
  nlohmann::ordered_json json{{"law", options.law}};
  for (const LawParameter& parameter : parameters_of(impact.law))
    json[parameter.name] = parameter.value;
  for (const auto& [name, value] : choices_of(impact.law))
    json[name] = value;
  json["shear_law"] = friction_name(impact.friction);
  for (const LawParameter& parameter : parameters_of(impact.friction))
    json[parameter.name] = parameter.value;
  if (!found.sought.empty()) json["found"] = found.sought;
  json["effective_mass"] = impact.effective_mass();
  json["mobility"] = impact.mobility();
  json["speed"] = impact.speed;
  if (const auto& rebound = found.rebound) {
    const KnownImpact known = known_impact(impact.law, impact.effective_mass(), impact.approach_speed());
    json["angle"] = impact.angle;
    json["approach_speed"] = impact.approach_speed();
    json["contact_time"] = known.contact_time;
    json["largest_overlap"] = known.largest_overlap;
    json["stiffness_ratio"] = stiffness_ratio(impact.friction, impact.law, known.largest_overlap);
    json["restitution"] = rebound->restitution;
    json["tangential_restitution"] = rebound->tangential_restitution;
    json["rotational_restitution"] = rebound->rotational_restitution;
    json["rebound_angle"] = rebound->angle;
    json["spin"] = rebound->spin;
    json["sticking"] = rebound->sticking;
  }
  if (!found.table.empty()) json["angles"] = rows_of(found.table);
  json["shortest_undamped_contact_time"] = found.undamped_time;
  json["step"] = found.step.step;
  json["restitution_error"] = found.step.largest_error;
  add_rayleigh_time(json, found.rayleigh);
  json["units"] = "SI";
  fmt::print("{}\n", json.dump(2));
}

void print_rebound(const ObliqueCalibration& found, const ValueLines& line) {
  const ObliqueImpact& impact = found.impact;
  const KnownImpact known = known_impact(impact.law, impact.effective_mass(), impact.approach_speed());
  line("angle of the impact, from the normal", impact.angle, dimension::angle);
  line("speed of approach", impact.approach_speed(), dimension::velocity);
  line("contact time", known.contact_time, dimension::time);
  line("largest overlap", known.largest_overlap, dimension::length);
  line("tangential over normal stiffness", stiffness_ratio(impact.friction, impact.law, known.largest_overlap),
       dimension::number);
  line("restitution", found.rebound->restitution, dimension::number);
  line("tangential restitution", found.rebound->tangential_restitution, dimension::number);
  line("rotational restitution", found.rebound->rotational_restitution, dimension::number);
  line("angle of the rebound", found.rebound->angle, dimension::angle);
  line("spin of body 2", found.rebound->spin, dimension::angular_velocity);
  line("sticking fraction of the contact time", found.rebound->sticking, dimension::number);
}

/// The lines of the contact in a scene.
void print_scene_lines(const ObliqueImpact& impact, const CalibrateOptions& options, const UnitSystem& units) {
  fmt::print("in a scene, for these bodies:\n{}", scene_lines(impact.law, units));
  if (options.shear_law != CoulombFriction::name) fmt::print("  shear_law = \"{}\"\n", options.shear_law);
  for (const LawParameter& parameter : parameters_of(impact.friction))
    fmt::print("{}", scene_line(parameter, units));
}

void print_text(const ObliqueCalibration& found, const CalibrateOptions& options, const UnitSystem& units) {
  const ObliqueImpact& impact = found.impact;
  const ValueLines line{39, units};
  const std::string laws = fmt::format("{}; {} friction", law_text(impact.law), options.shear_law);
  if (!found.sought.empty()) {
    fmt::print("{} for a tangential restitution of {} ({})\n", found.sought, *options.tangential_restitution, laws);
  } else {
    fmt::print("oblique impact with friction ({})\n", laws);
  }
  fmt::print("{}", bodies_text(options, units));
  const std::string shape = options.discs.empty() ? "sphere" : "disc";
  if (impact.first) line("radius of body 1, " + shape, impact.first->radius, dimension::length);
  line("radius of body 2, " + shape, impact.second.radius, dimension::length);
  const LawParameter dissipation = dissipation_of(impact.law);
  line("effective mass", impact.effective_mass(), dimension::mass);
  line("mobility of the contact", impact.mobility(), dimension::number);
  line("speed", impact.speed, dimension::velocity);
  line(dissipation.name, dissipation.value, dissipation.dimension);
  for (const LawParameter& parameter : parameters_of(impact.friction))
    line(parameter.name, parameter.value, parameter.dimension);
  if (found.rebound) print_rebound(found, line);
  if (!found.table.empty()) print_table(found.table, units);
  line("shortest undamped contact time", found.undamped_time, dimension::time);
  line("step", found.step.step, dimension::time);
  line("step over undamped contact time", found.step.step / found.undamped_time, dimension::number);
  print_rayleigh_time(found.rayleigh, found.step.step, line);
  fmt::print(
      "  with {}; the errors of both restitutions over all phases of the step are at most {:.3g}, required {:.3g}\n",
      options.integrator, found.step.largest_error, options.bound);
  print_scene_lines(impact, options, units);
}

/// Writes the table, and requests its drawing.
void write_files(const ObliqueCalibration& found, const CalibrateOptions& options, const UnitSystem& units,
                 const DrawingSink& sink) {
  std::vector<QuantityColumn> drawn;
  for (const char* name : {"tangential_restitution", "rotational_restitution", "rebound_angle", "spin"})
    drawn.push_back(*std::ranges::find(found.table, name, &QuantityColumn::name));
  const std::string title = fmt::format("{}; {} friction {:.4g}", law_text(found.impact.law), options.shear_law,
                                        parameters_of(found.impact.friction).front().value);
  write_table(
      found.table, options, units,
      results_drawing(found.table.front(), drawn, options.tangential_restitution, title, units, options.picture), sink);
}

}  // namespace

int calibrate_oblique(const CalibrateOptions& options, const DrawingSink& sink) {
  return report(calibrated_oblique, options, sink);
}

}  // namespace talus::app
