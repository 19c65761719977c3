#include "solver/app/calibration/range_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/law_options.hpp"
#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/calibrate/impact_range.hpp"
#include "solver/draw/range_drawing.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

constexpr int maximum_on_axis = 100;

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

  const CommonDissipation& used() const { return given ? *given : minimax; }
  LawParameter dissipation() const { return dissipation_of(law); }
};

/// The numbers of an axis: FIRST LAST COUNT.
std::vector<double> axis_of(const std::string& option, const std::vector<std::string>& texts, Dimension dimension) {
  const double first = option_quantity(option, texts[0], dimension, si);
  const double last = option_quantity(option, texts[1], dimension, si);
  if (!(first < last)) {
    throw InputError{
        fmt::format("{}: found \"{}\" and \"{}\"; the first must be less than the second", option, texts[0], texts[1])};
  }
  int count = 0;
  const std::string& text = texts[2];
  const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || count < 2 || count > maximum_on_axis) {
    throw InputError{
        fmt::format("{}: found \"{}\"; the count must be a whole number from 2 to {}", option, text, maximum_on_axis)};
  }
  return log_spaced(first, last, count);
}

/// All pairs of a radius and a speed; without one of the axes, those of the other.
GivenPairs pairs_of_axes(const CalibrateOptions& options) {
  std::vector<double> radii, speeds;
  if (!options.radii.empty()) radii = axis_of("--radii", options.radii, dimension::length);
  if (!options.speeds.empty()) speeds = axis_of("--speeds", options.speeds, dimension::velocity);
  QuantityColumn radius{"sphere_radius", dimension::length}, speed{"speed", dimension::velocity};
  for (std::size_t i = 0; i < std::max<std::size_t>(radii.size(), 1); ++i) {
    for (std::size_t j = 0; j < std::max<std::size_t>(speeds.size(), 1); ++j) {
      if (!radii.empty()) radius.values.push_back(radii[i]);
      if (!speeds.empty()) speed.values.push_back(speeds[j]);
    }
  }
  GivenPairs pairs;
  pairs.rows = std::max(radius.values.size(), speed.values.size());
  for (QuantityColumn* column : {&radius, &speed})
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
        "{}: column 'mass_2': it is missing; a single mass is that of body 2, and body 1 is fixed", options.pairs)};
  }
  return pairs;
}

/// Errors: InputError for options that the range replaces, or that belong to a single pair.
void refuse_replaced(const CalibrateOptions& options, const GivenPairs& pairs) {
  for (const std::string& given : options.own_to_impact) {
    if (given == "--bound" || given == "--integrator")
      throw InputError{fmt::format("{}: no step is found for several pairs; remove it", given)};
    if (given == "--speed" && pairs.has("speed"))
      throw InputError{fmt::format("{}: each pair gives its own; remove it", given)};
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
    if (options.masses.empty())
      throw InputError{"--masses: it is missing; give one or two, e.g. --masses \"2 kg\" \"1 kg\""};
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
  if (!options.restitution) throw InputError{"--restitution: it is missing; give e.g. --restitution 0.7"};
  const GivenPairs given = options.pairs.empty() ? pairs_of_axes(options) : pairs_of_file(options);
  refuse_replaced(options, given);
  RangeCalibration found;
  found.wanted = *options.restitution;
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

  found.table = given.columns;
  found.table.push_back(masses);
  found.abscissae = found.table.size();
  QuantityColumn restitution{"restitution", dimension::number}, deviation{"deviation", dimension::number};
  for (const ImpactingPair& pair : pairs) {
    restitution.values.push_back(restitution_with(pair, found.used().value));
    deviation.values.push_back(restitution.values.back() - found.wanted);
  }
  for (QuantityColumn* column : {&exact, &restitution, &deviation})
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
  json["pairs"] = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < found.table.front().values.size(); ++row) {
    nlohmann::ordered_json pair;
    for (const QuantityColumn& column : found.table)
      pair[column.name] = column.values[row];
    json["pairs"].push_back(std::move(pair));
  }
  json["units"] = "SI";
  fmt::print("{}\n", json.dump(2));
}

void print_table(const std::vector<QuantityColumn>& table, const UnitSystem& units) {
  std::vector<std::size_t> widths;
  const auto print_row = [&](const auto& text) {
    for (std::size_t i = 0; i < table.size(); ++i)
      fmt::print("{:>{}}", text(table[i]), widths[i]);
    fmt::print("\n");
  };
  for (const QuantityColumn& column : table)
    widths.push_back(std::max<std::size_t>(column.name.size(), 12) + 2);
  print_row([](const QuantityColumn& column) { return column.name; });
  print_row([&](const QuantityColumn& column) { return symbol(units, column.dimension); });
  for (std::size_t row = 0; row < table.front().values.size(); ++row) {
    print_row([&](const QuantityColumn& column) {
      return fmt::format("{:.6g}", column.values[row] / si_size(units, column.dimension));
    });
  }
}

void print_text(const RangeCalibration& found, const UnitSystem& units) {
  const LawParameter dissipation = found.dissipation();
  const std::string unit = symbol(units, dissipation.dimension);
  const double size = si_size(units, dissipation.dimension);
  const std::size_t pairs = found.table.front().values.size();
  fmt::print("one {} for a restitution of {} of {} pair{} ({})\n", dissipation.name, found.wanted, pairs,
             pairs == 1 ? "" : "s", law_text(found.law));
  print_table(found.table, units);
  const auto line = [&](const std::string& what, const CommonDissipation& common) {
    fmt::print("  {:<32}{:>16.9g} {}: the restitutions deviate by at most {:.6g}\n", what, common.value / size, unit,
               common.largest_deviation);
  };
  if (found.given) line(dissipation.name + ", as given", *found.given);
  line(dissipation.name + ", minimax", found.minimax);
  if (std::ranges::find(found.table[found.abscissae + 1].values, 0.0) != found.table[found.abscissae + 1].values.end())
    fmt::print("  a restitution of 0: the contact does not end\n");
  fmt::print("in a scene, for all these pairs:\n  {} = \"{:.17g} {}\"\n", dissipation.name, found.used().value / size,
             unit);
  if (restitution_varies(found.law)) {
    fmt::print("for every impact at the speed restitution_speed: restitution = {} in place of {}\n", found.wanted,
               dissipation.name);
  } else {
    fmt::print("for every impact, whatever the bodies and the speed: restitution = {} in place of {}\n", found.wanted,
               dissipation.name);
  }
}

/// Writes the table, and requests its drawing.
void write_files(const RangeCalibration& found, const CalibrateOptions& options, const UnitSystem& units,
                 const DrawingSink& sink) {
  const fs::path folder{options.picture.folder};
  make_folder(folder);
  const FolderLock lock{folder};
  write_whole(folder / "calibration.csv", quantity_csv(found.table, units));
  if (!options.json) fmt::print("{}\n", (folder / "calibration.csv").string());
  const LawParameter dissipation = found.dissipation();
  const std::string title =
      fmt::format("{}, {} = {:.4g} {}", law_text(found.law), dissipation.name,
                  found.used().value / si_size(units, dissipation.dimension), symbol(units, dissipation.dimension));
  const DrawnRange range{std::span{found.table}.first(found.abscissae), found.table[found.abscissae + 1].values,
                         found.wanted, found.used().largest_deviation};
  DrawingRequest request = range_drawing(range, title, units, options.picture);
  request.lists_files = !options.json;
  sink(std::move(request));
}

}  // namespace

bool gives_range(const CalibrateOptions& options) {
  return !options.speeds.empty() || !options.radii.empty() || !options.pairs.empty();
}

int calibrate_range(const CalibrateOptions& options, const DrawingSink& sink) {
  const UnitSystem units = unit_system(options.units);
  const RangeCalibration found = calibrated_range(options);
  if (options.json) {
    print_json(found, options);
  } else {
    print_text(found, units);
  }
  if (!options.picture.folder.empty()) write_files(found, options, units, sink);
  return ok;
}

}  // namespace talus::app
