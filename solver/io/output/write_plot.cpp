#include "solver/io/output/write_plot.hpp"

#include <fmt/format.h>
#include <array>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "solver/io/output/write_history.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

/// One kind of figure: all columns whose name ends (or begins) so, against time.
struct Kind {
  std::string_view name;
  std::string_view title;
  std::string_view axis;
  std::vector<std::string_view> endings;
  std::string_view beginning;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"positions", "Positions of the centres of mass", "position", {".x", ".y"}, ""},
      {"angles", "Angles", "angle", {".angle"}, ""},
      {"velocities", "Velocities", "velocity", {".vx", ".vy"}, ""},
      {"spins", "Angular velocities", "angular velocity", {".spin"}, ""},
      {"depths", "Overlaps of the contacts", "overlap", {".depth"}, ""},
      {"contact_forces", "Contact forces", "force", {".force"}, ""},
      {"tensions", "Cable tensions", "tension", {".tension"}, ""},
      {"energies", "Energies", "energy", {}, "energy."},
      {"losses", "Energy lost, by mechanism", "energy", {}, "lost."},
      {"energy_closure", "Closure of the energy ledger", "energy", {}, "closure.energy"}};
  return all;
}

bool belongs(const Column& column, const Kind& kind) {
  const std::string_view name = column.name;
  if (!kind.beginning.empty()) return name.substr(0, kind.beginning.size()) == kind.beginning;
  return std::any_of(kind.endings.begin(), kind.endings.end(), [name](std::string_view ending) {
    return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
  });
}

/// Curves that all are zero throughout say nothing.
bool is_zero(const History& history, std::size_t column) {
  return std::all_of(history.rows.begin(), history.rows.end(),
                     [column](const std::vector<double>& row) { return row[column] == 0.0; });
}

Json axis(std::string_view label, const UnitSystem& units, Dimension dimension) {
  return {{"label", label}, {"unit", symbol(units, dimension)}, {"log", false}};
}

}  // namespace

std::string plot_json(const RunRecord& record, const std::string& csv_file, const RunFiles& files) {
  const History& history = record.history;
  Json figures = Json::array();
  for (const Kind& kind : kinds()) {
    Json series = Json::array();
    Dimension dimension;
    for (std::size_t i = 1; i < history.columns.size(); ++i) {
      const Column& column = history.columns[i];
      if (!belongs(column, kind) || is_zero(history, i)) continue;
      dimension = column.dimension;
      series.push_back({{"label", column.name},
                        {"x", csv_header(history.columns[0], record.units)},
                        {"y", csv_header(column, record.units)},
                        {"style", "lines"}});
    }
    if (series.empty()) continue;
    figures.push_back({{"name", kind.name},
                       {"title", kind.title},
                       {"caption", fmt::format("{}: {}.", record.title, kind.title)},
                       {"x", axis("time", record.units, dimension::time)},
                       {"y", axis(kind.axis, record.units, dimension)},
                       {"csv", csv_file},
                       {"series", series},
                       {"slopes", Json::array()},
                       {"lines", Json::array()}});
  }
  Json json = run_folder_json(record.title, record.units, files);
  json["figures"] = std::move(figures);
  return json.dump(2) + "\n";
}

}  // namespace talus
