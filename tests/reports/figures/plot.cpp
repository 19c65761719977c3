#include "reports/figures/plot.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "reports/base/error.hpp"
#include "reports/figures/drawing.hpp"
#include "reports/figures/gnuplot_script.hpp"
#include "reports/figures/gnuplot_text.hpp"
#include "reports/figures/page_script.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(plot_tests)

using namespace talus::reports;

namespace {

/// A series over columns "h [s]" and "e".
Series series_of(const std::string& label, Style style, const std::string& where, int panel = 0) {
  Series series{.label = label, .x = {}, .y = {}, .style = style, .panel = panel};
  series.columns = {.x = "h [s]", .y = "e", .where = where};
  if (style == Style::heat) series.columns.value = "value";
  return series;
}

Figure figure_of(bool log) {
  Figure figure;
  figure.name = "f";
  figure.title = "F";
  figure.x = {"step", "s", log, {}, {}};
  figure.y = {"error", "1", log, {}, {}};
  figure.csv = "f.csv";
  figure.series = {series_of("two_cable", Style::points, "")};
  return figure;
}

void write_csv(const Folder& scratch, const std::string& text) { std::ofstream(scratch.path / "f.csv") << text; }

std::string error_message(const Figure& figure, const Folder& scratch) {
  try {
    static_cast<void>(plot_of(figure, scratch.path));
  } catch (const RecordError& wrong) {
    return wrong.what();
  }
  return {};
}

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(labels_are_text) {
  BOOST_TEST(gnuplot_text("two_cable") == "'two\\_cable'");
  BOOST_TEST(gnuplot_text("$h^2$") == "'h^{2}'");
  BOOST_TEST(gnuplot_text("k_n^{-1/2}") == "'k_{n}^{-1/2}'");
  BOOST_TEST(gnuplot_text("it's {a}") == "'it''s \\{a\\}'");
  BOOST_TEST(gnuplot_text("$x$ for $5, or 3 $") == "'x for $5, or 3 $'");
  BOOST_TEST(gnuplot_text("$\\omega_0$, $k_\\theta$, $x^\\alpha$") == "'ω_{0}, k_{θ}, x^{α}'");
  BOOST_TEST(gnuplot_text("$a$, $b_c$") == "'a, b_{c}'");
  BOOST_TEST(gnuplot_verbatim("$x$ a_b^2 it's") == "'$x$ a\\_b\\^2 it''s'");
  BOOST_TEST(gnuplot_verbatim("größer als", 3) == "'grö...'");
  BOOST_TEST(gnuplot_verbatim("grö", 3) == "'grö'");
  BOOST_TEST(gnuplot_quoted("a'b") == "'a''b'");
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_named) {
  const Folder scratch;
  BOOST_TEST(names(error_message(figure_of(false), scratch), "f.csv: No such file or directory"));
  write_csv(scratch, "h [s],error\n1,2\n");
  BOOST_TEST(names(error_message(figure_of(false), scratch), "has no column 'e'; its columns: h [s], error"));
  write_csv(scratch, "h [s],e\n1,2\n3\n");
  BOOST_TEST(names(error_message(figure_of(false), scratch), "f.csv:3: found 1 cells; the header has 2"));
  write_csv(scratch, "h [s],e\n1,nan\n");
  BOOST_TEST(names(error_message(figure_of(false), scratch), "f.csv:2: column 'e': found 'nan'"));
  write_csv(scratch, "h [s],e\n");
  BOOST_TEST(names(error_message(figure_of(false), scratch), "has no row"));
  write_csv(scratch, "h [s],e\n1,0\n");
  BOOST_TEST(names(error_message(figure_of(true), scratch), "is empty: no point can be drawn"));
}

BOOST_AUTO_TEST_CASE(limits_hold_the_points) {
  const Extent linear = extent_of({1.0, 3.0}, false);
  BOOST_TEST(linear.low < 1.0);
  BOOST_TEST(linear.high > 3.0);
  const Extent single = extent_of({0.0}, false);
  BOOST_TEST(single.low < single.high);
  const Extent log = extent_of({1e-3, 1e-3}, true);
  BOOST_TEST(log.low > 0.0);
  BOOST_TEST(log.low < log.high);
}

BOOST_AUTO_TEST_CASE(thinning_keeps_ends_and_extremes) {
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i)
    points.push_back({double(i), i == 5001 ? 9.0 : std::sin(i), 0.0, 0.0});
  const std::vector<Point> kept = thinned(points, 1000);
  BOOST_TEST(kept.size() < 1100U);
  BOOST_TEST(kept.front().x == 0.0);
  BOOST_TEST(kept.back().x == 9999.0);
  BOOST_TEST(std::any_of(kept.begin(), kept.end(), [](const Point& p) { return p.y == 9.0; }));
  BOOST_TEST(std::is_sorted(kept.begin(), kept.end(), [](const Point& a, const Point& b) { return a.x < b.x; }));
}

BOOST_AUTO_TEST_CASE(a_script_draws_points_slopes_and_lines) {
  const Folder scratch;
  write_csv(scratch, "series,h [s],e\na,0.1,1e-2\nb,0.1,7\na,0.001,1e-6\na,0.01,0\n");
  Figure figure = figure_of(true);
  figure.series[0].columns.where = "a";
  figure.slopes = {{2.0, 1e-2, 1e-4, "h^2"}};
  figure.lines = {{'x', 0.02, "production"}, {'y', 1e-3, "limit"}};
  const Plot plot = plot_of(figure, scratch.path);
  BOOST_TEST(plot.undrawn == 1U);
  BOOST_TEST(plot.curves[0].points.size() == 2U);
  const std::string script = figure_script(plot, {"/p/preamble.gp", "/out", {"pdf", "svg"}}, "stem");
  for (const char* part : {"load '/p/preamble.gp'", "set logscale x", "set output '/out/stem.pdf'", "'/out/stem.svg'",
                           "$slope1 with lines", "'h^{2}'", "'production'", "to graph 1, first 0.001", "'10^{-2}' 1e-2",
                           "'step [s]'", "'error'"}) {
    BOOST_TEST(names(script, part), part);
  }
}

// Both ends are written with nine digits, and so lie outside of the limits.
BOOST_AUTO_TEST_CASE(a_slope_that_ends_on_both_limits_is_drawn) {
  const Folder scratch;
  write_csv(scratch, "h [s],e\n2,2\n3,3\n");
  Figure figure = figure_of(true);
  figure.x.min = 1.0, figure.x.max = 10.0;
  figure.y.min = 1.0000000004, figure.y.max = 9.9999999996;
  figure.slopes = {{4.0, 3.0, 3.0, "h^4"}};
  const std::filesystem::path preamble = std::filesystem::path{TALUS_TEMPLATES} / "../gnuplot/preamble.gp";
  const std::string script = figure_script(plot_of(figure, scratch.path), {preamble, scratch.path, {"svg"}}, "figure");
  BOOST_TEST_REQUIRE(names(script, " 1\n"), script);
  BOOST_TEST_REQUIRE(names(script, " 10\nEND"), script);
  BOOST_TEST(draw({{"figure", script}}, scratch.path, 1) == "");
  const std::string picture = talus::records::read_whole(scratch.path / "figure.svg");
  BOOST_TEST(names(picture, "<path stroke='rgb( 85,  85,  85)'"));  // the grey of slopes
}

// The title of a y axis has as many lines as the height of its axis requires; none is cut off.
BOOST_AUTO_TEST_CASE(long_titles_of_y_axes_are_broken) {
  BOOST_TEST(gnuplot_lines("error against rigid impact [ft/s, rad]", 29) ==
             R"('error against rigid impact'."\n".'[ft/s, rad]')");
  BOOST_TEST(gnuplot_lines("k_n of a contact", 16) == "'k_{n} of a contact'");
  BOOST_TEST(gnuplot_lines("incompressible", 5) == "'incompressible'");
  const Folder scratch;
  write_csv(scratch, "series,h [s],e\na,0.1,1e-2\na,0.001,1e-6\n");
  Figure figure = figure_of(true);
  figure.y.label = "plastic elongation of the segment beside the column that was hit";
  const Canvas canvas{"/p/preamble.gp", "/out", {"pdf"}};
  const std::string script = figure_script(plot_of(figure, scratch.path), canvas, "stem");
  const std::size_t maximum = letters_along(canvas.height - 1.8, canvas.letters);
  const std::size_t from = script.find("set ylabel "), to = script.find('\n', from);
  std::size_t lines = 0;
  for (std::size_t at = script.find('\'', from); at < to;
       at = script.find('\'', script.find('\'', at + 1) + 1), ++lines)
    BOOST_TEST(script.find('\'', at + 1) - at - 1 <= maximum);
  BOOST_TEST(lines == 2U);
}

BOOST_AUTO_TEST_CASE(narrow_log_axes_have_numbers) {
  const std::string narrow = log_tics('y', {2.0, 6.0});
  BOOST_TEST(names(narrow, "'2' 2e0, '3' 3e0, '5' 5e0"));
}

BOOST_AUTO_TEST_CASE(log_tics_stand_at_powers_of_ten) {
  const std::string tics = log_tics('x', {83.2, 12022.0});
  BOOST_TEST(names(tics, "set xtics ('' 9e1 1, '10^{2}' 1e2, '' 2e2 1"), tics);
  BOOST_TEST(names(tics, "'10^{3}' 1e3"));
  BOOST_TEST(names(tics, "'' 9e3 1, '10^{4}' 1e4)"), tics);
  BOOST_TEST(!names(tics, "8.3"));
  BOOST_TEST(!names(tics, "%"));
  BOOST_TEST(log_tics('y', {1e-20, 1.0}) ==
             "set ytics ('10^{-20}' 1e-20, '10^{-17}' 1e-17, '10^{-14}' 1e-14, '10^{-11}' 1e-11, '10^{-8}' 1e-8, "
             "'10^{-5}' 1e-5, '10^{-2}' 1e-2)\n");
}

BOOST_AUTO_TEST_CASE(heat_maps_are_drawn_in_their_panels) {
  const Folder scratch;
  Figure figure = figure_of(false);
  figure.series = {series_of("map", Style::heat, "a"), series_of("limit", Style::lines, "b"),
                   series_of("other", Style::heat, "a", 1)};
  figure.panels = {"first", "second"};
  figure.columns = 2;
  figure.scale = Scale{"growth", -1.0, 1.0, "1"};
  write_csv(scratch, "series,h [s],e,value\na,0,1,-9\na,1,1,0\nb,0,1,0\nb,1,1,0\n");
  const PagePlot page = panelled(figure, scratch.path);
  BOOST_TEST(page.panels.size() == 2u);
  BOOST_TEST(page.panels[0].figure.title == "first");
  const std::string script = page_script(page, {"preamble.gp", scratch.path, {"svg"}}, "f");
  BOOST_TEST(names(script, "0 1 5 48 97\n"));  // below the scale: blue, the colour of its lower end
  BOOST_TEST(names(script, "1 1 247 247 247\n"));
  BOOST_TEST(names(script, "with rgbimage"));
  BOOST_TEST(names(script, "with lines linetype 2 lc rgb '#000000'"));
}

BOOST_AUTO_TEST_SUITE_END()
