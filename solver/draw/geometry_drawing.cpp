#include "solver/draw/geometry_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/record/csv.hpp"

namespace talus::app {
namespace {

/// How the kinds of shapes are drawn, those behind first. In a frame's CSV file the column `series` holds the kind.
struct Kind {
  const char* name;
  const char* words;
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

/// An outline as it is seen along the fence: rocks are taken as round, columns as upright cylinders as wide as at the
/// start; of other bodies no thickness is known.
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

/// Ends the series of mirror images, which the view along the fence alone shows.
constexpr std::string_view of_images = "_image";

/// Rows of a frame's CSV file: x, y of the side view, z, v of the view along the fence.
class Rows {
 public:
  std::string_view suffix{};  ///< of the series' names

  void add(const char* series, const Vec2& side, const Vec2& along, double tension) {
    csv_.cell(fmt::format("{}{}", series, suffix));
    csv_.cell(line_);
    for (const double value : {side.x, side.y, along.x, along.y, tension})
      csv_.number(value, 6);
    csv_.end_row();
  }
  void next_line() { line_ = fmt::format("{}", ++lines_); }
  std::string text() && { return std::move(csv_).text(); }

 private:
  records::CsvText csv_{{"series", "line", "x", "y", "z", "v", "tension"}};
  long lines_{0};
  std::string line_{"0"};
};

void add_outline(Rows& rows, const DrawnGeometry& geometry, const GeometryLine& line) {
  const std::string& kind = body_of(geometry, line).kind;
  const std::vector<Vec2> along = seen_along(line, kind, half_width(geometry, line.body));
  const auto series =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& each) { return each.name == kind; });
  // Both views have as many rows: the shorter one stays at its end.
  for (std::size_t i = 0; i < std::max(line.points.size(), along.size()); ++i) {
    const Vec3& p = line.points[std::min(i, line.points.size() - 1)];
    rows.add(series->name, {p.x, p.y}, along[std::min(i, along.size() - 1)], 0.0);
  }
  rows.next_line();
}

void add_cable(Rows& rows, const GeometryLine& line) {
  for (const Vec3& p : line.points)
    rows.add(line.slack ? "slack" : "taut", {p.x, p.y}, {p.z, p.y}, line.tension);
  rows.next_line();
}

void add_line(Rows& rows, const DrawnGeometry& geometry, const GeometryLine& line) {
  if (line.body >= 0) return add_outline(rows, geometry, line);
  add_cable(rows, line);
}

void add_hanger(Rows& rows, const HangerBar& bar, double z) {
  rows.add("hanger", in_plane(bar.joint), {z, bar.joint.y}, 0.0);
  rows.add("hanger", in_plane(bar.end), {z, bar.end.y}, 0.0);
  rows.next_line();
}

/// Element numbers at the bodies' middles; those of one kind that would cover each other stand together.
std::vector<records::Mark> marks(const DrawnGeometry& geometry, const GeometryFrame& frame, const FrameStyle& style) {
  struct Place {
    Vec2 p;
    std::string kind;
    std::vector<int> numbers;
  };
  const double near = 0.05 * (style.window.right - style.window.left);
  std::vector<Place> places;
  for (const GeometryLine& line : frame.lines) {
    if (line.body < 0 || !is_closed(line) || body_of(geometry, line).number == 0) continue;
    const Vec3 centre = middle(line);
    const Vec2 p{style.view == View::side ? centre.x : line.points.front().z, centre.y};
    const auto& [name, number, kind] = body_of(geometry, line);
    auto place = places.begin();
    while (place != places.end() && (place->kind != kind || norm(place->p - p) >= near))
      ++place;
    if (place == places.end()) place = places.insert(place, {p, kind, {}});
    place->numbers.push_back(number);
  }
  std::vector<records::Mark> made;
  for (const Place& place : places) {
    const int first = place.numbers.front();
    const int last = place.numbers.back();
    const auto count = place.numbers.size();
    made.push_back({place.p.x, place.p.y,
                    count == 1   ? fmt::format("{}", first)
                    : count == 2 ? fmt::format("{}, {}", first, last)
                                 : fmt::format("{} .. {}", first, last)});
  }
  return made;
}

}  // namespace

std::string frame_csv(const DrawnGeometry& geometry, std::size_t frame) {
  Rows rows;
  std::vector<const GeometryLine*> lines;
  for (const GeometryLine& line : geometry.frames[frame].lines)
    lines.push_back(&line);
  // The middle of the fence stands in front of its ends.
  std::stable_sort(lines.begin(), lines.end(), [](const GeometryLine* a, const GeometryLine* b) {
    return std::abs(a->points.front().z) > std::abs(b->points.front().z);
  });
  for (const GeometryLine* line : lines) {
    add_line(rows, geometry, *line);
    const auto image = mirror_image(geometry, *line);
    if (!image) continue;
    rows.suffix = of_images;
    add_line(rows, geometry, *image);
    rows.suffix = {};
  }
  for (const HangerBar& bar : hangers(geometry.frames[frame])) {
    rows.suffix = {};
    add_hanger(rows, bar, bar.joint.z);
    if (!geometry.run.files.mirrored || bar.joint.z == 0.0) continue;
    rows.suffix = of_images;
    add_hanger(rows, bar, -bar.joint.z);
  }
  return std::move(rows).text();
}

records::Figure frame_figure(const DrawnGeometry& geometry, std::size_t frame, const FrameStyle& style,
                             const std::string& csv_file) {
  const GeometryFrame& shown = geometry.frames[frame];
  const bool side = style.view == View::side;
  const std::string csv = frame_csv(geometry, frame);
  std::vector<records::Series> series;
  const auto add = [&](const Kind& kind, std::string_view suffix) {
    const std::string where = fmt::format("{}{}", kind.name, suffix);
    if (csv.find(fmt::format("\n{},", where)) == std::string::npos) return;
    const bool taut = std::string_view{kind.name} == "taut";
    const bool named = suffix.empty() && !(taut && geometry.largest_tension > 0.0);
    series.push_back(frame_series(where, named ? kind.words : "", records::Style::shapes,
                                  {kind.colour, kind.fill, kind.width, kind.dashed}));
    records::Columns& columns = series.back().columns;
    if (!side) columns.x = "z", columns.y = "v";
    if (taut) columns.value = "tension";
  };
  for (const Kind& kind : kinds) {
    if (!side) add(kind, of_images);  // behind the middle of the fence
    add(kind, {});
  }
  ShownFrame which{frame, shown.time, csv_file};
  if (!side) which.abscissa = geometry.run.files.mirrored ? "z, below 0 the mirror image" : "z";
  return frame_figure(geometry.run, style, which, std::move(series),
                      style.numbers ? marks(geometry, shown, style) : std::vector<records::Mark>{});
}

std::optional<records::Scale> colour_scale(const DrawnGeometry& geometry) {
  return colour_scale("tension of taut cables", geometry.run.unit(dimension::force), geometry.largest_tension);
}

}  // namespace talus::app
