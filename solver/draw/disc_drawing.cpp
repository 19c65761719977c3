#include "solver/draw/disc_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus::app {
namespace {

/// Calls draw(shift) for each periodic shift by which an object that spans `left` to `right` is in the window.
template <class Draw>
void for_images(double left, double right, double period, const Window& window, Draw draw) {
  const double last = std::floor((window.right - left) / period);
  for (double image = std::ceil((window.left - right) / period); image <= last; image += 1.0)
    draw(image * period);
}

/// Adds a bar of the given width between two points.
void add_bar(records::Series& bars, const Vec2& from, const Vec2& to, double width) {
  const Vec2 along = to - from;
  const double length = norm(along);
  const Vec2 side = length > 0.0 ? (0.5 * width / length) * Vec2{-along.y, along.x} : Vec2{};
  add_polyline(bars, {from + side, to + side, to - side, from - side});
}

/// Adds the discs of a frame to `walls` or to `discs`; the latter are coloured by their values.
void add_discs(const DrawnDiscs& drawn, const DiscFrame& frame, records::Series& walls, records::Series& discs) {
  const std::vector<double> values = disc_values(frame, drawn.colour);
  for (std::size_t i = 0; i < frame.discs.size(); ++i) {
    const SeenDisc& disc = frame.discs[i];
    for_images(disc.p.x - disc.radius, disc.p.x + disc.radius, *drawn.run.files.period, drawn.window,
               [&](double shift) {
                 records::Series& series = disc.wall ? walls : discs;
                 series.add(disc.p.x + shift, disc.p.y);
                 series.radius.push_back(disc.radius);
                 if (!disc.wall) series.values.push_back(values[i]);
               });
  }
}

void add_contacts(const DrawnDiscs& drawn, const DiscFrame& frame, records::Series& bars) {
  const double scale = drawn.largest_force > 0.0 ? widest_bar(drawn) / drawn.largest_force : 0.0;
  for (const SeenContact& contact : frame.contacts) {
    const auto [left, right] = std::minmax(contact.from.x, contact.to.x);
    for_images(left, right, *drawn.run.files.period, drawn.window, [&](double shift) {
      const Vec2 by{shift, 0.0};
      add_bar(bars, contact.from + by, contact.to + by, scale * contact.force);
    });
  }
}

void add_borders(const DrawnDiscs& drawn, records::Series& borders) {
  const double period = *drawn.run.files.period;
  for_images(-0.5 * period, -0.5 * period, period, drawn.window, [&](double shift) {
    const double x = shift - 0.5 * period;
    add_polyline(borders, {{x, drawn.window.bottom}, {x, drawn.window.top}});
  });
}

/// The series of a frame, from back to front.
std::vector<records::Series> series_of(const DrawnDiscs& drawn, const DiscFrame& frame) {
  using records::Style;
  records::Series walls = frame_series("disc of a wall", Style::circles, {"#5f6368", "#c4c7cb", 0.3});
  records::Series discs = frame_series("", Style::circles, {"#33475b", "", 0.3});
  records::Series borders =
      frame_series("border of the field, beyond it images", Style::shapes, {"#0072b2", "", 1.2, true});
  add_discs(drawn, frame, walls, discs);
  add_borders(drawn, borders);
  std::vector<records::Series> series;
  if (!walls.x.empty()) series.push_back(std::move(walls));
  if (!discs.x.empty()) series.push_back(std::move(discs));
  series.push_back(std::move(borders));
  if (frame.contacts.empty()) return series;
  const std::string unit = drawn.run.unit(dimension::force);
  const std::string largest = fmt::format("{:.3g}{}{}", drawn.largest_force, unit.empty() ? "" : " ", unit);
  records::Series bars =
      frame_series("contact, as wide as its force; widest " + largest, Style::shapes, {"#000000", "#000000", 0.3});
  add_contacts(drawn, frame, bars);
  // A white edge makes the bars visible on dark discs.
  records::Series edges = bars;
  edges.label.clear();
  edges.look = {"#ffffff", "#ffffff", 1.0};
  series.push_back(std::move(edges));
  series.push_back(std::move(bars));
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

records::Figure frame_figure(const DrawnDiscs& drawn, std::size_t frame, const FrameStyle& style) {
  const DiscFrame& shown = drawn.frames[frame];
  return frame_figure(drawn.run, style, {.number = frame, .time = shown.time}, series_of(drawn, shown),
                      style.numbers ? numbers(shown, style.window) : std::vector<records::Mark>{});
}

std::optional<records::Scale> colour_scale(const DrawnDiscs& drawn) {
  const bool speed = drawn.colour == DiscColour::speed;
  return colour_scale(speed ? "speed of a disc" : "sum of the contact forces on a disc",
                      drawn.run.unit(speed ? dimension::velocity : dimension::force),
                      largest_value(drawn, drawn.colour));
}

}  // namespace talus::app
