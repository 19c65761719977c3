#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/draw/curve_choice.hpp"
#include "solver/draw/history_plot.hpp"
#include "solver/draw/run_figures.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  HistoryPlotOptions wish;
  std::vector<double> x_limits;
  std::vector<double> y_limits;
  bool list{false};
};

Limits limits(const char* option, const std::vector<double>& ends) {
  if (ends.empty()) return {};
  if (!(ends[0] < ends[1])) {
    throw InputError{fmt::format("{}: found {} {}; the first must be less than the second", option, ends[0], ends[1])};
  }
  return std::pair{ends[0], ends[1]};
}

int plot(PlotOptions& options, const DrawingSink& sink) {
  HistoryPlotOptions& wish = options.wish;
  if (options.list) return list_histories(wish.folders);
  if (!wish.histories.empty()) {
    wish.x_limits = limits("--x-limits", options.x_limits);
    wish.y_limits = limits("--y-limits", options.y_limits);
    sink(history_drawing(wish));
    return ok;
  }
  const fs::path folder = wish.folders.front();
  if (wish.folders.size() > 1) throw InputError{"several runs are drawn over each other by --history only; name one"};
  sink(run_drawing({.folder = folder,
                    .target = wish.picture.folder.empty() ? folder / "plots" : fs::path{wish.picture.folder},
                    .elements = wish.elements,
                    .all = wish.all,
                    .formats = wish.picture.formats}));
  return ok;
}

}  // namespace

Command add_plot(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* app = talus.add_subcommand("plot", "Draw the histories of a run, or chosen ones of several runs");
  const auto options = std::make_shared<PlotOptions>();
  HistoryPlotOptions& wish = options->wish;
  app->add_option("DIR", wish.folders,
                  "folders that `talus run --out` or `talus cell --out` wrote; without --history one, drawn whole")
      ->required();
  CLI::Option* const history =
      app->add_option(
             "--history", wish.histories,
             "histories to draw: a number or title of 1993 (48), a quantity (top_tension, vx) or a whole column "
             "(rock.vx)")
          ->delimiter(',');
  app->add_option(
         "--element", wish.elements,
         fmt::format("elements by number, bodies and cables by name; default: all, of more than {} curves in a "
                     "panel those with the largest range (maximum less minimum)",
                     maximum_curves))
      ->delimiter(',');
  app->add_flag("--all", wish.all, "all curves, however many a panel has");
  app->add_option("--x", wish.abscissa, "abscissa, named as a history is; default time");
  app->add_option("--until", wish.until, "last time drawn, e.g. \"0.1 s\"");
  app->add_flag("--apart", wish.apart, "a panel for each history; else for each unit");
  app->add_option("--columns", wish.columns, "panels side by side")->check(whole_between(1, 6));
  app->add_option("--x-limits", options->x_limits, "window: the abscissa's ends, in its unit")->expected(2);
  app->add_option("--y-limits", options->y_limits, "window: the ordinate's ends, in its unit")->expected(2);
  app->add_option("--x-title", wish.x_title, "words at the abscissa");
  app->add_option("--y-title", wish.y_title, "words at the ordinate");
  app->add_option("--divisions", wish.divisions, "parts of the grid in x and in y")
      ->expected(2)
      ->check(whole_between(1, 100));
  app->add_flag("--no-grid", wish.no_grid, "no grid");
  app->add_flag("--list", options->list, "print what can be drawn, and of which elements");
  add_format_option(*app, wish.picture);
  add_picture_options(*app, wish.picture);
  // A run drawn whole has the figures of its plot.json, with their axes.
  for (const char* const name : {"--x", "--until", "--apart", "--columns", "--x-limits", "--y-limits", "--x-title",
                                 "--y-title", "--divisions", "--no-grid", "--name", "--title"})
    app->get_option(name)->needs(history);
  app->footer(
      "Examples:\n"
      "  talus run cases/two_cable.toml --out out && talus plot out --format svg\n"
      "  talus plot out --list\n"
      "  talus plot out --history top_joint_force,48 --element 3,4 --format ps\n"
      "  talus plot slack tight --history 4 --element 2 --x x --title \"Rock\"");
  return {app, [options, sink] { return plot(*options, sink); }};
}

}  // namespace talus::app
