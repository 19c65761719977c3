#include "verification/check/convergence.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(convergence_tests)

using namespace talus::verification;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

BOOST_AUTO_TEST_CASE(a_pure_power_gives_its_order_and_constant) {
  Convergence points;
  for (const double h : {0.3, 0.1, 0.02, 0.004})
    points.add(h, 0.7 * std::pow(h, 2.5));
  const PowerLaw law = points.fit();
  BOOST_TEST(law.order == 2.5, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(law.constant == 0.7, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(law.scatter < 1e-13);
  BOOST_TEST(law.at(0.05) == 0.7 * std::pow(0.05, 2.5), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_fit_is_least_squares) {
  // ln h = 0, 1, 2 and ln e = 0, 1, 5: slope (5 - 0)/2, mean 2, residuals 0.5, -1, 0.5.
  const PowerLaw law = Convergence({1.0, std::exp(1.0), std::exp(2.0)}, {1.0, std::exp(1.0), std::exp(5.0)}).fit();
  BOOST_TEST(law.order == 2.5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law.constant == std::exp(-0.5), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law.scatter == std::sqrt(0.5), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_has_no_order_gives_nan) {
  BOOST_TEST(std::isnan(Convergence().fit().order));
  BOOST_TEST(std::isnan(Convergence({0.1}, {1.0}).fit().order));
  BOOST_TEST(std::isnan(Convergence({0.1, 0.1}, {1.0, 2.0}).fit().order));
  BOOST_TEST(std::isnan(Convergence({0.1, 0.2}, {0.0, 2.0}).fit().order));
  BOOST_TEST(std::isnan(Convergence({0.1, 0.2}, {not_a_number, 2.0}).fit().order));
  BOOST_CHECK_THROW(Convergence({0.1}, {1.0, 2.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(points_are_chosen_by_count_or_range) {
  const Convergence points({0.4, 0.2, 0.1, 0.05}, {4.0, 3.0, 2.0, 1.0});
  BOOST_TEST(points.last(2).steps() == std::vector<double>({0.1, 0.05}));
  BOOST_TEST(points.between(0.1, 0.2).errors() == std::vector<double>({3.0, 2.0}));
  BOOST_CHECK_THROW((void)points.last(5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_diverging_method_shows_a_negative_order) {
  const Convergence points({0.2, 0.1, 0.05}, {1.0, 0.25, 0.5});
  BOOST_TEST(points.last(2).fit().order == -1.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(phase_errors_are_reduced_and_keep_a_nan) {
  PhaseError error;
  BOOST_TEST(std::isnan(error.rms()));
  BOOST_TEST(std::isnan(error.max()));
  error.add(3.0);
  error.add(-4.0);
  BOOST_TEST(error.rms() == std::sqrt(12.5), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(error.max() == 4.0);
  error.add(not_a_number);
  error.add(1.0);
  BOOST_TEST(std::isnan(error.rms()));
  BOOST_TEST(std::isnan(error.max()));
}

BOOST_AUTO_TEST_CASE(phases_are_evenly_spread) {
  for (auto phases : {even_phases(64), golden_phases(64)}) {
    std::sort(phases.begin(), phases.end());
    BOOST_TEST(phases.size() == 64u);
    BOOST_TEST(phases.front() > 0.0);
    BOOST_TEST(phases.back() < 1.0);
    // Golden-ratio points leave no gap longer than about 2.2/n.
    for (std::size_t i = 1; i < phases.size(); ++i)
      BOOST_TEST(phases[i] - phases[i - 1] < 2.7 / 64.0);
  }
}

BOOST_AUTO_TEST_CASE(steps_are_incommensurate_with_the_contact) {
  BOOST_TEST(1.0 / incommensurate_step(1.0, 16.0) == 16.381966011250105, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(1.0 / offset_step(1.0, 16.0, 0) == 16.309016994374947, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(offset_step(1.0, 16.0, 0) != offset_step(1.0, 16.0, 1));
  BOOST_TEST(doublings(16.0, 4) == std::vector<double>({16.0, 32.0, 64.0, 128.0}));
}

BOOST_AUTO_TEST_SUITE_END()
