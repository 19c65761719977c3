#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/draw/drawn_states.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// The name of all views together.
constexpr std::string_view both_views = "both";

/// Options of `talus snapshot`, corresponding to GPLOT's dialogue.
struct SnapshotOptions {
  std::string folder;
  std::vector<std::string> times;
  int count{9};
  std::string view{name_of(View::side)};
  std::vector<double> window;
  bool numbers{false};
  bool no_grid{false};
  std::vector<int> divisions;
  bool single{false};
  int columns{};
  PictureOptions picture;
};

/// The states to be drawn, and notes that give their times.
struct ChosenStates {
  std::vector<GeometryFile> files;
  std::vector<std::string> notes;
};

std::string time_text(double time, const RunFolder& run) {
  return fmt::format("t = {:.6g}{}", time, run.units ? " " + run.unit(dimension::time) : "");
}

/// Adds the state nearest to the time `text`, with a note that says if it is at another time: states are stored at the
/// end of a step, every n steps.
void add_nearest(ChosenStates& chosen, const std::vector<GeometryFile>& files, const std::string& text,
                 const RunFolder& run) {
  const double time = option_time("--times", text, run, false);
  const double first = files.front().time;
  const double last = files.back().time;
  const double apart = files.size() > 1 ? (last - first) / static_cast<double>(files.size() - 1) : 0.0;
  if (time < first - apart || time > last + apart) {
    const std::string unit = run.units ? " " + run.unit(dimension::time) : "";
    throw InputError{fmt::format("--times: found \"{}\"; the run has states from {:.6g}{} to {:.6g}{}", text, first,
                                 unit, last, unit)};
  }
  const GeometryFile& state =
      *std::min_element(files.begin(), files.end(), [time](const GeometryFile& a, const GeometryFile& b) {
        return std::abs(a.time - time) < std::abs(b.time - time);
      });
  chosen.files.push_back(state);
  // A time that is given as it is printed, with six digits, is the same.
  constexpr double six_digits = 5.1e-6;
  const bool differs = std::abs(state.time - time) > six_digits * std::max(std::abs(time), apart);
  chosen.notes.push_back(fmt::format("state drawn at {}{}", time_text(state.time, run),
                                     differs ? fmt::format(", the nearest one to \"{}\"", text) : ""));
}

ChosenStates chosen_states(const std::vector<GeometryFile>& files, const SnapshotOptions& options,
                           const RunFolder& run) {
  ChosenStates chosen;
  for (const std::string& time : options.times)
    add_nearest(chosen, files, time, run);
  if (!chosen.files.empty()) return chosen;
  const auto count = std::min(static_cast<std::size_t>(options.count), files.size());
  for (std::size_t i = 0; i < count; ++i)
    chosen.files.push_back(files[count == 1 ? files.size() - 1 : i * (files.size() - 1) / (count - 1)]);
  const std::string last = time_text(chosen.files.back().time, run);
  chosen.notes.push_back(count == 1 ? fmt::format("state drawn at {}", last)
                                    : fmt::format("{} states drawn from {} to {}", count,
                                                  time_text(chosen.files.front().time, run), last));
  return chosen;
}

/// Number of panels side by side that makes the page about as high as wide, preferably with a full last row.
int usual_columns(const Window& window, std::size_t panels) {
  const double shape = (window.top - window.bottom) / (window.right - window.left);
  const double wanted = std::clamp(std::sqrt(std::max(shape, 0.1) * static_cast<double>(panels)), 1.0, 5.0);
  const auto cost = [&](std::size_t columns) {
    return std::abs(static_cast<double>(columns) - wanted) + (panels % columns == 0 ? 0.0 : 1.0);
  };
  std::size_t best = 1;
  for (std::size_t columns = 2; columns <= std::min<std::size_t>(5, panels); ++columns)
    if (cost(columns) < cost(best)) best = columns;
  return static_cast<int>(best);
}

template <class Drawn>
void add_pages(std::vector<reports::Page>& pages, const Drawn& drawn, View view, const SnapshotOptions& options) {
  FrameStyle style{view, window_of(drawn, view), options.numbers, !options.no_grid, options.divisions};
  if (!options.window.empty())
    style.window = {options.window[0], options.window[1], options.window[2], options.window[3]};
  const std::string stem =
      fmt::format("{}_{}", options.picture.name.empty() ? "snapshot" : options.picture.name, name_of(view));
  reports::Page page{.name = stem,
                     .title = options.picture.title.empty() ? drawn.run.title : options.picture.title,
                     .panels = {},
                     .scale = colour_scale(drawn)};
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
    page.panels.push_back(frame_figure(drawn, i, style));
    if (!options.single) continue;
    page.name = fmt::format("{}_{:02}", stem, i + 1);
    pages.push_back(page);
    page.panels.clear();
  }
  if (options.single) return;
  page.columns = options.columns > 0 ? options.columns : usual_columns(style.window, page.panels.size());
  pages.push_back(std::move(page));
}

/// The pages of the chosen states. `drawn`: DrawnGeometry or DrawnDiscs.
template <class Drawn>
DrawingRequest snapshot(const Drawn& drawn, const SnapshotOptions& options, std::vector<std::string> notes) {
  if (options.view != name_of(View::side) && !drawn.has_depth) {
    throw InputError{fmt::format("--view: found \"{}\"; the run in '{}' is plane; this view requires a fence",
                                 options.view, options.folder)};
  }
  const PictureOptions& picture = options.picture;
  DrawingRequest request{
      .pictures = {},
      .target = picture.folder.empty() ? fs::path{options.folder} / "plots" : fs::path{picture.folder},
      .formats = picture.formats,
      .notes = std::move(notes)};
  std::vector<reports::Page>& pages = request.pictures.pages;
  for (const View view : {View::side, View::along})
    if (options.view == both_views || options.view == name_of(view)) add_pages(pages, drawn, view, options);
  return request;
}

int snapshot(const SnapshotOptions& options, const DrawingSink& sink) {
  if (!options.window.empty() && !(options.window[0] < options.window[2] && options.window[1] < options.window[3])) {
    throw InputError{fmt::format("--window: found {}; it must be x-min y-min x-max y-max, with min < max",
                                 fmt::join(options.window, " "))};
  }
  const RunFolder run = read_run_folder(options.folder);
  const ChosenStates chosen = chosen_states(state_files(run), options, run);
  const DrawnStates states = read_states(run, chosen.files, options.picture.colour);
  sink(std::visit([&](const auto& drawn) { return snapshot(drawn, options, chosen.notes); }, states));
  return ok;
}

}  // namespace

Command add_snapshot(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* app = talus.add_subcommand("snapshot", "Draw bodies and cables, or discs, of a run at chosen times");
  const auto options = std::make_shared<SnapshotOptions>();
  app->add_option("DIR", options->folder, "folder that `talus run --out` or `talus cell --out` wrote")->required();
  const auto times = app->add_option("--times", options->times,
                                     "times, e.g. \"0 s,50 ms\"; the nearest state is drawn, and its time printed")
                         ->delimiter(',');
  app->add_option("--count", options->count, "number of states, evenly over the run; default 9")
      ->check(whole_between(1, 60))
      ->excludes(times);
  std::vector<std::string> views = names_of<View>();
  views.emplace_back(both_views);
  app->add_option("--view", options->view, "side (x, y), along (z, y: the fence from the front) or both; default side")
      ->check(CLI::IsMember(views));
  app->add_option("--window", options->window, "x-min y-min x-max y-max (along: z for x); default: all that moves")
      ->expected(4);
  app->add_flag("--numbers", options->numbers, "numbers of elements or discs");
  app->add_option("--divisions", options->divisions, "parts of the grid in x and in y")
      ->expected(2)
      ->check(whole_between(1, 100));
  add_colour_option(*app, options->picture);
  app->add_flag("--no-grid", options->no_grid, "no grid");
  app->add_flag("--single", options->single, "a picture for each state instead of one page of them");
  app->add_option("--columns", options->columns, "states side by side")->check(whole_between(1, 12));
  add_format_option(*app, options->picture);
  add_picture_options(*app, options->picture);
  app->footer(
      "Taut cables are coloured by their tension, slack ones are dashed. Discs are coloured by --colour, those of "
      "walls\n"
      "are grey, and bars join those that push each other, as wide as the force.\n"
      "Examples:\n"
      "  talus run cases/fence/sample2.DAT --out out && talus snapshot out --format pdf\n"
      "  talus snapshot out --times \"0 s,20 ms,50 ms\" --view both --numbers\n"
      "  talus cell cases/cell/ice.toml --out cell && talus snapshot cell --colour force --count 4\n"
      "  talus snapshot out --count 1 --window -10 -15 10 9.69 --format ps");
  return {app, [options, sink] { return snapshot(*options, sink); }};
}

}  // namespace talus::app
