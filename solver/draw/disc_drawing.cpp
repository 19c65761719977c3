#include "solver/draw/disc_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/record/csv.hpp"

namespace talus::app {
namespace {

/// Calls draw(shift) for each whole number of periods by which what reaches from `left` to `right` is in the window.
template <class Draw>
void for_images(double left, double right, double period, const Window& window, Draw draw) {
  const double last = std::floor((window.right - left) / period);
  for (double image = std::ceil((window.left - right) / period); image <= last; image += 1.0)
    draw(image * period);
}

/// Rows of a frame's CSV file.
class Rows {
 public:
  void add(const char* series, const Vec2& p, double radius = 0.0, double value = 0.0) {
    csv_.cell(series);
    csv_.cell(line_);
    for (const double number : {p.x, p.y, radius})
      csv_.number(number, 6);
    csv_.number(value, 4);
    csv_.end_row();
  }
  void next_line() { line_ = fmt::format("{}", ++lines_); }
  std::string text() && { return std::move(csv_).text(); }

 private:
  records::CsvText csv_{{"series", "line", "x", "y", "radius", "value"}};
  long lines_{0};
  std::string line_{"0"};
};

/// A bar of that width between two points.
void add_bar(Rows& rows, const char* series, const Vec2& from, const Vec2& to, double width) {
  const Vec2 along = to - from;
  const double length = norm(along);
  const Vec2 side = length > 0.0 ? (0.5 * width / length) * Vec2{-along.y, along.x} : Vec2{};
  for (const Vec2& corner : {from + side, to + side, to - side, from - side})
    rows.add(series, corner);
  rows.next_line();
}

/// Those behind first. In a frame's CSV file the column `series` holds the kind.
std::vector<records::Series> series_of(const DrawnDiscs& drawn, const DiscFrame& frame) {
  using records::Style;
  const auto walls =
      std::count_if(frame.discs.begin(), frame.discs.end(), [](const SeenDisc& disc) { return disc.wall; });
  const std::string unit = drawn.run.unit(dimension::force);
  std::vector<records::Series> series;
  if (walls > 0) {
    series.push_back(frame_series("wall", "disc of a wall", Style::circles, {"#5f6368", "#c4c7cb", 0.3}));
    series.back().columns.radius = "radius";
  }
  if (static_cast<std::size_t>(walls) < frame.discs.size()) {
    series.push_back(frame_series("disc", "", Style::circles, {"#33475b", "", 0.3}));
    series.back().columns.radius = "radius";
    series.back().columns.value = "value";
  }
  series.push_back(
      frame_series("border", "border of the field, beyond it images", Style::shapes, {"#0072b2", "", 1.2, true}));
  if (frame.contacts.empty()) return series;
  // On an edge of white, which tells it from dark discs.
  series.push_back(frame_series("contact", "", Style::shapes, {"#ffffff", "#ffffff", 1.0}));
  const std::string largest = fmt::format("{:.3g}{}{}", drawn.largest_force, unit.empty() ? "" : " ", unit);
  series.push_back(frame_series("contact", "contact, as wide as its force; widest " + largest, Style::shapes,
                                {"#000000", "#000000", 0.3}));
  return series;
}

Window whole_window(const DrawnDiscs& drawn) {
  const double beyond = 2.0 * drawn.largest_radius, margin = 0.5 * drawn.largest_radius;
  const double y = drawn.frames.front().discs.front().p.y;
  const double half = 0.5 * *drawn.run.files.period;
  Window window{-half - beyond, y, half + beyond, y};
  for (const DiscFrame& frame : drawn.frames) {
    for (const SeenDisc& disc : frame.discs) {
      window.bottom = std::min(window.bottom, disc.p.y - disc.radius - margin);
      window.top = std::max(window.top, disc.p.y + disc.radius + margin);
    }
  }
  return window;
}

std::vector<records::Mark> numbers(const DiscFrame& frame, const Window& window) {
  std::vector<records::Mark> marks;
  for (std::size_t i = 0; i < frame.discs.size(); ++i) {
    const Vec2& p = frame.discs[i].p;
    if (p.x < window.left || p.x > window.right) continue;
    marks.push_back({p.x, p.y, fmt::format("{}", i + 1)});
  }
  return marks;
}

}  // namespace

DrawnDiscs read_disc_frames(RunFolder run, const std::vector<GeometryFile>& files, DiscColour colour) {
  DrawnDiscs drawn{.run = std::move(run), .frames = {}, .colour = colour};
  const double period = *drawn.run.files.period;
  const auto whole = [period](double x) { return period * std::floor(x / period + 0.5); };
  for (const GeometryFile& file : files) {
    DiscFrame frame = read_discs(file);
    for (SeenDisc& disc : frame.discs) {
      disc.p.x -= whole(disc.p.x);
      drawn.largest_radius = std::max(drawn.largest_radius, disc.radius);
    }
    for (SeenContact& contact : frame.contacts) {
      const double back = whole(contact.from.x);
      contact.from.x -= back, contact.to.x -= back;
      drawn.largest_force = std::max(drawn.largest_force, contact.force);
    }
    drawn.frames.push_back(std::move(frame));
  }
  drawn.window = whole_window(drawn);
  return drawn;
}

std::vector<double> disc_values(const DiscFrame& frame, DiscColour colour) {
  std::vector<double> values(frame.discs.size(), 0.0);
  if (colour == DiscColour::speed) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = norm(frame.discs[i].v);
    return values;
  }
  for (const SeenContact& contact : frame.contacts)
    values[contact.a] += contact.force, values[contact.b] += contact.force;
  return values;
}

double largest_value(const DrawnDiscs& drawn, DiscColour colour) {
  double largest = 0.0;
  for (const DiscFrame& frame : drawn.frames) {
    const std::vector<double> values = disc_values(frame, colour);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!frame.discs[i].wall) largest = std::max(largest, values[i]);
  }
  return largest;
}

double widest_bar(const DrawnDiscs& drawn) { return 0.8 * drawn.largest_radius; }

std::string frame_csv(const DrawnDiscs& drawn, std::size_t frame) {
  const Window& window = drawn.window;
  const DiscFrame& shown = drawn.frames[frame];
  const double period = *drawn.run.files.period;
  const std::vector<double> values = disc_values(shown, drawn.colour);
  Rows rows;
  for (std::size_t i = 0; i < shown.discs.size(); ++i) {
    const SeenDisc& disc = shown.discs[i];
    for_images(disc.p.x - disc.radius, disc.p.x + disc.radius, period, window, [&](double shift) {
      rows.add(disc.wall ? "wall" : "disc", disc.p + Vec2{shift, 0.0}, disc.radius, values[i]);
    });
  }
  const double scale = drawn.largest_force > 0.0 ? widest_bar(drawn) / drawn.largest_force : 0.0;
  for (const SeenContact& contact : shown.contacts) {
    const auto [left, right] = std::minmax(contact.from.x, contact.to.x);
    for_images(left, right, period, window, [&](double shift) {
      const Vec2 by{shift, 0.0};
      add_bar(rows, "contact", contact.from + by, contact.to + by, scale * contact.force);
    });
  }
  for_images(-0.5 * period, -0.5 * period, period, window, [&](double shift) {
    rows.add("border", {shift - 0.5 * period, window.bottom});
    rows.add("border", {shift - 0.5 * period, window.top});
    rows.next_line();
  });
  return std::move(rows).text();
}

records::Figure frame_figure(const DrawnDiscs& drawn, std::size_t frame, const FrameStyle& style,
                             const std::string& csv_file) {
  const DiscFrame& shown = drawn.frames[frame];
  return frame_figure(drawn.run, style, {frame, shown.time, csv_file}, series_of(drawn, shown),
                      style.numbers ? numbers(shown, style.window) : std::vector<records::Mark>{});
}

std::optional<records::Scale> colour_scale(const DrawnDiscs& drawn) {
  const bool speed = drawn.colour == DiscColour::speed;
  return colour_scale(speed ? "speed of a disc" : "sum of the contact forces on a disc",
                      drawn.run.unit(speed ? dimension::velocity : dimension::force),
                      largest_value(drawn, drawn.colour));
}

}  // namespace talus::app
