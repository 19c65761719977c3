#include "solver/draw/player_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to six digits: finer than a screen resolves, and the file is a tenth of the size. Not by std::stod, which
/// throws for subnormal numbers.
double rounded(double value) { return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr); }

/// Position of a body (mean of its outline's points) and its angle (direction from there to the first point).
struct PlanePose {
  Vec2 p;
  double angle{};
};

PlanePose pose_of(const GeometryLine& line) {
  Vec2 sum;
  const bool closed = line.points.size() > 2 && line.points.front() == line.points.back();
  const std::size_t count = line.points.size() - (closed ? 1 : 0);  // the last point of a closed line repeats the first
  for (std::size_t i = 0; i < count; ++i)
    sum += in_plane(line.points[i]);
  const Vec2 p = (1.0 / static_cast<double>(count)) * sum;
  const Vec2 arm = in_plane(line.points.front()) - p;
  return {p, std::atan2(arm.y, arm.x)};
}

/// Coordinates of a point in the axes of a body.
Vec2 within(const PlanePose& pose, const Vec3& point) {
  const double c = std::cos(pose.angle);
  const double s = std::sin(pose.angle);
  const Vec2 r = in_plane(point) - pose.p;
  return {rounded(c * r.x + s * r.y), rounded(c * r.y - s * r.x)};
}

Json body(const DrawnGeometry& geometry, const GeometryLine& line, const std::vector<HangerBar>& all_bars) {
  const PlanePose pose = pose_of(line);
  Json outline = Json::array();
  for (const Vec3& point : line.points) {
    const Vec2 p = within(pose, point);
    outline.push_back({p.x, p.y});
  }
  Json bars = Json::array();
  for (const HangerBar& bar : all_bars) {
    if (bar.body != line.body) continue;
    const Vec2 joint = within(pose, bar.joint);
    const Vec2 end = within(pose, bar.end);
    bars.push_back({joint.x, joint.y, end.x, end.y});
  }
  const DrawnBody& named = geometry.run.files.bodies[static_cast<std::size_t>(line.body)];
  return {{"body", line.body},
          {"name", named.name},
          {"number", named.number},
          {"kind", named.kind},
          {"z", rounded(line.points.front().z)},
          {"outline", std::move(outline)},
          {"hangers", std::move(bars)}};
}

/// A frame as JSON. `bars` are the hangers of the first frame; bodies that have lost all of theirs count as broken.
Json frame_json(const GeometryFrame& frame, const std::vector<HangerBar>& bars) {
  const std::vector<HangerBar> left = hangers(frame);
  Json broken = Json::array();
  for (const HangerBar& bar : bars) {
    const bool holds =
        std::any_of(left.begin(), left.end(), [&](const HangerBar& each) { return each.body == bar.body; });
    if (!holds && std::find(broken.begin(), broken.end(), bar.body) == broken.end()) broken.push_back(bar.body);
  }

  Json poses = Json::array();
  Json cables = Json::array();
  for (const GeometryLine& line : frame.lines) {
    if (line.body >= 0) {
      const PlanePose pose = pose_of(line);
      poses.push_back({rounded(pose.p.x), rounded(pose.p.y), rounded(pose.angle)});
      continue;
    }
    const Vec3& a = line.points.front();
    const Vec3& b = line.points.back();
    cables.push_back({rounded(a.x), rounded(a.y), rounded(a.z), rounded(b.x), rounded(b.y), rounded(b.z),
                      line.slack ? 0.0 : rounded(line.tension)});
  }
  return {{"t", rounded(frame.time)},
          {"bodies", std::move(poses)},
          {"cables", std::move(cables)},
          {"broken", std::move(broken)}};
}

/// A long history is drawn by two points per block of rows, at most 1000, since a screen shows no more: the smallest
/// and the largest value, in their order, so that the peak of a short contact stays. The last row is always there.
constexpr std::size_t maximum_rows = 1000;
std::size_t block_length(std::size_t rows) { return rows <= maximum_rows ? 0 : 1 + 2 * rows / maximum_rows; }

Json thinned(const std::vector<double>& values) {
  Json list = Json::array();
  const std::size_t block = block_length(values.size());
  if (block == 0) {
    for (const double value : values)
      list.push_back(rounded(value));
    return list;
  }
  for (std::size_t first = 0; first + 1 < values.size(); first += block) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(first + block, values.size() - 1));
    const auto [smallest, largest] = std::minmax_element(begin, end);
    list.push_back(rounded(std::min(smallest, largest) == smallest ? *smallest : *largest));
    list.push_back(rounded(std::min(smallest, largest) == smallest ? *largest : *smallest));
  }
  list.push_back(rounded(values.back()));
  return list;
}

/// Times of the points of thinned(): of a block its first and middle row.
Json thinned_times(const std::vector<double>& times) {
  const std::size_t block = block_length(times.size());
  if (block == 0) return thinned(times);
  Json list = Json::array();
  for (std::size_t first = 0; first + 1 < times.size(); first += block) {
    list.push_back(rounded(times[first]));
    list.push_back(rounded(times[std::min(first + block / 2, times.size() - 2)]));
  }
  list.push_back(rounded(times.back()));
  return list;
}

/// Rows of a history nearest to the times of the frames, both in order.
std::vector<std::size_t> rows_at(const std::vector<double>& times, const std::vector<double>& frames) {
  std::vector<std::size_t> rows;
  std::size_t row = 0;
  for (const double t : frames) {
    while (row + 1 < times.size() && std::abs(times[row + 1] - t) <= std::abs(times[row] - t))
      ++row;
    rows.push_back(row);
  }
  return rows;
}

/// Values of some rows.
Json picked(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  Json list = Json::array();
  for (const std::size_t row : rows)
    list.push_back(rounded(values[row]));
  return list;
}

double reach(const SavedColumn& column) {
  double largest = 0.0;
  for (const double value : column.values)
    largest = std::max(largest, std::abs(value));
  return largest;
}

/// A chart of the columns selected by `belongs`, without columns that are zero up to rounding; null if none remain. The
/// curve of a series has its `values`; the cursor shows those `at` the frames, of the given rows: the smallest and
/// largest values of thinned() are not those of one time.
template <class Belongs>
Json chart(const std::string& title, const KeptHistory& history, const std::vector<std::size_t>& rows,
           Belongs belongs) {
  constexpr double rounding = 1e-12;
  double largest = 0.0;
  for (const SavedColumn& column : history.columns)
    if (belongs(column)) largest = std::max(largest, reach(column));
  Json series = Json::array();
  std::string unit;
  for (const SavedColumn& column : history.columns) {
    if (!belongs(column) || reach(column) <= rounding * largest) continue;
    unit = column.unit;
    series.push_back({{"name", column.name}, {"values", thinned(column.values)}, {"at", picked(column.values, rows)}});
  }
  if (series.empty()) return nullptr;
  return {{"title", title},
          {"unit", unit},
          {"t", thinned_times(history.columns.front().values)},
          {"series", std::move(series)}};
}

/// The curves of a run: energies and forces of bodies, stresses and contact fractions of a cell.
Json charts(const KeptHistory& history, const std::vector<double>& frames) {
  const std::vector<std::size_t> rows = rows_at(history.columns.front().values, frames);
  const auto of = [](std::initializer_list<std::string_view> names) {
    return [names = std::vector<std::string_view>{names}](const SavedColumn& column) {
      return std::find(names.begin(), names.end(), column.name) != names.end();
    };
  };
  Json made = Json::array();
  for (Json each :
       {chart(
            "Energies", history, rows,
            [](const SavedColumn& column) { return column.subject() == "energy" || column.subject() == "dissipated"; }),
        chart("Cable tensions", history, rows,
              [](const SavedColumn& column) { return column.quantity() == "tension"; }),
        chart("Contact forces", history, rows, [](const SavedColumn& column) { return column.quantity() == "force"; }),
        chart("Stresses on the walls", history, rows, of({"top_shear", "top_normal", "bottom_shear", "bottom_normal"})),
        chart("Stress ratio and fractions", history, rows,
              of({"stress_ratio", "solid_fraction", "touching", "multiple_fraction"})),
        chart("Depth of the field", history, rows, of({"depth"}))}) {
    if (!each.is_null()) made.push_back(std::move(each));
  }
  return made;
}

Json window_json(const Window& window) {
  return {rounded(window.left), rounded(window.bottom), rounded(window.right), rounded(window.top)};
}

/// Page data common to all runs. `states`: the frames, with their times.
template <class Frames>
Json page_json(const SavedRun& histories, const Window& side, const Frames& states) {
  const RunFolder& run = histories.run;
  std::vector<double> times;
  for (const auto& state : states)
    times.push_back(state.time);
  return {{"title", run.title},
          {"units",
           {{"time", run.unit(dimension::time)},
            {"length", run.unit(dimension::length)},
            {"velocity", run.unit(dimension::velocity)},
            {"force", run.unit(dimension::force)}}},
          {"side", window_json(side)},
          {"charts", charts(histories.histories.back(), times)}};  // history.csv, which every run writes
}

/// A frame of discs as JSON: positions as integer multiples of `quantum`, speeds and forces in thousandths of the
/// largest; integers are shorter than decimals.
Json disc_frame_json(const DiscFrame& frame, double quantum, double speed, double force) {
  const auto thousandths = [](double value, double largest) {
    return largest > 0.0 ? std::lround(1000.0 * value / largest) : 0L;
  };
  Json positions = Json::array(), speeds = Json::array(), contacts = Json::array();
  for (const SeenDisc& disc : frame.discs) {
    positions.push_back(std::lround(disc.p.x / quantum));
    positions.push_back(std::lround(disc.p.y / quantum));
    speeds.push_back(thousandths(norm(disc.v), speed));
  }
  for (const SeenContact& contact : frame.contacts) {
    contacts.push_back(contact.a);
    contacts.push_back(contact.b);
    contacts.push_back(thousandths(contact.force, force));
  }
  return {{"t", rounded(frame.time)},
          {"positions", std::move(positions)},
          {"speeds", std::move(speeds)},
          {"contacts", std::move(contacts)}};
}

}  // namespace

std::string player_json(const DrawnGeometry& geometry, const SavedRun& histories, const Window& side,
                        const Window& along) {
  Json bodies = Json::array();
  const std::vector<HangerBar> bars = hangers(geometry.frames.front());
  for (const GeometryLine& line : geometry.frames.front().lines) {
    if (line.body >= 0) bodies.push_back(body(geometry, line, bars));
  }
  Json frames = Json::array();
  for (const GeometryFrame& frame : geometry.frames)
    frames.push_back(frame_json(frame, bars));
  Json page = page_json(histories, side, geometry.frames);
  page["along"] = geometry.has_depth ? window_json(along) : Json(nullptr);
  page["mirrored"] = geometry.run.files.mirrored;
  page["largest_tension"] = rounded(geometry.largest_tension);
  page["bodies"] = std::move(bodies);
  page["cables"] = geometry.run.files.cables;
  page["frames"] = std::move(frames);
  return page.dump();
}

std::string player_json(const DrawnDiscs& drawn, const SavedRun& histories, const Window& side, const Window&) {
  const double quantum = drawn.largest_radius / 500.0;
  const double speed = largest_value(drawn, DiscColour::speed);
  Json radii = Json::array(), walls = Json::array();
  const std::vector<SeenDisc>& discs = drawn.frames.front().discs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    radii.push_back(std::lround(discs[i].radius / quantum));
    if (discs[i].wall) walls.push_back(i);
  }
  Json frames = Json::array();
  for (const DiscFrame& frame : drawn.frames)
    frames.push_back(disc_frame_json(frame, quantum, speed, drawn.largest_force));
  Json page = page_json(histories, side, drawn.frames);
  page["discs"] = {
      {"period", rounded(*drawn.run.files.period)},
      {"quantum", quantum},
      {"radii", std::move(radii)},
      {"walls", std::move(walls)},
      {"colour", name_of(drawn.colour)},
      {"largest", {{"speed", rounded(speed)}, {"force", rounded(largest_value(drawn, DiscColour::force))}}},
      {"contact", rounded(drawn.largest_force)},
      {"widest", rounded(widest_bar(drawn))}};
  page["frames"] = std::move(frames);
  return page.dump();
}

}  // namespace talus::app
