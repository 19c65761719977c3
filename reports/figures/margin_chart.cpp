#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reports/figures/gnuplot_script.hpp"
#include "reports/figures/gnuplot_text.hpp"

namespace talus::reports {
namespace {

constexpr std::array kinds{std::pair{Kind::truncation, "truncation"}, std::pair{Kind::round_off, "round-off"},
                           std::pair{Kind::model, "model"}, std::pair{Kind::interval, "interval"},
                           std::pair{Kind::exact, "exact"}};

/// Smallest error/bound drawn to scale; smaller ones are drawn at the left end of the axis.
constexpr double minimum_margin = 1e-5;
constexpr double strip_of_zero = minimum_margin / 10.0;
constexpr double strip_of_infinity = 300.0;

double shown_margin(const Check& check) {
  if (!(check.margin <= 100.0)) return strip_of_infinity;  // NaN too
  if (check.margin == 0.0) return strip_of_zero;
  return std::max(check.margin, minimum_margin);
}

/// The dots of one kind: position on the axis, row of the case; the checks of a case are spread over its row.
std::string dots(const Results& results, Kind kind, bool passed, bool& some) {
  std::string text;
  for (std::size_t row = 0; row < results.records.size(); ++row) {
    const std::vector<Check>& checks = results.records[row].checks;
    for (std::size_t i = 0; i < checks.size(); ++i) {
      if (checks[i].kind != kind || checks[i].pass != passed) continue;
      const double spread = (static_cast<double>(i) + 0.5) / static_cast<double>(checks.size()) - 0.5;
      text += fmt::format("{:.6g} {:.4f}\n", shown_margin(checks[i]), static_cast<double>(row) + 1.0 + 0.7 * spread);
      some = true;
    }
  }
  return text;
}

std::string frame(const Results& results, std::size_t rows) {
  std::string names;
  for (std::size_t row = 0; row < results.records.size(); ++row) {
    names += fmt::format("{}{} {}", row == 0 ? "" : ", ", gnuplot_text(results.records[row].id), row + 1);
  }
  std::string text = fmt::format("set yrange [{}:0.4]\nset ytics ({})\n", static_cast<double>(rows) + 0.6, names);
  text +=
      "set lmargin 19\nset bmargin 5.2\nset tmargin 2\nset key at screen 0.5, char 0.4 center bottom maxrows 1\nset "
      "logscale x\nset grid noytics\nset xlabel 'error / bound'\n";
  text += fmt::format("set xrange [{:g}:{:g}]\n", strip_of_zero / 3.0, strip_of_infinity * 2.0);
  text += fmt::format(
      "set xtics ('0' {:g}, '≤10^{{-5}}' 1e-5, '10^{{-4}}' 1e-4, '10^{{-3}}' 1e-3, '1/50' 0.02, "
      "'0.1' 0.1, '1' 1, '10' 10, '>100' {:g})\n",
      strip_of_zero, strip_of_infinity);
  for (std::size_t row = 0; row <= rows; ++row) {
    text +=
        fmt::format("set arrow from graph 0, first {0:g} to graph 1, first {0:g} nohead lc rgb '#cccccc' lw 0.5 back\n",
                    static_cast<double>(row) + 0.5);
  }
  text += fmt::format("set arrow from {0:g}, graph 0 to {0:g}, graph 1 nohead lc rgb '#999999' lw 0.8 back\n",
                      minimum_margin / 3.0);
  text +=
      "set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb '#D55E00' lw 2 back\n"
      "set arrow from 0.02, graph 0 to 0.02, graph 1 nohead lc rgb '#555555' lw 1.2 dt 2 back\n"
      "set label 'limit' at 1, graph 1.02 center textcolor rgb '#D55E00'\n"
      "set label 'slack' at 0.02, graph 1.02 center textcolor rgb '#555555'\n";
  text += fmt::format("set label 'no error' at {:g}, graph 1.02 center textcolor rgb '#555555'\n", strip_of_zero);
  return text;
}

}  // namespace

std::string margin_script(const Results& results, const Canvas& canvas, const std::string& stem) {
  const std::size_t rows = std::max<std::size_t>(results.records.size(), 1);
  std::string text = fmt::format("load {}\n", gnuplot_quoted(canvas.preamble.string())) + frame(results, rows);
  std::string curves;
  std::size_t in_key = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (const bool passed : {true, false}) {
      bool some = false;
      const std::string points = dots(results, kinds[i].first, passed, some);
      if (!some) continue;
      ++in_key;
      const std::string block = fmt::format("${}{}", passed ? "kind" : "failed", i);
      text += fmt::format("{} << END\n{}END\n", block, points);
      curves += fmt::format("{}{} using 1:2 with points linetype {}{} title '{}{}'", curves.empty() ? "" : ", ", block,
                            i + 1, passed ? "" : " pt 2 ps 1.3 lw 3", kinds[i].second, passed ? "" : " (failed)");
    }
  }
  if (curves.empty()) curves = "NaN notitle";  // no check: draw the frame and the names of the cases
  if (in_key > kinds.size()) text += "set key maxrows 2\nset bmargin 6.3\n";  // a single row would be cut at both ends
  const double height = 3.4 + 0.9 * static_cast<double>(rows);
  return text + drawn_in_each_format(canvas, stem, "plot " + curves, height);
}

}  // namespace talus::reports
