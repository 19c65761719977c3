#include "solver/app/calibration/range_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/law_options.hpp"
#include "solver/app/calibration/range_table.hpp"
#include "solver/app/calibration/rayleigh_times.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/calibrate/impact_range.hpp"
#include "solver/draw/range_drawing.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/parameter.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {
namespace {

/// A range as the options give it, in SI units: one row for each pair.
struct GivenPairs {
  std::vector<QuantityColumn> columns;
  std::size_t rows{};

  const QuantityColumn* find(std::string_view name) const {
    const auto found = std::ranges::find(columns, name, &QuantityColumn::name);
    return found == columns.end() ? nullptr : &*found;
  }
  bool has(std::string_view name) const { return find(name) != nullptr; }
};

/// A parameter with the largest deviation of the restitutions that it gives the pairs.
struct CommonDissipation {
  double value{};
  double largest_deviation{};
};

/// Result of the calibration, in SI units.
struct RangeCalibration {
  ContactLaw law;                     ///< with the parameters of the options
  std::vector<QuantityColumn> table;  ///< columns as given, effective mass, and results
  std::size_t abscissae{};            ///< number of the columns before the results
  std::vector<std::string> of_pairs;  ///< parameters of the law that differ from pair to pair
  double wanted{};
  CommonDissipation minimax;
  std::optional<CommonDissipation> given;
  double undamped_time{};         ///< shortest contact time of the pairs without dashpot
  std::optional<RangeStep> step;  ///< none if no contact ends
  std::optional<RayleighTime> rayleigh;

  const CommonDissipation& used() const { return given ? *given : minimax; }
  LawParameter dissipation() const { return dissipation_of(law); }
};

/// All pairs of a radius or a mass, and a speed; without one of the axes, those of the other.
GivenPairs pairs_of_axes(const CalibrateOptions& options) {
  const bool has_masses = gives_mass_axis(options);
  std::vector<double> bodies, speeds;
  if (has_masses) bodies = axis_of("--masses", options.masses, dimension::mass, Spacing::logarithmic);
  if (!options.radii.empty()) bodies = axis_of("--radii", options.radii, dimension::length, Spacing::logarithmic);
  if (!options.speeds.empty()) speeds = axis_of("--speeds", options.speeds, dimension::velocity, Spacing::logarithmic);
  QuantityColumn body = has_masses ? QuantityColumn{"mass_2", dimension::mass}
                                   : QuantityColumn{"sphere_radius", dimension::length},
                 speed{"speed", dimension::velocity};
  for (std::size_t i = 0; i < std::max<std::size_t>(bodies.size(), 1); ++i) {
    for (std::size_t j = 0; j < std::max<std::size_t>(speeds.size(), 1); ++j) {
      if (!bodies.empty()) body.values.push_back(bodies[i]);
      if (!speeds.empty()) speed.values.push_back(speeds[j]);
    }
  }
  GivenPairs pairs;
  pairs.rows = std::max(body.values.size(), speed.values.size());
  for (QuantityColumn* column : {&body, &speed})
    if (!column->values.empty()) pairs.columns.push_back(std::move(*column));
  return pairs;
}

/// The pairs of a file: mass_1, mass_2, speed, and the parameters of the law but for the one that dissipates.
GivenPairs pairs_of_file(const CalibrateOptions& options) {
  std::vector<AllowedColumn> allowed{{"mass_1", dimension::mass, Range::positive},
                                     {"mass_2", dimension::mass, Range::positive},
                                     {"speed", dimension::velocity, Range::positive}};
  for (const LawParameter& parameter : parameters_of(law_named(options.law)))
    if (!parameter.is_dissipation) allowed.push_back({parameter.name, parameter.dimension, parameter.range});
  GivenPairs pairs{read_quantity_table(options.pairs, allowed, si)};
  pairs.rows = pairs.columns.front().values.size();
  if (pairs.has("mass_1") && !pairs.has("mass_2")) {
    throw InputError{fmt::format(
        "{}: column 'mass_2': it is missing; a single mass is that of body 2, and body 1 is fixed; give it as mass_2",
        options.pairs)};
  }
  return pairs;
}

/// Errors: InputError for options that the range replaces, or that belong to a single pair.
void refuse_replaced(const CalibrateOptions& options, const GivenPairs& pairs) {
  for (const std::string& given : options.own_to_impact) {
    if (given == "--speed" && pairs.has("speed"))
      throw InputError{fmt::format("{}: each pair gives its own; remove it", given)};
  }
  if (!options.spheres.empty() &&
      (gives_mass_axis(options) || pairs.has("sphere_radius") || pairs.has("mass_2") || pairs.has("radius")))
    throw InputError{"--spheres: each pair gives its own bodies; remove it"};
  if (!options.spheres.empty() && (!options.pivot.empty() || !options.offset.empty()))
    throw InputError{spheres_are_central};
  if (gives_mass_axis(options)) {
    if (!options.radii.empty() || !options.pairs.empty()) {
      throw InputError{fmt::format("--masses: found three values, an axis of masses, and {}; give one of the two",
                                   options.radii.empty() ? "--pairs" : "--radii")};
    }
    if (!options.pivot.empty() || !options.offset.empty())
      throw InputError{"--pivot and --offset: bodies of an axis of masses are hit centrally; remove them"};
    return;
  }
  if (!pairs.has("sphere_radius") && !pairs.has("mass_2")) return;
  if (!options.masses.empty() || !options.pivot.empty() || !options.offset.empty())
    throw InputError{"--masses, --pivot and --offset: each pair gives its own; remove them"};
}

/// The effective masses of the pairs.
QuantityColumn effective_masses(const CalibrateOptions& options, const GivenPairs& pairs) {
  QuantityColumn column{"effective_mass", dimension::mass};
  const QuantityColumn *radius = pairs.find("sphere_radius"), *first = pairs.find("mass_1"),
                       *second = pairs.find("mass_2");
  if (radius == nullptr && second == nullptr) {
    demand_masses(options);
    column.values.assign(pairs.rows, effective_mass_of(options));
    return column;
  }
  for (std::size_t i = 0; i < pairs.rows; ++i) {
    if (radius != nullptr) {
      const double density = option_quantity("--density", options.density, dimension::density, si);
      column.values.push_back(EqualSpheres{radius->values[i], density}.effective_mass());
    } else if (first != nullptr) {
      column.values.push_back(effective_mass({first->values[i], {}, 0.0, false}, {second->values[i], {}, 0.0, false}));
    } else {
      column.values.push_back(second->values[i]);
    }
  }
  return column;
}

/// The spheres of one pair: of --radii, or those of --spheres, which all pairs share.
std::vector<Sphere> spheres_of(const CalibrateOptions& options, const GivenPairs& pairs, std::size_t row) {
  if (!options.spheres.empty()) return app::spheres_of(round_bodies(options));
  const QuantityColumn* const radii = pairs.find("sphere_radius");
  if (radii == nullptr) return {};
  return {{option_quantity("--density", options.density, dimension::density, si), radii->values[row]}};
}

/// The law of one pair.
ContactLaw law_of_pair(ContactLaw law, const GivenPairs& pairs, std::size_t row) {
  for (const LawParameter& parameter : parameters_of(law)) {
    if (const QuantityColumn* column = pairs.find(parameter.name))
      set_parameter(law, parameter.name, column->values[row]);
    if (const QuantityColumn* radius = pairs.find("sphere_radius"); radius != nullptr && parameter.name == "radius")
      set_parameter(law, parameter.name, EqualSpheres{radius->values[row], 1.0}.effective_radius());
  }
  return law;
}

RangeCalibration calibrated_range(const CalibrateOptions& options) {
  const ElapsedTime elapsed{"calibrating"};
  RangeCalibration found;
  found.wanted = demanded_restitution(options);
  const GivenPairs given = options.pairs.empty() ? pairs_of_axes(options) : pairs_of_file(options);
  refuse_replaced(options, given);
  for (const LawParameter& parameter : parameters_of(law_named(options.law))) {
    const bool is_of_spheres = given.has("sphere_radius") && parameter.name == "radius";
    if (given.has(parameter.name) || is_of_spheres) found.of_pairs.push_back(parameter.name);
  }
  found.law = law_of_options(options, found.of_pairs);
  const QuantityColumn masses = effective_masses(options, given);
  const QuantityColumn* speeds = given.find("speed");
  const double speed = option_quantity("--speed", options.speed, dimension::velocity, si);
  std::vector<ImpactingPair> pairs;
  for (std::size_t i = 0; i < given.rows; ++i) {
    pairs.push_back(
        {law_of_pair(found.law, given, i), masses.values[i], speeds == nullptr ? speed : speeds->values[i]});
    const auto rayleigh = rayleigh_time(options, pairs.back().law, {}, spheres_of(options, given, i));
    if (rayleigh && !(found.rayleigh && found.rayleigh->shortest <= rayleigh->shortest)) found.rayleigh = rayleigh;
  }
  const auto common = [&](double value) {
    return CommonDissipation{value, largest_deviation(pairs, value, found.wanted)};
  };
  const LawParameter dissipation = found.dissipation();
  QuantityColumn exact{"exact_" + dissipation.name, dissipation.dimension};
  for (const ImpactingPair& pair : pairs)
    exact.values.push_back(exact_dissipation(pair, found.wanted));
  found.minimax = common(minimax_dissipation(pairs, exact.values, found.wanted));
  if (gives_dissipation(options, found.law)) found.given = common(dissipation.value);
  found.step = advise_range_step(pairs, found.used().value, options.bound, make_integrator(options.integrator));

  found.table = given.columns;
  found.table.push_back(masses);
  found.abscissae = found.table.size();
  QuantityColumn restitution{"restitution", dimension::number}, deviation{"deviation", dimension::number};
  for (const ImpactingPair& pair : pairs) {
    restitution.values.push_back(restitution_with(pair, found.used().value));
    deviation.values.push_back(restitution.values.back() - found.wanted);
  }
  QuantityColumn undamped{"undamped_contact_time", dimension::time};
  for (const ImpactingPair& pair : pairs)
    undamped.values.push_back(
        known_impact(with_dissipation(pair.law, 0.0), pair.effective_mass, pair.speed).contact_time);
  found.undamped_time = std::ranges::min(undamped.values);
  for (QuantityColumn* column : {&exact, &restitution, &deviation, &undamped})
    found.table.push_back(std::move(*column));
  return found;
}

/// Whether all pairs of the options have this parameter in common.
bool is_common(const RangeCalibration& found, const LawParameter& parameter) {
  return !parameter.is_dissipation && std::ranges::find(found.of_pairs, parameter.name) == found.of_pairs.end();
}

void print_json(const RangeCalibration& found, const CalibrateOptions& options) {
  const std::string name = found.dissipation().name;
  nlohmann::ordered_json json{{"law", options.law}};
  for (const LawParameter& parameter : parameters_of(found.law))
    if (is_common(found, parameter)) json[parameter.name] = parameter.value;
  for (const auto& [choice, value] : choices_of(found.law))
    json[choice] = value;
  json["wanted_restitution"] = found.wanted;
  json[name] = found.used().value;
  json["largest_deviation"] = found.used().largest_deviation;
  json["minimax_" + name] = found.minimax.value;
  json["minimax_deviation"] = found.minimax.largest_deviation;
  json["shortest_undamped_contact_time"] = found.undamped_time;
  if (found.step) {
    json["step"] = found.step->step;
    json["step_row"] = found.step->pair + 1;
    json["restitution_error"] = found.step->largest_error;
  } else {
    json["step"] = nullptr;
    json["step_row"] = nullptr;
    json["restitution_error"] = nullptr;
  }
  add_rayleigh_time(json, found.rayleigh);
  json["pairs"] = rows_of(found.table);
  json["units"] = "SI";
  fmt::print("{}\n", json.dump(2));
}

/// The step for all pairs, as a text.
void print_step(const RangeCalibration& found, const CalibrateOptions& options, const UnitSystem& units) {
  const ValueLines line{39, units};
  line("shortest undamped contact time", found.undamped_time, dimension::time);
  if (!found.step) return print_rayleigh_time(found.rayleigh, {}, line);
  line("step for all pairs", found.step->step, dimension::time);
  line("step over shortest undamped contact time", found.step->step / found.undamped_time, dimension::number);
  print_rayleigh_time(found.rayleigh, found.step->step, line);
  fmt::print(
      "  with {}; row {} requires it; the error of the restitutions over all phases of the step is at most {:.3g}, "
      "required {:.3g}\n",
      options.integrator, found.step->pair + 1, found.step->largest_error, options.bound);
}

void print_text(const RangeCalibration& found, const CalibrateOptions& options, const UnitSystem& units) {
  const LawParameter dissipation = found.dissipation();
  const std::string unit = symbol(units, dissipation.dimension);
  const double size = si_size(units, dissipation.dimension);
  const std::size_t pairs = found.table.front().values.size();
  fmt::print("one {} for a restitution of {} of {} pair{} ({})\n", dissipation.name, found.wanted, pairs,
             pairs == 1 ? "" : "s", law_text(found.law));
  print_table(found.table, units);
  const auto line = [&](const std::string& what, const CommonDissipation& common) {
    fmt::print("{}: the restitutions deviate by at most {:.6g}\n", value_line(32, what, common.value / size, unit),
               common.largest_deviation);
  };
  if (found.given) line(dissipation.name + ", as given", *found.given);
  line(dissipation.name + ", minimax", found.minimax);
  if (std::ranges::find(found.table[found.abscissae + 1].values, 0.0) != found.table[found.abscissae + 1].values.end())
    fmt::print("  a restitution of 0: the contact does not end\n");
  print_step(found, options, units);
  fmt::print("in a scene, for all these pairs:\n{}",
             scene_lines(with_dissipation(found.law, found.used().value), units, found.of_pairs));
  if (restitution_varies(found.law)) {
    fmt::print("for every impact at one speed: restitution = {} and restitution_speed, that speed, in place of {}\n",
               found.wanted, dissipation.name);
  } else {
    fmt::print("for every impact, whatever the bodies and the speed: restitution = {} in place of {}\n", found.wanted,
               dissipation.name);
  }
}

/// Writes the table, and requests its drawing.
void write_files(const RangeCalibration& found, const CalibrateOptions& options, const UnitSystem& units,
                 const DrawingSink& sink) {
  const LawParameter dissipation = found.dissipation();
  const std::string title =
      fmt::format("{}, {} = {:.4g} {}", law_text(found.law), dissipation.name,
                  found.used().value / si_size(units, dissipation.dimension), symbol(units, dissipation.dimension));
  const DrawnRange range{std::span{found.table}.first(found.abscissae), found.table[found.abscissae + 1].values,
                         found.wanted, found.used().largest_deviation};
  write_table(found.table, options, units, range_drawing(range, title, units, options.picture), sink);
}

}  // namespace

bool gives_mass_axis(const CalibrateOptions& options) { return options.masses.size() == 3; }

bool gives_range(const CalibrateOptions& options) {
  return gives_mass_axis(options) || !options.speeds.empty() || !options.radii.empty() || !options.pairs.empty();
}

int calibrate_range(const CalibrateOptions& options, const DrawingSink& sink) {
  return report(calibrated_range, options, sink);
}

}  // namespace talus::app
