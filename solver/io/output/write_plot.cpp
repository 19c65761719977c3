#include "solver/io/output/write_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/io/output/write_history.hpp"
#include "verification/record/figure_fields.hpp"

namespace talus {
namespace {

using records::Json;

/// One kind of figure: all columns whose names have one of these endings (or this beginning), against time.
struct FigureKind {
  std::string_view name;
  std::string_view title;
  std::string_view axis;
  std::vector<std::string_view> endings;
  std::string_view beginning;
};

const std::vector<FigureKind>& kinds() {
  static const std::vector<FigureKind> all{
      {"positions", "Positions of the centres of mass", "position", {".x", ".y"}, ""},
      {"angles", "Angles", "angle", {".angle"}, ""},
      {"velocities", "Velocities", "velocity", {".vx", ".vy"}, ""},
      {"spins", "Angular velocities", "angular velocity", {".spin"}, ""},
      {"overlaps", "Overlaps of the contacts", "overlap", {".overlap"}, ""},
      {"contact_forces", "Contact forces", "force", {".force"}, ""},
      {"tensions", "Cable tensions", "tension", {".tension"}, ""},
      {"energies", "Energies", "energy", {}, "energy."},
      {"dissipation", "Dissipated energy, by mechanism", "energy", {}, "dissipated."},
      {"energy_balance_error", "Energy balance error", "energy", {}, "balance_error.energy"}};
  return all;
}

bool belongs(const Column& column, const FigureKind& kind) {
  const std::string_view name = column.name;
  if (!kind.beginning.empty()) return name.substr(0, kind.beginning.size()) == kind.beginning;
  return std::any_of(kind.endings.begin(), kind.endings.end(), [name](std::string_view ending) {
    return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
  });
}

/// Whether a curve is zero throughout; such curves are not drawn.
bool is_zero(const History& history, std::size_t column) {
  return std::all_of(history.rows.begin(), history.rows.end(),
                     [column](const std::vector<double>& row) { return row[column] == 0.0; });
}

records::Axis axis(std::string_view label, const UnitSystem& units, Dimension dimension) {
  return {.label = std::string{label}, .unit = symbol(units, dimension)};
}

}  // namespace

std::string plot_json(const RunRecord& record, const std::string& csv_file, const RunFiles& files) {
  const History& history = record.history;
  std::vector<records::Figure> figures;
  for (const FigureKind& kind : kinds()) {
    std::vector<records::Series> all;
    Dimension dimension;
    for (std::size_t i = 1; i < history.columns.size(); ++i) {
      const Column& column = history.columns[i];
      if (!belongs(column, kind) || is_zero(history, i)) continue;
      dimension = column.dimension;
      records::Series& series = all.emplace_back();
      series.label = column.name;
      series.style = records::Style::lines;
      series.columns.x = csv_header(history.columns[0], record.units);
      series.columns.y = csv_header(column, record.units);
    }
    if (all.empty()) continue;
    figures.push_back({.name = std::string{kind.name},
                       .title = std::string{kind.title},
                       .caption = fmt::format("{}: {}.", record.title, kind.title),
                       .x = axis("time", record.units, dimension::time),
                       .y = axis(kind.axis, record.units, dimension),
                       .series = std::move(all),
                       .csv = csv_file});
  }
  Json json = run_folder_json(record.title, record.units, files);
  json["figures"] = records::json_of(figures);
  return json.dump(2) + "\n";
}

}  // namespace talus
