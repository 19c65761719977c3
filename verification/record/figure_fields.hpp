/// The fields of figures in JSON; see json_fields.hpp.
#pragma once

#include "verification/record/figure.hpp"
#include "verification/record/json_fields.hpp"

namespace talus::records {

void fields(auto& f, Like<Axis> auto& axis) {
  f.nonempty_text("label", axis.label);
  f.defaulted("unit", axis.unit);
  f.defaulted("log", axis.log);
  f.value_if(axis.min.has_value(), "min", axis.min);
  f.value_if(axis.max.has_value(), "max", axis.max);
  f.value_if(axis.divisions != 0, "divisions", axis.divisions);
}

void fields(auto& f, Like<Series> auto& series) {
  auto& columns = series.columns;
  f.defaulted("label", series.label);
  f.nonempty_text("x", columns.x);
  f.nonempty_text("y", columns.y);
  f.value("style", series.style);
  f.value_if(!columns.where.empty(), "where", columns.where);
  f.value_if(!columns.y_low.empty(), "y_low", columns.y_low);
  f.value_if(!columns.y_high.empty(), "y_high", columns.y_high);
  f.value_if(!columns.value.empty(), "value", columns.value);
  f.value_if(!columns.radius.empty(), "radius", columns.radius);
  f.value_if(!series.look.colour.empty(), "colour", series.look.colour);
  f.value_if(!series.look.fill.empty(), "fill", series.look.fill);
  f.value_if(series.look.width != 1.0, "width", series.look.width);
  f.value_if(series.look.dashed, "dashed", series.look.dashed);
}

void fields(auto& f, Like<Slope> auto& slope) {
  f.value("order", slope.order);
  f.value("x", slope.x);
  f.value("y", slope.y);
  f.value("label", slope.label);
}

void fields(auto& f, Like<Line> auto& line) {
  f.value("axis", line.axis);
  f.value("at", line.at);
  f.value("label", line.label);
}

void fields(auto& f, Like<Mark> auto& mark) {
  f.value("x", mark.x);
  f.value("y", mark.y);
  f.nonempty_text("text", mark.text, "words");
}

void fields(auto& f, Like<Scale> auto& scale) {
  f.nonempty_text("label", scale.label);
  f.defaulted("unit", scale.unit);
  f.value("min", scale.min);
  f.value("max", scale.max);
}

void fields(auto& f, Like<Figure> auto& figure) {
  f.file_name("name", figure.name, Node::longest_part);
  f.value("title", figure.title);
  f.defaulted("caption", figure.caption);
  f.value("x", figure.x);
  f.value("y", figure.y);
  f.file_name("csv", figure.csv);
  f.list("series", figure.series, [&](auto& of_series, auto& series) {
    fields(of_series, series);
    of_series.value_if(!figure.panels.empty(), "panel", series.panel);
  });
  f.defaulted("slopes", figure.slopes);
  f.defaulted("lines", figure.lines);
  f.value_if(!figure.panels.empty(), "panels", figure.panels);
  f.value_if(!figure.panels.empty(), "columns", figure.columns);
  f.value_if(figure.scale.has_value(), "scale", figure.scale);
  f.value_if(!figure.marks.empty(), "marks", figure.marks);
  f.value_if(!figure.grid, "grid", figure.grid);
  f.value_if(figure.equal, "equal", figure.equal);
}

inline void demand_sound(const Node& node, const Figure& figure) {
  demand_sound(figure, [&](const std::string& part, const std::string& fault) { node.fail_at(part, fault); });
}

}  // namespace talus::records
