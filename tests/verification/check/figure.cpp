#include "verification/check/figure.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(figure_tests)

using namespace talus::verification;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Figure two_series() {
  return {.name = "error",
          .title = "Error against step",
          .caption = "It falls.",
          .x = {.label = "step", .unit = "s", .log = true},
          .y = {.label = "error", .unit = "m", .log = true},
          .series = {{"Verlet, RMS", {0.1, 0.2}, {1.0, 1.0 / 3.0}},
                     {"verlet rms", {0.1}, {2.0}, Style::errorbars, {1.5}, {2.5}}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(malformed_figures_are_refused) {
  const auto refuse = [](auto&& spoil) {
    Figure figure = two_series();
    spoil(figure);
    BOOST_CHECK_THROW(demand_well_formed(figure), std::invalid_argument);
  };
  BOOST_CHECK_NO_THROW(demand_well_formed(two_series()));
  refuse([](Figure& f) { f.name = "a/b"; });
  refuse([](Figure& f) { f.caption.clear(); });
  refuse([](Figure& f) { f.series.clear(); });
  refuse([](Figure& f) { f.series[0].x.pop_back(); });
  refuse([](Figure& f) { f.series[1].y_low.clear(); });
  refuse([](Figure& f) { f.lines = {{'z', 1.0, "none"}}; });
  refuse([](Figure& f) { f.series[0].label.clear(); });
  refuse([](Figure& f) { f.series[1].y_high.pop_back(); });
  refuse([](Figure& f) { f.x.min = 0.0; });
}

BOOST_AUTO_TEST_CASE(points_that_cannot_be_drawn_are_counted) {
  Figure figure = two_series();
  figure.series.push_back({"diverged", {0.1, 0.2, 0.3}, {not_a_number, 0.0, 1.0}});
  figure.series.push_back({"nothing", {0.1}, {not_a_number}});
  BOOST_TEST(not_finite(figure) == 2u);
  BOOST_TEST(not_finite(two_series()) == 0u);
  const Figure drawn = drawable(figure);
  BOOST_TEST(drawn.series.size() == 3u);
  BOOST_TEST(drawn.series[2].x == std::vector<double>({0.3}));
  BOOST_TEST(drawn.caption.find("3 points are left out") != std::string::npos);
  BOOST_TEST(drawable(two_series()).caption == "It falls.");
}

BOOST_AUTO_TEST_CASE(heat_maps_keep_their_values_and_panels) {
  Figure figure = two_series();
  figure.panels = {"left", "right"};
  figure.scale = Scale{"growth", -1.0, 1.0};
  figure.series.push_back({.label = "map",
                           .x = {1.0, 2.0},
                           .y = {1.0, 1.0},
                           .style = Style::heat,
                           .values = {-0.25, not_a_number},
                           .panel = 1});
  BOOST_CHECK_NO_THROW(demand_well_formed(figure));
  BOOST_TEST(not_finite(figure) == 1u);
  figure = drawable(figure);
  BOOST_TEST(figure.series[2].values == std::vector<double>({-0.25}));
  BOOST_TEST(figure.series[2].panel == 1);
  const auto refuse = [&](auto&& spoil) {
    Figure spoilt = figure;
    spoil(spoilt);
    BOOST_CHECK_THROW(demand_well_formed(spoilt), std::invalid_argument);
  };
  refuse([](Figure& f) { f.scale.reset(); });
  refuse([](Figure& f) { f.series[2].values.clear(); });
  refuse([](Figure& f) { f.series[0].values = {1.0, 2.0}; });
  refuse([](Figure& f) { f.series[2].panel = 2; });
  refuse([](Figure& f) { f.columns = 0; });
  refuse([](Figure& f) { f.scale->max = -2.0; });
}

BOOST_AUTO_TEST_SUITE_END()
