#include "reports/figures/page_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "reports/figures/gnuplot_text.hpp"
#include "verification/record/figure_points.hpp"

namespace talus::reports {
namespace {

/// Number of characters of a title that fit in one line on a page.
constexpr std::size_t characters_wide = 95;

// All lengths in centimetres.
constexpr double line_high = 0.44;
constexpr double tallest_panel = 11.0;
constexpr double panels_left = 1.55, panels_right = 0.35;  // space beside all panels

/// Font size of panels; smaller than in a separate figure.
constexpr Letters panel_letters{0.385, 10.4};

/// Rectangle of a page inside the axes of one panel.
struct Frame {
  double left{}, right{}, bottom{}, top{};
};

/// Space around and between panels.
struct Layout {
  bool shared{};    ///< inner panels have no axis labels
  double height{};  ///< of the page
  double legend{};  ///< upper edge of the legend, from the lower edge of the page
  std::vector<Frame> frames;
};

bool same(const Axis& a, const Axis& b) { return a.label == b.label && a.unit == b.unit && a.log == b.log; }
bool same(const Extent& a, const Extent& b) { return a.low == b.low && a.high == b.high; }

bool axes_shared(const std::vector<Plot>& panels) {
  return std::all_of(panels.begin(), panels.end(), [&](const Plot& panel) {
    const Plot& first = panels.front();
    return same(panel.figure.x, first.figure.x) && same(panel.figure.y, first.figure.y) && same(panel.x, first.x) &&
           same(panel.y, first.y);
  });
}

/// Shapes with a label, each label once.
std::vector<const Curve*> explained(const PagePlot& page) {
  std::vector<const Curve*> entries;
  std::set<std::string> seen;
  for (const Plot& panel : page.panels) {
    for (const Curve& curve : panel.curves) {
      if (has_look(curve.style) && !curve.label.empty() && seen.insert(curve.label).second) entries.push_back(&curve);
    }
  }
  return entries;
}

/// Width and height of a panel; one with equal units is as large as fits into its column.
std::pair<double, double> panel_size(const Plot& plot, const PagePlot& page, double room) {
  if (!plot.figure.equal) return {room, page.panel_high.value_or(room > 9.0 ? 5.6 : 4.4)};
  const double shape = (plot.y.high - plot.y.low) / (plot.x.high - plot.x.low);
  const double width = std::min(room, tallest_panel / shape);
  return {width, width * shape};
}

std::size_t columns_of(const PagePlot& page) {
  return std::min(static_cast<std::size_t>(page.page.columns), page.panels.size());
}

double gap_of(bool shared) { return shared ? 0.35 : panels_left + 0.15; }

/// Width of a column of panels.
double room_of(const PagePlot& page) {
  const auto per_row = static_cast<double>(columns_of(page));
  return (centimetres_wide - panels_left - panels_right - gap_of(axes_shared(page.panels)) * (per_row - 1.0)) / per_row;
}

Layout layout_of(const PagePlot& page, const std::vector<Panel>& panels, double legend) {
  Layout layout{axes_shared(page.panels), 0.0, legend, {}};
  const std::size_t columns = columns_of(page);
  const double gap = gap_of(layout.shared), room = room_of(page);
  const bool titled = std::any_of(page.panels.begin(), page.panels.end(),
                                  [](const Plot& panel) { return !panel.figure.title.empty(); });
  const double above = titled ? 0.62 : 0.2;
  // Measured from the upper edge downwards; inverted at the end, when the height is known.
  double y = page.page.title.empty() ? 0.0 : 0.85;
  for (std::size_t first = 0; first < panels.size(); first += columns) {
    const std::size_t end = std::min(first + columns, panels.size());
    double tallest = 0.0;
    std::size_t key_rows = 0;
    for (std::size_t i = first; i < end; ++i) {
      const auto [width, height] = panel_size(page.panels[i], page, room);
      const double x = panels_left + static_cast<double>(i - first) * (room + gap) + 0.5 * (room - width);
      layout.frames.push_back({x, x + width, y + above + height, y + above});
      tallest = std::max(tallest, height);
      key_rows = std::max(key_rows, columns == 1 ? panels[i].key_rows : panels[i].in_key);
    }
    const double below = layout.shared && end < panels.size() ? 0.1 : 1.1;
    y += above + tallest + below + line_high * static_cast<double>(key_rows);
  }
  layout.height = y + legend;
  for (Frame& frame : layout.frames) {
    frame.bottom = layout.height - frame.bottom;
    frame.top = layout.height - frame.top;
  }
  return layout;
}

/// Round number (1, 2 or 5 times a power of ten) nearest to a step.
double round_step(double wanted) {
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double part = wanted / decade;
  return decade * (part <= 1.5 ? 1.0 : part <= 3.5 ? 2.0 : part <= 7.5 ? 5.0 : 10.0);
}

/// Tics at round numbers, as many as fit on the axis.
std::string tics(char axis, const Extent& extent, double length) {
  const double parts = std::max(2.0, length / (axis == 'x' ? 1.25 : 0.8));
  return fmt::format("set {}tics {:.6g}\n", axis, round_step((extent.high - extent.low) / parts));
}

std::string panel_commands(const Plot& plot, const Panel& panel, const Layout& layout, std::size_t index,
                           std::size_t columns) {
  const Frame& frame = layout.frames[index];
  const double w = centimetres_wide;
  const double h = layout.height;
  std::string text = panel.settings;
  text += fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n", frame.left / w, frame.right / w);
  text += fmt::format("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n", frame.bottom / h, frame.top / h);
  text += fmt::format("set title {} offset 0,-0.6\n", gnuplot_verbatim(plot.figure.title));
  if (plot.figure.x.divisions == 0 && !plot.figure.x.log) text += tics('x', plot.x, frame.right - frame.left);
  if (plot.figure.y.divisions == 0 && !plot.figure.y.log) text += tics('y', plot.y, frame.top - frame.bottom);
  if (layout.shared && index % columns > 0) text += "unset ylabel\nset format y ''\n";
  if (layout.shared && index + columns < layout.frames.size()) text += "unset xlabel\nset format x ''\n";
  if (panel.in_key == 0) return text + "unset key\n";
  const std::size_t rows = columns == 1 ? panel.key_rows : panel.in_key;
  return text + fmt::format("set key at screen {:.6f}, screen {:.6f} center top maxrows {} reverse Left\n",
                            0.5 * (frame.left + frame.right) / w, (frame.bottom - 1.05) / h, rows);
}

std::string legend_entry(const Curve& curve) {
  const Look& look = curve.look;
  const std::string label = gnuplot_verbatim(curve.label);
  if (!look.fill.empty()) {
    return fmt::format("keyentry with boxes fs solid 0.75 border lc rgb '{}' fc rgb '{}' title {}",
                       look.colour.empty() ? look.fill : look.colour, look.fill, label);
  }
  const std::string colour = curve.by_value ? "rgb 'black'" : fmt::format("rgb '{}'", look.colour);
  return fmt::format("keyentry with lines lw {:g} dt {} lc {} title {}", std::max(look.width, 1.5),
                     look.dashed ? "(6,4)" : "1", colour, label);
}

/// Colour scale of a page's values.
ColourScale colours_of(const PagePlot& page) {
  const auto& scale = page.page.scale;
  return scale ? ColourScale{scale->min, scale->max, page.two_hues} : ColourScale{};
}

/// Colour bar with its numbers; `top` is its upper edge.
std::string bar_commands(const Scale& scale, const ColourScale& colours, double top, double height) {
  constexpr double left = 0.60;
  constexpr double width = 0.35;
  constexpr int parts = 96;  // each overlaps the next, to avoid seams
  const auto up = [&](double centimetres) { return (top - centimetres) / height; };
  std::string text;
  for (int i = 0; i < parts; ++i) {
    text += fmt::format(
        "set object rect from screen {:.6f}, screen {:.6f} to screen {:.6f}, screen {:.6f} fs solid "
        "noborder fc rgb {}\n",
        left + width * i / parts, up(0.35), std::min(left + width * (i + 2) / parts, left + width), up(0.1),
        colours.colour(scale.min + (i + 0.5) / parts * (scale.max - scale.min)));
  }
  // A number of six digits is as wide as two numbers of three.
  const double parts_of_bar = std::max(std::abs(scale.min), std::abs(scale.max)) >= 1e5 ? 2.0 : 4.0;
  const double step = round_step((scale.max - scale.min) / parts_of_bar);
  const long last = std::lround(std::floor(scale.max / step + 1e-9));
  for (long i = std::lround(std::ceil(scale.min / step - 1e-9)); i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    text += fmt::format("set label '{:.6g}' at screen {:.6f}, screen {:.6f} center\n", value,
                        left + width * (value - scale.min) / (scale.max - scale.min), up(0.6));
  }
  return text + fmt::format("set label {} at screen {:.6f}, screen {:.6f} center\n",
                            gnuplot_text(scale.label +
                                         (scale.unit.empty() || scale.unit == "1" ? "" : " [" + scale.unit + "]")),
                            left + 0.5 * width, up(1.05));
}

/// Number of key rows beside the colour bar, chosen so that the key's columns do not overlap it.
std::size_t rows_beside_bar(std::size_t entries) { return entries == 3 ? 3 : 2; }

/// Colour bar and key of the shapes, below all panels.
std::string legend_commands(const PagePlot& page, const std::vector<const Curve*>& entries, const Layout& layout) {
  if (entries.empty() && !page.page.scale) return {};
  const double h = layout.height;
  const bool bar = page.page.scale.has_value();
  std::string text = fmt::format(
      "unset border\nunset tics\nunset grid\nset xrange [0:1]\nset yrange [0:1]\nset lmargin at screen 0\n"
      "set rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen {:.6f}\n",
      layout.legend / h);
  if (bar) text += bar_commands(*page.page.scale, colours_of(page), layout.legend, h);
  text += entries.empty()
              ? "unset key\n"
              : fmt::format("set key at screen {:.6f}, screen {:.6f} {} top maxrows {} samplen 2.2 reverse Left\n",
                            bar ? 0.06 : 0.5, (layout.legend - 0.1) / h, bar ? "left" : "center",
                            bar ? rows_beside_bar(entries.size()) : 1);
  // A point outside the axes, because gnuplot draws a key only together with a plot.
  text += "plot '+' using (2):(2) with points notitle";
  for (const Curve* curve : entries)
    text += ", " + legend_entry(*curve);
  return text + "\n";
}

/// The page between `set multiplot` and `unset multiplot`, and its height.
std::pair<std::string, double> page_commands(const PagePlot& page, const Canvas& canvas) {
  const std::vector<const Curve*> entries = explained(page);
  const double legend = page.page.scale ? 1.5 : entries.empty() ? 0.0 : 0.8;
  std::vector<Panel> panels;
  for (const Plot& plot : page.panels)
    panels.push_back(panel_of(plot, fmt::format("panel{}_", panels.size() + 1), colours_of(page), canvas,
                              letters_along(panel_size(plot, page, room_of(page)).second, panel_letters)));
  const Layout layout = layout_of(page, panels, legend);
  const std::size_t columns = columns_of(page);
  const std::string clean = fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string()));
  std::string text = "set multiplot\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    text += clean;
    if (i == 0 && !page.page.title.empty()) {
      text += fmt::format("set label {} at screen 0.5, screen {:.6f} center font ',{}'\n",
                          gnuplot_verbatim(page.page.title, characters_wide), 1.0 - 0.42 / layout.height, 14);
    }
    text += panel_commands(page.panels[i], panels[i], layout, i, columns) + "plot " + panels[i].curves + "\n";
  }
  return {text + clean + legend_commands(page, entries, layout) + "unset multiplot", layout.height};
}

}  // namespace

PagePlot page_plot_of(Page page) {
  PagePlot made{std::move(page), {}};
  for (Figure& figure : made.page.panels)
    made.panels.push_back(plot_of(std::move(figure)));
  made.page.panels.clear();
  return made;
}

PagePlot panelled(const Figure& figure, const std::filesystem::path& folder) {
  Page page{figure.name, {}, figure.columns, {}, figure.scale};
  Figure filled = figure;
  records::read_points(filled, folder, records::Rows::some);
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    Figure panel = figure;
    panel.title = figure.panels[p];
    panel.panels.clear();
    panel.series.clear();
    for (Series& series : filled.series) {
      if (series.panel != static_cast<int>(p)) continue;
      series.label.clear();
      if (figure.scale && series.style != Style::heat) series.look.colour = "#000000";
      panel.series.push_back(std::move(series));
    }
    if (!panel.series.empty()) page.panels.push_back(std::move(panel));
  }
  PagePlot made = page_plot_of(std::move(page));
  made.panel_high = 2.8;
  made.two_hues = true;
  return made;
}

std::string page_script(const PagePlot& page, const Canvas& canvas, const std::string& stem) {
  const auto [body, height] = page_commands(page, canvas);
  return drawn_in_each_format(canvas, stem, body, height, panel_letters);
}

std::string film_script(const std::vector<PagePlot>& pages, double delay, const Canvas& canvas,
                        const std::string& stem) {
  constexpr double pixels_wide = 900.0;
  std::string bodies;
  double tallest = 0.0;
  for (const PagePlot& page : pages) {
    const auto [body, height] = page_commands(page, canvas);
    bodies += body + "\n";
    tallest = std::max(tallest, height);
  }
  // A GIF counts in hundredths of a second; most viewers slow down delays shorter than two of them.
  const auto hundredths = std::max(2L, std::lround(100.0 * delay));
  return fmt::format(
             "set terminal gif animate delay {} loop 0 enhanced font 'DejaVu Sans,11' size {:.0f},{:.0f}\n"
             "set output {}\n",
             hundredths, pixels_wide, pixels_wide * tallest / centimetres_wide,
             gnuplot_quoted((canvas.folder / (stem + ".gif")).string())) +
         bodies + "unset output\n";
}

}  // namespace talus::reports
