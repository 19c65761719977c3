#include "reports/figure_record.hpp"

#include <algorithm>

namespace talus::reports {
namespace {

Axis axis_of(const Node& node) {
  Axis axis{node.at("label").words(), node.text_or_empty("unit"), node.flag_or_false("log"), {}, {}};
  if (node.has("min")) axis.min = node.at("min").finite();
  if (node.has("max")) axis.max = node.at("max").finite();
  if (axis.log && ((axis.min && *axis.min <= 0.0) || (axis.max && *axis.max <= 0.0))) {
    node.complain("limits of a log axis must be > 0");
  }
  if (node.has("divisions")) axis.divisions = node.at("divisions").integer();
  if (axis.divisions < 0 || axis.divisions > 100) node.at("divisions").complain("must be from 0 to 100");
  return axis;
}

std::string colour_or_empty(const Node& node, const char* key) {
  const std::string colour = node.text_or_empty(key);
  const bool fine = colour.size() == 7 && colour[0] == '#' &&
                    colour.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!colour.empty() && !fine) node.at(key).complain("must be a colour such as #0072b2");
  return colour;
}

Look look_of(const Node& node) {
  Look look{colour_or_empty(node, "colour"), colour_or_empty(node, "fill"), node.text_or_empty("value")};
  if (node.has("width")) look.width = node.at("width").finite();
  look.dashed = node.flag_or_false("dashed");
  if (look.colour.empty() && look.fill.empty() && look.value.empty()) {
    node.complain("shapes need a colour, a fill or a value");
  }
  return look;
}

Series series_of(const Node& node) {
  Series series;
  series.label = node.text_or_empty("label");
  series.x = node.at("x").words();
  series.y = node.at("y").words();
  series.style = node.at("style").one_of(
      {"points", "lines", "linespoints", "errorbars", "crosses", "outlines", "heat", "shapes", "circles"});
  series.where = node.text_or_empty("where");
  if (series.style == "errorbars") {
    series.y_low = node.at("y_low").words();
    series.y_high = node.at("y_high").words();
  }
  if (has_look(series.style)) series.look = look_of(node);
  if (series.style == "circles") {
    series.look.radius = node.at("radius").words();
    if (series.look.fill.empty() && series.look.value.empty()) node.complain("circles need a fill or a value");
  }
  if (series.style == "heat") series.look.value = node.at("value").words();
  if (node.has("panel")) series.panel = node.at("panel").integer();
  return series;
}

Scale scale_of(const Node& node, bool two_hues) {
  const Scale scale{node.at("label").words(), node.text_or_empty("unit"), node.at("min").finite(),
                    node.at("max").finite(), two_hues};
  if (!(scale.min < scale.max)) node.complain("min must be less than max");
  return scale;
}

void read_panels(const Node& node, Figure& figure) {
  for (const Node& item : node.list_or_empty("panels"))
    figure.panels.push_back(item.words());
  if (!figure.panels.empty()) figure.columns = node.at("columns").integer();
  if (figure.columns < 1 || figure.columns > 12) node.at("columns").complain("must be from 1 to 12");
  if (node.has("scale")) figure.scale = scale_of(node.at("scale"), true);
  for (const Series& series : figure.series) {
    const int panels = std::max(1, static_cast<int>(figure.panels.size()));
    if (series.panel < 0 || series.panel >= panels) node.at("series").complain("a series is in no panel");
    if (series.style == "heat" && (!figure.scale || figure.panels.empty()))
      node.at("series").complain("a heat map needs panels and a scale");
  }
}

}  // namespace

std::string file_name(const Node& node) {
  std::string name = node.words();
  if (name.find('/') != std::string::npos || name.front() == '.') node.complain("must be a plain file name");
  return name;
}

Figure figure_of(const Node& node) {
  Figure figure;
  figure.name = file_name(node.at("name"));
  figure.title = node.at("title").text();
  figure.caption = node.text_or_empty("caption");
  figure.x = axis_of(node.at("x"));
  figure.y = axis_of(node.at("y"));
  figure.csv = file_name(node.at("csv"));
  for (const Node& item : node.at("series").list())
    figure.series.push_back(series_of(item));
  if (figure.series.empty()) node.at("series").complain("must hold at least one series");
  for (const Node& item : node.list_or_empty("slopes")) {
    if (!figure.x.log || !figure.y.log) item.complain("a slope needs both axes to be log");
    const Slope slope{item.at("order").finite(), item.at("x").finite(), item.at("y").finite(),
                      item.text_or_empty("label")};
    if (slope.x <= 0.0 || slope.y <= 0.0) item.complain("x and y must be > 0");
    figure.slopes.push_back(slope);
  }
  for (const Node& item : node.list_or_empty("lines")) {
    const LimitLine line{item.at("axis").one_of({"x", "y"})[0], item.at("at").finite(), item.text_or_empty("label")};
    if ((line.axis == 'x' ? figure.x : figure.y).log && line.at <= 0.0) item.at("at").complain("a log axis needs > 0");
    figure.lines.push_back(line);
  }
  for (const Node& item : node.list_or_empty("marks"))
    figure.marks.push_back({item.at("x").finite(), item.at("y").finite(), item.at("words").words()});
  if (node.has("grid")) figure.grid = node.at("grid").flag();
  figure.equal = node.flag_or_false("equal");
  read_panels(node, figure);
  if (figure.equal && (!figure.x.min || !figure.x.max || !figure.y.min || !figure.y.max)) {
    node.complain("a figure with equal units needs min and max of both axes");
  }
  return figure;
}

Page page_of(const Node& node) {
  Page page{file_name(node.at("name")), node.text_or_empty("title"), node.at("columns").integer(), {}, {}};
  if (page.columns < 1 || page.columns > 12) node.at("columns").complain("must be from 1 to 12");
  for (const Node& item : node.at("panels").list())
    page.panels.push_back(figure_of(item));
  if (page.panels.empty()) node.at("panels").complain("must hold at least one figure");
  if (!node.has("scale")) return page;
  page.scale = scale_of(node.at("scale"), false);
  return page;
}

Film film_of(const Node& node) {
  Film film{file_name(node.at("name")), node.at("delay").finite(), {}};
  if (film.delay <= 0.0) node.at("delay").complain("must be > 0");
  for (const Node& item : node.at("pages").list())
    film.pages.push_back(page_of(item));
  if (film.pages.empty()) node.at("pages").complain("must hold at least one page");
  return film;
}

Player player_of(const Node& node) {
  return {file_name(node.at("name")), node.at("title").words(), file_name(node.at("data"))};
}

}  // namespace talus::reports
