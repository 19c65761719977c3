#include "reports/sheet/sheet_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/figures/gnuplot_text.hpp"

namespace talus::reports {
namespace {

/// Grey, blue and vermilion of the preamble: start, largest travel, end.
constexpr std::array colours{"#999999", "#0072B2", "#D55E00"};

/// Polylines as one gnuplot data block; an empty line ends a polyline.
class Block {
 public:
  explicit Block(std::string name) : name_{std::move(name)} {}
  void add(double x, double y) {
    fmt::format_to(std::back_inserter(text_), "{:.6g} {:.6g}\n", x, y);
    x_.push_back(x), y_.push_back(y);
  }
  void end() { text_ += '\n'; }
  bool empty() const { return x_.empty(); }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  std::string data() const { return fmt::format("${} << EOD\n{}EOD\n", name_, text_); }
  std::string curve(std::string_view style, const std::string& title = "") const {
    const std::string title_text = title.empty() ? "notitle" : "title " + gnuplot_text(title);
    return fmt::format("${} using 1:2 with lines {} {}", name_, style, title_text);
  }

 private:
  std::string name_;
  std::string text_;
  std::vector<double> x_, y_;
};

/// A panel: its blocks and curves.
struct View {
  std::string data;
  std::string curves;
  std::vector<double> x, y;

  void add(const Block& block, std::string_view style, const std::string& title = "") {
    if (block.empty()) return;
    data += block.data();
    curves += (curves.empty() ? "" : ", ") + block.curve(style, title);
    x.insert(x.end(), block.x().begin(), block.x().end());
    y.insert(y.end(), block.y().begin(), block.y().end());
  }
};

std::string style(std::size_t state, double width) { return fmt::format("lc rgb '{}' lw {}", colours[state], width); }

std::string state_title(const SheetState& state) { return fmt::format("{}, {:.4g} s", state.name, state.time); }

/// True if a later state has the same time and would be drawn over this one.
bool hidden(const SheetRecord& record, std::size_t state) {
  return state + 1 < record.states.size() && record.states[state].time == record.states[state + 1].time;
}

/// True for a column in the middle of the fence: in front of it the side view shows the impact.
bool central(const SheetRecord& record, const std::string& name) {
  double minimum = record.span;
  for (const SheetColumn& column : record.columns)
    minimum = std::min(minimum, std::abs(column.along));
  return std::any_of(record.columns.begin(), record.columns.end(), [&](const SheetColumn& column) {
    return column.name == name && std::abs(column.along) <= minimum * (1.0 + 1e-9);
  });
}

View side_view(const SheetRecord& record) {
  View panel;
  for (std::size_t r = 0; r < record.rocks.size(); ++r) {
    Block path{fmt::format("path{}", r)};
    for (const std::vector<double>& row : record.history)
      path.add(row[1 + 3 * r], row[2 + 3 * r]);
    panel.add(path, "lc rgb '#009E73' lw 1 dt 2", r == 0 ? "path of the rock" : "");
  }
  for (std::size_t s = 0; s < record.states.size(); ++s) {
    if (hidden(record, s)) continue;
    Block bodies{fmt::format("bodies{}", s)}, cables{fmt::format("cables{}", s)};
    for (const SheetState::Body& body : record.states[s].bodies) {
      if (body.layer != 0 && !central(record, body.name)) continue;
      for (const Pair p : body.outline)
        bodies.add(p[0], p[1]);
      bodies.end();
    }
    for (const SheetState::Segment& segment : record.states[s].cables) {
      for (const Triple& p : segment.ends)
        cables.add(p[0], p[1]);
      cables.end();
    }
    panel.add(cables, style(s, 0.6));
    panel.add(bodies, style(s, 1.6));
  }
  return panel;
}

/// View across the fence; a half model is shown with its mirror image.
View front_view(const SheetRecord& record) {
  View panel;
  const std::vector<double> sides = record.half_model ? std::vector{1.0, -1.0} : std::vector{1.0};
  for (std::size_t s = 0; s < record.states.size(); ++s) {
    if (hidden(record, s)) continue;
    const SheetState& state = record.states[s];
    Block block{fmt::format("front{}", s)};
    for (const double side : sides) {
      for (const SheetState::Segment& segment : state.cables) {
        if (segment.layer != 1) continue;
        for (const Triple& p : segment.ends)
          block.add(side * p[2], p[1]);
        block.end();
      }
      for (const SheetColumn& column : record.columns) {
        const auto body = std::find_if(state.bodies.begin(), state.bodies.end(),
                                       [&](const SheetState::Body& b) { return b.name == column.name; });
        if (column.layer != 1 || body == state.bodies.end()) continue;
        const auto [low, high] = std::minmax_element(body->outline.begin(), body->outline.end(),
                                                     [](const Pair& a, const Pair& b) { return a[1] < b[1]; });
        const double half = std::min(record.column_half_width, 0.42 * record.spacing);
        const double left = side * column.along - half, right = side * column.along + half;
        for (const auto& [z, y] : {Pair{left, (*low)[1]}, Pair{right, (*low)[1]}, Pair{right, (*high)[1]},
                                   Pair{left, (*high)[1]}, Pair{left, (*low)[1]}})
          block.add(z, y);
        block.end();
      }
    }
    panel.add(block, style(s, s == 0 ? 1.4 : 1.0), state_title(state));
  }
  return panel;
}

View force_chart(const SheetRecord& record) {
  View panel;
  constexpr std::array names{"hanger", "top", "bottom"};
  constexpr std::array titles{"hanger", "top cable", "bottom cable"};
  constexpr std::array styles{"lt 3", "lt 1", "lt 2"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto column = std::find(record.history_columns.begin(), record.history_columns.end(), names[i]);
    const auto index = static_cast<std::size_t>(column - record.history_columns.begin());
    Block block{fmt::format("force{}", i)};
    for (const std::vector<double>& row : record.history)
      block.add(row.at(0), 1e-3 * row.at(index));
    const bool any = std::any_of(block.y().begin(), block.y().end(), [](double y) { return y > 0.0; });
    if (any) panel.add(block, styles[i], titles[i]);
  }
  return panel;
}

/// Height of the ground line at x.
double ground_below(const SheetRecord& record, double x) {
  const auto next = std::find_if(record.ground.begin(), record.ground.end(), [x](Pair p) { return p[0] > x; });
  if (record.ground.empty()) return 0.0;
  if (next == record.ground.begin() || next == record.ground.end()) return record.ground.front()[1];
  const Pair a = *(next - 1), b = *next;
  return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
}

/// Limits of an axis with a small margin.
std::string range(char axis, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double room = 0.04 * std::max(*high - *low, 0.1);
  return fmt::format("set {}range [{:.6g}:{:.6g}]\n", axis, *low - room, *high + room);
}

/// Positions of the parts of the drawing, and font sizes.
struct SheetLayout {
  struct Frame {
    double left, right, bottom, top;  ///< fractions of the drawing
    std::string margins() const {
      return fmt::format(
          "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
          left, right, bottom, top);
    }
  };
  double tics, titles;  ///< font sizes
  Frame side, front, forces;
  std::string states_key;  ///< options of gnuplot's key
  std::string forces_key;
  double forces_title;   ///< its height, as a fraction of the drawing
  const char* mirrored;  ///< title of the view along the fence of a half model
  double width, height;  ///< [cm]
};

SheetLayout sheet_layout(const SheetRecord& record, SheetMedium medium) {
  if (medium == SheetMedium::phone) {
    // 364 pixels: the phone's 390 minus the margins of the page.
    return {.tics = 11.5,
            .titles = 12.0,
            .side = {0.13, 0.53, 0.68, 0.955},
            .front = {0.13, 0.97, 0.43, 0.57},
            .forces = {0.13, 0.97, 0.065, 0.265},
            .states_key = "at screen 0.98, screen 0.955 right top vertical maxrows 3",
            .forces_key = "at screen 0.98, screen 0.298 right center horizontal maxrows 2",
            .forces_title = 0.335,
            .mirrored = "\"along the fence, first layer;\\nbelow z = 0 the half model mirrored\"",
            .width = 364.0 / 760.0 * centimetres_wide,
            .height = 14.6};
  }
  const bool paper = medium == SheetMedium::paper;
  // Long tables reduce the space for the drawing.
  const bool long_tables = record.rocks.size() + record.columns.size() > 9;
  return {.tics = paper ? 10.0 : 11.5,
          .titles = paper ? 11.0 : 12.0,
          .side = {0.075, 0.30, 0.52, 0.89},
          .front = {0.37, 0.98, 0.52, 0.89},
          .forces = {0.075, 0.98, 0.12, 0.35},
          .states_key = "at screen 0.98, screen 0.995 right top horizontal maxrows 1",
          .forces_key = "at screen 0.98, screen 0.385 right center horizontal maxrows 1",
          .forces_title = 0.385,
          .mirrored = "'along the fence, first layer; below z = 0 the half model mirrored'",
          .width = centimetres_wide,
          .height = paper && long_tables ? 7.0 : 8.4};
}

}  // namespace

std::string sheet_script(const SheetRecord& record, const Canvas& canvas, const std::string& stem, SheetMedium medium) {
  const SheetLayout layout = sheet_layout(record, medium);
  View side = side_view(record), front = front_view(record);
  const View forces = force_chart(record);
  Block ground{"ground"};
  for (const Pair p : record.ground)
    ground.add(p[0], p[1]);
  // Along the fence the ground is drawn level, at its height below the columns.
  const double level = ground_below(record, 0.0);
  side.y.push_back(level), front.y.push_back(level);
  std::string body = fmt::format(
      "set multiplot\nset size ratio -1\nset tics font ',{0}'\nset title font ',{1}' offset 0,-0.7\n"
      "set xlabel font ',{0}' offset 0,0.8\nset ylabel font ',{0}' offset 1,0\nset key font ',{0}'\n",
      layout.tics, layout.titles);
  body += layout.side.margins() +
          "set key off\nset xtics 1\nset title 'from the side'\nset xlabel 'x, m'\nset ylabel 'y, m'\n" +
          range('x', side.x) + range('y', side.y);
  body += fmt::format("plot {}, {}\n", ground.curve("lc rgb '#666666' lw 1.4"), side.curves);
  body +=
      layout.front.margins() +
      fmt::format("set xtics autofreq\nset title {}\nset xlabel 'z, m'\nset key on {} Right noreverse samplen 1.5\n",
                  record.half_model ? layout.mirrored : "'along the fence, first layer'", layout.states_key) +
      range('x', front.x) + range('y', front.y);
  body += fmt::format("plot {:.6g} with lines lc rgb '#666666' lw 1.4 notitle, {}\n", level, front.curves);
  body += layout.forces.margins() +
          fmt::format(
              "set size noratio\nunset title\nset xlabel 'time, s'\nunset ylabel\n"
              "set label 1 'largest forces in kN, at the times of the histories' at screen {}, screen {} font ',{}'\n"
              "set key {} Right noreverse\nset autoscale\nset yrange [0:*]\n",
              layout.forces.left, layout.forces_title, layout.titles, layout.forces_key);
  body += fmt::format("plot {}\nunset label 1\nunset multiplot", forces.curves);
  Canvas wide = canvas;
  wide.width = layout.width;
  return fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string())) + ground.data() + side.data + front.data +
         forces.data + drawn_in_each_format(wide, stem, body, layout.height);
}

}  // namespace talus::reports
