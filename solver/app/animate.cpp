#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/draw/player_data.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct AnimateOptions {
  std::string folder;
  bool gif{false};
  bool html{false};
  std::vector<double> window;
  bool numbers{false};
  double seconds{6.0};
  std::string until;
  PictureOptions picture;
};

/// The states up to the time of --until; all without it.
std::vector<GeometryFile> chosen_files(const RunFolder& run, const AnimateOptions& options) {
  std::vector<GeometryFile> files = state_files(run);
  if (options.until.empty()) return files;
  const double until = option_time("--until", options.until, run);
  files.erase(std::remove_if(files.begin(), files.end(), [until](const auto& file) { return file.time > until; }),
              files.end());
  if (files.size() < 2) {
    throw InputError{fmt::format(
        "--until: found \"{}\"; the run has fewer than two states up to that time; give a later one", options.until)};
  }
  return files;
}

/// One page for each frame: the side view, and beside it the view along the fence if positions along z differ.
template <class Drawn>
reports::Film film(const Drawn& drawn, const std::string& name, const std::string& title, const FrameStyle& side,
                   const FrameStyle& along, double seconds) {
  reports::Film made{name, seconds / static_cast<double>(drawn.frames.size()), {}};
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
    reports::Page page{.name = fmt::format("page{}", i),
                       .title = title,
                       .panels = {frame_figure(drawn, i, side)},
                       .scale = colour_scale(drawn)};
    if (drawn.has_depth) page.panels.push_back(frame_figure(drawn, i, along));
    page.columns = static_cast<int>(page.panels.size());
    made.pages.push_back(std::move(page));
  }
  return made;
}

/// The GIF or HTML player, or both, as requested. `drawn`: DrawnGeometry or DrawnDiscs.
template <class Drawn>
DrawingRequest animation(const Drawn& drawn, const SavedRun& run, const AnimateOptions& options) {
  FrameStyle side{View::side, window_of(drawn, View::side), options.numbers, true, {}};
  if (!options.window.empty())
    side.window = {options.window[0], options.window[1], options.window[2], options.window[3]};
  const FrameStyle along{View::along, window_of(drawn, View::along), options.numbers, true, {}};
  const PictureOptions& picture = options.picture;
  const std::string name = picture.name.empty() ? "animation" : picture.name;
  const std::string title = picture.title.empty() ? run.run.title : picture.title;
  DrawingRequest request{
      .pictures = {},
      .target = picture.folder.empty() ? fs::path{options.folder} / "plots" : fs::path{picture.folder},
      .formats = {}};
  if (options.gif) request.pictures.films.push_back(film(drawn, name, title, side, along, options.seconds));
  if (options.html || !options.gif)
    request.pictures.players.push_back({name, title, player_json(drawn, run, side.window, along.window)});
  return request;
}

int animate(const AnimateOptions& options, const DrawingSink& sink) {
  if (!options.window.empty() && !(options.window[0] < options.window[2] && options.window[1] < options.window[3])) {
    throw InputError{fmt::format("--window: found {}; it must be x-min y-min x-max y-max, with min < max",
                                 fmt::join(options.window, " "))};
  }
  const SavedRun run = read_saved_run(options.folder);
  const DrawnStates states = read_states(run.run, chosen_files(run.run, options), options.picture.colour);
  sink(std::visit([&](const auto& drawn) { return animation(drawn, run, options); }, states));
  return ok;
}

}  // namespace

Command add_animate(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* app = talus.add_subcommand("animate", "Write an animation of a run: an HTML page or a GIF");
  const auto options = std::make_shared<AnimateOptions>();
  app->add_option("DIR", options->folder, "folder that `talus run --out` or `talus cell --out` wrote")->required();
  app->add_flag("--html", options->html, "one HTML page with all in it, which any browser plays; the default");
  app->add_flag("--gif", options->gif, "a GIF; with --html both");
  app->add_option("--seconds", options->seconds, "how long the GIF takes; default 6")
      ->check(number_between(0.1, 600.0));
  app->add_option("--until", options->until, "last time shown, e.g. \"0.1 s\"");
  app->add_option("--window", options->window, "x-min y-min x-max y-max of the side view; default: all that moves")
      ->expected(4);
  app->add_flag("--numbers", options->numbers, "numbers of elements or discs in the GIF");
  add_colour_option(*app, options->picture);
  add_picture_options(*app, options->picture);
  app->footer(
      "More states make a smoother motion: talus run SCENE --out out --frames 200; of a cell, a shorter LOOP.\n"
      "Examples:\n"
      "  talus run cases/fence/sample2.DAT --out out --frames 200 && talus animate out\n"
      "  talus animate out --gif --seconds 10\n"
      "  talus cell cases/cell/ice.toml --out cell && talus animate cell --colour force --gif --html");
  return {app, [options, sink] { return animate(*options, sink); }};
}

}  // namespace talus::app
