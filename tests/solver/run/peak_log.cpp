/// Local maxima beside closed forms, for even and uneven states.
#include "solver/run/peak_log.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(peak_log_tests)

using namespace talus;

namespace {

PeakLog log_of(const std::vector<std::pair<double, double>>& states) {
  PeakLog log;
  for (const auto& [time, value] : states)
    log.add(time, value);
  return log;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_parabola_is_exact_with_uneven_states) {
  PeakLog log;
  for (const double t : {0.0, 0.3, 0.35, 0.7, 1.2})
    log.add(t, 2.0 - 3.0 * (t - 0.4) * (t - 0.4));
  BOOST_REQUIRE(log.peaks().size() == 1U);
  BOOST_TEST(log.peaks()[0].time == 0.4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(log.peaks()[0].value == 2.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(maxima_of_an_oscillation_converge_with_the_third_order) {
  const auto error = [](double h) {
    PeakLog log;
    for (int i = 0; i * h < 7.0; ++i)
      log.add(i * h, std::exp(-0.3 * i * h) * std::sin(2.0 * i * h));
    BOOST_REQUIRE(log.peaks().size() == 2U);
    double worst = 0.0;
    for (int k = 0; k < 2; ++k) {
      const double time = 0.5 * std::atan2(2.0, 0.3) + k * std::numbers::pi;
      worst = std::max(worst, std::abs(log.peaks()[static_cast<std::size_t>(k)].value -
                                       std::exp(-0.3 * time) * std::sin(2.0 * time)));
    }
    return worst;
  };
  BOOST_TEST(error(0.1) < 2e-3);
  BOOST_TEST(error(0.01) < 2e-6);
}

BOOST_AUTO_TEST_CASE(equal_states_are_one_maximum_in_their_middle) {
  const PeakLog two = log_of({{0.0, 0.0}, {1.0, 3.0}, {2.0, 3.0}, {3.0, 0.0}});
  BOOST_REQUIRE(two.peaks().size() == 1U);
  BOOST_TEST(two.peaks()[0].time == 1.5);
  BOOST_TEST(two.peaks()[0].value == 3.375);  // 3.375 - 1.5 (t - 1.5)^2
  const PeakLog three = log_of({{0.0, 0.0}, {1.0, 3.0}, {2.0, 3.0}, {4.0, 3.0}, {5.0, 0.0}});
  BOOST_REQUIRE(three.peaks().size() == 1U);
  BOOST_TEST(three.peaks()[0].time == 2.5);
  BOOST_TEST(three.peaks()[0].value == 3.0);
}

BOOST_AUTO_TEST_CASE(the_ends_and_steps_on_the_way_up_are_no_maxima) {
  BOOST_TEST(log_of({{0.0, 1.0}, {1.0, 0.0}, {2.0, 5.0}}).peaks().empty());
  BOOST_TEST(log_of({{0.0, 1.0}, {1.0, 1.0}, {2.0, 0.0}}).peaks().empty());
  BOOST_TEST(log_of({{0.0, 0.0}, {1.0, 1.0}, {2.0, 1.0}, {3.0, 2.0}, {4.0, 2.0}}).peaks().empty());
  BOOST_TEST(log_of({{0.0, 0.0}, {1.0, 1.0}, {2.0, 1.0}}).peaks().empty());
}

BOOST_AUTO_TEST_CASE(round_off_makes_no_maximum) {
  BOOST_TEST(log_of({{0.0, 0.0}, {1.0, 1.0}, {2.0, 1.0 + 1e-15}, {3.0, 1.0}, {4.0, 2.0}, {5.0, 3.0}}).peaks().empty());
  // The wobble does not hide the maximum, nor count twice.
  const PeakLog log =
      log_of({{0.0, 0.0}, {1.0, 3.0}, {2.0, 3.0 - 1e-15}, {3.0, 3.0}, {4.0, 0.0}, {5.0, 1.0}, {6.0, 0.0}});
  BOOST_REQUIRE(log.peaks().size() == 2U);
  BOOST_TEST(std::abs(log.peaks()[0].value - 3.375) < 1e-9);  // as of two equal states
  BOOST_TEST(log.peaks()[1].time == 5.0);
}

BOOST_AUTO_TEST_SUITE_END()
