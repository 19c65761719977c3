#include "solver/draw/run_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/draw/curve_choice.hpp"
#include "solver/draw/history_choice.hpp"
#include "solver/io/output/run_folder.hpp"
#include "verification/record/error.hpp"
#include "verification/record/figure_points.hpp"
#include "verification/record/plots.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Subject of a curve: "rock" for "rock.vx", "energy" for "energy.kinetic".
std::string subject_of(const records::Series& series) { return series.label.substr(0, series.label.rfind('.')); }

/// Keeps only the curves of the given elements. Errors: InputError for an element without curves in any figure.
void keep_elements(std::vector<records::Figure>& figures, const SavedRun& run,
                   const std::vector<std::string>& elements) {
  std::set<std::string> wanted;
  std::vector<std::string> known;
  for (const records::Figure& figure : figures) {
    for (const records::Series& series : figure.series) {
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
  for (records::Figure& figure : figures)
    std::erase_if(figure.series, [&](const auto& series) { return !wanted.contains(subject_of(series)); });
  std::erase_if(figures, [](const records::Figure& figure) { return figure.series.empty(); });
}

/// Keeps only the curves with the largest ranges. Adds a note about omitted curves.
void keep_widest(records::Figure& figure, std::vector<std::string>& notes) {
  std::vector<double> ranges;
  for (const records::Series& curve : figure.series)
    ranges.push_back(range_of(curve.y));
  std::vector<records::Series> kept;
  for (const std::size_t index : indices_of_largest(ranges, maximum_curves))
    kept.push_back(std::move(figure.series[index]));
  note_left_out(figure.name, kept.size(), figure.series.size(), notes);
  figure.series = std::move(kept);
}

/// The figures described by the run's plot.json, without their points. Errors: IoError, InputError.
std::vector<records::Figure> figures_of(const fs::path& file) {
  try {
    return records::read_plots(file);
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  } catch (const records::RecordError& error) {
    throw InputError{
        fmt::format("{}; it is not a file written by `talus run --out` or `talus cell --out`", error.what())};
  }
}

}  // namespace

DrawingRequest run_drawing(const RunFigureOptions& options) {
  demand_run_folder(options.folder);
  std::vector<records::Figure> figures = figures_of(options.folder / "plot.json");
  if (!options.elements.empty()) keep_elements(figures, read_saved_run(options.folder.string()), options.elements);
  try {
    records::read_points(figures, options.folder);
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  }
  DrawingRequest request{.pictures = {}, .target = options.target, .formats = options.formats};
  if (!options.all && options.elements.empty()) {
    for (records::Figure& figure : figures)
      if (figure.series.size() > maximum_curves) keep_widest(figure, request.notes);
  }
  request.pictures.figures = std::move(figures);
  return request;
}

}  // namespace talus::app
