#include "solver/draw/geometry_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::app {
namespace {

/// Drawing style of each kind of shape, from back to front.
struct Kind {
  const char* name;
  const char* label;
  const char* colour;
  const char* fill;
  double width;
  bool dashed;
};
constexpr Kind kinds[] = {
    {"ground", "", "#6b6257", "", 2.0, false},          {"column", "column", "#5b4a32", "#dcc9a3", 0.9, false},
    {"body", "body", "#33475b", "#bfd3e6", 1.1, false}, {"rock", "rock", "#2b2b2b", "#a3a3a3", 1.1, false},
    {"hanger", "", "#5b4a32", "", 1.0, false},          {"slack", "cable, slack", "#4b9ad6", "", 1.3, true},
    {"taut", "cable, taut", "", "", 2.6, false}};

/// An outline in the view along the fence: rocks are taken as round and columns as upright cylinders of their initial
/// width; other bodies are drawn as lines, because their thickness is unknown.
std::vector<Vec2> seen_along(const GeometryLine& line, const std::string& kind, double half_width) {
  std::vector<Vec2> points;
  const double z = line.points.front().z;
  if (kind == "column") {
    const auto [low, high] = heights(line);
    return {{z - half_width, low},
            {z + half_width, low},
            {z + half_width, high},
            {z - half_width, high},
            {z - half_width, low}};
  }
  const double centre = is_closed(line) ? middle(line).x : 0.0;
  for (const Vec3& p : line.points)
    points.push_back({kind == "rock" ? z + p.x - centre : z, p.y});
  return points;
}

std::vector<Vec2> seen(const GeometryLine& line, View view) {
  std::vector<Vec2> points;
  for (const Vec3& p : line.points)
    points.push_back({view == View::side ? p.x : p.z, p.y});
  return points;
}

/// The shapes of a frame in one view: for each kind, the actual shapes and their mirror images.
class Shapes {
 public:
  Shapes(const DrawnGeometry& geometry, View view) : geometry_{geometry}, view_{view} {
    for (std::size_t i = 0; i < series_.size(); ++i) {
      const Kind& kind = kinds[i];
      const bool scaled = std::string_view{kind.name} == "taut" && geometry.largest_tension > 0.0;
      const records::Look look{kind.colour, kind.fill, kind.width, kind.dashed};
      series_[i] = {frame_series("", records::Style::shapes, look),
                    frame_series(scaled ? "" : kind.label, records::Style::shapes, look)};
    }
  }

  void add_line(const GeometryLine& line, bool image) {
    if (line.body < 0) {
      records::Series& cables = of_kind(line.slack ? "slack" : "taut", image);
      add_polyline(cables, seen(line, view_));
      if (!line.slack) cables.values.resize(cables.x.size(), line.tension);
      return;
    }
    const std::string& kind = body_of(geometry_, line).kind;
    const bool along = view_ == View::along;
    add_polyline(of_kind(kind, image),
                 along ? seen_along(line, kind, half_width(geometry_, line.body)) : seen(line, view_));
  }

  /// Adds a hanger bar at this z instead of the joint's.
  void add_hanger(const HangerBar& bar, double z, bool image) {
    const bool side = view_ == View::side;
    add_polyline(of_kind("hanger", image), {{side ? bar.joint.x : z, bar.joint.y}, {side ? bar.end.x : z, bar.end.y}});
  }

  /// The series that are not empty, from back to front; within a kind, mirror images come first (behind).
  [[nodiscard]] std::vector<records::Series> all() && {
    std::vector<records::Series> found;
    for (auto& [images, there] : series_) {
      for (records::Series* one : {&images, &there})
        if (!one->x.empty()) found.push_back(std::move(*one));
    }
    return found;
  }

 private:
  struct OfKind {
    records::Series images, there;
  };

  records::Series& of_kind(std::string_view name, bool image) {
    const auto kind =
        std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& each) { return each.name == name; });
    OfKind& found = series_.at(static_cast<std::size_t>(kind - std::begin(kinds)));
    return image ? found.images : found.there;
  }

  const DrawnGeometry& geometry_;
  View view_;
  std::array<OfKind, std::size(kinds)> series_;
};

std::vector<records::Series> series_of(const DrawnGeometry& geometry, const GeometryFrame& frame, View view) {
  const bool along = view == View::along;  // mirror images are drawn only in this view
  Shapes shapes{geometry, view};
  std::vector<const GeometryLine*> lines;
  for (const GeometryLine& line : frame.lines)
    lines.push_back(&line);
  // The middle of the fence is drawn in front of its ends.
  std::stable_sort(lines.begin(), lines.end(), [](const GeometryLine* a, const GeometryLine* b) {
    return std::abs(a->points.front().z) > std::abs(b->points.front().z);
  });
  for (const GeometryLine* line : lines) {
    shapes.add_line(*line, false);
    if (!along) continue;
    if (const auto image = mirror_image(geometry, *line)) shapes.add_line(*image, true);
  }
  for (const HangerBar& bar : hangers(frame)) {
    shapes.add_hanger(bar, bar.joint.z, false);
    if (along && geometry.run.files.mirrored && bar.joint.z != 0.0) shapes.add_hanger(bar, -bar.joint.z, true);
  }
  return std::move(shapes).all();
}

/// Element numbers at the bodies' centres; numbers of one kind that would overlap are combined in one mark.
std::vector<records::Mark> marks(const DrawnGeometry& geometry, const GeometryFrame& frame, const FrameStyle& style) {
  struct NumberedPoint {
    Vec2 p;
    std::string kind;
    std::vector<int> numbers;
  };
  const double near = 0.05 * (style.window.right - style.window.left);
  std::vector<NumberedPoint> points;
  for (const GeometryLine& line : frame.lines) {
    if (line.body < 0 || !is_closed(line) || body_of(geometry, line).number == 0) continue;
    const Vec3 centre = middle(line);
    const Vec2 p{style.view == View::side ? centre.x : line.points.front().z, centre.y};
    const auto& [name, number, kind] = body_of(geometry, line);
    auto point = points.begin();
    while (point != points.end() && (point->kind != kind || norm(point->p - p) >= near))
      ++point;
    if (point == points.end()) point = points.insert(point, {p, kind, {}});
    point->numbers.push_back(number);
  }
  std::vector<records::Mark> made;
  for (const NumberedPoint& point : points) {
    const int first = point.numbers.front();
    const int last = point.numbers.back();
    const auto count = point.numbers.size();
    made.push_back({point.p.x, point.p.y,
                    count == 1   ? fmt::format("{}", first)
                    : count == 2 ? fmt::format("{}, {}", first, last)
                                 : fmt::format("{} .. {}", first, last)});
  }
  return made;
}

}  // namespace

records::Figure frame_figure(const DrawnGeometry& geometry, std::size_t frame, const FrameStyle& style) {
  const GeometryFrame& shown = geometry.frames[frame];
  ShownFrame which{.number = frame, .time = shown.time};
  if (style.view == View::along) which.abscissa = geometry.run.files.mirrored ? "z, below 0 the mirror image" : "z";
  return frame_figure(geometry.run, style, which, series_of(geometry, shown, style.view),
                      style.numbers ? marks(geometry, shown, style) : std::vector<records::Mark>{});
}

std::optional<records::Scale> colour_scale(const DrawnGeometry& geometry) {
  return colour_scale("tension of taut cables", geometry.run.unit(dimension::force), geometry.largest_tension);
}

}  // namespace talus::app
