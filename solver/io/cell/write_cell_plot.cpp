#include "solver/io/cell/write_cell_plot.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "solver/io/output/run_folder.hpp"
#include "verification/record/figure_fields.hpp"

namespace talus {
namespace {

/// A column of a CSV file and its label in pictures.
struct Drawn {
  std::string_view column;
  std::string_view label;
};

/// A figure: columns over one abscissa, or the height over one column.
struct Kind {
  std::string_view name, title, axis;
  Dimension dimension;
  std::vector<Drawn> columns;
  bool with_friction{};  ///< only for cells whose discs turn
};

const std::vector<Kind>& histories() {
  static const std::vector<Kind> all{
      {"stresses",
       "Stresses on the walls",
       "stress",
       dimension::pressure,
       {{"top_shear", "S on the block"},
        {"top_normal", "N on the block"},
        {"bottom_shear", "S on the base"},
        {"bottom_normal", "N on the base"}}},
      {"stress_ratio", "Stress ratio", "S/N on the block", dimension::number, {{"stress_ratio", ""}}},
      {"depth", "Depth of the field", "depth", dimension::length, {{"depth", ""}}},
      {"fractions",
       "Solid fraction and contacts",
       "fraction",
       dimension::number,
       {{"solid_fraction", "solid fraction"},
        {"touching", "fraction of time with contacts"},
        {"multiple_fraction", "fraction of contact time in multiple contacts"}}},
      {"coordination", "Contacts of a free disc", "coordination", dimension::number, {{"coordination", ""}}}};
  return all;
}

const std::vector<Kind>& profiles() {
  static const std::vector<Kind> all{
      {"velocity_profile", "Velocity over the height", "velocity along x", dimension::velocity, {{"velocity", ""}}},
      {"temperature_profile",
       "Granular temperature over the height",
       "energy of a disc's motion about the mean",
       dimension::energy,
       {{"temperature", ""}}},
      {"solid_fraction_profile",
       "Solid fraction over the height",
       "solid fraction",
       dimension::number,
       {{"solid_fraction", ""}}},
      {"spin_profile", "Spin over the height", "spin", dimension::angular_velocity, {{"spin", ""}}, true}};
  return all;
}

records::Axis axis(const CellScene& scene, std::string_view label, Dimension dimension) {
  return {.label = std::string{label}, .unit = scene.units ? symbol(*scene.units, dimension) : ""};
}

records::Figure figure(const CellScene& scene, const Kind& kind, std::string_view csv, std::string_view caption) {
  return {.name = std::string{kind.name},
          .title = std::string{kind.title},
          .caption = fmt::format("{}: {}{}.", scene.title, kind.title, caption),
          .x = {},
          .y = {},
          .series = {},
          .csv = std::string{csv}};
}

records::Series series(std::string_view label, std::string x, std::string y) {
  records::Series made{.label = std::string{label}, .x = {}, .y = {}};
  made.columns.x = std::move(x);
  made.columns.y = std::move(y);
  return made;
}

records::Figure history_figure(const CellScene& scene, const Kind& kind) {
  records::Figure made = figure(scene, kind, "history.csv", ", means over each LOOP");
  made.x = axis(scene, "time", dimension::time);
  made.y = axis(scene, kind.axis, kind.dimension);
  for (const Drawn& drawn : kind.columns) {
    made.series.push_back(series(drawn.label, cell_header(scene, "time", dimension::time),
                                 cell_header(scene, drawn.column, kind.dimension)));
  }
  return made;
}

records::Figure profile_figure(const CellScene& scene, const Kind& kind) {
  records::Figure made = figure(scene, kind, "profile.csv", ", mean after the start-up");
  made.x = axis(scene, kind.axis, kind.dimension);
  made.y = axis(scene, "height y", dimension::length);
  made.series.push_back(series("", cell_header(scene, kind.columns.front().column, kind.dimension),
                               cell_header(scene, "y", dimension::length)));
  return made;
}

}  // namespace

std::string cell_plot_json(const CellScene& scene, const CellRun& run) {
  RunFiles files;
  files.histories = {"history.csv"};
  if (scene.pictures) files.geometry = "cell.pvd";
  files.period = scene.cell.width();
  records::Json json = run_folder_json(scene.title, scene.units, files);
  std::vector<records::Figure> figures;
  for (const Kind& kind : histories())
    if (run.intervals() > 0) figures.push_back(history_figure(scene, kind));
  const bool has_profile = cell_profile(scene, run).rows() > 0;
  for (const Kind& kind : profiles())
    if (has_profile && (scene.cell.friction || !kind.with_friction)) figures.push_back(profile_figure(scene, kind));
  json["figures"] = records::json_of(figures);
  return json.dump(2) + "\n";
}

}  // namespace talus
