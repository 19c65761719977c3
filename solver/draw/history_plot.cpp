#include "solver/draw/history_plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/draw/curve_choice.hpp"
#include "solver/draw/frame_style.hpp"
#include "solver/draw/history_choice.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// One curve and the name of its run.
struct RunCurve {
  std::string run;
  SelectedCurve curve;
};

/// Curves drawn in one panel.
struct CurvePanel {
  std::string key;  ///< history or unit that all curves of the panel share
  std::vector<RunCurve> curves;
};

/// Distinct names of the runs: their folder names, or the paths as given if two folder names are equal.
std::vector<std::string> run_names(const std::vector<std::string>& folders) {
  if (folders.size() == 1) return {""};
  std::vector<std::string> names;
  for (const std::string& folder : folders) {
    const fs::path path = fs::path{folder}.lexically_normal();
    names.push_back((path.has_filename() ? path.filename() : path.parent_path().filename()).string());
  }
  auto sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const bool distinct = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  return distinct ? names : folders;
}

/// Truncates the curve at a time.
void cut(SelectedCurve& curve, const std::vector<double>& times, double until) {
  const auto rows = static_cast<std::size_t>(
      std::count_if(times.begin(), times.end(), [until](double time) { return time <= until; }));
  curve.x.values.resize(rows);
  curve.y.values.resize(rows);
}

std::vector<CurvePanel> panels_of(const HistoryPlotOptions& options) {
  const std::vector<std::string> names = run_names(options.folders);
  std::vector<CurvePanel> panels;
  for (std::size_t i = 0; i < options.folders.size(); ++i) {
    const SavedRun run = read_saved_run(options.folders[i]);
    for (const std::string& history : options.histories) {
      for (SelectedCurve& curve : selected_curves(run, {history, options.elements, options.abscissa})) {
        if (!options.until.empty()) {
          const double until = option_time("--until", options.until, run.run, false);
          cut(curve, selected_curves(run, {history, options.elements, "time"}).front().x.values, until);
          if (curve.x.values.size() < 2) {
            throw InputError{
                fmt::format("--until: found \"{}\"; {} has fewer than two records up to that time; give a later one",
                            options.until, options.folders[i])};
          }
        }
        const std::string key = options.apart ? history : curve.y.unit;
        auto found = std::find_if(panels.begin(), panels.end(), [&](const auto& panel) { return panel.key == key; });
        if (found == panels.end()) found = panels.insert(found, {key, {}});
        found->curves.push_back({names[i], std::move(curve)});
      }
    }
  }
  return panels;
}

/// Keeps only the curves with the largest ranges; with several runs, a quantity is kept for all runs or for none. Adds
/// a note about omitted curves.
void limit(CurvePanel& panel, std::vector<std::string>& notes) {
  if (panel.curves.size() <= maximum_curves) return;
  using Quantity = std::pair<std::string, std::string>;
  const auto quantity_of = [](const RunCurve& each) {
    return Quantity{each.curve.y.subject, each.curve.y.description};
  };
  std::vector<Quantity> quantities;
  std::vector<double> ranges;
  std::vector<std::size_t> counts;
  for (const RunCurve& each : panel.curves) {
    const auto known = std::find(quantities.begin(), quantities.end(), quantity_of(each));
    const auto index = static_cast<std::size_t>(known - quantities.begin());
    if (known == quantities.end()) quantities.push_back(quantity_of(each)), ranges.push_back(0.0), counts.push_back(0);
    ranges[index] = std::max(ranges[index], range_of(each.curve.y.values));
    ++counts[index];
  }
  const std::size_t runs = *std::max_element(counts.begin(), counts.end());
  const auto kept = indices_of_largest(ranges, std::max<std::size_t>(maximum_curves / runs, 1));
  std::vector<RunCurve> curves;
  for (RunCurve& each : panel.curves) {
    const auto known = std::find(quantities.begin(), quantities.end(), quantity_of(each));
    if (std::binary_search(kept.begin(), kept.end(), static_cast<std::size_t>(known - quantities.begin())))
      curves.push_back(std::move(each));
  }
  note_left_out(panel.key.empty() ? "panel" : fmt::format("panel [{}]", panel.key), curves.size(), panel.curves.size(),
                notes);
  panel.curves = std::move(curves);
}

/// The text that all curves share; empty if they differ.
template <class Word>
std::string shared(const std::vector<RunCurve>& curves, Word word) {
  const std::string first = word(curves.front());
  const bool all = std::all_of(curves.begin(), curves.end(), [&](const RunCurve& each) { return word(each) == first; });
  return all ? first : "";
}

std::string subject(const RunCurve& each) { return each.curve.y.subject; }
std::string description(const RunCurve& each) { return each.curve.y.description; }
std::string run_name(const RunCurve& each) { return each.run; }

/// Label that distinguishes a curve from the others of its panel.
std::string label(const RunCurve& each, const CurvePanel& panel) {
  std::vector<std::string> parts;
  if (shared(panel.curves, run_name).empty() && !each.run.empty()) parts.push_back(each.run);
  if (shared(panel.curves, subject).empty() || panel.curves.size() == 1) parts.push_back(each.curve.y.subject);
  if (shared(panel.curves, description).empty()) parts.push_back(each.curve.y.description);
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return fmt::format("{}", fmt::join(parts, ", "));
}

records::Axis axis(const std::string& title, const std::string& fallback, const std::string& unit, const Limits& limits,
                   int divisions) {
  records::Axis made{
      .label = !title.empty() ? title : fallback, .unit = title.empty() ? unit : "", .divisions = divisions};
  if (limits) made.min = limits->first;
  if (limits) made.max = limits->second;
  return made;
}

void demand_one_unit(const CurvePanel& panel) {
  const auto x_unit = [](const RunCurve& each) { return each.curve.x.unit; };
  const auto y_unit = [](const RunCurve& each) { return each.curve.y.unit; };
  for (const RunCurve& each : panel.curves) {
    const RunCurve& first = panel.curves.front();
    if (x_unit(each) == x_unit(first) && y_unit(each) == y_unit(first)) continue;
    throw InputError{fmt::format("{} of {} is in {} against {}, {} of {} in {} against {}; one panel has one unit",
                                 first.curve.y.description, first.run, y_unit(first), x_unit(first),
                                 each.curve.y.description, each.run, y_unit(each), x_unit(each))};
  }
}

/// The figure of a panel; moves the values out of the panel's curves.
records::Figure figure(CurvePanel& panel, const HistoryPlotOptions& options, std::size_t index, bool alone) {
  demand_one_unit(panel);
  const SelectedCurve& first = panel.curves.front().curve;
  const std::string common = shared(panel.curves, description);
  const bool of_time = options.abscissa == "time";
  const std::string x_label = of_time || first.x.subject.empty() ? first.x.description
                              : first.x.subject == first.y.subject
                                  ? first.x.description
                                  : fmt::format("{} of {}", first.x.description, first.x.subject);
  const std::string y_label = common.empty() ? "value" : common;
  const std::vector<int> divisions = options.divisions.empty() ? std::vector<int>{0, 0} : options.divisions;
  records::Figure made{.name = fmt::format("panel{}", index),
                       .title = alone ? "" : fmt::format("({})", static_cast<char>('a' + static_cast<int>(index % 26))),
                       .caption = "",
                       .x = axis(options.x_title, x_label, first.x.unit, options.x_limits, divisions[0]),
                       .y = axis(options.y_title, y_label, first.y.unit, options.y_limits, divisions[1]),
                       .grid = !options.no_grid};
  for (RunCurve& each : panel.curves) {
    records::Series& series = made.series.emplace_back(frame_series(label(each, panel), records::Style::lines, {}));
    series.x = std::move(each.curve.x.values);
    series.y = std::move(each.curve.y.values);
  }
  return made;
}

/// File stem: --name if given, "history_" and the history's name for a single history, else "histories".
std::string file_stem(const HistoryPlotOptions& options) {
  if (!options.picture.name.empty()) return options.picture.name;
  if (options.histories.size() != 1) return "histories";
  std::string stem;
  for (const char letter : options.histories.front())
    stem += std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' ? letter : '_';
  return "history_" + stem;
}

}  // namespace

DrawingRequest history_drawing(const HistoryPlotOptions& options) {
  std::vector<CurvePanel> panels = panels_of(options);
  const PictureOptions& picture = options.picture;
  DrawingRequest request{
      .pictures = {},
      .target = picture.folder.empty() ? fs::path{options.folders.front()} / "plots" : fs::path{picture.folder},
      .formats = picture.formats};
  if (!options.all && options.elements.empty()) {
    for (CurvePanel& panel : panels)
      limit(panel, request.notes);
  }
  const std::string own_title = options.folders.size() == 1 ? read_run_folder(options.folders.front()).title : "";
  reports::Page page{.name = file_stem(options),
                     .title = picture.title.empty() ? own_title : picture.title,
                     .columns = options.columns > 0 ? options.columns
                                : panels.size() > 2 ? 2
                                                    : 1,
                     .panels = {}};
  for (std::size_t i = 0; i < panels.size(); ++i)
    page.panels.push_back(figure(panels[i], options, i, panels.size() == 1));
  request.pictures.pages.push_back(std::move(page));
  return request;
}

int list_histories(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders)
    fmt::print("{}", menu(read_saved_run(folder)));
  return ok;
}

}  // namespace talus::app
