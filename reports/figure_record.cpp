#include "reports/figure_record.hpp"

namespace talus::reports {
namespace {

Axis axis_of(const Node& node) {
  Axis axis{node.at("label").words(), node.text_or_empty("unit"), node.flag_or_false("log"), {}, {}};
  if (node.has("min")) axis.min = node.at("min").finite();
  if (node.has("max")) axis.max = node.at("max").finite();
  if (axis.log && ((axis.min && *axis.min <= 0.0) || (axis.max && *axis.max <= 0.0))) {
    node.complain("limits of a log axis must be > 0");
  }
  return axis;
}

Series series_of(const Node& node) {
  Series series;
  series.label = node.text_or_empty("label");
  series.x = node.at("x").words();
  series.y = node.at("y").words();
  series.style = node.at("style").one_of({"points", "lines", "linespoints", "errorbars", "crosses"});
  series.where = node.text_or_empty("where");
  if (series.style == "errorbars") {
    series.y_low = node.at("y_low").words();
    series.y_high = node.at("y_high").words();
  }
  return series;
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
  figure.title = node.at("title").words();
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
  return figure;
}

}  // namespace talus::reports
