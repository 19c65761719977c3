#include "solver/draw/frame_style.hpp"

#include <fmt/format.h>

#include <utility>

namespace talus::app {

records::Figure frame_figure(const RunFolder& run, const FrameStyle& style, const ShownFrame& frame,
                             std::vector<records::Series> series, std::vector<records::Mark> marks) {
  const std::string length = run.unit(dimension::length), time = run.unit(dimension::time);
  const Window& window = style.window;
  const auto axis = [&](const std::string& label, double low, double high, std::size_t which) {
    return records::Axis{.label = label,
                         .unit = length,
                         .min = low,
                         .max = high,
                         .divisions = style.divisions.empty() ? 0 : style.divisions[which]};
  };
  return {.name = fmt::format("{}{}", name_of(style.view), frame.number),
          .title = fmt::format("t = {:.4g}{}{}", frame.time, time.empty() ? "" : " ", time),
          .caption = "",
          .x = axis(frame.abscissa, window.left, window.right, 0),
          .y = axis("y", window.bottom, window.top, 1),
          .series = std::move(series),
          .marks = std::move(marks),
          .grid = style.grid,
          .equal = true};
}

records::Series frame_series(const std::string& label, records::Style style, records::Look look) {
  return {.label = label, .x = {}, .y = {}, .style = style, .look = std::move(look)};
}

void add_polyline(records::Series& shapes, const std::vector<Vec2>& points) {
  const double line = shapes.line.empty() ? 0.0 : shapes.line.back() + 1.0;
  for (const Vec2& p : points) {
    shapes.add(p.x, p.y);
    shapes.line.push_back(line);
  }
}

std::optional<records::Scale> colour_scale(const std::string& label, const std::string& unit, double largest) {
  if (!(largest > 0.0)) return std::nullopt;
  return records::Scale{.label = label, .min = 0.0, .max = largest, .unit = unit};
}

}  // namespace talus::app
