// The comparator, tested separately: the controls of cases inject faults into the code under test instead.
#include "verification/check/check.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(check_tests)

using talus::verification::Check;
using talus::verification::compare;
using talus::verification::compare_between;
using talus::verification::Tolerance;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const Tolerance within = Tolerance::model(0.25, "a bound exact in binary");

Check of(double measured, double reference, const Tolerance& tolerance = within) {
  return compare("a", measured, reference, tolerance, "m");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_shift_below_the_bound_passes_and_above_fails_on_both_sides) {
  for (const double sign : {-1.0, 1.0}) {
    BOOST_TEST(of(3.0, 3.0 + sign * 0.999 * 0.25).pass);
    BOOST_TEST(of(3.0, 3.0 + sign * 0.25).pass);
    BOOST_TEST(!of(3.0, 3.0 + sign * 1.001 * 0.25).pass);
  }
}

BOOST_AUTO_TEST_CASE(relative_errors_are_divided_by_the_reference) {
  const Tolerance relative = Tolerance::model(0.01, "one per cent").relative();
  BOOST_TEST(of(-2.0 * 1.00999, -2.0, relative).pass);
  BOOST_TEST(!of(-2.0 * 1.01001, -2.0, relative).pass);
  BOOST_TEST(of(2.02, 2.0, relative).error == 0.01, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_relative_error_needs_a_reference_other_than_zero) {
  const Check check = of(0.0, 0.0, Tolerance::model(0.01, "one per cent").relative());
  BOOST_TEST(!check.pass);
  BOOST_TEST(!check.message.empty());
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_fail) {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    BOOST_TEST(!of(bad, 1.0).pass);
    BOOST_TEST(!of(1.0, bad).pass);
    BOOST_TEST(!of(bad, bad).pass);
    BOOST_TEST(!of(bad, bad, Tolerance::exact("same")).pass);
    BOOST_TEST(!compare_between("a", bad, 0.0, 1.0, "why", "1").pass);
    BOOST_TEST(!of(bad, 1.0).slack);
  }
}

// Rounded to two or three digits, 0.9996 and 1.0004 are both 1.
BOOST_AUTO_TEST_CASE(a_printed_margin_shows_the_verdict) {
  using talus::records::margin_text;
  const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
  for (const int digits : {2, 3}) {
    BOOST_TEST(margin_text(0.9996, true, digits) == "0.999");
    BOOST_TEST(margin_text(below, true, digits) == "0.999");
    BOOST_TEST(margin_text(1.0, true, digits) == "0.999");  // error = bound passes
    BOOST_TEST(margin_text(1.0004, false, digits) == "1.001");
    BOOST_TEST(margin_text(above, false, digits) == "1.001");
    BOOST_TEST(margin_text(1.0, false, digits) == "1.001");  // error > bound, the quotient rounded to 1
    BOOST_TEST(margin_text(0.0, true, digits) == "0");
    BOOST_TEST(margin_text(infinity, false, digits) == "inf");
    BOOST_TEST(margin_text(not_a_number, false, digits) == "nan");
  }
  BOOST_TEST(margin_text(0.996, true, 2) == "0.996");
  BOOST_TEST(margin_text(0.987, true, 2) == "0.99");
  BOOST_TEST(margin_text(1.004, false, 3) == "1.004");
  BOOST_TEST(margin_text(1.04, false, 2) == "1.040");
  BOOST_TEST(margin_text(34.56, false, 3) == "34.6");
}

BOOST_AUTO_TEST_CASE(exact_is_equality_of_doubles) {
  const Tolerance exact = Tolerance::exact("same bits");
  BOOST_TEST(of(0.1, 0.1, exact).pass);
  BOOST_TEST(of(0.1, 0.1, exact).margin == 0.0);
  BOOST_TEST(!of(0.1, std::nextafter(0.1, 1.0), exact).pass);
  BOOST_TEST(std::isinf(of(0.1, 0.2, exact).margin));
}

BOOST_AUTO_TEST_CASE(slack_is_a_margin_below_a_fiftieth_of_a_chosen_bound) {
  const auto margin = [](double error_over_bound, const Tolerance& tolerance) {
    return of(error_over_bound, 0.0, tolerance).slack;
  };
  const Tolerance chosen[] = {Tolerance::model(1.0, "why"), Tolerance::truncation(0.5, 2.0, "why")};
  for (const auto& tolerance : chosen) {
    BOOST_TEST(margin(0.0199, tolerance));
    BOOST_TEST(!margin(0.0201, tolerance));
  }
  BOOST_TEST(!margin(1e-9, Tolerance::round_off(1.0, "why")));
  BOOST_TEST(!margin(0.0, Tolerance::exact("why")));
  BOOST_TEST(compare_between("a", 2.001, 1.9, 2.1, "why", "1").slack);
  BOOST_TEST(!of(9.0, 0.0, Tolerance::model(1.0, "why")).slack);
}

BOOST_AUTO_TEST_CASE(an_interval_is_closed_and_two_sided) {
  const auto between = [](double x) { return compare_between("a", x, 1.5, 2.5, "why", "1"); };
  BOOST_TEST(between(1.5).pass);
  BOOST_TEST(between(2.5).pass);
  BOOST_TEST(!between(1.4999).pass);
  BOOST_TEST(!between(2.5001).pass);
  BOOST_TEST(between(2.0).reference == 2.0);
  BOOST_TEST(between(2.0).bound == 0.5);
}

BOOST_AUTO_TEST_CASE(an_interval_needs_two_ends_and_words) {
  BOOST_CHECK_THROW((void)compare_between("a", 1.0, 2.0, 1.0, "why", "1"), std::invalid_argument);
  BOOST_CHECK_THROW((void)compare_between("a", 1.0, 1.0, 1.0, "why", "1"), std::invalid_argument);
  BOOST_CHECK_THROW((void)compare_between("a", 1.0, not_a_number, 1.0, "why", "1"), std::invalid_argument);
  BOOST_CHECK_THROW((void)compare_between("a", 1.0, 0.0, 1.0, "", "1"), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
