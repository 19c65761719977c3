#include "reports/figures/pictures.hpp"

#include <fmt/format.h>

#include "reports/base/error.hpp"

namespace talus::reports {
namespace {

constexpr int maximum_columns = 12;

void demand_file_name(const std::string& kind, const std::string& name) {
  if (!name.empty() && name.front() != '.' && name.find('/') == std::string::npos) return;
  throw RecordError(fmt::format("name of a {}: found '{}'; it must be a plain file name", kind, name));
}

/// Returns a function that throws RecordError about a part of a picture.
records::Fail fail_in(const std::string& picture) {
  return [picture](const std::string& part, const std::string& fault) {
    throw RecordError(fmt::format("{}{}{}: {}", picture, part.empty() ? "" : ": ", part, fault));
  };
}

void demand_sound_page(const Page& page, const std::string& picture) {
  const records::Fail fail = fail_in(picture);
  if (page.columns < 1 || page.columns > maximum_columns)
    fail("columns", fmt::format("must be from 1 to {}, found {}", maximum_columns, page.columns));
  if (page.panels.empty()) fail("panels", "must hold at least one figure");
  for (std::size_t i = 0; i < page.panels.size(); ++i)
    records::demand_sound(page.panels[i], fail_in(fmt::format("{}: panels[{}]", picture, i)));
  if (page.scale) records::demand_sound(*page.scale, fail);
}

}  // namespace

void demand_sound(const Pictures& pictures) {
  for (const Figure& figure : pictures.figures) {
    demand_file_name("figure", figure.name);
    records::demand_sound(figure, fail_in(fmt::format("figure '{}'", figure.name)));
  }
  for (const Page& page : pictures.pages) {
    demand_file_name("page", page.name);
    demand_sound_page(page, fmt::format("page '{}'", page.name));
  }
  for (const Film& film : pictures.films) {
    demand_file_name("film", film.name);
    const std::string picture = fmt::format("film '{}'", film.name);
    if (!(film.delay > 0.0)) fail_in(picture)("delay", fmt::format("must be > 0, found {}", film.delay));
    if (film.pages.empty()) fail_in(picture)("pages", "must hold at least one page");
    for (std::size_t i = 0; i < film.pages.size(); ++i)
      demand_sound_page(film.pages[i], fmt::format("{}: pages[{}]", picture, i));
  }
  for (const Player& player : pictures.players)
    demand_file_name("player", player.name);
}

}  // namespace talus::reports
