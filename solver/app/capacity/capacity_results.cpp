#include "solver/app/capacity/capacity_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema = 5;
constexpr std::array<const char*, 3> state_names{"stopped", "not stopped", "open"};
/// Labels of capacity_outputs in the text.
constexpr std::array<std::string_view, 6> output_labels{"anchor force",       "cable force",
                                                        "hanger force",       "cable force/limit",
                                                        "hanger force/limit", "energy after the last contact"};

/// Places in capacity_outputs.
constexpr std::size_t anchor_force = 0, cable_force = 1, hanger_force = 2, cable_margin = 3, hanger_margin = 4,
                      exit_energy = 5;

struct Unit {
  std::string_view name;
  double size{};  ///< in SI

  [[nodiscard]] double of(double value) const { return value / size; }
};

/// Units of tables, texts and figures: those of the base, as engineers write them.
struct CapacityUnits {
  Unit length, speed, mass, force, energy;
  Unit thousand_force, thousand_energy;  ///< of texts and figures

  /// Those of capacity_outputs.
  [[nodiscard]] const Unit& of_output(std::size_t output) const { return of(output, force, energy); }
  [[nodiscard]] const Unit& of_text(std::size_t output) const { return of(output, thousand_force, thousand_energy); }

 private:
  [[nodiscard]] static const Unit& of(std::size_t output, const Unit& force, const Unit& energy) {
    static constexpr Unit one{"1", 1.0};
    return output <= hanger_force ? force : output == exit_energy ? energy : one;
  }
};

constexpr double kip = 1e3 * exact::pound_force_in_N;
constexpr CapacityUnits si_units{{"m", 1.0}, {"m/s", 1.0}, {"kg", 1.0}, {"N", 1.0},
                                 {"J", 1.0}, {"kN", 1e3},  {"kJ", 1e3}};
constexpr CapacityUnits us_units{{"ft", exact::foot_in_m},
                                 {"ft/s", exact::foot_in_m},
                                 {"lb", exact::pound_in_kg},
                                 {"lbf", exact::pound_force_in_N},
                                 {"lbf ft", exact::pound_force_in_N* exact::foot_in_m},
                                 {"kip", kip},
                                 {"kip ft", kip* exact::foot_in_m}};

const CapacityUnits& units_of(const CapacityStudy& study) { return study.units() == us ? us_units : si_units; }

template <class Visit>
void for_each_node(const RockMap& map, Visit&& visit) {
  for (int j = 0; j < map.map.side(); ++j)
    for (int i = 0; i < map.map.side(); ++i)
      visit(MapNode{i, j}, map.map.number({i, j}));
}

Json ends_json(const RockTrials& trials) {
  Json json = Json::object();
  const std::array<std::size_t, 6> ends = trials.ends();
  for (std::size_t i = 0; i < ends.size(); ++i)
    json[std::string{Names<RockEnd>::list[i]}] = ends[i];
  return json;
}

/// An end that is not known is null.
Json interval_json(const Interval& interval) {
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return Json{end(interval.low), end(interval.high)};
}

/// Whether an output is the margin of forces that have no limit.
bool has_no_limit(const RockTrials& trials, std::size_t output) {
  if (output != cable_margin && output != hanger_margin) return false;
  const std::size_t force = output == cable_margin ? cable_force : hanger_force;
  return std::ranges::max(trials.values(output)) == 0.0 && std::ranges::max(trials.values(force)) > 0.0;
}

/// By their names; null: margins of forces that have no limit.
Json outputs_json(const RockTrials& trials) {
  Json json = Json::object();
  for (std::size_t output = 0; output < capacity_outputs.size(); ++output) {
    const std::vector<double> values = trials.values(output);
    if (values.empty()) continue;
    Json& quantiles = json[std::string{capacity_outputs[output]}];
    if (has_no_limit(trials, output)) continue;
    quantiles = {{"runs", values.size()}};
    for (const auto& [name, probability] : {std::pair{"median", 0.5}, std::pair{"p95", 0.95}}) {
      const SampleQuantile quantile = sample_quantile(values, probability);
      quantiles[name] = {{"value", quantile.value}, {"interval", interval_json(quantile.interval)}};
    }
  }
  return json;
}

/// Ends and outputs of the trials at one node; null without them.
Json trials_json(const RockTrials* trials) {
  if (trials == nullptr) return nullptr;
  return {{"ends", ends_json(*trials)}, {"outputs", outputs_json(*trials)}};
}

RockTrials all_trials(const RockMap& map) {
  RockTrials all;
  for (const RockTrials& node : map.nodes)
    all.trials.insert(all.trials.end(), node.trials.begin(), node.trials.end());
  return all;
}

/// "height 1.37 m", with spin and position if the file gives them.
std::string name_of(const CapacityStudy& study, const Rock& rock, int digits) {
  const Unit& length = units_of(study).length;
  std::string name = fmt::format("height {:.{}g} {}", length.of(rock.height), digits, length.name);
  if (!study.file().spins.empty()) name += fmt::format(", spin {:.{}g} rad/s", rock.spin, digits);
  if (!study.file().positions.empty())
    name += fmt::format(", along {:.{}g} {}", length.of(rock.along), digits, length.name);
  return name;
}

/// A random number of the expected rocks.
struct ExpectedNumber {
  std::string_view name;
  Unit unit;
  double low{}, high{};  ///< percentiles of 95 and 99 %, equal: a fixed value; or
  bool is_uniform{};     ///< ends
};

/// Those that a table does not give.
std::vector<ExpectedNumber> expected_numbers(const RockHazard& hazard, const CapacityUnits& units) {
  std::vector<ExpectedNumber> numbers;
  if (hazard.table.empty()) {
    for (const auto& [name, number, unit] : {std::tuple{"mass", hazard.mass, units.mass},
                                             {"speed", hazard.speed, units.speed},
                                             {"height", hazard.height, units.length}})
      numbers.push_back({name, unit, number.p95, number.p99, false});
  }
  for (const auto& [name, ends, unit] :
       {std::tuple{"spin", hazard.spin, Unit{"rad/s", 1.0}}, {"along", hazard.along, units.length}})
    if (ends) numbers.push_back({name, unit, (*ends)[0], (*ends)[1], true});
  return numbers;
}

/// Of each number its value, its percentiles, or its ends; a table by its name.
Json expected_json(const RockHazard& hazard, const CapacityUnits& units) {
  Json json = Json::object();
  if (!hazard.table.empty()) json = {{"table", hazard.table_name}, {"rows", hazard.table.size()}};
  for (const ExpectedNumber& number : expected_numbers(hazard, units)) {
    Json& of = json[std::string{number.name}];
    if (number.is_uniform) {
      of = {{"from", number.low}, {"to", number.high}};
    } else if (number.low == number.high) {
      of = {{"value", number.low}};
    } else {
      of = {{"p95", number.low}, {"p99", number.high}};
    }
  }
  return json;
}

std::string expected_text(const RockHazard& hazard, const CapacityUnits& units) {
  std::string text;
  if (!hazard.table.empty()) text = fmt::format("; rows of {} ({})", hazard.table_name, hazard.table.size());
  for (const ExpectedNumber& number : expected_numbers(hazard, units)) {
    const double low = number.unit.of(number.low), high = number.unit.of(number.high);
    text += number.is_uniform ? fmt::format("; {} {:.4g} to {:.4g} {}", number.name, low, high, number.unit.name)
            : low == high
                ? fmt::format("; {} {:.4g} {}", number.name, low, number.unit.name)
                : fmt::format("; {0} {1:.4g} {3} (95 %), {2:.4g} {3} (99 %)", number.name, low, high, number.unit.name);
  }
  return text.substr(2);
}

std::size_t full_grid(const RockMap& map) { return map.nodes.size() * map.map.rules().trials; }

std::string ends_text(const RockTrials& trials) {
  std::string text;
  const std::array<std::size_t, 6> ends = trials.ends();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i] == 0) continue;
    std::string name{Names<RockEnd>::list[i]};
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", ends[i], name);
  }
  return text;
}

/// Why the first run failed, as a line; nothing if none did.
std::string failure_text(const RockTrials& trials) {
  const auto failed = std::ranges::find(trials.trials, RockEnd::failed, &RockTrial::end);
  return failed == trials.trials.end() ? "" : fmt::format("  failed, for example: {}\n", failed->reason);
}

/// "4.1 to 4.3"; where an end is not in the map, "below" or "above" the other one.
std::string range_text(const Interval& interval, const Unit& unit) {
  const bool is_bounded = std::isfinite(interval.high);
  if (!(interval.low > 0.0)) return is_bounded ? fmt::format("below {:.4g}", unit.of(interval.high)) : "open";
  if (!is_bounded) return fmt::format("above {:.4g}", unit.of(interval.low));
  return fmt::format("{:.4g} to {:.4g}", unit.of(interval.low), unit.of(interval.high));
}

/// A percentile of an output; "" if there is none.
std::string quantile_text(const RockTrials* trials, std::size_t output, double probability, const Unit& unit) {
  const std::vector<double> values = trials == nullptr ? std::vector<double>{} : trials->values(output);
  return values.empty() ? "" : fmt::format("{:.4g}", unit.of(sample_quantile(values, probability).value));
}

records::Figure map_figure(const CapacityStudy& study, const RockMap& map, std::size_t number) {
  const CapacityFile& file = study.file();
  const CapacityUnits& units = units_of(study);
  records::Figure figure{
      .name = fmt::format("envelope_{}", number),
      .title = fmt::format("Rocks stopped: {}", name_of(study, map.rock, 3)),
      .caption =
          "Rocks that are stopped, and that are not, by mass and speed at the start. A node is drawn where runs "
          "were executed; it is open if the interval of 95 % of its probability contains one half. Thin lines: "
          "equal kinetic energy.",
      .x = {.label = "mass", .unit = std::string{units.mass.name}},
      .y = {.label = "speed", .unit = std::string{units.speed.name}}};
  std::array<records::Series, 3> nodes;
  for (std::size_t state = 0; state < nodes.size(); ++state) {
    nodes[state].label = state_names[state];
    nodes[state].style = state == 1 ? records::Style::crosses : records::Style::points;
  }
  for_each_node(map, [&](MapNode node, std::size_t at) {
    if (map.map.trials(node) == 0) return;
    const Rock rock = study.rock_at(map, node);
    nodes[static_cast<std::size_t>(map.states[at])].add(units.mass.of(rock.mass), units.speed.of(rock.speed));
  });
  for (records::Series& series : nodes)
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  // Lines through the middle of the right side, and of a quarter and four times that energy.
  const double energy = 0.125 * file.mass[1] * file.speed[1] * file.speed[1];
  for (const double factor : {0.25, 1.0, 4.0}) {
    const Unit& unit = units.thousand_energy;
    records::Series line{.label = fmt::format("{:.3g} {}", unit.of(factor * energy), unit.name),
                         .style = records::Style::lines};
    constexpr int points = 100;
    for (int i = 0; i <= points; ++i) {
      const double mass = std::lerp(file.mass[0], file.mass[1], i / static_cast<double>(points));
      const double speed = std::sqrt(2.0 * factor * energy / mass);
      if (speed >= file.speed[0] && speed <= file.speed[1]) line.add(units.mass.of(mass), units.speed.of(speed));
    }
    if (line.x.size() > 1) figure.series.push_back(std::move(line));
  }
  return figure;
}

/// Adds the median of an output, with a bar to its 95th percentile.
void add_quantiles(records::Series& series, double at, const RockTrials* trials, std::size_t output, const Unit& unit) {
  const std::vector<double> values = trials == nullptr ? std::vector<double>{} : trials->values(output);
  if (values.empty()) return;
  const double median = unit.of(sample_quantile(values, 0.5).value);
  series.add(at, median);
  series.y_low.push_back(median);
  series.y_high.push_back(unit.of(sample_quantile(values, 0.95).value));
}

records::Figure force_figure(const CapacityStudy& study, const RockMap& map, std::size_t number) {
  const CapacityUnits& units = units_of(study);
  const Unit &force = units.thousand_force, &energy = units.thousand_energy;
  records::Figure figure{
      .name = fmt::format("cable_force_{}", number),
      .title = fmt::format("Largest cable force: {}", name_of(study, map.rock, 3)),
      .caption =
          "Median of the largest cable force at each node, over the kinetic energy; bars to the 95th percentile. Light "
          "and heavy: the lower and the upper half of the masses. Rocks of one energy give different forces.",
      .x = {.label = "kinetic energy", .unit = std::string{energy.name}},
      .y = {.label = "largest cable force", .unit = std::string{force.name}, .min = 0.0}};
  std::array<records::Series, 2> halves;
  halves[0].label = "light rocks", halves[1].label = "heavy rocks";
  for (records::Series& half : halves)
    half.style = records::Style::errorbars;
  for_each_node(map, [&](MapNode node, std::size_t at) {
    add_quantiles(halves[2 * node.i < map.map.rules().cells ? 0 : 1],
                  energy.of(study.rock_at(map, node).kinetic_energy()), &map.nodes[at], cable_force, force);
  });
  for (records::Series& half : halves)
    if (!half.x.empty()) figure.series.push_back(std::move(half));
  return figure;
}

records::Figure boundary_force_figure(const CapacityStudy& study, const RockMap& map, std::size_t number) {
  const CapacityUnits& units = units_of(study);
  records::Figure figure{
      .name = fmt::format("boundary_forces_{}", number),
      .title = fmt::format("Forces at the boundary: {}", name_of(study, map.rock, 3)),
      .caption =
          "Largest forces at the speed up to which rocks of each mass are stopped: medians, with bars to the 95th "
          "percentiles.",
      .x = {.label = "mass", .unit = std::string{units.mass.name}},
      .y = {.label = "largest force", .unit = std::string{units.thousand_force.name}, .min = 0.0}};
  for (const auto& [label, output] :
       {std::pair{"anchor", anchor_force}, std::pair{"cable", cable_force}, std::pair{"hanger", hanger_force}}) {
    records::Series series{.label = label, .style = records::Style::errorbars};
    for (const CapacityBoundary& boundary : boundaries_of(study, map, 1))
      add_quantiles(series, units.mass.of(boundary.mass), boundary.stopped, output, units.thousand_force);
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  }
  return figure;
}

records::Figure boundary_energy_figure(const CapacityStudy& study, const RockMap& map, std::size_t number) {
  const CapacityUnits& units = units_of(study);
  records::Figure figure{
      .name = fmt::format("boundary_energy_{}", number),
      .title = fmt::format("Energy at the boundary: {}", name_of(study, map.rock, 3)),
      .caption =
          "Translational and rotational kinetic energy at the speed from which rocks of each mass are not stopped, "
          "at the start and after the last contact: medians, with bars to the 95th percentiles.",
      .x = {.label = "mass", .unit = std::string{units.mass.name}},
      .y = {.label = "energy", .unit = std::string{units.thousand_energy.name}, .min = 0.0}};
  records::Series before{.label = "at the start", .style = records::Style::linespoints},
      after{.label = "after the last contact", .style = records::Style::errorbars};
  for (const CapacityBoundary& boundary : boundaries_of(study, map, 1)) {
    if (boundary.passed == nullptr) continue;
    Rock rock = map.rock;
    rock.mass = boundary.mass, rock.speed = boundary.speed.high;
    before.add(units.mass.of(boundary.mass), units.thousand_energy.of(study.start_energy(rock)));
    add_quantiles(after, units.mass.of(boundary.mass), boundary.passed, exit_energy, units.thousand_energy);
  }
  for (records::Series* const series : {&before, &after})
    if (!series->x.empty()) figure.series.push_back(std::move(*series));
  return figure;
}

}  // namespace

std::vector<CapacityBoundary> boundaries_of(const CapacityStudy& study, const RockMap& map, int stride) {
  std::vector<CapacityBoundary> boundaries;
  if (all_trials(map).all_failed()) return boundaries;
  if (stride == 0) stride = map.map.rules().cells / map.map.rules().first_cells;
  const auto trials_at = [&](MapNode node) -> const RockTrials* {
    if (node.j < 0 || map.map.trials(node) == 0) return nullptr;
    return &map.nodes[map.map.number(node)];
  };
  for (int i = 0; i < map.map.side(); i += stride) {
    const MapBoundary at = boundary_at(map.map, map.states, i);
    CapacityBoundary found;
    found.mass = study.rock_at(map, {i, 0}).mass;
    found.speed = {
        at.last_above < 0 ? 0.0 : study.rock_at(map, {i, at.last_above}).speed,
        at.first_below < 0 ? std::numeric_limits<double>::infinity() : study.rock_at(map, {i, at.first_below}).speed};
    const auto energy = [&](double speed) { return 0.5 * found.mass * speed * speed; };
    found.energy = {energy(found.speed.low), energy(found.speed.high)};
    found.stopped = trials_at({i, at.last_above}), found.passed = trials_at({i, at.first_below});
    boundaries.push_back(found);
  }
  return boundaries;
}

double energy_factor(const std::vector<CapacityBoundary>& boundaries) {
  double stopped = 0.0, passed = std::numeric_limits<double>::infinity();
  for (const CapacityBoundary& boundary : boundaries) {
    stopped = std::max(stopped, boundary.energy.low);
    passed = std::min(passed, boundary.energy.high);
  }
  return std::max(1.0, stopped / passed);
}

std::string capacity_csv(const CapacityStudy& study) {
  const CapacityUnits& units = units_of(study);
  std::string text =
      fmt::format("height [{0}],spin [rad/s],along [{0}],mass [{1}],speed [{2}],kinetic_energy [{3}],runs",
                  units.length.name, units.mass.name, units.speed.name, units.energy.name);
  for (const std::string_view end : Names<RockEnd>::list)
    text += fmt::format(",{}", end);
  text += ",probability,probability_low,probability_high,state";
  for (std::size_t i = 0; i < capacity_outputs.size(); ++i) {
    for (const char* const of : {"median", "p95"})
      text += fmt::format(",{}.{} [{}]", capacity_outputs[i], of, units.of_output(i).name);
  }
  text += '\n';
  for (const RockMap& map : study.maps()) {
    for_each_node(map, [&](MapNode node, std::size_t at) {
      const std::size_t trials = map.map.trials(node);
      if (trials == 0) return;
      const Rock rock = study.rock_at(map, node);
      text += fmt::format("{},{},{},{},{},{},{}", units.length.of(rock.height), rock.spin, units.length.of(rock.along),
                          units.mass.of(rock.mass), units.speed.of(rock.speed), units.energy.of(rock.kinetic_energy()),
                          trials);
      for (const std::size_t count : map.nodes[at].ends())
        text += fmt::format(",{}", count);
      const Interval interval = wilson_interval(map.map.hits(node), trials);
      text += fmt::format(",{},{},{},{}", static_cast<double>(map.map.hits(node)) / static_cast<double>(trials),
                          interval.low, interval.high, state_names[static_cast<std::size_t>(map.states[at])]);
      for (std::size_t output = 0; output < capacity_outputs.size(); ++output) {
        const std::vector<double> values = map.nodes[at].values(output);
        const bool has_value = !values.empty() && !has_no_limit(map.nodes[at], output);
        for (const double probability : {0.5, 0.95})
          text += !has_value
                      ? ","
                      : fmt::format(",{}", units.of_output(output).of(sample_quantile(values, probability).value));
      }
      text += '\n';
    });
  }
  return text;
}

std::string capacity_json(const CapacityStudy& study, const RockRuns& rocks) {
  const Rock& own = rocks.own();
  const CapacityFile& file = study.file();
  Json json{
      {"schema", schema},
      {"title", file.title},
      {"units", "SI"},
      {"base", file.base.filename().string()},
      {"scene_units", rocks.units().name},
      {"symmetry", rocks.is_full() ? "full" : "half"},
      {"mass", file.mass},
      {"speed", file.speed},
      {"rock",
       {{"mass", own.mass}, {"speed", own.speed}, {"height", own.height}, {"spin", own.spin}, {"along", own.along}}},
      {"seed", file.seed},
      {"cells", file.map.cells},
      {"first_cells", file.map.first_cells},
      {"runs_of_a_node", file.map.trials},
      {"few_runs", file.map.few},
      {"changes",
       {{"speed", file.changes.speed},
        {"height", file.changes.height},
        {"angle", file.changes.angle},
        {"spin", file.changes.spin},
        {"along", file.changes.along}}}};
  json["maps"] = Json::array();
  for (const RockMap& map : study.maps()) {
    const RockTrials all = all_trials(map);
    Json of_map{{"height", map.rock.height},
                {"spin", map.rock.spin},
                {"along", map.rock.along},
                {"runs", all.trials.size()},
                {"full_grid_runs", full_grid(map)},
                {"ends", ends_json(all)},
                {"audit",
                 {{"runs", map.audit.trials.size()},
                  {"ends", ends_json(map.audit)},
                  {"contradictions", map.contradicted},
                  {"interval", interval_json(wilson_interval(map.contradicted, map.audit.trials.size()))}}}};
    of_map["boundary"] = Json::array();
    const std::vector<CapacityBoundary> boundaries = boundaries_of(study, map);
    for (const CapacityBoundary& boundary : boundaries) {
      of_map["boundary"].push_back({{"mass", boundary.mass},
                                    {"speed", interval_json(boundary.speed)},
                                    {"kinetic_energy", interval_json(boundary.energy)},
                                    {"stopped", trials_json(boundary.stopped)},
                                    {"not_stopped", trials_json(boundary.passed)}});
    }
    of_map["energy_factor"] = energy_factor(boundaries);
    json["maps"].push_back(std::move(of_map));
  }
  if (file.hazard) {
    const RockTrials& hazard = study.hazard();
    const std::size_t runs = hazard.trials.size(), failures = runs - hazard.stopped();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr Interval unknown{-infinity, infinity};
    json["hazard"] = {
        {"rocks", expected_json(*file.hazard, units_of(study))},
        {"runs", runs},
        {"ends", ends_json(hazard)},
        {"probability_of_failure",
         hazard.all_failed() ? Json(nullptr) : Json(static_cast<double>(failures) / static_cast<double>(runs))},
        {"interval", interval_json(hazard.all_failed() ? unknown : wilson_interval(failures, runs))},
        {"outputs", outputs_json(hazard)}};
  }
  return json.dump(2) + "\n";
}

std::string capacity_text(const CapacityStudy& study) {
  const CapacityFile& file = study.file();
  const CapacityUnits& units = units_of(study);
  const Unit &force = units.thousand_force, &energy = units.thousand_energy;
  std::string text;
  for (const RockMap& map : study.maps()) {
    const RockTrials all = all_trials(map);
    text += fmt::format("{}: {} runs ({:.3g} % of the full grid): {}\n", name_of(study, map.rock, 4), all.trials.size(),
                        100.0 * static_cast<double>(all.trials.size()) / static_cast<double>(full_grid(map)),
                        ends_text(all));
    text += failure_text(all);
    if (all.all_failed()) {
      text += "  no boundary: no run finished\n";
      continue;
    }
    text +=
        fmt::format("  {:>9}  {:>17}  {:>23}  {:>18}  {:>21}\n", fmt::format("mass [{}]", units.mass.name),
                    fmt::format("stopped to [{}]", units.speed.name), fmt::format("kinetic energy [{}]", energy.name),
                    fmt::format("anchor force [{}]", force.name), fmt::format("energy after [{}]", energy.name));
    const std::vector<CapacityBoundary> boundaries = boundaries_of(study, map);
    for (const CapacityBoundary& boundary : boundaries) {
      text += fmt::format("  {:>9.4g}  {:>17}  {:>23}  {:>18}  {:>21}\n", units.mass.of(boundary.mass),
                          range_text(boundary.speed, units.speed), range_text(boundary.energy, energy),
                          quantile_text(boundary.stopped, anchor_force, 0.95, force),
                          quantile_text(boundary.passed, exit_energy, 0.5, energy));
    }
    if (const double factor = energy_factor(boundaries); factor > 1.0)
      text += fmt::format("  energy at the boundary differs by a factor of {:.3g} between masses\n", factor);
    if (const std::size_t audited = map.audit.trials.size(); audited > 0) {
      text += fmt::format("  audit: {} of {} runs at nodes without any ended otherwise than the map says\n",
                          map.contradicted, audited);
    }
  }
  if (file.hazard) {
    const RockTrials& hazard = study.hazard();
    const std::size_t runs = hazard.trials.size(), failures = runs - hazard.stopped();
    const Interval interval = wilson_interval(failures, runs);
    text += fmt::format("expected rocks: {} runs: {}\n  {}\n", runs, ends_text(hazard),
                        expected_text(*file.hazard, units)) +
            failure_text(hazard);
    text += hazard.all_failed()
                ? "  no probability of failure: no run finished\n"
                : fmt::format("  probability of failure per impact {:.4g}, 95 %: {:.4g} to {:.4g}\n",
                              static_cast<double>(failures) / static_cast<double>(runs), interval.low, interval.high);
    for (std::size_t output = 0; output < capacity_outputs.size(); ++output) {
      if (hazard.values(output).empty()) continue;
      const Unit& unit = units.of_text(output);
      if (has_no_limit(hazard, output)) {
        text += fmt::format("  {:<30} no limit\n", output_labels[output]);
        continue;
      }
      text += fmt::format("  {:<30} median {:>10}, 95th percentile {:>10}{}\n", output_labels[output],
                          quantile_text(&hazard, output, 0.5, unit), quantile_text(&hazard, output, 0.95, unit),
                          unit.name == "1" ? "" : fmt::format(" {}", unit.name));
    }
  }
  return text;
}

std::vector<records::Figure> capacity_figures(const CapacityStudy& study) {
  std::vector<records::Figure> figures;
  std::size_t number = 0;
  for (const RockMap& map : study.maps()) {
    ++number;
    if (all_trials(map).all_failed()) continue;
    figures.push_back(map_figure(study, map, number));
    for (records::Figure& of_forces :
         std::array{force_figure(study, map, number), boundary_force_figure(study, map, number),
                    boundary_energy_figure(study, map, number)})
      if (!of_forces.series.empty()) figures.push_back(std::move(of_forces));
  }
  return figures;
}

}  // namespace talus::app
