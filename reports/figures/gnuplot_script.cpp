#include "reports/figures/gnuplot_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/figures/gnuplot_curve.hpp"
#include "reports/figures/gnuplot_text.hpp"

namespace talus::reports {
namespace {

/// Part of a power law within the plot: a third of the x axis to each side of its point, clipped.
std::array<Point, 2> slope_ends(const Slope& slope, const Plot& plot) {
  const double reach = std::pow(plot.x.high / plot.x.low, 1.0 / 3.0);
  std::array<Point, 2> ends;
  double low = std::max(slope.x / reach, plot.x.low);
  double high = std::min(slope.x * reach, plot.x.high);
  if (slope.order != 0.0) {
    const auto x_at = [&](double y) { return slope.x * std::pow(y / slope.y, 1.0 / slope.order); };
    const double one = x_at(plot.y.low);
    const double other = x_at(plot.y.high);
    low = std::max(low, std::min(one, other));
    high = std::min(high, std::max(one, other));
  }
  const auto at = [&](double x) {
    const double y = slope.y * std::pow(x / slope.x, slope.order);
    return Point{x, y, y, y};
  };
  ends = {at(low), at(high)};
  return ends;
}

std::string slope_commands(const Plot& plot, std::string& curves) {
  std::string text;
  int index = 0;
  for (const Slope& slope : plot.figure.slopes) {
    const std::array<Point, 2> ends = slope_ends(slope, plot);
    if (!(ends[0].x < ends[1].x)) continue;  // the law passes outside the limits
    ++index;
    text += fmt::format("$slope{} << END\n{:.9g} {:.9g}\n{:.9g} {:.9g}\nEND\n", index, ends[0].x, ends[0].y, ends[1].x,
                        ends[1].y);
    const std::string label = slope.label.empty() ? fmt::format("slope {:g}", slope.order) : slope.label;
    // The label is placed beside the end with more room to the border.
    const double width = std::log(plot.x.high / plot.x.low);
    const bool at_low = std::log(ends[0].x / plot.x.low) / width >= std::log(plot.x.high / ends[1].x) / width;
    const Point& end = ends[at_low ? 0 : 1];
    text += fmt::format("set label {} at {:.9g},{:.9g} {} front boxed textcolor rgb '#444444'\n", gnuplot_text(label),
                        end.x, end.y, at_low ? "right offset char -0.8,0" : "left offset char 0.8,0");
    curves += fmt::format(", $slope{} with lines lc rgb '#555555' lw 1.4 dt 2 notitle", index);
  }
  return text;
}

std::string line_commands(const Plot& plot) {
  std::string text;
  for (const Line& line : plot.figure.lines) {
    const Extent& extent = line.axis == 'x' ? plot.x : plot.y;
    if (line.at < extent.low || line.at > extent.high) continue;  // outside the record's limits
    const std::string from = line.axis == 'x' ? fmt::format("first {:.9g}, graph 0", line.at)
                                              : fmt::format("graph 0, first {:.9g}", line.at);
    const std::string to = line.axis == 'x' ? fmt::format("first {:.9g}, graph 1", line.at)
                                            : fmt::format("graph 1, first {:.9g}", line.at);
    text += fmt::format("set arrow from {} to {} nohead lc rgb '#333333' lw 1.2 dt 4 back\n", from, to);
    if (line.label.empty()) continue;
    const std::string position = line.axis == 'x'
                                     ? fmt::format("first {:.9g}, graph 1.035 center", line.at)
                                     : fmt::format("graph 0.985, first {:.9g} right offset 0,char 0.55", line.at);
    text += fmt::format("set label {} at {} front boxed textcolor rgb '#333333'\n", gnuplot_text(line.label), position);
  }
  return text;
}

std::string axis_commands(char name, const Axis& axis, const Extent& extent, std::size_t maximum) {
  const std::string unit = axis.unit.empty() || axis.unit == "1" || axis.unit == "-" ? "" : " [" + axis.unit + "]";
  std::string text = fmt::format("set {}label {}\n", name, gnuplot_lines(axis.label + unit, maximum));
  text += fmt::format("set {}range [{:.12g}:{:.12g}]\n", name, extent.low, extent.high);
  if (axis.log) {
    text += fmt::format("set logscale {}\n", name) + log_tics(name, extent);
  } else {
    text += fmt::format("set format {} '%.8g'\n", name);
    if (axis.divisions > 0) {
      const double part = (extent.high - extent.low) / axis.divisions;
      text += fmt::format("set {}tics {:.12g},{:.12g}\nset format {} '%.4g'\n", name, extent.low, part, name);
    }
  }
  return text;
}

std::string mark_commands(const Plot& plot) {
  std::string text;
  for (const Mark& mark : plot.figure.marks) {
    const bool inside = mark.x > plot.x.low && mark.x < plot.x.high && mark.y > plot.y.low && mark.y < plot.y.high;
    if (!inside) continue;
    text += fmt::format("set label {} at {:.6g},{:.6g} center front textcolor rgb '#111111' font ',{}'\n",
                        gnuplot_text(mark.text), mark.x, mark.y, 9);
  }
  return text;
}

std::size_t longest_label(const Plot& plot) {
  std::size_t longest = 8;
  for (const Curve& curve : plot.curves)
    longest = std::max(longest, curve.label.size());
  return longest;
}

/// Number of key columns that fit side by side below the plot, from the longest label.
std::size_t key_columns(const Plot& plot, const Canvas& canvas) {
  constexpr std::size_t sample = 6;  // letters, of the line and the space beside it
  return std::clamp<std::size_t>(letters_along(canvas.width, canvas.letters) / (longest_label(plot) + sample), 1, 4);
}

}  // namespace

std::string log_tics(char axis, const Extent& extent) {
  const int first = static_cast<int>(std::ceil(std::log10(extent.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(extent.high) + 1e-9));
  std::string ticks;
  // Each position is listed explicitly: gnuplot's series would start at the end of the axis, whatever its value.
  const auto add = [&](const std::string& label, double digit, int decade, const char* level) {
    const double value = digit * std::pow(10.0, decade);
    if (value < extent.low * (1.0 - 1e-9) || value > extent.high * (1.0 + 1e-9)) return;
    ticks += fmt::format("{}{} {:g}e{}{}", ticks.empty() ? "" : ", ", label, digit, decade, level);
  };
  if (last - first >= 1) {
    const int stride = 1 + (last - first) / 9;
    for (int decade = first - 1; decade <= last; ++decade) {
      if ((decade - first) % stride == 0) add(fmt::format("'10^{{{}}}'", decade), 1.0, decade, "");
      for (int digit = 2; digit <= 9 && stride == 1; ++digit)
        add("''", digit, decade, " 1");
    }
  } else {
    for (int decade = first - 1; decade <= last + 1; ++decade) {
      for (const double digit : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
        add(fmt::format("'{:g}'", digit * std::pow(10.0, decade)), digit, decade, "");
    }
  }
  return fmt::format("set {}tics ({})\n", axis, ticks);
}

std::string drawn_in_each_format(const Canvas& canvas, const std::string& stem, const std::string& body, double height,
                                 Letters letters) {
  std::string text;
  for (const std::string& format : canvas.formats) {
    const std::string file = (canvas.folder / (stem + "." + format)).string();
    if (format == "pdf" || format == "ps") {
      text += fmt::format("set terminal {} enhanced font 'DejaVu Sans,12' fontscale {} size {}cm,{:.2f}cm\n",
                          format == "pdf" ? "pdfcairo" : "epscairo", letters.paper, canvas.width, height);
    } else if (format == "svg") {
      text += fmt::format(
          "set terminal svg enhanced font 'DejaVu Sans, Verdana, sans-serif,{}' size {:.0f},{:.0f} dynamic "
          "background '#ffffff'\n",
          letters.svg, 760.0 * canvas.width / centimetres_wide, 760.0 * height / centimetres_wide);
    } else {
      text += fmt::format(
          "set terminal pngcairo enhanced font 'DejaVu Sans,9' fontscale 1.6 linewidth 1.6 pointscale 1.6 size "
          "{:.0f},{:.0f}\n",
          1400.0 * canvas.width / centimetres_wide, 1400.0 * height / centimetres_wide);
    }
    text += fmt::format("set output {}\n{}\nunset output\n", gnuplot_quoted(file), body);
  }
  return text;
}

std::size_t letters_along(double length, const Letters& letters) {
  constexpr double letter_wide = 0.288;  // [cm] per unit of the scale, measured in PDF: DejaVu Sans, lower case
  return static_cast<std::size_t>(length / (letter_wide * letters.paper));
}

Panel panel_of(const Plot& plot, const std::string& prefix, const ColourScale& scale, const Canvas& canvas,
               std::size_t maximum) {
  Panel panel;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    if (curve.points.empty()) continue;  // no point fits a log axis; the caption counts such points
    const std::string block = fmt::format("${}{}", prefix, i + 1);
    const CurveScript script = curve_script(curve, block, i, scale);
    panel.settings += script.data;
    panel.curves += (panel.curves.empty() ? "" : ", ") + script.command;
    if (!has_look(curve.style) && curve.style != Style::heat && !curve.label.empty()) ++panel.in_key;
    if (curve.style == Style::outlines) panel.settings += "set size ratio -1\n";
  }
  panel.settings +=
      axis_commands('x', plot.figure.x, plot.x, std::string::npos) + axis_commands('y', plot.figure.y, plot.y, maximum);
  if (!plot.figure.grid) panel.settings += "unset grid\n";
  panel.settings += slope_commands(plot, panel.curves) + line_commands(plot) + mark_commands(plot);
  const std::size_t columns = key_columns(plot, canvas);
  panel.key_rows = (panel.in_key + columns - 1) / columns;
  return panel;
}

std::string figure_script(const Plot& plot, const Canvas& canvas, const std::string& stem) {
  const double line_high = 0.62 * canvas.letters.paper;  // [cm], of the margins below and above the axes
  const std::size_t maximum = letters_along(canvas.height - 5.9 * line_high, canvas.letters);
  const Panel panel = panel_of(plot, "curve", {}, canvas, maximum);
  const std::string text = fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string())) + panel.settings;
  const auto rows = static_cast<double>(panel.key_rows);
  // gnuplot counts each letter as wide as a digit, an eighth too wide, and omits columns that seem too wide.
  const std::string key = fmt::format(
      "set key at screen 0.5, char 0.4 center bottom maxrows {} width {:.1f}\nset bmargin {:.2f}\n",
      std::max<std::size_t>(panel.key_rows, 1), -0.125 * static_cast<double>(longest_label(plot)), 4.3 + 1.15 * rows);
  const double row = 0.84 * canvas.letters.paper;  // [cm]
  return text + key +
         drawn_in_each_format(canvas, stem, "plot " + panel.curves, canvas.height + row * rows, canvas.letters);
}

}  // namespace talus::reports
