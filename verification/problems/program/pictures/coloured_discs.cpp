#include "verification/problems/program/pictures/coloured_discs.hpp"

#include <algorithm>
#include <cmath>

#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::picture_options {
namespace {

/// Value of a colour on the bar: in the middle of its parts, each of which is covered by the next. NaN if it has none.
double value_of(const ColourBar& bar, long colour) {
  double positions = 0.0, count = 0.0;
  for (std::size_t i = 0; i < bar.parts.size(); ++i) {
    if (bar.parts[i].colour != colour) continue;
    const double end = i + 1 < bar.parts.size() ? bar.parts[i + 1].left : bar.parts[i].right;
    positions += 0.5 * (bar.parts[i].left + end), count += 1.0;
  }
  return bar.value_at(positions / count);
}

/// The state that a panel shows, by the time in its title.
const DiscState& state_of(const Panel& panel, const std::vector<DiscState>& states) {
  const double time = std::stod(panel.title.substr(panel.title.find('=') + 1));
  return *std::ranges::min_element(states, {}, [&](const DiscState& state) { return std::abs(state.time - time); });
}

}  // namespace

std::vector<DiscState> disc_states(const std::vector<GeometryState>& states, DiscValue value) {
  std::vector<DiscState> found;
  for (const GeometryState& state : states) {
    const std::vector<double> points = data_array(state.text, "Points"), velocity = data_array(state.text, "velocity"),
                              id = data_array(state.text, "id"), wall = data_array(state.text, "wall"),
                              force = data_array(state.text, "force"),
                              ends = data_array(state.text.substr(state.text.find("<Lines>")), "connectivity"),
                              vertices = data_array(state.text.substr(state.text.find("<Verts>")), "offsets");
    // An image has the negative number of its disc, and no vertex; forces of contacts follow those of the vertices.
    const auto disc_of = [&](std::size_t point) { return static_cast<std::size_t>(std::abs(id.at(point))); };
    std::vector<double> values(id.size() + 1, 0.0);
    for (std::size_t i = 0; i < ends.size(); ++i)
      values.at(disc_of(static_cast<std::size_t>(ends[i]))) += force.at(vertices.size() + i / 2);
    DiscState& now = found.emplace_back(DiscState{.time = state.time, .discs = {}});
    for (std::size_t i = 0; i < id.size(); ++i) {
      const double speed = std::hypot(velocity.at(3 * i), velocity.at(3 * i + 1));
      now.discs.push_back({static_cast<int>(id.at(i)), points.at(3 * i), points.at(3 * i + 1), wall.at(i) != 0.0,
                           value == DiscValue::speed ? speed : values.at(disc_of(i))});
    }
  }
  return found;
}

std::vector<DiscState> shown_states(const Picture& picture, const std::vector<DiscState>& states) {
  std::vector<DiscState> shown;
  for (const Panel& panel : picture.panels)
    shown.push_back(state_of(panel, states));
  return shown;
}

ColourErrors colour_errors(const Picture& picture, const std::vector<DiscState>& states, double period) {
  ColourErrors errors;
  double largest = 0.0;
  for (const DiscState& state : states)
    for (const DiscState::Disc& disc : state.discs)
      if (!disc.wall) largest = std::max(largest, disc.value);
  errors.largest =
      picture.bar.parts.empty() ? std::nan("") : picture.bar.value_at(picture.bar.parts.back().right) / largest - 1.0;
  for (const Panel& panel : picture.panels) {
    const DiscState& state = state_of(panel, states);
    for (const Curve& curve : panel.curves) {
      // Blocks of discs are named by their colour, as "$panel1_2_fec44f".
      const std::string colour = curve.name.substr(curve.name.rfind('_') + 1);
      if (colour.size() != 6) continue;
      for (const std::vector<Point>& outline : curve.lines) {
        Point centre{};
        for (const Point& corner : outline)
          centre = {centre[0] + corner[0] / static_cast<double>(outline.size()),
                    centre[1] + corner[1] / static_cast<double>(outline.size())};
        const auto distance = [&](const DiscState::Disc& disc) {
          const double across = centre[0] - disc.x;
          return std::hypot(across - period * std::round(across / period), centre[1] - disc.y);
        };
        const DiscState::Disc& disc = *std::ranges::min_element(state.discs, {}, distance);
        if (!(distance(disc) < 1e-4 * period)) errors.value = std::nan("");
        if (disc.wall) continue;
        keep_worst(errors.value, (value_of(picture.bar, std::stol(colour, nullptr, 16)) - disc.value) / largest);
        ++errors.discs;
      }
    }
  }
  return errors;
}

double largest_force(const std::vector<GeometryState>& states) {
  double largest = 0.0;
  for (const GeometryState& state : states)
    for (const double force : data_array(state.text, "force"))
      keep_largest(largest, force);
  return largest;
}

bool marks_are_numbers(const Picture& picture, const std::vector<DiscState>& states, double period) {
  bool agree = !picture.panels.empty();
  for (const Panel& panel : picture.panels) {
    std::size_t discs = 0;
    for (const DiscState::Disc& disc : state_of(panel, states).discs) {
      if (disc.number < 0) continue;
      ++discs;
      const auto mark = panel.marks.find(std::to_string(disc.number));
      if (mark == panel.marks.end()) return false;
      const double across = mark->second[0] - disc.x, up = mark->second[1] - disc.y;
      agree = agree && std::hypot(across - period * std::round(across / period), up) < 1e-4 * period;
    }
    agree = agree && panel.marks.size() == discs;
  }
  return agree;
}

Bars contact_bars(const Picture& picture) {
  Bars bars;
  for (const Panel& panel : picture.panels) {
    for (const Curve& curve : panel.curves) {
      for (const std::vector<Point>& corners : curve.lines) {
        if (corners.size() != 4) continue;
        const double x = corners.at(0)[0] + corners.at(3)[0] - corners.at(1)[0] - corners.at(2)[0],
                     y = corners[0][1] + corners[3][1] - corners[1][1] - corners[2][1];
        bars.longest = std::max(bars.longest, 0.5 * std::hypot(x, y)), ++bars.count;
        bars.widest = std::max(bars.widest, std::hypot(corners[0][0] - corners[3][0], corners[0][1] - corners[3][1]));
      }
    }
  }
  return bars;
}

}  // namespace talus::verification::problems::picture_options
