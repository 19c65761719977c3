#include "solver/draw/run_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/error.hpp"
#include "solver/draw/curve_choice.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/draw/history_choice.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What a curve is of: "rock" of "rock.vx", "energy" of "energy.kinetic".
std::string subject_of(const Json& series) {
  const std::string label = series.at("label").get<std::string>();
  return label.substr(0, label.rfind('.'));
}

/// Leaves the curves of the elements. Errors: InputError for one that has none in any figure.
void keep_elements(Json& figures, const KeptRun& run, const std::vector<std::string>& elements) {
  std::set<std::string> wanted;
  std::vector<std::string> known;
  for (const Json& figure : figures) {
    for (const Json& series : figure.at("series")) {
      const std::string subject = subject_of(series);
      if (std::find(known.begin(), known.end(), subject) == known.end()) known.push_back(subject);
    }
  }
  for (const std::string& element : elements) {
    const std::vector<std::string> names = subjects_of(run, element);
    const auto found = std::find_first_of(known.begin(), known.end(), names.begin(), names.end());
    if (found == known.end())
      throw InputError{fmt::format("--element: {}", unknown_name("element", element, known).what())};
    wanted.insert(*found);
  }
  Json kept = Json::array();
  for (Json& figure : figures) {
    Json curves = Json::array();
    for (Json& series : figure.at("series"))
      if (wanted.contains(subject_of(series))) curves.push_back(std::move(series));
    if (curves.empty()) continue;
    figure["series"] = std::move(curves);
    kept.push_back(std::move(figure));
  }
  figures = std::move(kept);
}

/// Leaves the curves with the largest ranges.
void keep_widest(Json& figure, const KeptHistory& history) {
  const Json& series = figure.at("series");
  std::vector<double> ranges;
  for (const Json& curve : series) {
    const KeptColumn* column = history.find(curve.at("label").get<std::string>());
    ranges.push_back(column != nullptr ? range_of(column->values) : 0.0);
  }
  Json kept = Json::array();
  for (const std::size_t place : places_of_largest(ranges, most_curves))
    kept.push_back(series.at(place));
  print_left_out(figure.at("name").get<std::string>(), kept.size(), series.size());
  figure["series"] = std::move(kept);
}

}  // namespace

int draw_run_figures(const RunFigureOptions& options) {
  const fs::path file = options.folder / "plot.json";
  Json plot;
  try {
    plot = Json::parse(read_text(file));
    Json& figures = plot.at("figures");
    if (!options.elements.empty()) keep_elements(figures, read_kept_run(options.folder.string()), options.elements);
    if (!options.all && options.elements.empty()) {
      std::map<std::string, KeptHistory> histories;
      for (Json& figure : figures) {
        if (figure.at("series").size() <= most_curves) continue;
        const std::string csv = figure.at("csv").get<std::string>();
        if (!histories.contains(csv)) histories.emplace(csv, read_history(options.folder / csv));
        keep_widest(figure, histories.at(csv));
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError{fmt::format("{}: it is not what `talus run --out` or `talus cell --out` leaves: {}", file.string(),
                                 error.what())};
  }
  const DrawingRecord record{options.target};
  std::set<std::string> csv_files;
  for (const Json& figure : plot.at("figures"))
    csv_files.insert(figure.at("csv").get<std::string>());
  for (const std::string& csv : csv_files)
    record.link(csv, options.folder / csv);
  record.add("plot.json", plot.dump(1));
  return record.draw(options.formats);
}

}  // namespace talus::app
