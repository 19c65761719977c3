#include "verification/check/findings.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/check/case.hpp"

BOOST_AUTO_TEST_SUITE(findings_tests)

using namespace talus::verification;

BOOST_AUTO_TEST_CASE(a_failed_check_is_kept_and_does_not_throw) {
  Findings findings;
  BOOST_TEST(findings.expect("right", 1.0, 1.0, Tolerance::exact("same")));
  BOOST_TEST(!findings.expect("wrong", 1.0, 2.0, Tolerance::exact("same"), "m"));
  BOOST_TEST(!findings.expect_true("false", false, "an identity"));
  BOOST_TEST(findings.checks().size() == 3u);
  BOOST_TEST(findings.find("wrong")->unit == "m");
  BOOST_TEST(findings.find("false")->text_measured == "false");
  BOOST_TEST(findings.find("none") == nullptr);
}

BOOST_AUTO_TEST_CASE(names_are_unique_and_not_empty) {
  Findings findings;
  findings.expect_true("a", true, "why");
  BOOST_CHECK_THROW(findings.expect_true("a", true, "why"), std::logic_error);
  BOOST_CHECK_THROW(findings.expect_true("", true, "why"), std::invalid_argument);
  const Table table{"t", "caption", {"x"}, {{"1"}}};
  findings.table(table);
  BOOST_CHECK_THROW(findings.table(table), std::logic_error);
}

BOOST_AUTO_TEST_CASE(each_kind_of_tolerance_has_its_call) {
  Findings findings;
  BOOST_TEST(findings.expect_exact("exact", 1.0, 1.0, "why", "m"));
  BOOST_TEST(!findings.expect_exact("not exact", 1.0 + 1e-15, 1.0, "why"));
  BOOST_TEST(findings.expect_round_off("round-off", 1.05, 1.0, 0.1, "why", "m"));
  BOOST_TEST(findings.expect_truncation("truncation", 1.25, 1.0, 0.15, 2.0, "why", "m"));
  BOOST_TEST(!findings.expect_model("model", 1.25, 1.0, 0.125, "why", "m"));
  const std::array kinds{Kind::exact, Kind::exact, Kind::round_off, Kind::truncation, Kind::model};
  const std::array bounds{0.0, 0.0, 0.1, 0.3, 0.125};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Check& check = findings.checks().at(i);
    BOOST_TEST((check.kind == kinds[i]));
    BOOST_TEST(check.bound == bounds[i]);
    BOOST_TEST(check.why == "why");
    BOOST_TEST(check.unit == (i == 1 ? "1" : "m"));
    BOOST_TEST(!check.relative);
  }
}

BOOST_AUTO_TEST_CASE(a_check_has_an_id_and_belongs_to_what_precedes_a_slash) {
  using Ids = std::vector<std::string>;
  Findings findings;
  findings.expect_true("alone", true, "why");
  findings.expect_true({"a", "of a"}, true, "why");
  const auto outer = findings.in("outer");
  findings.expect_order({"order/damped/rk4", "an order"}, {{1.0, 0.5}, {1.0, 0.5}}, 0.9, 1.1, "why");
  findings.expect_between({"b", "of b"}, 1.0, 0.0, 2.0, "why");
  BOOST_TEST(findings.find("an order") != nullptr);
  BOOST_TEST(findings.groups().at(0) == Ids{});
  BOOST_TEST(findings.groups().at(1) == Ids{"a"});
  BOOST_TEST((findings.groups().at(2) == Ids{"outer", "order", "order/damped", "order/damped/rk4"}));
  BOOST_TEST((findings.groups().at(3) == Ids{"outer", "b"}));
}

BOOST_AUTO_TEST_CASE(an_order_is_gated_on_both_sides) {
  const Convergence second({0.1, 0.05, 0.025}, {1e-2, 2.5e-3, 6.25e-4});
  Findings findings;
  BOOST_TEST(findings.expect_order("in", second, 1.85, 2.35, "second order"));
  BOOST_TEST(!findings.expect_order("too steep", second, 0.85, 1.35, "first order"));
  BOOST_TEST(!findings.expect_order("too flat", second, 3.85, 4.35, "fourth order"));
  BOOST_TEST(!findings.expect_order("no points", Convergence(), 1.85, 2.35, "nothing measured"));
}

BOOST_AUTO_TEST_CASE(evaluations_are_summed) {
  Findings findings;
  findings.count(3);
  findings.count(4);
  BOOST_TEST(findings.evaluations() == 7u);
}

BOOST_AUTO_TEST_CASE(a_table_row_is_as_long_as_the_columns) {
  Findings findings;
  BOOST_CHECK_THROW(findings.table({"t", "caption", {"x", "y"}, {{"1"}}}), std::invalid_argument);
  BOOST_CHECK_THROW(findings.table({"t", "", {"x"}, {{"1"}}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_data_file_has_a_name_and_rows_that_can_be_read_back) {
  Findings findings;
  findings.data({"d", {"x", "y"}, {{"1", ""}}});
  BOOST_CHECK_THROW(findings.data({"d", {"x"}, {}}), std::logic_error);
  BOOST_CHECK_THROW(findings.data({"", {"x"}, {}}), std::invalid_argument);
  BOOST_CHECK_THROW(findings.data({"e", {}, {}}), std::invalid_argument);
  BOOST_CHECK_THROW(findings.data({"e", {"x", "y"}, {{"1"}}}), std::invalid_argument);
  findings.data({"e", {"x"}, {{"1,2"}}});
  BOOST_TEST(csv_of(findings.data_files()[0]) == "x,y\n1,\n");
  BOOST_TEST(csv_of(findings.data_files()[1]) == "x\n\"1,2\"\n");
}

BOOST_AUTO_TEST_CASE(a_setup_knows_its_fault) {
  BOOST_TEST(Setup{.fault = "mass_halved"}.has("mass_halved"));
  BOOST_TEST(!Setup{}.has("mass_halved"));
}

BOOST_AUTO_TEST_CASE(a_run_ends_with_the_last_needed_check) {
  Findings findings{{"second", "fourth"}};
  const auto expect = [&](const std::string& name) { return findings.expect_true(name, false, "an identity"); };
  expect("first"), expect("second"), expect("third");
  BOOST_CHECK_THROW(expect("fourth"), Findings::Decided);
  BOOST_TEST(findings.checks().size() == 4u);
  BOOST_REQUIRE(findings.find("fourth") != nullptr);
  BOOST_TEST(!findings.find("fourth")->pass);
}

BOOST_AUTO_TEST_CASE(a_run_ends_with_the_first_failed_check_if_only_the_verdict_is_needed) {
  Findings findings = Findings::until_one_fails();
  const auto expect = [&](const std::string& name, bool holds) {
    return findings.expect_true(name, holds, "an identity");
  };
  BOOST_TEST(expect("first", true));
  BOOST_CHECK_THROW(expect("second", false), Findings::Decided);
  BOOST_TEST(findings.checks().size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_setup_needs_checks_by_parts_of_their_names) {
  BOOST_TEST(Setup{}.needs("anything"));
  const Setup control{.fault = "softer", .needed = {"largest error, disc", "order"}};
  BOOST_TEST(control.needs("disc"));
  BOOST_TEST(control.needs("order"));
  BOOST_TEST(!control.needs("cable"));
}

BOOST_AUTO_TEST_SUITE_END()
