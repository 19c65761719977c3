#include "solver/app/geometry_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

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

bool is_closed(const GeometryLine& line) { return line.points.size() > 2 && line.points.front() == line.points.back(); }

Vec3 middle(const GeometryLine& line) {
  Vec3 sum;
  const auto count = static_cast<double>(line.points.size() - 1);  // the first one stands at the end again
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    sum = {sum.x + line.points[i].x / count, sum.y + line.points[i].y / count, sum.z + line.points[i].z / count};
  return sum;
}

/// Smallest and largest of a coordinate over a line's points.
template <class Coordinate>
std::pair<double, double> extent(const GeometryLine& line, Coordinate of) {
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (const Vec3& p : line.points) {
    least = std::min(least, of(p));
    largest = std::max(largest, of(p));
  }
  return {least, largest};
}

/// An outline as it is seen along the fence: rocks are taken as round, columns as upright cylinders as wide as at the
/// start; of other bodies no thickness is known.
std::vector<Vec2> seen_along(const GeometryLine& line, const std::string& kind, double half_width) {
  std::vector<Vec2> points;
  const double z = line.points.front().z;
  if (kind == "column") {
    const auto [low, high] = extent(line, [](const Vec3& p) { return p.y; });
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

/// Half of the width of a body at the start.
double half_width(const DrawnGeometry& geometry, long body) {
  for (const GeometryLine& line : geometry.frames.front().lines) {
    if (line.body != body) continue;
    const auto [left, right] = extent(line, [](const Vec3& p) { return p.x; });
    return 0.5 * (right - left);
  }
  return 0.0;
}

/// Ground goes on for ever: its first and last piece are drawn far beyond what is seen.
void lengthen(GeometryLine& line) {
  constexpr double far = 50.0;
  const auto beyond = [](const Vec3& end, const Vec3& before) {
    const Vec3 step = end - before;
    return Vec3{end.x + far * step.x, end.y + far * step.y, end.z};
  };
  line.points.front() = beyond(line.points.front(), line.points[1]);
  line.points.back() = beyond(line.points.back(), line.points[line.points.size() - 2]);
}

const DrawnBody& body_of(const DrawnGeometry& geometry, const GeometryLine& line) {
  return geometry.run.files.bodies[static_cast<std::size_t>(line.body)];
}

/// Rows "series,line,x,y,z,v,tension": x, y of the side view, z, v of the view along the fence.
class Rows {
 public:
  void add(const char* series, const Vec2& side, const Vec2& along, double tension) {
    fmt::format_to(std::back_inserter(text_), "{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", series, line_, side.x,
                   side.y, along.x, along.y, tension);
  }
  void next_line() { ++line_; }
  const std::string& text() const { return text_; }

 private:
  std::string text_{"series,line,x,y,z,v,tension\n"};
  long line_{0};
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

/// Element numbers at the bodies' middles; those of one kind that would cover each other stand together.
Json marks(const DrawnGeometry& geometry, const GeometryFrame& frame, const FrameStyle& style) {
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
  Json made = Json::array();
  for (const Place& place : places) {
    const int first = place.numbers.front();
    const int last = place.numbers.back();
    const auto count = place.numbers.size();
    made.push_back({{"x", place.p.x},
                    {"y", place.p.y},
                    {"words", count == 1   ? fmt::format("{}", first)
                              : count == 2 ? fmt::format("{}, {}", first, last)
                                           : fmt::format("{} .. {}", first, last)}});
  }
  return made;
}

}  // namespace

std::vector<GeometryFile> geometry_files(const RunFolder& run) {
  return read_geometry_index(run.folder / run.files.geometry);
}

DrawnGeometry read_frames(RunFolder run, const std::vector<GeometryFile>& files) {
  DrawnGeometry geometry{std::move(run), {}, 0.0, false};
  const auto bodies = static_cast<long>(geometry.run.files.bodies.size());
  const auto cables = static_cast<long>(geometry.run.files.cables.size());
  for (const GeometryFile& file : files) {
    GeometryFrame frame = read_geometry(file);
    for (GeometryLine& line : frame.lines) {
      if (line.body >= bodies || line.cable >= cables || (line.body < 0 && line.cable < 0) || line.points.empty()) {
        throw InputError{fmt::format("{}: found body {}, cable {}; plot.json beside it names {} and {}",
                                     file.path.string(), line.body, line.cable, bodies, cables)};
      }
      geometry.largest_tension = std::max(geometry.largest_tension, line.tension);
      if (line.body >= 0 && line.points.size() > 1 && !is_closed(line) && body_of(geometry, line).kind == "ground") {
        lengthen(line);
      }
      const auto [near, far] = extent(line, [](const Vec3& p) { return p.z; });
      if (far > near || near != frame.lines.front().points.front().z) geometry.has_depth = true;
    }
    if (frame.lines.empty()) {
      throw InputError{
          fmt::format("{}: found no shape and no cable; a body is drawn by its shape", file.path.string())};
    }
    geometry.frames.push_back(std::move(frame));
  }
  return geometry;
}

std::vector<HangerBar> hangers(const GeometryFrame& frame) {
  std::vector<HangerBar> bars;
  for (const GeometryLine& cable : frame.lines) {
    for (std::size_t i = 0; cable.cable >= 0 && i < cable.points.size(); ++i) {
      const auto outline = std::find_if(frame.lines.begin(), frame.lines.end(), [&](const GeometryLine& line) {
        return line.body >= 0 && line.body == cable.bodies[i];
      });
      if (outline == frame.lines.end() || !is_closed(*outline)) continue;
      const Vec3& joint = cable.points[i];
      const Vec2 centre = in_plane(middle(*outline));
      const auto distance = [&](const Vec3& p) { return norm(in_plane(p - joint)); };
      const Vec3& nearest = *std::min_element(outline->points.begin(), outline->points.end(),
                                              [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
      const HangerBar bar{cable.bodies[i], joint, nearest};
      const bool outside = norm(in_plane(joint) - centre) > norm(in_plane(nearest) - centre);
      if (outside && std::find(bars.begin(), bars.end(), bar) == bars.end()) bars.push_back(bar);
    }
  }
  return bars;
}

Window window_of(const DrawnGeometry& geometry, View view) {
  const double none = std::numeric_limits<double>::infinity();
  Window window{none, none, -none, -none};
  for (const GeometryFrame& frame : geometry.frames) {
    for (const GeometryLine& line : frame.lines) {
      if (line.body >= 0 && !is_closed(line) && body_of(geometry, line).kind == "ground") continue;  // a half-plane
      const auto [low, high] = extent(line, [](const Vec3& p) { return p.y; });
      const double wide = view == View::along && line.body >= 0 && body_of(geometry, line).kind != "body"
                              ? half_width(geometry, line.body)
                              : 0.0;
      const auto [left, right] = extent(line, [view](const Vec3& p) { return view == View::side ? p.x : p.z; });
      window = {std::min(window.left, left - wide), std::min(window.bottom, low), std::max(window.right, right + wide),
                std::max(window.top, high)};
    }
  }
  if (window.left > window.right) return {-1.0, -1.0, 1.0, 1.0};
  const double width = window.right - window.left;
  const double height = window.top - window.bottom;
  // A flat scene gets some room: no window is ten times as wide as it is high, or the reverse.
  const double margin = 0.05 * std::max(width, height);
  const double x = std::max(margin, 0.05 * height + 0.5 * (0.1 * height - width));
  const double y = std::max(margin, 0.05 * width + 0.5 * (0.1 * width - height));
  const double least = width == 0.0 && height == 0.0 ? 1.0 : 0.0;
  return {window.left - x - least, window.bottom - y - least, window.right + x + least, window.top + y + least};
}

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
    if (line->body >= 0) {
      add_outline(rows, geometry, *line);
    } else {
      add_cable(rows, *line);
    }
  }
  for (const HangerBar& bar : hangers(geometry.frames[frame])) {
    rows.add("hanger", in_plane(bar.joint), {bar.joint.z, bar.joint.y}, 0.0);
    rows.add("hanger", in_plane(bar.end), {bar.joint.z, bar.end.y}, 0.0);
    rows.next_line();
  }
  return rows.text();
}

Json frame_figure(const DrawnGeometry& geometry, std::size_t frame, const FrameStyle& style,
                  const std::string& csv_file) {
  const GeometryFrame& shown = geometry.frames[frame];
  const bool side = style.view == View::side;
  const std::string csv = frame_csv(geometry, frame);
  Json series = Json::array();
  for (const Kind& kind : kinds) {
    if (csv.find(fmt::format("\n{},", kind.name)) == std::string::npos) continue;
    const bool taut = std::string_view{kind.name} == "taut";
    series.push_back({{"label", taut && geometry.largest_tension > 0.0 ? "" : kind.words},
                      {"x", side ? "x" : "z"},
                      {"y", side ? "y" : "v"},
                      {"style", "shapes"},
                      {"where", kind.name},
                      {"colour", kind.colour},
                      {"fill", kind.fill},
                      {"width", kind.width},
                      {"dashed", kind.dashed},
                      {"value", taut ? "tension" : ""}});
  }
  const std::string length = symbol(geometry.run.units, dimension::length);
  const Window& window = style.window;
  const std::vector<int> divisions = style.divisions.empty() ? std::vector<int>{0, 0} : style.divisions;
  return {
      {"name", fmt::format("{}{}", side ? "side" : "along", frame)},
      {"title", fmt::format("t = {:.4g} {}", shown.time, symbol(geometry.run.units, dimension::time))},
      {"x",
       {{"label", side ? "x" : "z"},
        {"unit", length},
        {"min", window.left},
        {"max", window.right},
        {"divisions", divisions[0]}}},
      {"y",
       {{"label", "y"}, {"unit", length}, {"min", window.bottom}, {"max", window.top}, {"divisions", divisions[1]}}},
      {"csv", csv_file},
      {"grid", style.grid},
      {"equal", true},
      {"marks", style.numbers ? marks(geometry, shown, style) : Json::array()},
      {"series", series}};
}

Json tension_scale(const DrawnGeometry& geometry) {
  if (!(geometry.largest_tension > 0.0)) return nullptr;
  return {{"label", "tension of taut cables"},
          {"unit", symbol(geometry.run.units, dimension::force)},
          {"min", 0.0},
          {"max", geometry.largest_tension}};
}

}  // namespace talus::app
