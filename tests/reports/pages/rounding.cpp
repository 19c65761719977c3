#include "reports/pages/rounding.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/temporary_folder.hpp"

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

/// As the report shows it: by the file rounding.json.
std::string text_of(const Results& nearest, const Results& upward) {
  const Folder folder;
  talus::records::write_rounding(talus::records::rounding_audit(nearest, {{"upward", upward}}),
                                 folder.path / "rounding.json");
  return rounding_text(*talus::records::read_audits(folder.path, {}).rounding, nearest);
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(checks_that_fail_under_another_rounding_are_listed) {
  const std::string text = text_of(results(0.5, 0.25), results(1.5, 0.25));
  BOOST_TEST(holds(text, "| round\\_off | 1 | 1 |"), text);
  BOOST_TEST(holds(text, "| truncation | 1 | 0 |"), text);
  BOOST_TEST(holds(text, "force"));
  BOOST_TEST(holds(text, "**1.5**"));
  BOOST_TEST(!holds(text, "energy"));
}

BOOST_AUTO_TEST_CASE(a_check_that_was_not_made_is_listed) {
  Results less = results(0.5, 0.25);
  less.records[0].checks.pop_back();
  BOOST_TEST(holds(text_of(results(0.5, 0.25), less), "not made"));
}

BOOST_AUTO_TEST_CASE(none_fails) {
  BOOST_TEST(holds(text_of(results(0.5, 0.25), results(0.5, 0.9)), "No check fails"));
}

BOOST_AUTO_TEST_SUITE_END()
