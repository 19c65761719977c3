#include "reports/pages/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>
#include <tuple>

#include "reports/base/record.hpp"
#include "reports/figures/gnuplot_text.hpp"
#include "reports/pages/pages.hpp"

namespace talus::reports {
namespace {

using Points = std::vector<SketchPoint>;
using Side = SketchLabel::Side;

constexpr double text_high = 12.0;      // of a sketch: half a page [cm]
constexpr double border_width = 0.12;   // around all elements [cm]
constexpr double letter_width = 0.135;  // of a label [cm]
constexpr double letter_height = 0.3;   // of a label [cm]

/// In the site, where letters are larger than on paper; pandoc/pdf.lua divides by it.
constexpr double em_per_centimetre = 4.0;

constexpr const char* ink = "#222222";
constexpr const char* body_fill = "#dce8f3";
constexpr const char* body_line = "#1f4e79";
constexpr const char* held_fill = "#c9c9c9";
constexpr const char* held_line = "#444444";
constexpr const char* ground_line = "#444444";
constexpr const char* cable_line = "#b34700";
constexpr const char* velocity_line = "#00724f";
constexpr const char* force_line = "#a3206a";
constexpr const char* thin_line = "#555555";

SketchPoint operator+(SketchPoint a, SketchPoint b) { return {a.x + b.x, a.y + b.y}; }
SketchPoint operator-(SketchPoint a, SketchPoint b) { return {a.x - b.x, a.y - b.y}; }
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

/// A line of the sketch, split into its parts. Lengths are on paper.
struct Element {
  std::string keyword;
  std::vector<double> numbers;
  std::set<std::string> flags;
  std::vector<std::string> labels;

  [[nodiscard]] SketchPoint point(std::size_t i) const { return {numbers[i], numbers[i + 1]}; }
  [[nodiscard]] Points points() const {
    Points all;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
      all.push_back(point(i));
    return all;
  }
  [[nodiscard]] double number_or(std::size_t i, double substitute) const {
    return i < numbers.size() ? numbers[i] : substitute;
  }
  [[nodiscard]] std::string label() const { return labels.empty() ? "" : labels.front(); }
  [[nodiscard]] bool has(const char* flag) const { return flags.contains(flag); }
};

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

/// Adds elements to a sketch.
class Drawer {
 public:
  explicit Drawer(Sketch& sketch) : sketch_{sketch} {}

  void body(const Element& e) {
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

  void ground(const Element& e) {
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

  void anchor(const Element& e) {
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

  void pin(const Element& e) {
    disc(e.point(0), 0.09, "#ffffff", ink, 1.3);
    label(e.label(), e.point(0) + SketchPoint{0.2, 0.02}, Side::left);
  }

  void dot(const Element& e) {
    disc(e.point(0), 0.055, ink, "", 1.0);
    label(e.label(), e.point(0) + SketchPoint{0.15, 0.05}, Side::left);
  }

  /// The engineers' mark: a circle in four quarters, two of them filled.
  void centre(const Element& e) {
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

  void line(const Element& e) {
    Points points = e.points();
    if (e.keyword == "curve") points = smooth(points);
    const bool cable = e.keyword == "cable";
    stroke({points, "", cable ? cable_line : thin_line, cable ? 2.0 : 1.0, e.has("dashed")});
    label_beside(e, points);
  }

  void spring(const Element& e) {
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

  void dashpot(const Element& e) {
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

  void arrow(const Element& e) {
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

  void turn(const Element& e) {
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

  void dimension(const Element& e) {
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

  void axes(const Element& e) {
    const SketchPoint origin = e.point(0);
    const double whole = e.numbers[2];
    for (const SketchPoint along : {SketchPoint{1.0, 0.0}, SketchPoint{0.0, 1.0}}) {
      stroke({{origin, origin + (whole - 0.08) * along}, "", thin_line, 0.9});
      head(origin + whole * along, along, thin_line, 0.16);
    }
    label(e.labels[0], origin + SketchPoint{whole + 0.08, 0.0}, Side::left, false, thin_line);
    label(e.labels[1], origin + SketchPoint{0.0, whole + 0.2}, Side::centre, false, thin_line);
  }

  void text(const Element& e) {
    label(e.label(), e.point(0), e.has("left") ? Side::left : e.has("right") ? Side::right : Side::centre);
  }

  /// Number of letters of a label times their width, without marks of formulas [cm].
  [[nodiscard]] static double text_width(const std::string& text) {
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

 private:
  void stroke(Stroke&& stroke) {
    for (const SketchPoint& point : stroke.points)
      include(point);
    sketch_.strokes.push_back(std::move(stroke));
  }

  void include(SketchPoint point) {
    sketch_.low = {std::min(sketch_.low.x, point.x), std::min(sketch_.low.y, point.y)};
    sketch_.high = {std::max(sketch_.high.x, point.x), std::max(sketch_.high.y, point.y)};
  }

  void disc(SketchPoint centre, double radius, const char* fill, const char* colour, double width) {
    Points outline = superellipse(centre, radius, radius, 2.0, 0.0);
    outline.push_back(outline.front());
    stroke({outline, fill, colour, width});
  }

  void head(SketchPoint tip, SketchPoint along, const char* colour, double size) {
    const SketchPoint back = tip - size * along, side = 0.3 * size * left_of(along);
    stroke({{tip, back + side, back - side, tip}, colour, "", 1.0});
  }

  void label(const std::string& text, SketchPoint at, Side side, bool boxed = false, const char* colour = ink) {
    if (text.empty()) return;
    sketch_.labels.push_back({text, at, side, boxed, colour});
    const double wide = text_width(text);
    const double begin = side == Side::left ? 0.0 : side == Side::right ? -wide : -0.5 * wide;
    include(at + SketchPoint{begin, -0.5 * letter_height});
    include(at + SketchPoint{begin + wide, 0.5 * letter_height});
  }

  /// The element's label beside the middle of a line, `distance` from it.
  void label_beside(const Element& e, const Points& points, double distance = 0.22) {
    const std::size_t half = (points.size() - 1) / 2;
    const SketchPoint from = points[half], to = points[half + 1];
    const SketchPoint normal = (e.has("below") ? -1.0 : 1.0) * left_of(unit(to - from));
    const bool level = std::abs(normal.x) < 0.5;
    label(e.label(), 0.5 * (from + to) + (level ? distance : distance - 0.06) * normal,
          level          ? Side::centre
          : normal.x > 0 ? Side::left
                         : Side::right);
  }

  Sketch& sketch_;
};

/// What a keyword allows.
struct Grammar {
  const char* keyword;
  std::size_t minimum, maximum;  ///< how many numbers
  std::size_t angles;            ///< index of the first number that is not a length
  std::size_t labels;            ///< how many labels at most
  const char* flags;
  void (Drawer::*draw)(const Element&);
};

constexpr std::size_t many = 1000;
constexpr Grammar grammar[] = {
    {"disc", 3, 3, many, 1, "held ghost", &Drawer::body},
    {"box", 4, 5, 4, 1, "held ghost", &Drawer::body},
    {"superellipse", 5, 6, 4, 1, "held ghost", &Drawer::body},
    {"polygon", 6, many, many, 1, "held ghost", &Drawer::body},
    {"ground", 4, many, many, 1, "below", &Drawer::ground},
    {"anchor", 2, 3, 2, 1, "", &Drawer::anchor},
    {"pin", 2, 2, many, 1, "", &Drawer::pin},
    {"centre", 2, 2, many, 1, "", &Drawer::centre},
    {"dot", 2, 2, many, 1, "", &Drawer::dot},
    {"cable", 4, many, many, 1, "dashed below", &Drawer::line},
    {"line", 4, many, many, 1, "dashed below", &Drawer::line},
    {"curve", 4, many, many, 1, "dashed below", &Drawer::line},
    {"spring", 4, 4, many, 1, "below", &Drawer::spring},
    {"dashpot", 4, 4, many, 1, "below", &Drawer::dashpot},
    {"velocity", 4, 4, many, 1, "", &Drawer::arrow},
    {"force", 4, 4, many, 1, "", &Drawer::arrow},
    {"turn", 5, 5, 3, 1, "", &Drawer::turn},
    {"dimension", 4, 4, many, 1, "below", &Drawer::dimension},
    {"axes", 3, 3, many, 2, "", &Drawer::axes},
    {"text", 2, 2, many, 1, "left right", &Drawer::text},
};

bool takes_pairs(const Grammar& rule) { return rule.maximum == many; }

double number_of(const std::string& word, std::size_t line) {
  double value{};
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
    throw RecordError(fmt::format("sketch, line {}: '{}' is not a number", line, word));
  return value;
}

/// The parts of a line. Numbers precede flags, flags precede labels.
Element element_of(const std::string& text, std::size_t line) {
  Element e;
  const std::size_t quote = text.find('"');
  std::istringstream tokens(text.substr(0, quote));
  tokens >> e.keyword;
  for (std::string word; tokens >> word;) {
    if (std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
      e.flags.insert(word);
    } else {
      e.numbers.push_back(number_of(word, line));
    }
  }
  for (std::size_t begin = quote; begin != std::string::npos; begin = text.find('"', begin)) {
    const std::size_t end = text.find('"', begin + 1);
    if (end == std::string::npos) throw RecordError(fmt::format("sketch, line {}: a label does not end", line));
    e.labels.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
    const std::size_t rest = text.find_first_not_of(" ", begin);
    if (rest != std::string::npos && text[rest] != '"')
      throw RecordError(fmt::format("sketch, line {}: '{}' follows a label; only labels may", line, text.substr(rest)));
  }
  return e;
}

std::string keywords() {
  std::string all = "unit";
  for (const Grammar& rule : grammar)
    all += fmt::format(", {}", rule.keyword);
  return all;
}

const Grammar& rule_of(const Element& e, std::size_t line) {
  const auto* const rule =
      std::ranges::find_if(grammar, [&](const Grammar& each) { return e.keyword == each.keyword; });
  if (rule == std::end(grammar))
    throw RecordError(fmt::format("sketch, line {}: unknown keyword '{}'; allowed: {}", line, e.keyword, keywords()));
  const std::size_t count = e.numbers.size();
  if (count < rule->minimum || count > rule->maximum || (takes_pairs(*rule) && count % 2 != 0)) {
    const std::string allowed = takes_pairs(*rule) ? fmt::format("{} or more, in pairs", rule->minimum)
                                : rule->minimum == rule->maximum
                                    ? fmt::format("{}", rule->minimum)
                                    : fmt::format("{} or {}", rule->minimum, rule->maximum);
    throw RecordError(fmt::format("sketch, line {}: {} has {} numbers; allowed: {}", line, e.keyword, count, allowed));
  }
  for (const std::string& flag : e.flags) {
    std::istringstream allowed(rule->flags);
    if (std::find(std::istream_iterator<std::string>(allowed), {}, flag) == std::istream_iterator<std::string>())
      throw RecordError(fmt::format("sketch, line {}: {} has no flag '{}'; allowed: {}", line, e.keyword, flag,
                                    *rule->flags == '\0' ? "none" : rule->flags));
  }
  for (const auto& [keyword, first, end] :
       {std::tuple{"disc", 2U, 3U}, {"box", 2U, 4U}, {"superellipse", 2U, 5U}, {"turn", 2U, 3U}, {"axes", 2U, 3U}}) {
    for (std::size_t i = first; e.keyword == keyword && i < end; ++i) {
      if (!(e.numbers[i] > 0.0))
        throw RecordError(fmt::format("sketch, line {}: number {} of {} is {}; it must be > 0", line, i + 1, e.keyword,
                                      e.numbers[i]));
    }
  }
  const bool text = e.keyword == "text", axes = e.keyword == "axes";
  if (e.labels.size() > rule->labels || (text && e.labels.empty()) || (axes && e.labels.size() != 2))
    throw RecordError(fmt::format("sketch, line {}: {} has {} labels; allowed: {}", line, e.keyword, e.labels.size(),
                                  text   ? "1"
                                  : axes ? "2"
                                         : "none or 1"));
  return *rule;
}

std::string stroke_commands(const Stroke& stroke, std::size_t number, std::string& plots) {
  std::string block = fmt::format("$stroke{} << END\n", number);
  for (const SketchPoint& point : stroke.points)
    block += fmt::format("{:.4f} {:.4f}\n", point.x, point.y);
  const auto add = [&](const std::string& style) {
    plots += fmt::format("{}$stroke{} with {} notitle", plots.empty() ? "" : ", ", number, style);
  };
  if (!stroke.fill.empty())
    add(fmt::format("filledcurves closed fillcolor rgb '{}' fillstyle solid noborder", stroke.fill));
  if (!stroke.colour.empty())
    add(fmt::format("lines lc rgb '{}' lw {:g}{}", stroke.colour, stroke.width, stroke.dashed ? " dt (6,4)" : ""));
  return block + "END\n";
}

}  // namespace

Sketch read_sketch(const std::string& text) {
  constexpr double far = 1e9;
  Sketch sketch{{}, {}, {far, far}, {-far, -far}};
  Drawer drawer(sketch);
  double scale = 1.0;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" ");
    if (first == std::string::npos || line[first] == '#') continue;
    Element e = element_of(line, number);
    if (e.keyword == "unit") {
      if (e.numbers.size() != 1 || !(e.numbers[0] > 0.0) || !e.flags.empty() || !e.labels.empty())
        throw RecordError(fmt::format("sketch, line {}: unit is followed by one number > 0 alone", number));
      scale = e.numbers[0];
      continue;
    }
    const Grammar& rule = rule_of(e, number);
    for (std::size_t i = 0; i < std::min(e.numbers.size(), rule.angles); ++i)
      e.numbers[i] *= scale;
    (drawer.*rule.draw)(e);
  }
  if (sketch.strokes.empty() && sketch.labels.empty()) throw RecordError("sketch: it has no element");
  sketch.low = sketch.low - SketchPoint{border_width, border_width};
  sketch.high = sketch.high + SketchPoint{border_width, border_width};
  const double wide = sketch.high.x - sketch.low.x;
  if (wide > text_wide)
    throw RecordError(fmt::format("sketch: it is {:.1f} cm wide; at most {} cm are allowed (unit)", wide, text_wide));
  const double high = sketch.high.y - sketch.low.y;
  if (high > text_high)
    throw RecordError(fmt::format("sketch: it is {:.1f} cm high; at most {} cm are allowed (unit)", high, text_high));
  return sketch;
}

std::string sketch_script(const Sketch& sketch, const Canvas& canvas, const std::string& stem) {
  const SketchPoint size = sketch.high - sketch.low;
  std::string text = fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string()));
  text += fmt::format(
      "unset border\nunset tics\nunset grid\nset margins screen 0,screen 1,screen 0,screen 1\n"
      "set xrange [{:.4f}:{:.4f}]\nset yrange [{:.4f}:{:.4f}]\n",
      sketch.low.x, sketch.high.x, sketch.low.y, sketch.high.y);
  std::string plots;
  for (std::size_t i = 0; i < sketch.strokes.size(); ++i)
    text += stroke_commands(sketch.strokes[i], i + 1, plots);
  if (plots.empty()) plots = "NaN notitle";  // labels alone
  for (const SketchLabel& label : sketch.labels) {
    const char* const side = label.side == Side::left ? "left" : label.side == Side::right ? "right" : "center";
    text += fmt::format("set label {} at {:.4f},{:.4f} {} front{} textcolor rgb '{}'\n", gnuplot_text(label.text),
                        label.at.x, label.at.y, side, label.boxed ? " boxed" : "", label.colour);
  }
  Canvas own = canvas;
  own.width = size.x;
  return text + drawn_in_each_format(own, stem, "plot " + plots, size.y, {0.42, 10.0});
}

std::vector<PageSketch> page_sketches(const std::string& page) {
  static const std::string fence = "```", opening = "```sketch";
  std::vector<PageSketch> found;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t line_end = std::min(page.find('\n', at), page.size());
    if (page.compare(at, fence.size(), fence) != 0) {
      at = line_end + 1;
      continue;
    }
    const std::size_t close = page.find("\n" + fence, at);
    if (close == std::string::npos) throw RecordError("page: a code block does not end");
    const std::size_t end = close + 1 + fence.size();
    if (page.compare(at, opening.size(), opening) == 0) {
      const std::size_t title = page.find_first_not_of(" ", at + opening.size());
      if (title >= line_end)
        throw RecordError(fmt::format("page: the line '{}' has no alternative text for its sketch", opening));
      found.push_back(
          {at, end, page.substr(title, line_end - title), read_sketch(page.substr(line_end + 1, close - line_end))});
    }
    at = end;
  }
  return found;
}

std::string sketch_stem(const std::string& case_id, std::size_t index) {
  return fmt::format("{}-sketch-{}", case_id, index + 1);
}

std::string with_sketch_pictures(const std::string& page, const std::string& case_id) {
  std::string text;
  std::size_t from = 0, index = 0;
  for (const PageSketch& sketch : page_sketches(page)) {
    std::string title = sketch.title;
    std::erase(title, '"');
    text += page.substr(from, sketch.begin - from);
    const double wide = em_per_centimetre * (sketch.drawing.high.x - sketch.drawing.low.x);
    text += fmt::format("![](figures/{}.svg){{.sketch alt=\"{}\" width={:.2f}em}}", sketch_stem(case_id, index++),
                        title, wide);
    from = sketch.end;
  }
  return text + page.substr(from);
}

}  // namespace talus::reports
