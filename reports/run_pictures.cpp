#include <fmt/format.h>

#include <kainjow/mustache.hpp>

#include "reports/drawing.hpp"
#include "reports/error.hpp"
#include "reports/file.hpp"
#include "reports/page_script.hpp"
#include "reports/report.hpp"
#include "reports/run_plots.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

namespace mustache = kainjow::mustache;

/// JSON as it may stand in a script of a page: no text in it can end the script.
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

std::string player_page(const Player& player, const fs::path& run, const fs::path& resources) {
  mustache::data values;
  values.set("title", player.title);
  values.set("data", within_script(records::read_whole(run / player.data)));
  const fs::path file = resources / "templates" / "player.mustache";
  mustache::mustache page(records::read_whole(file));
  const std::string text = page.render(values);
  if (!page.is_valid()) throw OutputError(fmt::format("{}: {}", file.string(), page.error_message()));
  return text;
}

/// Scripts of all that gnuplot draws, and the names of the files to come.
std::vector<Drawing> drawings_of(const Plots& plots, const fs::path& run, const Canvas& canvas,
                                 std::vector<std::string>& files) {
  std::vector<Drawing> drawings;
  const auto add = [&](const std::string& kind, const std::string& name, std::string script) {
    drawings.push_back({kind + " " + name, std::move(script)});
    for (const std::string& format : canvas.formats)
      files.push_back(name + "." + format);
  };
  for (const Figure& figure : plots.figures)
    add("figure", figure.name, figure_script(plot_of(figure, run), canvas, figure.name));
  for (const Page& page : plots.pages)
    add("page", page.name, page_script(page_plot_of(page, run), canvas, page.name));
  for (const Film& film : plots.films) {
    std::vector<PagePlot> pages;
    for (const Page& page : film.pages)
      pages.push_back(page_plot_of(page, run));
    drawings.push_back({"film " + film.name, film_script(pages, film.delay, canvas, film.name)});
    files.push_back(film.name + ".gif");
  }
  return drawings;
}

}  // namespace

std::vector<fs::path> make_plots(const fs::path& run, const fs::path& target, const std::set<std::string>& formats,
                                 const Workplace& workplace) {
  const Plots plots = read_plots(run / "plot.json");
  const Workshop workshop(target);
  const Canvas canvas{workplace.resources / "gnuplot" / "preamble.gp", workshop.folder(), formats};
  std::vector<std::string> names;
  const std::vector<Drawing> drawings = drawings_of(plots, run, canvas, names);
  const std::string warnings = draw(drawings, workshop.folder(), workplace.jobs);
  if (!warnings.empty()) fmt::print(stderr, "{}", warnings);
  for (const Player& player : plots.players) {
    names.push_back(player.name + ".html");
    records::write_whole(workshop.folder() / names.back(), player_page(player, run, workplace.resources));
  }
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    // A run has no date of its own; the same numbers still give the same bytes.
    date_picture(workshop.folder() / name, 0);
    workshop.publish(name);
    files.push_back(target / name);
  }
  return files;
}

}  // namespace talus::reports
