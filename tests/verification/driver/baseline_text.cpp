// A comparison as a table, a job summary and JSON.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/verification/driver/recorded_cases.hpp"
#include "tests/verification/driver/text_parts.hpp"
#include "verification/driver/baseline_json.hpp"
#include "verification/driver/baseline_lines.hpp"
#include "verification/driver/baseline_markdown.hpp"
#include "verification/driver/baseline_table.hpp"

BOOST_AUTO_TEST_SUITE(baseline_text_tests)

using namespace talus::verification;

namespace {

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

ResultsFile baseline() {
  ResultsFile results = recorded_results(
      {recorded_case("a", {measured("distance | x_1", 1.1), measured("gone", 1.1), measured("kept", 1.05)},
                     {control("halved")}),
       recorded_case("b", {measured("value", 1.1)}, {control("doubled")}),
       recorded_case("c", {measured("value", 1.6)})});
  results.results.provenance.revision = "0123456789abcdef";
  results.results.provenance.compiler = "GNU 12.2.0";
  results.results.provenance.date = "2026-01-02T03:04:05Z";
  results.results.provenance.libraries = {{"fmt", "9.1.0"}};
  return results;
}

/// Results in which everything differs: a check, a control, a case that is stopped, evaluations, a verdict that
/// improves, a wider bound.
ResultsFile changed() {
  ResultsFile results = recorded_results(
      {recorded_case("a", {measured("distance | x_1", 1.3), measured("kept", 1.05, 1.0), measured("new", 1.0)},
                     {control("halved", false)}),
       recorded_case("b", {}), recorded_case("c", {measured("value", 1.4)})},
      "new.json");
  results.results.records[0].evaluations = 150;
  Record& stopped = results.results.records[1];
  stopped.status = Status::timeout;
  stopped.message = "stopped at its time limit of 60 s";
  stopped.seconds = 60.0;
  stopped.evaluations = 0;
  results.results.provenance = baseline().results.provenance;
  results.results.provenance.compiler = "GNU 13.1.0";
  results.results.provenance.dirty = true;
  return results;
}

Comparison comparison_of(const ResultsFile& after) { return compare(baseline(), after, {}, {}); }

void demand_text(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    BOOST_TEST(holds_text(text, part), "'" << part << "' is not in\n" << text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_equal_run_prints_a_few_lines) {
  const std::string text = table_of(comparison_of(baseline()));
  demand_text(text, {"baseline     old.json: revision 0123456789ab, 2026-01-02T03:04:05Z, quick tier; ",
                     "compared     3 cases, 5 checks, 2 controls\n", "measured values: 5 identical\n",
                     "evaluations  300 (equal)\n", "NOT WORSE: nothing is worse than the baseline\n"});
  BOOST_TEST(lines_in(text) <= 7u, text);
}

BOOST_AUTO_TEST_CASE(a_line_says_what_became_worse_and_by_how_much) {
  const std::string text = table_of(comparison_of(changed()));
  demand_text(
      text,
      {"compiler: GNU 12.2.0 -> GNU 13.1.0\n",
       "  value           a/distance | x_1: 1.1 m -> 1.3 m; change/bound 0.4; error/bound 0.2 -> 0.6; bound 0.5 m\n",
       "  gone            a/gone: 1.1 m -> not made; bound 0.5 m\n",
       "  verdict         a/control: halved: red with the fault -> FAIL 'value' is green with the fault, green "
       "without it\n",
       "  status          b: pass -> timeout: stopped at its time limit of 60 s (1 check and 1 control gone)\n",
       "  evaluations     a: 100 evaluations -> 150 (+50 %)\n", "new          a/new\n",
       "largest changes that are not worse:\n", "  improved        c/value: FAIL 1.6 m -> 1.4 m",
       "  bound widened   a/kept: 1.05 m -> 1.05 m; change/bound 0; error/bound 0.1 -> 0.05; bound 0.5 m -> 1 m\n",
       "WORSE: 2 cases, 3 checks and 2 controls are worse than the baseline\n"});
  // Checks that are missing because a case was stopped are covered by the line of the case.
  BOOST_TEST(!holds_text(text, "b/value"), text);
  BOOST_TEST(!holds_text(text, "b/control"), text);
  BOOST_TEST(text.find("  status ") < text.find("  verdict "));
  BOOST_TEST(text.find("  verdict ") < text.find("  gone "));
  BOOST_TEST(text.find("  gone ") < text.find("  value "));
  BOOST_TEST(text.find("  value ") < text.find("  evaluations "));
}

BOOST_AUTO_TEST_CASE(the_largest_change_comes_first_and_the_rest_is_counted) {
  std::vector<Check> before, after;
  for (int i = 0; i < 300; ++i) {
    before.push_back(measured("check " + std::to_string(i), 1.0));
    after.push_back(measured("check " + std::to_string(i), 1.0 + 0.001 * (i + 1)));
  }
  const Comparison comparison =
      compare(recorded_results({recorded_case("a", before)}), recorded_results({recorded_case("a", after)}), {}, {});
  const std::string table = table_of(comparison);
  BOOST_TEST(lines_in(table) < 65u);
  demand_text(table,
              {"worse than the baseline:\n  value           a/check 299: ", "  and 250 more in baseline.json\n"});
  const std::string markdown = markdown_of(comparison);
  demand_text(markdown, {"| value | a/check 299 |", "\nand 200 more in `baseline.json`\n"});
  BOOST_TEST(nlohmann::json::parse(json_of(comparison)).at("checks").size() == 300u);
}

BOOST_AUTO_TEST_CASE(numbers_show_that_they_differ) {
  BOOST_TEST((number_pair(1.5, 2.5) == std::pair<std::string, std::string>{"1.5", "2.5"}));
  BOOST_TEST((number_pair(1.5, 1.5) == std::pair<std::string, std::string>{"1.5", "1.5"}));
  const auto close = number_pair(0.1 + 0.2, 0.3);
  BOOST_TEST(close.first != close.second);
  BOOST_TEST((number_pair(std::nan(""), 1.0) == std::pair<std::string, std::string>{"nan", "1"}));
  BOOST_TEST(grouped(7) == "7");
  BOOST_TEST(grouped(1234567) == "1,234,567");
  BOOST_TEST(counted(1, "check") == "1 check");
  BOOST_TEST(counted(1000, "check") == "1,000 checks");
}

BOOST_AUTO_TEST_CASE(true_and_false_are_words_and_changes_of_an_exact_check_are_of_its_reference) {
  const auto exact = [](double value) { return compare("size", value, value, Tolerance::exact("twice"), "lb"); };
  Findings holds, fails;
  holds.expect_true("same bits", true, "so");
  fails.expect_true("same bits", false, "so");
  const Comparison comparison =
      compare(recorded_results({recorded_case("a", {exact(2.0), holds.checks()[0]})}),
              recorded_results({recorded_case("a", {exact(2.5), fails.checks()[0]})}), {}, {});
  demand_text(table_of(comparison), {"verdict         a/same bits: true -> FAIL false; change/bound 1 of the "
                                     "reference; error/bound 0 -> inf; bound exact\n",
                                     "value           a/size: 2 lb (reference 2) -> 2.5 lb (reference 2.5); "
                                     "change/bound 0.25 of the reference; error/bound 0; bound exact\n"});
}

BOOST_AUTO_TEST_CASE(a_renamed_check_has_both_names) {
  const Comparison comparison = compare(recorded_results({recorded_case("a", {measured("x", 1.1)})}),
                                        recorded_results({recorded_case("a", {measured("y", 1.2)})}), {},
                                        {{{"a", "x"}, ItemName{"a", "y"}, "r:1"}});
  demand_text(table_of(comparison), {"a/y (was a/x): 1.1 m -> 1.2 m"});
  BOOST_TEST(nlohmann::json::parse(json_of(comparison)).at("checks").at(0).at("renamed_from") == "a/x");
}

BOOST_AUTO_TEST_CASE(a_baseline_that_is_partial_or_failed_is_said) {
  ResultsFile before = baseline();
  before.results.records[0].status = Status::fail;
  before.results.only = {"a", "b", "c"};
  const Comparison comparison = compare(before, baseline(), {}, {});
  demand_text(table_of(comparison), {"quick tier; it has only the 3 cases of its --only; its own verdict is fail\n"});
  demand_text(markdown_of(comparison), {"| verdict | fail | fail |\n", "| cases named by --only | 3 | none |\n"});
}

BOOST_AUTO_TEST_CASE(nothing_compared_is_said) {
  ResultsFile after = recorded_results({recorded_case("d", {measured("value", 1.1)})});
  after.results.only = {"d"};
  const Comparison comparison = comparison_of(after);
  demand_text(table_of(comparison),
              {"compared     0 cases, 0 checks, 0 controls; 3 cases of the baseline not selected\n",
               "NOT WORSE: nothing was compared"});
  demand_text(markdown_of(comparison), {"## Verification: nothing to compare with the baseline\n"});
}

BOOST_AUTO_TEST_CASE(the_job_summary_is_a_table_that_markdown_can_show) {
  const std::string text = markdown_of(comparison_of(changed()));
  demand_text(
      text, {"## Verification: worse than the baseline (2 cases, 3 checks, 2 controls)\n", "**The run itself fails:**",
             "| value | a/distance \\| x\\_1 | 1.1 m | 1.3 m | 0.4 | 0.2 -> 0.6 | 0.5 m |\n",
             "| gone | a/gone | 1.1 m | not made |  |  | 0.5 m |\n", "| compiler | GNU 12.2.0 | GNU 13.1.0 |\n",
             "| revision | 0123456789ab | 0123456789ab (modified) |\n", "| checks | 3 | 3 | 0 | 1 | 2 | 0 | 1 |\n",
             "\n### New\n\n- a/new\n", "| b | 1.00 s | 60.00 s |\n"});
  // Each row of a table has as many cells as its head.
  std::istringstream lines(text);
  std::size_t columns = 0;
  for (std::string line; std::getline(lines, line);) {
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
      bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    if (bars == 0) columns = 0;
    if (bars == 0) continue;
    if (columns == 0) columns = bars;
    BOOST_TEST(bars == columns, line);
  }
  demand_text(markdown_of(comparison_of(baseline())), {"## Verification: nothing is worse than the baseline\n"});
}

BOOST_AUTO_TEST_CASE(json_holds_everything) {
  Comparison comparison = comparison_of(changed());
  comparison.renaming_errors = {"r:1: wrong"};
  const auto json = nlohmann::json::parse(json_of(comparison));
  BOOST_TEST(json.at("schema") == 1);
  BOOST_TEST(json.at("verdict") == "worse");
  BOOST_TEST(json.at("tier") == "quick");
  BOOST_TEST(json.at("baseline").at("file") == "old.json");
  BOOST_TEST(json.at("baseline").at("libraries").at("fmt") == "9.1.0");
  BOOST_TEST(json.at("results").at("verdict") == "fail");
  BOOST_TEST(json.at("totals").at("checks").at("gone") == 2);
  BOOST_TEST(json.at("totals").at("values").at("changed") == 2);
  BOOST_TEST(json.at("totals").at("bounds").at("widened") == 1);
  BOOST_TEST(json.at("renaming_errors").at(0) == "r:1: wrong");
  const auto& checks = json.at("checks");
  BOOST_TEST(checks.size() == 6u);
  const auto& distance = checks.at(0);
  BOOST_TEST(distance.at("case") == "a");
  BOOST_TEST(distance.at("name") == "distance | x_1");
  BOOST_TEST(distance.at("presence") == "both");
  BOOST_TEST(distance.at("value") == "changed");
  BOOST_TEST(distance.at("worse") == nlohmann::json({"value", "error/bound"}));
  BOOST_TEST(distance.at("before").at("measured") == 1.1);
  BOOST_TEST(distance.at("after").at("measured") == 1.3);
  BOOST_TEST(distance.at("before").at("bound") == 0.5);
  BOOST_TEST(distance.at("change_over_bound").get<double>() == 0.4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(distance.at("margin_growth").get<double>() == 0.4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(checks.at(2).at("presence") == "new");
  BOOST_TEST(checks.at(2).at("before").is_null());
  const auto& control = json.at("controls").at(0);
  BOOST_TEST(control.at("name") == "control: halved");
  BOOST_TEST(control.at("after").at("observed") == "green");
  BOOST_TEST(json.at("cases").at(1).at("after").at("status") == "timeout");
  BOOST_TEST(json.at("cases").at(1).at("checks_gone") == 1);
  BOOST_TEST(json.at("cases").at(0).at("worse") == nlohmann::json({"status", "evaluations"}));
  BOOST_TEST(nlohmann::json::parse(json_of(comparison_of(baseline()))).at("verdict") == "not worse");
}

BOOST_AUTO_TEST_CASE(numbers_that_json_does_not_have_are_words) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("value", 1.1)})});
  const ResultsFile after =
      recorded_results({recorded_case("a", {measured("value", std::numeric_limits<double>::quiet_NaN())})});
  const auto check = nlohmann::json::parse(json_of(compare(before, after, {}, {}))).at("checks").at(0);
  BOOST_TEST(check.at("after").at("measured") == "nan");
  BOOST_TEST(check.at("change_over_bound") == "inf");
  BOOST_TEST(check.at("margin_growth") == "inf");
  demand_text(
      table_of(compare(before, after, {}, {})),
      {"verdict         a/value: 1.1 m -> FAIL nan m; change/bound inf; error/bound 0.2 -> nan; bound 0.5 m\n"});
}

BOOST_AUTO_TEST_SUITE_END()
