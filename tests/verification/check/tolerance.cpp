#include "verification/check/tolerance.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(tolerance_tests)

using talus::verification::Kind;
using talus::verification::Tolerance;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

}  // namespace

BOOST_AUTO_TEST_CASE(every_constructor_demands_words) {
  for (const char* reason : {"", "  \n\t"}) {
    BOOST_CHECK_THROW((void)Tolerance::exact(reason), std::invalid_argument);
    BOOST_CHECK_THROW((void)Tolerance::round_off(1e-15, reason), std::invalid_argument);
    BOOST_CHECK_THROW((void)Tolerance::truncation(1e-3, 2.0, reason), std::invalid_argument);
    BOOST_CHECK_THROW((void)Tolerance::model(1e-3, reason), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(a_bound_is_finite_and_positive) {
  for (const double bound : {0.0, -1e-3, not_a_number, infinity}) {
    BOOST_CHECK_THROW((void)Tolerance::round_off(bound, "why"), std::invalid_argument);
    BOOST_CHECK_THROW((void)Tolerance::truncation(bound, 2.0, "why"), std::invalid_argument);
    BOOST_CHECK_THROW((void)Tolerance::model(bound, "why"), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(a_truncation_bound_is_one_to_three_times_the_prediction) {
  BOOST_TEST(Tolerance::truncation(1e-3, 3.0, "why").bound() == 3e-3);
  BOOST_TEST(Tolerance::truncation(1e-3, 1.0, "why").bound() == 1e-3);
  for (const double factor : {0.99, 3.01, not_a_number}) {
    BOOST_CHECK_THROW((void)Tolerance::truncation(1e-3, factor, "why"), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(kind_words_and_relative_are_kept) {
  const Tolerance absolute = Tolerance::model(0.5, "half a unit of the last digit");
  const Tolerance relative = absolute.relative();
  BOOST_TEST(!absolute.is_relative());
  BOOST_TEST(relative.is_relative());
  BOOST_TEST(relative.bound() == 0.5);
  BOOST_TEST(relative.why() == "half a unit of the last digit");
  BOOST_TEST((relative.kind() == Kind::model));
  BOOST_TEST(Tolerance::exact("same bits").bound() == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
