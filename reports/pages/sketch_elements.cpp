#include "reports/pages/sketch_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace talus::reports {
namespace {

using Points = std::vector<SketchPoint>;
using Side = SketchLabel::Side;

constexpr double letter_width = 0.135;  // of a label [cm]
constexpr double letter_height = 0.3;   // of a label [cm]

constexpr const char* body_fill = "#dce8f3";
constexpr const char* body_line = "#1f4e79";
constexpr const char* held_fill = "#c9c9c9";
constexpr const char* held_line = "#444444";
constexpr const char* ground_line = "#444444";
constexpr const char* cable_line = "#b34700";
constexpr const char* velocity_line = "#00724f";
constexpr const char* force_line = "#a3206a";
constexpr const char* thin_line = "#555555";

SketchPoint operator*(double s, SketchPoint a) { return {s * a.x, s * a.y}; }
double length(SketchPoint a) { return std::hypot(a.x, a.y); }
SketchPoint left_of(SketchPoint direction) { return {-direction.y, direction.x}; }
SketchPoint unit(SketchPoint a) {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : SketchPoint{1.0, 0.0};
}
SketchPoint at_angle(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Half of a superellipse's outline has 64 points; their parameter is that of the ellipse with the same half axes.
Points superellipse(SketchPoint centre, double a, double b, double exponent, double degrees) {
  Points outline;
  const SketchPoint along = at_angle(degrees), across = left_of(along);
  const auto power = [&](double c) { return std::copysign(std::pow(std::abs(c), 2.0 / exponent), c); };
  for (int i = 0; i < 128; ++i) {
    const SketchPoint direction = at_angle(i * 360.0 / 128);
    outline.push_back(centre + a * power(direction.x) * along + b * power(direction.y) * across);
  }
  return outline;
}

/// Catmull-Rom spline.
Points smooth(const Points& points) {
  Points line;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const SketchPoint p1 = points[i], p2 = points[i + 1];
    const SketchPoint p0 = i > 0 ? points[i - 1] : 2.0 * p1 - p2;
    const SketchPoint p3 = i + 2 < points.size() ? points[i + 2] : 2.0 * p2 - p1;
    for (int k = 0; k < 16; ++k) {
      const double t = k / 16.0;
      line.push_back(0.5 * (2.0 * p1 + t * (p2 - p0) + t * t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) +
                            t * t * t * (3.0 * p1 - p0 - 3.0 * p2 + p3)));
    }
  }
  line.push_back(points.back());
  return line;
}

/// Number of letters of a label times their width, without marks of formulas [cm].
double text_width(const std::string& text) {
  double letters = 0.0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_continued = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;  // of a UTF-8 character
    if (is_continued || std::string("$^_{}").find(text[i]) != std::string::npos) continue;
    letters += 1.0;
    if (text[i] != '\\') continue;
    while (i + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0)
      ++i;  // a name is one sign
  }
  return letter_width * letters;
}

}  // namespace

void SketchDrawer::body(const SketchElement& e) {
  const bool held = e.has("held"), ghost = e.has("ghost");
  Points outline;
  if (e.keyword == "polygon") {
    outline = e.points();
  } else if (e.keyword == "disc") {
    outline = superellipse(e.point(0), e.numbers[2], e.numbers[2], 2.0, 0.0);
  } else if (e.keyword == "box") {
    const SketchPoint along = at_angle(e.number_or(4, 0.0)), across = left_of(along);
    for (const auto [x, y] : {SketchPoint{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      outline.push_back(e.point(0) + x * e.numbers[2] * along + y * e.numbers[3] * across);
  } else {
    outline = superellipse(e.point(0), e.numbers[2], e.numbers[3], e.numbers[4], e.number_or(5, 0.0));
  }
  SketchPoint middle{};
  for (const SketchPoint& point : outline)
    middle = middle + (1.0 / static_cast<double>(outline.size())) * point;
  outline.push_back(outline.front());
  stroke({outline, ghost ? "" : held ? held_fill : body_fill, held ? held_line : body_line, 1.4, ghost});
  label(e.label(), middle, Side::centre);
}

void SketchDrawer::ground(const SketchElement& e) {
  const Points points = e.points();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const SketchPoint direction = unit(points[i + 1] - points[i]);
    const double whole = length(points[i + 1] - points[i]);
    const int lines = std::max(1, static_cast<int>(std::round(whole / 0.18)));
    for (int k = 0; k < lines; ++k) {
      const SketchPoint foot = points[i] + ((k + 0.7) * whole / lines) * direction;
      stroke({{foot, foot - 0.13 * direction - 0.17 * left_of(direction)}, "", ground_line, 0.6});
    }
  }
  stroke({points, "", ground_line, 1.6});
  label_beside(e, points);
}

void SketchDrawer::anchor(const SketchElement& e) {
  const SketchPoint tip = e.point(0), out = at_angle(e.number_or(2, 90.0)), side = left_of(out);
  const SketchPoint base = tip + 0.28 * out;
  stroke({{tip, base + 0.18 * side, base - 0.18 * side, tip}, "#ffffff", ground_line, 1.2});
  for (int k = 0; k < 4; ++k) {
    const SketchPoint foot = base + (-0.21 + 0.14 * k) * side;
    stroke({{foot, foot + 0.11 * out + 0.08 * side}, "", ground_line, 0.6});
  }
  stroke({{base + 0.28 * side, base - 0.28 * side}, "", ground_line, 1.4});
  label(e.label(), tip + 0.32 * side + 0.14 * out,
        side.x > 0.5    ? Side::left
        : side.x < -0.5 ? Side::right
                        : Side::centre);
}

void SketchDrawer::pin(const SketchElement& e) {
  disc(e.point(0), 0.09, "#ffffff", ink, 1.3);
  label(e.label(), e.point(0) + SketchPoint{0.2, 0.02}, Side::left);
}

void SketchDrawer::dot(const SketchElement& e) {
  disc(e.point(0), 0.055, ink, "", 1.0);
  label(e.label(), e.point(0) + SketchPoint{0.15, 0.05}, Side::left);
}

/// The engineers' mark: a circle in four quarters, two of them filled.
void SketchDrawer::centre(const SketchElement& e) {
  constexpr double radius = 0.11;
  disc(e.point(0), radius, "#ffffff", ink, 0.9);
  for (const double from : {0.0, 180.0}) {
    Points quarter{e.point(0)};
    for (int i = 0; i <= 16; ++i)
      quarter.push_back(e.point(0) + radius * at_angle(from + 90.0 * i / 16));
    quarter.push_back(e.point(0));
    stroke({quarter, ink, "", 1.0});
  }
  label(e.label(), e.point(0) + SketchPoint{0.2, 0.0}, Side::left);
}

void SketchDrawer::line(const SketchElement& e) {
  Points points = e.points();
  if (e.keyword == "curve") points = smooth(points);
  const bool cable = e.keyword == "cable";
  stroke({points, "", cable ? cable_line : thin_line, cable ? 2.0 : 1.0, e.has("dashed")});
  label_beside(e, points);
}

void SketchDrawer::spring(const SketchElement& e) {
  const SketchPoint from = e.point(0), to = e.point(2), along = unit(to - from), across = left_of(along);
  const double whole = length(to - from), lead = std::min(0.15, 0.2 * whole);
  const int bends = std::max(4, 2 * static_cast<int>(std::round((whole - 2 * lead) / 0.22)));
  Points points{from, from + lead * along};
  for (int i = 0; i < bends; ++i) {
    const double s = lead + (i + 0.5) * (whole - 2 * lead) / bends;
    points.push_back(from + s * along + (i % 2 == 0 ? 0.13 : -0.13) * across);
  }
  points.push_back(to - lead * along);
  points.push_back(to);
  stroke({points, "", ink, 1.0});
  label_beside(e, {from, to}, 0.32);
}

void SketchDrawer::dashpot(const SketchElement& e) {
  const SketchPoint from = e.point(0), to = e.point(2), along = unit(to - from), across = left_of(along);
  const double whole = length(to - from), half = std::min(0.2, 0.3 * whole);
  const SketchPoint middle = from + 0.5 * whole * along;
  const SketchPoint left = 0.12 * across;
  stroke({{from, middle - half * along}, "", ink, 1.0});
  stroke({{middle + half * along + left, middle - half * along + left, middle - half * along - left,
           middle + half * along - left},
          "",
          ink,
          1.0});
  stroke({{middle + 0.8 * left, middle - 0.8 * left}, "", ink, 1.4});
  stroke({{middle, to}, "", ink, 1.0});
  label_beside(e, {from, to}, 0.32);
}

void SketchDrawer::arrow(const SketchElement& e) {
  const char* const colour = e.keyword == "force" ? force_line : velocity_line;
  const SketchPoint tip = e.point(0) + e.point(2), along = unit(e.point(2));
  stroke({{e.point(0), tip - 0.1 * along}, "", colour, 1.6});
  head(tip, along, colour, 0.22);
  const bool level = std::abs(along.x) > 0.35;
  label(e.label(), tip + (level ? 0.1 : 0.24) * along,
        !level        ? Side::centre
        : along.x > 0 ? Side::left
                      : Side::right,
        false, colour);
}

void SketchDrawer::turn(const SketchElement& e) {
  const double radius = e.numbers[2], from = e.numbers[3], to = e.numbers[4];
  Points points;
  for (int i = 0; i <= 32; ++i)
    points.push_back(e.point(0) + radius * at_angle(from + (to - from) * i / 32));
  const SketchPoint tip = points.back();
  // The head is a chord: its direction is that of the arc half its length before the tip.
  const double back = 0.11 / radius * 180.0 / std::numbers::pi;
  const SketchPoint along = (to > from ? 1.0 : -1.0) * left_of(at_angle(to > from ? to - back : to + back));
  stroke({points, "", velocity_line, 1.4});
  head(tip, along, velocity_line, 0.2);
  const SketchPoint out = at_angle(0.5 * (from + to));
  label(e.label(), e.point(0) + (radius + 0.18) * out,
        out.x > 0.4    ? Side::left
        : out.x < -0.4 ? Side::right
                       : Side::centre,
        false, velocity_line);
}

void SketchDrawer::dimension(const SketchElement& e) {
  const SketchPoint from = e.point(0), to = e.point(2), along = unit(to - from), across = 0.1 * left_of(along);
  stroke({{from, to}, "", thin_line, 0.7});
  for (const SketchPoint end : {from, to})
    stroke({{end + across, end - across}, "", thin_line, 0.7});
  if (length(to - from) > 0.45) {
    head(to, along, thin_line, 0.15);
    head(from, -1.0 * along, thin_line, 0.15);
  }
  // A label as long as the dimension would hide it: it is put beside.
  if (length(to - from) > 0.5 + (std::abs(along.x) > 0.5 ? text_width(e.label()) : letter_height)) {
    label(e.label(), 0.5 * (from + to), Side::centre, true, ink);
  } else {
    label_beside(e, {from, to});
  }
}

void SketchDrawer::axes(const SketchElement& e) {
  const SketchPoint origin = e.point(0);
  const double whole = e.numbers[2];
  for (const SketchPoint along : {SketchPoint{1.0, 0.0}, SketchPoint{0.0, 1.0}}) {
    stroke({{origin, origin + (whole - 0.08) * along}, "", thin_line, 0.9});
    head(origin + whole * along, along, thin_line, 0.16);
  }
  label(e.labels[0], origin + SketchPoint{whole + 0.08, 0.0}, Side::left, false, thin_line);
  label(e.labels[1], origin + SketchPoint{0.0, whole + 0.2}, Side::centre, false, thin_line);
}

void SketchDrawer::text(const SketchElement& e) {
  label(e.label(), e.point(0), e.has("left") ? Side::left : e.has("right") ? Side::right : Side::centre);
}

void SketchDrawer::stroke(Stroke&& stroke) {
  for (const SketchPoint& point : stroke.points)
    include(point);
  sketch_.strokes.push_back(std::move(stroke));
}

void SketchDrawer::include(SketchPoint point) {
  sketch_.low = {std::min(sketch_.low.x, point.x), std::min(sketch_.low.y, point.y)};
  sketch_.high = {std::max(sketch_.high.x, point.x), std::max(sketch_.high.y, point.y)};
}

void SketchDrawer::disc(SketchPoint centre, double radius, const char* fill, const char* colour, double width) {
  Points outline = superellipse(centre, radius, radius, 2.0, 0.0);
  outline.push_back(outline.front());
  stroke({outline, fill, colour, width});
}

void SketchDrawer::head(SketchPoint tip, SketchPoint along, const char* colour, double size) {
  const SketchPoint back = tip - size * along, side = 0.3 * size * left_of(along);
  stroke({{tip, back + side, back - side, tip}, colour, "", 1.0});
}

void SketchDrawer::label(const std::string& text, SketchPoint at, Side side, bool boxed, const char* colour) {
  if (text.empty()) return;
  sketch_.labels.push_back({text, at, side, boxed, colour});
  const double wide = text_width(text);
  const double begin = side == Side::left ? 0.0 : side == Side::right ? -wide : -0.5 * wide;
  include(at + SketchPoint{begin, -0.5 * letter_height});
  include(at + SketchPoint{begin + wide, 0.5 * letter_height});
}

void SketchDrawer::label_beside(const SketchElement& e, const Points& points, double distance) {
  const std::size_t half = (points.size() - 1) / 2;
  const SketchPoint from = points[half], to = points[half + 1];
  const SketchPoint normal = (e.has("below") ? -1.0 : 1.0) * left_of(unit(to - from));
  const bool level = std::abs(normal.x) < 0.5;
  label(e.label(), 0.5 * (from + to) + (level ? distance : distance - 0.06) * normal,
        level          ? Side::centre
        : normal.x > 0 ? Side::left
                       : Side::right);
}

}  // namespace talus::reports
