#include "solver/draw/drawn_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

/// Minimum and maximum of a coordinate over a line's points.
template <class Coordinate>
std::pair<double, double> extent(const GeometryLine& line, Coordinate of) {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (const Vec3& p : line.points) {
    smallest = std::min(smallest, of(p));
    largest = std::max(largest, of(p));
  }
  return {smallest, largest};
}

/// Extends the first and last segment of ground, which is unbounded, far beyond the window.
void lengthen(GeometryLine& line) {
  constexpr double far = 50.0;
  const auto beyond = [](const Vec3& end, const Vec3& before) {
    const Vec3 step = end - before;
    return Vec3{end.x + far * step.x, end.y + far * step.y, end.z};
  };
  line.points.front() = beyond(line.points.front(), line.points[1]);
  line.points.back() = beyond(line.points.back(), line.points[line.points.size() - 2]);
}

}  // namespace

const DrawnBody& body_of(const DrawnGeometry& geometry, const GeometryLine& line) {
  return geometry.run.files.bodies[static_cast<std::size_t>(line.body)];
}

bool is_closed(const GeometryLine& line) { return line.points.size() > 2 && line.points.front() == line.points.back(); }

Vec3 middle(const GeometryLine& line) {
  Vec3 sum;
  const auto count = static_cast<double>(line.points.size() - 1);  // the last point repeats the first
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    sum = {sum.x + line.points[i].x / count, sum.y + line.points[i].y / count, sum.z + line.points[i].z / count};
  return sum;
}

double half_width(const DrawnGeometry& geometry, long body) {
  for (const GeometryLine& line : geometry.frames.front().lines) {
    if (line.body != body) continue;
    const auto [left, right] = extent(line, [](const Vec3& p) { return p.x; });
    return 0.5 * (right - left);
  }
  return 0.0;
}

std::pair<double, double> heights(const GeometryLine& line) {
  return extent(line, [](const Vec3& p) { return p.y; });
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

std::optional<GeometryLine> mirror_image(const DrawnGeometry& geometry, const GeometryLine& line) {
  const auto off_plane = [](const Vec3& p) { return p.z != 0.0; };
  if (!geometry.run.files.mirrored || std::none_of(line.points.begin(), line.points.end(), off_plane)) return {};
  GeometryLine image = line;
  for (Vec3& p : image.points)
    p.z = -p.z;
  return image;
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
      auto [left, right] = extent(line, [view](const Vec3& p) { return view == View::side ? p.x : p.z; });
      if (view == View::along && geometry.run.files.mirrored)
        left = std::min(left, -right), right = std::max(right, -left);
      window = {std::min(window.left, left - wide), std::min(window.bottom, low), std::max(window.right, right + wide),
                std::max(window.top, high)};
    }
  }
  if (window.left > window.right) return {-1.0, -1.0, 1.0, 1.0};
  const double width = window.right - window.left;
  const double height = window.top - window.bottom;
  // Flat scenes get a larger margin, so that the aspect ratio of the window stays below 10.
  const double margin = 0.05 * std::max(width, height);
  const double x = std::max(margin, 0.05 * height + 0.5 * (0.1 * height - width));
  const double y = std::max(margin, 0.05 * width + 0.5 * (0.1 * width - height));
  const double smallest = width == 0.0 && height == 0.0 ? 1.0 : 0.0;
  return {window.left - x - smallest, window.bottom - y - smallest, window.right + x + smallest,
          window.top + y + smallest};
}

}  // namespace talus::app
