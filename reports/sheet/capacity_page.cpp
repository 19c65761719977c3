#include "reports/sheet/capacity_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "reports/base/error.hpp"
#include "reports/sheet/sheet_units.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

using records::Json;
using records::Node;

constexpr int capacity_schema = 5;

/// Maximum rows of the table of boundaries, so that the page is one.
constexpr std::size_t maximum_boundaries = 14;

CapacityInterval interval(const Node& node) {
  const std::vector<Node> ends = node.list();
  if (ends.size() != 2) node.fail(fmt::format("must be 2 numbers, found {}", ends.size()));
  CapacityInterval found;
  for (std::size_t i = 0; i < 2; ++i)
    if (!ends[i].json().is_null()) found[i] = ends[i].finite();
  return found;
}

std::array<double, 2> pair(const Node& node) {
  const CapacityInterval ends = interval(node);
  if (!ends[0] || !ends[1]) node.fail("must be 2 numbers, found null");
  return {*ends[0], *ends[1]};
}

CapacityRuns runs(const Node& ends, const Node* outputs) {
  CapacityRuns found;
  for (const auto& [name, count] : ends.members())
    found.ends.emplace_back(name, count.count());
  if (outputs == nullptr) return found;
  for (const auto& [name, of] : outputs->members()) {
    if (of.json().is_null()) {
      found.without_limit.push_back(name);
      continue;
    }
    const Node p95 = of.at("p95");
    found.outputs.emplace_back(name, CapacityOutput{of.at("median").at("value").finite(), p95.at("value").finite(),
                                                    interval(p95.at("interval"))});
  }
  return found;
}

CapacityRocks expected_rocks(const Node& node) {
  CapacityRocks rocks;
  if (node.has("table")) rocks.table = node.at("table").text(), rocks.rows = node.at("rows").count();
  for (const char* const name : {"mass", "speed", "height", "spin", "along"}) {
    if (!node.has(name)) continue;
    const Node of = node.at(name);
    const bool is_uniform = of.has("from");
    const auto [low, high] = of.has("value") ? std::pair{"value", "value"}
                             : is_uniform    ? std::pair{"from", "to"}
                                             : std::pair{"p95", "p99"};
    rocks.numbers.emplace_back(name, CapacityRocks::Number{of.at(low).finite(), of.at(high).finite(), is_uniform});
  }
  if (rocks.table.empty() && rocks.numbers.empty()) node.fail("must have a table, or a mass");
  return rocks;
}

CapacityRuns node_runs(const Node& line, const char* key) {
  if (line.is_null(key)) return {};
  const Node outputs = line.at(key).at("outputs");
  return runs(line.at(key).at("ends"), &outputs);
}

std::size_t count_of(const CapacityRuns& of, const std::string& end) {
  const auto found = std::ranges::find(of.ends, end, &std::pair<std::string, std::size_t>::first);
  return found == of.ends.end() ? 0 : found->second;
}

const CapacityOutput* output_of(const CapacityRuns& of, const std::string& name) {
  const auto found = std::ranges::find(of.outputs, name, &std::pair<std::string, CapacityOutput>::first);
  return found == of.outputs.end() ? nullptr : &found->second;
}

/// Whether there are runs, and all failed: they say nothing about the fence.
bool all_failed(const CapacityRuns& of) { return of.count() > 0 && count_of(of, "failed") == of.count(); }

std::string ends_text(const CapacityRuns& of) {
  std::string text = fmt::format("{} runs", of.count());
  for (const auto& [end, count] : of.ends) {
    if (count == 0) continue;
    std::string name = end;
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("{} {} {}", text.find(':') == std::string::npos ? ":" : ",", count, name);
  }
  return text;
}

/// "4.1 to 4.3", in the scene's units; where an end is not in the map, "below" or "above" the other one.
std::string range_text(const CapacityRecord& record, const CapacityInterval& of, const SheetUnits& units) {
  const double unit = record.us_units ? units.us : units.si;
  const bool has_low = of[0].value_or(0.0) > 0.0;
  if (!has_low) return of[1] ? fmt::format("below {}", digits(*of[1] / unit)) : "open";
  if (!of[1]) return fmt::format("above {}", digits(*of[0] / unit));
  return fmt::format("{} to {}", digits(*of[0] / unit), digits(*of[1] / unit));
}

std::string value_text(const CapacityRecord& record, const CapacityOutput* of, bool is_p95, const SheetUnits& units) {
  return of == nullptr ? "" : both(record.us_units, is_p95 ? of->p95 : of->median, units);
}

SheetHead first_unit(const CapacityRecord& record, const char* group, const SheetUnits& units) {
  return {group, std::string{record.us_units ? units.us_name : units.si_name}};
}

/// Whether the maps differ in a number of their rocks.
bool differ(const CapacityRecord& record, double CapacityMapRecord::*of) {
  return std::ranges::any_of(record.maps,
                             [&](const CapacityMapRecord& map) { return map.*of != record.maps.front().*of; });
}

std::string length_text(const CapacityRecord& record, double length, int digits) {
  const double unit = record.us_units ? length_units.us : length_units.si;
  return fmt::format("{:.{}g} {}", length / unit, digits,
                     record.us_units ? length_units.us_name : length_units.si_name);
}

std::string map_name(const CapacityRecord& record, const CapacityMapRecord& map) {
  std::string name = length_text(record, map.height, 4);
  if (differ(record, &CapacityMapRecord::spin)) name += fmt::format(", {:.4g} rad/s", map.spin);
  if (differ(record, &CapacityMapRecord::along)) name += fmt::format(", at {}", length_text(record, map.along, 4));
  return name;
}

SheetTable boundary_table(const CapacityRecord& record) {
  SheetTable table{"Rocks are stopped up to the first value and not from the second on",
                   SheetTable::Location::page,
                   {{"", "height"},
                    head("rock", record.us_units, mass_units),
                    first_unit(record, "speed", speed_units),
                    first_unit(record, "kinetic energy", energy_units),
                    head("anchor force", record.us_units, force_units),
                    head("cable force", record.us_units, force_units),
                    head("hanger force", record.us_units, force_units),
                    head("energy after", record.us_units, energy_units)},
                   {}};
  for (const CapacityMapRecord& map : record.maps) {
    if (all_failed(map.runs)) {
      table.rows.push_back({map_name(record, map), "", "no run finished", "", "", "", "", ""});
      continue;
    }
    for (const CapacityLine& line : map.boundary) {
      table.rows.push_back({map_name(record, map), both(record.us_units, line.mass, mass_units),
                            range_text(record, line.speed, speed_units), range_text(record, line.energy, energy_units),
                            value_text(record, output_of(line.stopped, "fence.anchor_force"), true, force_units),
                            value_text(record, output_of(line.stopped, "fence.cable_force"), true, force_units),
                            value_text(record, output_of(line.stopped, "fence.hanger_force"), true, force_units),
                            value_text(record, output_of(line.passed, "fence.exit_energy"), false, energy_units)});
    }
  }
  table.note =
      "Stopped: with a probability above one half. Forces: 95th percentile at the first speed. Energy after: median "
      "after the last contact at the second. ";
  cut(table, maximum_boundaries, "capacity.json");
  return table;
}

SheetTable hazard_table(const CapacityRecord& record) {
  SheetTable table{"Expected rocks: largest values of an impact",
                   SheetTable::Location::left,
                   {{"", ""}, {"", "unit", true}, {"", "median"}, {"", "95th percentile"}, {"", "its interval, 95 %"}},
                   {}};
  struct Line {
    const char *name, *label;
    const SheetUnits* units = nullptr;
  };
  const std::vector<Line> lines{{"fence.anchor_force", "anchor force", &force_units},
                                {"fence.cable_force", "cable force", &force_units},
                                {"fence.hanger_force", "hanger force", &force_units},
                                {"fence.cable_margin", "cable force/limit"},
                                {"fence.hanger_margin", "hanger force/limit"},
                                {"fence.exit_energy", "energy after the last contact", &energy_units}};
  for (const Line& line : lines) {
    if (std::ranges::find(record.hazard->without_limit, line.name) != record.hazard->without_limit.end())
      table.rows.push_back({line.label, "", "no limit", "no limit", ""});
    const CapacityOutput* const of = output_of(*record.hazard, line.name);
    if (of == nullptr) continue;
    const double unit = line.units == nullptr ? 1.0 : record.us_units ? line.units->us : line.units->si;
    const auto number = [&](const std::optional<double>& value) { return value ? digits(*value / unit) : "unknown"; };
    table.rows.push_back(
        {line.label,
         line.units == nullptr ? "" : std::string{record.us_units ? line.units->us_name : line.units->si_name},
         number(of->median), number(of->p95),
         fmt::format("{} to {}", number(of->p95_interval[0]), number(of->p95_interval[1]))});
  }
  return table;
}

SheetTable ends_table(const CapacityRecord& record) {
  SheetTable table{"Runs by their end",
                   record.hazard ? SheetTable::Location::right : SheetTable::Location::left,
                   {{"", ""}, {"", "maps"}, {"", "audits"}},
                   {}};
  if (record.hazard) table.heads.push_back({"", "expected rocks"});
  for (const auto& [end, unused] : record.maps.front().runs.ends) {
    std::size_t of_maps = 0, of_audits = 0;
    for (const CapacityMapRecord& map : record.maps)
      of_maps += count_of(map.runs, end), of_audits += count_of(map.audit, end);
    std::string name = end;
    std::ranges::replace(name, '_', ' ');
    table.rows.push_back({name, fmt::format("{}", of_maps), fmt::format("{}", of_audits)});
    if (record.hazard) table.rows.back().push_back(fmt::format("{}", count_of(*record.hazard, end)));
  }
  return table;
}

/// The energy up to which every mass is stopped, and from which none is.
std::string energies_text(const CapacityRecord& record) {
  if (std::ranges::all_of(record.maps, [](const CapacityMapRecord& map) { return all_failed(map.runs); }))
    return "no boundary: no run finished";
  double all = std::numeric_limits<double>::infinity(), none = 0.0;
  for (const CapacityMapRecord& map : record.maps) {
    for (const CapacityLine& line : map.boundary) {
      all = std::min(all, line.energy[0].value_or(0.0));
      none = std::max(none, line.energy[1].value_or(std::numeric_limits<double>::infinity()));
    }
  }
  const auto text = [&](double energy) { return with_units(record.us_units, energy, energy_units); };
  std::string found = all > 0.0 && std::isfinite(all)
                          ? fmt::format("every mass of the table is stopped up to {}", text(all))
                          : "at some mass no energy of the map is stopped";
  found += std::isfinite(none) && none > 0.0 ? fmt::format("; none is from {} on", text(none))
                                             : "; at some mass rocks are stopped up to the end of the map";
  return found;
}

std::string changes_text(const CapacityRecord& record) {
  std::string text;
  for (const auto& [name, change] : record.changes) {
    if (change == 0.0) continue;
    const std::string amount = name == "speed"   ? fmt::format("{:.3g} %", 100.0 * change)
                               : name == "angle" ? fmt::format("{:.3g} rad", change)
                               : name == "spin"  ? fmt::format("{:.3g} rad/s", change)
                                                 : length_text(record, change, 3);
    text += fmt::format("{}{} +-{}", text.empty() ? "" : ", ", name, amount);
  }
  return text;
}

const SheetUnits& units_of_rock(const std::string& number) {
  static constexpr SheetUnits spin_units{1.0, 1.0, "rad/s", "rad/s"};
  return number == "mass" ? mass_units : number == "speed" ? speed_units : number == "spin" ? spin_units : length_units;
}

std::string expected_text(const CapacityRecord& record) {
  const CapacityRocks& expected = record.expected;
  std::string text;
  if (!expected.table.empty()) text = fmt::format("; rows of {} ({})", expected.table, expected.rows);
  for (const auto& [name, number] : expected.numbers) {
    const SheetUnits& units = units_of_rock(name);
    const double unit = record.us_units ? units.us : units.si, low = number.low / unit, high = number.high / unit;
    const std::string_view of = record.us_units ? units.us_name : units.si_name;
    text += number.is_uniform ? fmt::format("; {} {:.4g} to {:.4g} {}", name, low, high, of)
            : low == high     ? fmt::format("; {} {:.4g} {}", name, low, of)
                              : fmt::format("; {0} {1:.4g} {3} (95 %), {2:.4g} {3} (99 %)", name, low, high, of);
  }
  return text.substr(2);
}

std::array<SheetBox, 2> boxes(const CapacityRecord& record) {
  SheetBox left{"Capacity", "amber", {}};
  if (record.hazard) {
    const CapacityRuns& hazard = *record.hazard;
    const std::size_t failures = hazard.count() - count_of(hazard, "stopped");
    if (all_failed(hazard)) {
      left.heading = "No probability of failure: no run finished";
    } else {
      left.heading = fmt::format("Probability of failure per impact: {}",
                                 digits(static_cast<double>(failures) / static_cast<double>(hazard.count())));
      left.colour = failures == 0 ? "green" : "amber";
      left.facts.push_back({"95 %", fmt::format("{} to {}", digits(record.failure[0].value_or(0.0)),
                                                digits(record.failure[1].value_or(1.0)))});
    }
    left.facts.push_back({"expected rocks", expected_text(record)});
    left.facts.push_back({"their runs", ends_text(hazard)});
  }
  left.facts.push_back({"energy", energies_text(record)});
  const double factor = std::ranges::max(record.maps, {}, &CapacityMapRecord::energy_factor).energy_factor;
  if (factor > 1.0)
    left.facts.push_back({"one energy", fmt::format("misjudges masses by a factor of up to {:.3g}", factor)});

  std::size_t all = 0, full = 0, failed = 0, audited = 0, wrong = 0;
  for (const CapacityMapRecord& map : record.maps) {
    all += map.runs.count(), full += map.full_grid,
        failed += count_of(map.runs, "failed") + count_of(map.audit, "failed");
    audited += map.audit.count(), wrong += map.contradictions;
  }
  if (record.hazard) failed += count_of(*record.hazard, "failed");
  SheetBox right{
      fmt::format("Audit: {} of {} runs contradict the map", wrong, audited), wrong == 0 ? "green" : "amber", {}};
  if (audited == 0) right.heading = "No audit", right.colour = "amber";
  if (failed > 0) right.heading += fmt::format("; {} runs failed", failed), right.colour = "red";
  right.facts = {
      {"runs",
       fmt::format("{}, {:.3g} % of the full grid", all, 100.0 * static_cast<double>(all) / static_cast<double>(full))},
      {"random", fmt::format("{}; seed {}", changes_text(record), record.seed)},
      {"model", fmt::format("plane motion, {} fence, elastic, plastic or breaking cables, columns that do not break, "
                            "no net",
                            record.is_full ? "whole" : "half")},
      {"interval",
       "of the runs alone: it knows nothing of errors of the model; no conformity with a standard is "
       "claimed"}};
  return {left, right};
}

}  // namespace

std::size_t CapacityRuns::count() const {
  return std::accumulate(ends.begin(), ends.end(), std::size_t{0},
                         [](std::size_t sum, const auto& end) { return sum + end.second; });
}

CapacityRecord read_capacity_record(const fs::path& file) {
  const Json all = records::read_json(file);
  const Node node{all, file.string()};
  if (const Node found = node.at("schema"); found.integer() != capacity_schema) {
    found.fail(fmt::format("must be {}, found {}: start talus capacity again, by this version", capacity_schema,
                           found.integer()));
  }
  CapacityRecord record;
  record.title = node.at("title").text();
  record.base = node.at("base").text();
  record.us_units = node.at("scene_units").one_of({"SI", "US"}) == "US";
  record.is_full = node.at("symmetry").one_of({"half", "full"}) == "full";
  record.mass = pair(node.at("mass")), record.speed = pair(node.at("speed"));
  for (const auto& [name, change] : node.at("changes").members())
    record.changes.emplace_back(name, change.finite());
  record.seed = static_cast<long long>(node.at("seed").count());
  for (const Node& of : node.at("maps").list()) {
    CapacityMapRecord& map = record.maps.emplace_back();
    map.height = of.at("height").finite(), map.spin = of.at("spin").finite(), map.along = of.at("along").finite();
    map.energy_factor = of.at("energy_factor").finite();
    map.full_grid = of.at("full_grid_runs").count();
    map.runs = runs(of.at("ends"), nullptr);
    map.audit = runs(of.at("audit").at("ends"), nullptr);
    map.contradictions = of.at("audit").at("contradictions").count();
    for (const Node& line : of.at("boundary").list()) {
      map.boundary.push_back({line.at("mass").finite(), interval(line.at("speed")), interval(line.at("kinetic_energy")),
                              node_runs(line, "stopped"), node_runs(line, "not_stopped")});
    }
  }
  if (record.maps.empty()) node.at("maps").fail("must have a map");
  if (node.has("hazard")) {
    const Node hazard = node.at("hazard"), outputs = hazard.at("outputs");
    record.hazard = runs(hazard.at("ends"), &outputs);
    record.failure = interval(hazard.at("interval"));
    record.expected = expected_rocks(hazard.at("rocks"));
  }
  return record;
}

SheetPage capacity_page(const CapacityRecord& record) {
  const auto range = [&](const std::array<double, 2>& ends, const SheetUnits& units) {
    return fmt::format("{} to {}", with_units(record.us_units, ends[0], units),
                       with_units(record.us_units, ends[1], units));
  };
  SheetPage page;
  page.title = record.title.empty() ? "What the fence stops" : record.title;
  page.lines = {fmt::format("Rocks that the fence of {} stops: {}", record.base, range(record.mass, mass_units)),
                fmt::format("at speeds of {}", range(record.speed, speed_units))};
  page.boxes = boxes(record);
  page.tables.push_back(boundary_table(record));
  if (record.hazard) page.tables.push_back(hazard_table(record));
  page.tables.push_back(ends_table(record));
  return page;
}

SheetPictures capacity_pictures(const CapacityRecord& record, const fs::path& plots, const fs::path& staging) {
  struct Picture {
    std::string name, title;
  };
  std::vector<Picture> shown;
  if (record.maps.size() == 1) {
    for (const Picture& picture : {Picture{"envelope_1", "Rocks that are stopped; lines: equal energy"},
                                   Picture{"boundary_forces_1", "Largest forces at the first speed of each mass"},
                                   Picture{"cable_force_1", "Largest cable force of all rocks"},
                                   Picture{"boundary_energy_1", "Energy at the second speed of each mass"}})
      if (fs::exists(plots / (picture.name + ".svg"))) shown.push_back(picture);
  } else {
    for (std::size_t i = 0; i < std::min<std::size_t>(record.maps.size(), 4); ++i)
      if (!all_failed(record.maps[i].runs))
        shown.push_back({fmt::format("envelope_{}", i + 1),
                         fmt::format("Rocks that are stopped: height {}", map_name(record, record.maps[i]))});
  }
  SheetPictures pictures;
  for (const Picture& picture : shown) {
    const std::string& name = picture.name;
    const fs::path svg = plots / (name + ".svg"), pdf = plots / (name + ".pdf");
    for (const fs::path& file : {svg, pdf})
      if (!fs::exists(file))
        throw OutputError{fmt::format("{}: it is missing; talus capacity draws it", file.string())};
    fs::copy_file(pdf, staging / (name + ".pdf"));
    const bool is_left = (&picture - &shown.front()) % 2 == 0;
    pictures.latex += fmt::format(
        "\\begin{{minipage}}[t]{{0.49\\linewidth}}\\SheetTitle{{{}}}\\includegraphics[width=\\linewidth]{{{}.pdf}}"
        "\\end{{minipage}}{}\n",
        picture.title, picture.name, is_left ? "\\hfill" : "\\par\\smallskip");
    const std::string html = fmt::format("<h3>{}</h3>\n{}", picture.title, records::read_whole(svg));
    pictures.html += fmt::format("<div class=\"half\">{}</div>\n", html);
    pictures.phone_html += fmt::format("<div>{}</div>\n", html);
  }
  if (!pictures.latex.empty()) pictures.latex += "\\par\\smallskip\n";
  return pictures;
}

}  // namespace talus::reports
