#include "solver/app/capacity/capacity_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/scene/scene_table.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Standard normal quantiles.
constexpr double normal_95 = 1.6448536269514722, normal_99 = 2.3263478740408408;

/// Two positive quantities, the first less than the second.
std::array<double, 2> ends_of(SceneTable& table, std::string_view key, Dimension dimension) {
  const auto ends = table.two_quantities(key, dimension);
  if (ends && !((*ends)[0] > 0.0 && (*ends)[0] < (*ends)[1])) {
    table.report(key,
                 fmt::format("found {}; both must be > 0, the first less than the second", found(*table.value(key))));
  }
  return ends.value_or(std::array{1.0, 2.0});
}

/// Two ends, the first at most the second, or one quantity that is both; nothing if the key is missing.
std::optional<std::array<double, 2>> range_of(SceneTable& table, std::string_view key, Dimension dimension) {
  if (!table.has(key)) return {};
  if (table.is_text(key)) {
    const double both = table.quantity(key, dimension);
    return std::array{both, both};
  }
  const auto ends = table.two_quantities(key, dimension);
  if (ends && !((*ends)[0] <= (*ends)[1]))
    table.report(key, fmt::format("found {}; the first must be at most the second", found(*table.value(key))));
  return ends;
}

void read_changes(SceneTable table, RockChanges& changes) {
  table.allow({"speed", "height", "angle", "spin", "along"});
  if (table.has("speed")) changes.speed = table.number("speed", Range::fraction);
  changes.height = table.quantity_or("height", dimension::length, 0.0, Range::non_negative);
  changes.angle = table.quantity_or("angle", dimension::angle, 0.0, Range::non_negative);
  changes.spin = table.quantity_or("spin", dimension::angular_velocity, 0.0, Range::non_negative);
  changes.along = table.quantity_or("along", dimension::length, 0.0, Range::non_negative);
}

void read_map(SceneTable table, CapacityFile& file) {
  table.allow({"cells", "first_cells", "runs", "few_runs", "audit"});
  if (table.has("cells")) file.map.cells = static_cast<int>(table.whole_between("cells", 1, 1024));
  if (table.has("first_cells")) file.map.first_cells = static_cast<int>(table.whole_between("first_cells", 1, 64));
  if (table.has("runs")) file.map.trials = static_cast<std::size_t>(table.whole_between("runs", 4, 10'000));
  if (table.has("few_runs")) file.map.few = static_cast<std::size_t>(table.whole_between("few_runs", 1, 10'000));
  if (file.map.few > file.map.trials) {
    table.report("few_runs",
                 fmt::format("found {}; it must be at most the runs of a node, {}", file.map.few, file.map.trials));
    file.map.few = file.map.trials;
  }
  if (table.has("audit")) file.audit = static_cast<std::size_t>(table.whole_between("audit", 0, 10'000));
  table.guard([&] {
    try {
      static_cast<void>(CapacityMap{file.map});
    } catch (const InputError& error) {
      table.fail("cells", error.what());
    }
  });
}

RockNumber read_number(SceneTable& table, std::string_view key, Dimension dimension) {
  RockNumber number{1.0, 1.0};
  if (table.is_text(key) || !table.has(key)) {
    number.p95 = number.p99 = table.quantity(key, dimension, Range::positive);
    return number;
  }
  table.guard([&] {
    SceneTable percentiles = table.table(key);
    percentiles.allow({"p95", "p99"});
    const std::size_t errors = table.source().errors();
    number = {percentiles.quantity("p95", dimension, Range::positive),
              percentiles.quantity("p99", dimension, Range::positive)};
    // A misspelt key is an error later on.
    const auto *const p95 = percentiles.value("p95"), *const p99 = percentiles.value("p99");
    if (p95 && p99 && table.source().errors() == errors && !(number.p95 <= number.p99))
      percentiles.fail("p99", fmt::format("found {}, less than the percentile of 95 %, {}; it must be at least that",
                                          found(*p99), found(*p95)));
  });
  return number;
}

/// Reads the table of a hazard, with the columns for spin and position that it may have.
void read_rocks(SceneTable& table, const fs::path& file, RockHazard& hazard) {
  const std::vector<AllowedColumn> allowed{{"mass", dimension::mass, Range::positive},
                                           {"speed", dimension::velocity, Range::positive},
                                           {"height", dimension::length},
                                           {"spin", dimension::angular_velocity},
                                           {"along", dimension::length}};
  constexpr std::array<double Rock::*, 5> members{&Rock::mass, &Rock::speed, &Rock::height, &Rock::spin, &Rock::along};
  constexpr std::size_t required = 3;
  std::vector<QuantityColumn> columns;
  try {
    columns = read_quantity_table(file, allowed, si);
  } catch (const InputError& error) {
    table.fail("table", error.what());
  } catch (const IoError& error) {
    throw IoError{fmt::format("{}: hazard: table: {}", table.source().file, error.what())};
  }
  const auto column_named = [&](const std::string& name) {
    return std::ranges::find(columns, name, &QuantityColumn::name);
  };
  hazard.table_has_spin = column_named("spin") != columns.end();
  hazard.table_has_along = column_named("along") != columns.end();
  hazard.table.resize(columns.front().values.size());
  hazard.table_name = file.filename().string();
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    const auto column = column_named(allowed[i].name);
    if (column == columns.end()) {
      if (i < required)
        table.fail("table", fmt::format("{}: the column {} is missing; give it", file.string(), allowed[i].name));
      continue;
    }
    for (std::size_t row = 0; row < hazard.table.size(); ++row)
      hazard.table[row].*members[i] = column->values[row];
  }
}

RockHazard read_hazard(SceneTable table, const fs::path& folder) {
  table.allow({"mass", "speed", "height", "spin", "along", "table", "runs"});
  RockHazard hazard;
  if (table.has("runs")) hazard.runs = static_cast<std::size_t>(table.whole_between("runs", 1, 1'000'000));
  hazard.spin = range_of(table, "spin", dimension::angular_velocity);
  hazard.along = range_of(table, "along", dimension::length);
  if (table.has("table")) {
    constexpr const char* reason = "the rows of the table give it";
    for (const char* other : {"mass", "speed", "height"})
      table.refuse(other, reason);
    read_rocks(table, folder / table.file_name("table"), hazard);
    if (hazard.table_has_spin) table.refuse("spin", reason);
    if (hazard.table_has_along) table.refuse("along", reason);
    return hazard;
  }
  hazard.mass = read_number(table, "mass", dimension::mass);
  hazard.speed = read_number(table, "speed", dimension::velocity);
  hazard.height = read_number(table, "height", dimension::length);
  return hazard;
}

}  // namespace

double RockNumber::at(double z) const {
  if (p95 == p99) return p95;
  const double deviation = std::log(p99 / p95) / (normal_99 - normal_95);
  return p95 * std::exp(deviation * (z - normal_95));
}

CapacityFile read_capacity(std::string_view text, const fs::path& name) {
  const TomlValue document = parse_toml(text, name.string());
  SceneSource source{name.string(), si};
  SceneTable file{source, document, ""};
  const fs::path folder = name.parent_path();
  CapacityFile made;
  made.file = name;
  source.collect();
  try {
    file.allow({"title", "base", "mass", "speed", "height", "spin", "along", "set", "map", "changes", "seed", "hazard",
                "limits"});
    made.title = file.title();
    made.base = folder / file.file_name("base");
    made.mass = ends_of(file, "mass", dimension::mass);
    made.speed = ends_of(file, "speed", dimension::velocity);
    if (file.has("height")) made.heights = file.quantities_or_one("height", dimension::length, Range::positive);
    if (file.has("spin")) made.spins = file.quantities_or_one("spin", dimension::angular_velocity);
    if (file.has("along")) made.positions = file.quantities_or_one("along", dimension::length);
    constexpr std::size_t maximum_maps = 100;
    const auto count = [](const std::vector<double>& list) { return std::max<std::size_t>(1, list.size()); };
    for (const auto& [key, list] :
         {std::pair{"height", &made.heights}, {"spin", &made.spins}, {"along", &made.positions}}) {
      std::vector<double> sorted = *list;
      std::ranges::sort(sorted);
      if (std::ranges::adjacent_find(sorted) != sorted.end())
        file.report(key, fmt::format("found {}, with one value twice; remove it", found(*file.value(key))));
    }
    if (const std::size_t maps = count(made.heights) * count(made.spins) * count(made.positions); maps > maximum_maps)
      file.report("height", fmt::format("with `spin` and `along` there are {} maps; there may be at most {}", maps,
                                        maximum_maps));
    if (const TomlValue* const fields = file.value("set")) {
      const auto* const table = std::get_if<TomlTable>(&fields->data);
      if (table == nullptr) file.fail("set", "it must be a table of fields of the base with their values");
      for (const TomlEntry& entry : *table) {
        if (std::holds_alternative<TomlArray>(entry.value.data) || std::holds_alternative<TomlTable>(entry.value.data))
          file.fail("set", fmt::format("{}: found {}; it must be a number, a text, true or false", entry.key,
                                       found(entry.value)));
        made.fields.emplace_back(entry.key, entry.value);
      }
    }
    if (file.has("map")) read_map(file.table("map"), made);
    if (file.has("changes")) read_changes(file.table("changes"), made.changes);
    if (const RockChanges& of = made.changes;
        !(of.speed > 0.0 || of.height > 0.0 || of.angle > 0.0 || of.spin > 0.0 || of.along > 0.0))
      file.report("changes", "all are 0, so that the runs of a node would be the same; give one that is > 0");
    if (file.has("seed")) made.seed = file.whole_between("seed", 0, 1'000'000'000);
    if (file.has("hazard")) made.hazard = read_hazard(file.table("hazard"), folder);
    if (file.has("limits")) made.limits = read_evaluation_limit(file.table("limits"));
  } catch (const SceneSource::Collected&) {
    source.check();
    throw;
  }
  source.check();
  return made;
}

}  // namespace talus::app
