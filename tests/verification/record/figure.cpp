#include "verification/record/figure.hpp"

#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/verification/record/error_message.hpp"
#include "verification/record/figure_points.hpp"

BOOST_AUTO_TEST_SUITE(figure_tests)

using namespace talus::records;

namespace {

Figure two_series() {
  Figure figure{.name = "error",
                .title = "Error against step",
                .caption = "It falls.",
                .x = {.label = "step", .unit = "s", .log = true},
                .y = {.label = "error", .unit = "m", .log = true},
                .series = {{"Verlet, RMS", {0.1, 0.2}, {1.0, 1.0 / 3.0}},
                           {"verlet rms", {0.1}, {2.0}, Style::errorbars, {1.5}, {2.5}}}};
  name_columns(figure);
  return figure;
}

Figure heat_map() {
  Figure figure = two_series();
  figure.panels = {"left", "right"};
  figure.columns = 2;
  figure.scale = Scale{"growth", -1.0, 1.0};
  figure.series.push_back(
      {.label = "map", .x = {1.0, 2.0}, .y = {1.0, 1.0}, .style = Style::heat, .values = {-0.25, 1e-300}, .panel = 1});
  name_columns(figure);
  return figure;
}

Figure without_points(Figure figure) {
  for (Series& series : figure.series) {
    for (auto* const numbers : {&series.x, &series.y, &series.y_low, &series.y_high, &series.values})
      numbers->clear();
  }
  return figure;
}

/// Part and fault that demand_sound() reports for a figure changed by `spoil`.
std::string fault_of(Figure figure, void (*spoil)(Figure&)) {
  spoil(figure);
  try {
    demand_sound(figure, [](const std::string& part, const std::string& fault) {
      throw std::runtime_error(part + ": " + fault);
    });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(columns_are_named_by_what_a_series_has) {
  const Figure figure = heat_map();
  BOOST_TEST(figure.csv == "error.csv");
  BOOST_TEST(figure.series[0].columns.x == "x");
  BOOST_TEST(figure.series[0].columns.where == "verlet_rms");
  BOOST_TEST(figure.series[1].columns.where == "verlet_rms_2");
  BOOST_TEST(figure.series[0].columns.y_low == "");
  BOOST_TEST(figure.series[1].columns.y_high == "y_high");
  BOOST_TEST(figure.series[1].columns.value == "");
  BOOST_TEST(figure.series[2].columns.value == "value");
}

BOOST_AUTO_TEST_CASE(points_round_trip_through_csv_bit_by_bit) {
  const Figure figure = heat_map();
  Figure back = without_points(figure);
  read_points(back, Csv("error.csv", csv_of(figure)), Rows::all);
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    BOOST_TEST(back.series[i].x == figure.series[i].x);
    BOOST_TEST(back.series[i].y == figure.series[i].y);
    BOOST_TEST(back.series[i].y_low == figure.series[i].y_low);
    BOOST_TEST(back.series[i].y_high == figure.series[i].y_high);
    BOOST_TEST(back.series[i].values == figure.series[i].values);
  }
}

BOOST_AUTO_TEST_CASE(broken_points_are_refused) {
  Figure figure = two_series();
  figure.series.resize(1);
  const auto refused = [&](const std::string& csv, Rows rows = Rows::all) {
    return error_message([&] { read_points(figure, Csv("a.csv", csv), rows); });
  };
  BOOST_TEST(refused("series,x,y\nverlet_rms,1,2\n") == "");
  BOOST_TEST(holds(refused("series,x,y\n"),
                   "a.csv: figure 'error': series 'Verlet, RMS' (columns 'x', 'y', series = "
                   "'verlet_rms') has no row"));
  BOOST_TEST(holds(refused("series,x,z\nverlet_rms,1,2\n"), "a.csv: has no column 'y'"));
  BOOST_TEST(holds(refused("key,x,y\nverlet_rms,1,2\n"), "a.csv: has no column 'series'"));
  BOOST_TEST(holds(refused("series,x,y\nverlet_rms,1,nan\n"), "a.csv:2: column 'y': found 'nan'"));
  const std::string stray = "series,x,y\nverlet_rms,1,2\nother,1,2\n";
  BOOST_TEST(refused(stray) == "a.csv:3: found a row of 'other', which is no series of figure 'error'");
  BOOST_TEST(refused(stray, Rows::some) == "");
}

BOOST_AUTO_TEST_CASE(shapes_and_circles_have_lines_values_and_radii) {
  Figure figure{.name = "frame", .title = "", .caption = "", .x = {.label = "x"}, .y = {.label = "y"}, .series = {}};
  figure.series.push_back({.label = "", .x = {}, .y = {}, .style = Style::shapes});
  figure.series.back().columns = {.x = "z", .y = "v", .where = "taut", .value = "tension"};
  figure.series.push_back({.label = "", .x = {}, .y = {}, .style = Style::circles});
  figure.series.back().columns = {.x = "z", .y = "v", .where = "disc", .radius = "r"};
  read_points(figure, Csv("f.csv", "series,line,z,v,r,tension\ntaut,0,1,2,0,7\ntaut,4,3,4,0,8\ndisc,5,5,6,0.5,0\n"),
              Rows::all);
  using Numbers = std::vector<double>;
  BOOST_TEST(figure.series[0].x == Numbers({1.0, 3.0}));
  BOOST_TEST(figure.series[0].line == Numbers({0.0, 4.0}));
  BOOST_TEST(figure.series[0].values == Numbers({7.0, 8.0}));
  BOOST_TEST(figure.series[0].radius.empty());
  BOOST_TEST(figure.series[1].radius == Numbers({0.5}));
  BOOST_TEST(figure.series[1].line.empty());
}

BOOST_AUTO_TEST_CASE(figures_share_a_file_beside_them) {
  const Folder scratch;
  std::ofstream{scratch.path / "a.csv"} << "t,x,y\n0,1,2\n1,3,4\n";
  std::ofstream{scratch.path / "b.csv"} << "t,x\n0,5\n";
  const auto figure = [](const std::string& name, const std::string& csv, const std::string& column) {
    Figure made{.name = name, .title = "", .caption = "", .x = {.label = "t"}, .y = {.label = column}, .csv = csv};
    made.series.push_back({.label = column});
    made.series.back().columns = {.x = "t", .y = column};
    return made;
  };
  std::vector<Figure> figures{figure("one", "a.csv", "x"), figure("two", "b.csv", "x"), figure("three", "a.csv", "y")};
  read_points(figures, scratch.path);
  using Numbers = std::vector<double>;
  BOOST_TEST(figures[0].series[0].y == Numbers({1.0, 3.0}));
  BOOST_TEST(figures[1].series[0].y == Numbers({5.0}));
  BOOST_TEST(figures[2].series[0].y == Numbers({2.0, 4.0}));
  BOOST_TEST(figures[2].series[0].x == Numbers({0.0, 1.0}));
  figures.push_back(figure("four", "c.csv", "x"));
  BOOST_TEST(holds(error_message([&] { read_points(figures, scratch.path); }), "c.csv: No such file or directory"));
}

BOOST_AUTO_TEST_CASE(each_rule_of_a_figure_is_demanded) {
  const auto of = [](void (*spoil)(Figure&)) { return fault_of(heat_map(), spoil); };
  BOOST_TEST(of([](Figure&) {}) == "");
  BOOST_TEST(of([](Figure& f) { f.x.min = 0.0; }) == "x: limits of a log axis must be > 0");
  BOOST_TEST(of([](Figure& f) { f.y.max = -1.0; }) == "y: limits of a log axis must be > 0");
  BOOST_TEST(of([](Figure& f) { f.y.divisions = 101; }) == "y.divisions: must be from 0 to 100, found 101");
  BOOST_TEST(of([](Figure& f) { f.series.clear(); }) == "series: must hold at least one series");
  BOOST_TEST(of([](Figure& f) { f.columns = 0; }) == "columns: must be from 1 to 12, found 0");
  BOOST_TEST(of([](Figure& f) { f.columns = 13; }) == "columns: must be from 1 to 12, found 13");
  BOOST_TEST(of([](Figure& f) { f.scale->max = -1.0; }) == "scale: min must be less than max, found -1 and -1");
  BOOST_TEST(of([](Figure& f) { f.scale.reset(); }) == "series[2]: a heat map needs panels and a scale");
  BOOST_TEST(of([](Figure& f) {
               f.panels.clear();
               f.series[2].panel = 0;
             }) == "series[2]: a heat map needs panels and a scale");
  BOOST_TEST(of([](Figure& f) {
               f.series[2].values.clear();
               f.series[2].columns.value.clear();
             }) == "series[2]: a heat map needs a value for each point");
  BOOST_TEST(of([](Figure& f) { f.series[0].panel = 2; }) == "series[0].panel: must be from 0 to 1, found 2");
  BOOST_TEST(of([](Figure& f) { f.series[0].panel = -1; }) == "series[0].panel: must be from 0 to 1, found -1");
  BOOST_TEST(of([](Figure& f) {
               f.series[1].y_low.clear();
               f.series[1].columns.y_low.clear();
             }) == "series[1]: error bars need y_low and y_high");
  BOOST_TEST(of([](Figure& f) { f.series[0].look.colour = "blue"; }) ==
             "series[0].colour: must be a colour such as #0072b2, found 'blue'");
  BOOST_TEST(of([](Figure& f) { f.series[0].look.fill = "#00000g"; }) ==
             "series[0].fill: must be a colour such as #0072b2, found '#00000g'");
  BOOST_TEST(of([](Figure& f) { f.series[0].style = Style::shapes; }) ==
             "series[0]: shapes need a colour, a fill or a value");
  BOOST_TEST(of([](Figure& f) {
               f.series[0].style = Style::circles;
               f.series[0].look.colour = "#000000";
             }) == "series[0]: circles need a fill or a value");
  BOOST_TEST(of([](Figure& f) {
               f.series[0].style = Style::circles;
               f.series[0].look.fill = "#000000";
             }) == "series[0].radius: is missing: circles need it");
  BOOST_TEST(of([](Figure& f) { f.lines = {{'z', 1.0, ""}}; }) == "lines[0].axis: must be x or y, found z");
  BOOST_TEST(of([](Figure& f) { f.lines = {{'y', 0.0, ""}}; }) == "lines[0].at: must be > 0 on a log axis, found 0");
  BOOST_TEST(of([](Figure& f) {
               f.slopes = {{2.0, 1.0, 1.0, ""}};
               f.y.log = false;
             }) == "slopes[0]: a slope needs both axes to be log");
  BOOST_TEST(of([](Figure& f) { f.slopes = {{2.0, 1.0, 0.0, ""}}; }) == "slopes[0]: x and y must be > 0");
  BOOST_TEST(of([](Figure& f) { f.equal = true; }) == ": a figure with equal units needs min and max of both axes");
}

BOOST_AUTO_TEST_SUITE_END()
