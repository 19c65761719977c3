#include "reports/run_plots.hpp"

#include <fmt/format.h>

#include "verification/record/figure_fields.hpp"

namespace talus::reports {

using records::Like;
using records::Node;

void fields(auto& f, Like<Page> auto& page) {
  f.file_name("name", page.name);
  f.value("title", page.title);
  f.value("columns", page.columns);
  f.value("panels", page.panels);
  f.value_if(page.scale.has_value(), "scale", page.scale);
}

void demand_sound(const Node& node, const Page& page) {
  if (page.columns < 1 || page.columns > 12) node.at("columns").refuse("from 1 to 12");
  if (page.panels.empty()) node.at("panels").complain("must hold at least one figure");
  if (!page.scale) return;
  records::demand_sound(*page.scale,
                        [&](const std::string& part, const std::string& fault) { node.complain_of(part, fault); });
}

void fields(auto& f, Like<Film> auto& film) {
  f.file_name("name", film.name);
  f.value("delay", film.delay);
  f.value("pages", film.pages);
}

void demand_sound(const Node& node, const Film& film) {
  if (film.delay <= 0.0) node.at("delay").refuse("> 0");
  if (film.pages.empty()) node.at("pages").complain("must hold at least one page");
}

void fields(auto& f, Like<Player> auto& player) {
  f.file_name("name", player.name);
  f.words("title", player.title);
  f.file_name("data", player.data);
}

void fields(auto& f, Like<Plots> auto& plots) {
  f.defaulted("title", plots.title);
  f.value("figures", plots.figures);
  f.defaulted("pages", plots.pages);
  f.defaulted("films", plots.films);
  f.defaulted("players", plots.players);
}

void demand_sound(const Node& node, const Plots& plots) {
  if (plots.figures.empty() && plots.pages.empty() && plots.films.empty() && plots.players.empty())
    node.at("figures").complain("must hold at least one figure");
  records::demand_distinct_names(node, "figures", plots.figures);
  if (!plots.pages.empty()) records::demand_distinct_names(node, "pages", plots.pages);
}

Plots read_plots(const std::filesystem::path& file) {
  const records::Json document = records::read_json(file);
  Plots plots;
  records::read_into(Node{document, file.string() + ": plot"}, plots, records::Completeness::sparse);
  return plots;
}

}  // namespace talus::reports
