#include "reports/pages/rounding.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(rounding_tests)

namespace {

using namespace talus::reports;

Results results(double first, double second) {
  Results all;
  Record record;
  record.id = "column";
  record.title = "Column";
  for (const double margin : {first, second}) {
    Check check;
    check.name = record.checks.empty() ? "force" : "energy";
    check.kind = record.checks.empty() ? Kind::round_off : Kind::truncation;
    check.margin = margin;
    check.pass = margin <= 1.0;
    record.checks.push_back(check);
  }
  all.records.push_back(record);
  return all;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(checks_that_fail_under_another_rounding_are_listed) {
  const std::string text = rounding_text(results(0.5, 0.25), {{"upward", results(1.5, 0.25)}});
  BOOST_TEST(holds(text, "force"));
  BOOST_TEST(holds(text, "**1.5**"));
  BOOST_TEST(!holds(text, "energy"));
}

BOOST_AUTO_TEST_CASE(a_check_that_was_not_made_is_listed) {
  Results less = results(0.5, 0.25);
  less.records[0].checks.pop_back();
  BOOST_TEST(holds(rounding_text(results(0.5, 0.25), {{"upward", less}}), "not made"));
}

BOOST_AUTO_TEST_CASE(none_fails) {
  BOOST_TEST(holds(rounding_text(results(0.5, 0.25), {{"upward", results(0.5, 0.9)}}), "No check fails"));
}

BOOST_AUTO_TEST_SUITE_END()
