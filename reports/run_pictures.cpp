#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <utility>

#include "reports/base/error.hpp"
#include "reports/base/file.hpp"
#include "reports/figures/drawing.hpp"
#include "reports/figures/page_script.hpp"
#include "reports/report.hpp"
#include "verification/record/figure_points.hpp"
#include "verification/record/plots.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

namespace mustache = kainjow::mustache;

/// JSON for embedding in a script of a page: no text in it can end the script.
std::string within_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

std::string player_page(const Player& player, const fs::path& resources) {
  mustache::data values;
  values.set("title", player.title);
  values.set("data", within_script(player.data));
  const fs::path file = resources / "templates" / "player.mustache";
  mustache::mustache page(records::read_whole(file));
  const std::string text = page.render(values);
  if (!page.is_valid()) throw OutputError(fmt::format("{}: {}", file.string(), page.error_message()));
  return text;
}

/// Scripts for all gnuplot pictures, and the names of the resulting files. Moves the points out of `pictures`.
std::vector<Drawing> drawings_of(Pictures& pictures, const Canvas& canvas, std::vector<std::string>& files) {
  std::vector<Drawing> drawings;
  const auto add = [&](const std::string& kind, const std::string& name, std::string script) {
    drawings.push_back({kind + " " + name, std::move(script)});
    for (const std::string& format : canvas.formats)
      files.push_back(name + "." + format);
  };
  for (Figure& figure : pictures.figures) {
    const std::string name = figure.name;
    add("figure", name, figure_script(plot_of(std::move(figure)), canvas, name));
  }
  for (Page& page : pictures.pages) {
    const std::string name = page.name;
    add("page", name, page_script(page_plot_of(std::move(page)), canvas, name));
  }
  for (Film& film : pictures.films) {
    std::vector<PagePlot> pages;
    for (Page& page : film.pages)
      pages.push_back(page_plot_of(std::move(page)));
    drawings.push_back({"film " + film.name, film_script(pages, film.delay, canvas, film.name)});
    files.push_back(film.name + ".gif");
  }
  return drawings;
}

}  // namespace

Made make_pictures(Pictures pictures, const fs::path& target, const std::set<std::string>& formats,
                   const ToolPaths& tools) {
  demand_sound(pictures);
  const StagingFolder staging(target);
  const Canvas canvas{tools.resources / "gnuplot" / "preamble.gp", staging.folder(), formats};
  std::vector<std::string> names;
  const std::vector<Drawing> drawings = drawings_of(pictures, canvas, names);
  Made made;
  try {
    made.warnings = draw(drawings, staging.folder(), tools.jobs);
  } catch (const OutputError& wrong) {
    if (pictures.players.empty()) throw;
    made.unmade = fmt::format("{}\n", wrong.what());
    names.clear();
  }
  for (const Player& player : pictures.players) {
    names.push_back(player.name + ".html");
    records::write_whole(staging.folder() / names.back(), player_page(player, tools.resources));
  }
  for (const std::string& name : names) {
    // A run has no date; the same numbers must give the same bytes.
    date_picture(staging.folder() / name, 0);
    staging.publish(name);
    made.files.push_back(target / name);
  }
  return made;
}

Made make_plots(const fs::path& run, const fs::path& target, const std::set<std::string>& formats,
                const ToolPaths& tools) {
  Pictures pictures{.figures = records::read_plots(run / "plot.json")};
  records::read_points(pictures.figures, run);
  return make_pictures(std::move(pictures), target, formats, tools);
}

}  // namespace talus::reports
