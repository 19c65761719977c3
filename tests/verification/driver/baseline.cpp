// The comparison of two results: every class of difference, allowances, and renames.
#include "verification/driver/baseline.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"
#include "tests/verification/driver/recorded_cases.hpp"

BOOST_TEST_DONT_PRINT_LOG_VALUE(talus::verification::Movement)
BOOST_TEST_DONT_PRINT_LOG_VALUE(talus::verification::Presence)
BOOST_TEST_DONT_PRINT_LOG_VALUE(std::vector<talus::verification::Reason>)

BOOST_AUTO_TEST_SUITE(baseline_tests)

using namespace talus::verification;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Reasons = std::vector<Reason>;

Comparison compared(const ResultsFile& before, const ResultsFile& after, const Allowance& allowance = {},
                    const std::vector<Renaming>& renames = {}) {
  return compare(before, after, allowance, renames);
}

/// Compares one check before and after.
CheckChange compared(const Check& before, const Check& after, const Allowance& allowance = {}) {
  const Comparison comparison = compared(recorded_results({recorded_case("a", {before})}),
                                         recorded_results({recorded_case("a", {after})}, "new.json"), allowance);
  BOOST_REQUIRE(comparison.checks.size() == 1u);
  return comparison.checks[0];
}

Allowance tolerance(double value) { return {.tolerances = {{"", value}}, .margin = {}}; }

template <class Changes>
auto find(const Changes& changes, const std::string& name) {
  const auto found =
      std::find_if(changes.begin(), changes.end(), [&](const auto& change) { return text_of(change.name) == name; });
  BOOST_REQUIRE_MESSAGE(found != changes.end(), name);
  return *found;
}

ItemName name(const std::string& id, const std::string& item = "") { return {id, item}; }

}  // namespace

BOOST_AUTO_TEST_CASE(equal_results_are_not_worse) {
  const ResultsFile results = recorded_results(
      {recorded_case("a", {measured("value", 1.1), measured("lost", not_a_number)}, {control("fault")}),
       recorded_case("b", {measured("value", 1.2)})});
  const Comparison comparison = compared(results, results);
  const Totals totals = totals_of(comparison);
  BOOST_TEST(totals.worse() == 0u);
  BOOST_TEST(totals.cases.compared == 2u);
  BOOST_TEST(totals.checks.compared == 3u);
  BOOST_TEST(totals.controls.compared == 1u);
  BOOST_TEST(totals.identical == 3u);  // including NaN with NaN
  BOOST_TEST(totals.evaluations_before == 200u);
  BOOST_TEST(totals.seconds_after == 2.0);
  BOOST_TEST(comparison.renaming_errors.empty());
}

// --- Measured values ------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(any_change_is_worse_by_default) {
  const CheckChange nearer = compared(measured("value", 1.2), measured("value", 1.1));
  BOOST_TEST(nearer.movement == Movement::changed);
  BOOST_TEST(nearer.moved == 0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(nearer.growth == -0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(nearer.worse == Reasons{Reason::value});
  const CheckChange farther = compared(measured("value", 1.1), measured("value", 1.2));
  BOOST_TEST(farther.difference == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(farther.worse == (Reasons{Reason::value, Reason::margin}));
}

BOOST_AUTO_TEST_CASE(round_off_is_a_separate_class) {
  const Check before = measured("value", 1.1);
  const CheckChange last_bit = compared(before, measured("value", std::nextafter(1.1, 1.0)));
  BOOST_TEST(last_bit.movement == Movement::round_off);
  BOOST_TEST(last_bit.worse == Reasons{Reason::round_off});
  BOOST_TEST(compared(before, measured("value", 1.1 - 0.4e-9)).movement == Movement::round_off);
  BOOST_TEST(compared(before, measured("value", 1.1 - 0.6e-9)).movement == Movement::changed);
  const Allowance allowance{.tolerances = {}, .margin = {}, .round_off = true};
  BOOST_TEST(compared(before, measured("value", 1.1 + 0.4e-9), allowance).worse == Reasons{});
  BOOST_TEST(compared(before, measured("value", 1.1 + 0.6e-9), allowance).worse ==
             (Reasons{Reason::value, Reason::margin}));
}

BOOST_AUTO_TEST_CASE(checks_that_count_roundings_may_move_within_their_bound) {
  const auto rounded = [](double value) {
    return compare("value", value, 0.0, Tolerance::round_off(4e-16, "two operations"), "1");
  };
  const Allowance allowance{.tolerances = {}, .margin = {}, .round_off = true};
  const CheckChange within = compared(rounded(1e-16), rounded(-3e-16), allowance);
  BOOST_TEST(within.movement == Movement::round_off);
  BOOST_TEST(within.worse == Reasons{});
  BOOST_TEST(compared(rounded(1e-16), rounded(-3e-16)).worse == (Reasons{Reason::margin, Reason::round_off}));
  BOOST_TEST(compared(rounded(3e-16), rounded(-2e-16), allowance).worse == Reasons{Reason::value});
  // The same change of a check of another kind does not count as round-off.
  Check other = rounded(-3e-16);
  other.kind = Kind::truncation;
  BOOST_TEST(compared(rounded(1e-16), other).movement == Movement::changed);
}

BOOST_AUTO_TEST_CASE(the_sign_of_zero_shows_and_does_not_gate) {
  const CheckChange change = compared(measured("value", 0.0, 2.0), measured("value", -0.0, 2.0));
  BOOST_TEST(change.movement == Movement::round_off);
  BOOST_TEST(change.worse == Reasons{});
}

BOOST_AUTO_TEST_CASE(a_tolerance_is_in_bounds_on_both_sides) {
  const Check before = measured("value", 1.1);  // bound 0.5
  BOOST_TEST(compared(before, measured("value", 1.19), tolerance(0.2)).worse == Reasons{});
  BOOST_TEST(compared(before, measured("value", 1.01), tolerance(0.2)).worse == Reasons{});
  BOOST_TEST(compared(before, measured("value", 1.21), tolerance(0.2)).worse ==
             (Reasons{Reason::value, Reason::margin}));
  BOOST_TEST(compared(before, measured("value", 0.99), tolerance(0.2)).worse == Reasons{Reason::value});
  // Exactly at the limit; all numbers are exact in binary.
  BOOST_TEST(compared(measured("value", 1.125), measured("value", 1.25), tolerance(0.25)).worse == Reasons{});
}

BOOST_AUTO_TEST_CASE(a_relative_bound_is_taken_times_the_reference) {
  const auto relative = [](double value) {
    return compare("value", value, 10.0, Tolerance::model(0.1, "chosen").relative(), "m");
  };
  const CheckChange change = compared(relative(10.0), relative(10.5));
  BOOST_TEST(change.moved == 0.5);
  BOOST_TEST(compared(relative(10.0), relative(10.5), tolerance(0.5)).worse == Reasons{});
  BOOST_TEST(compared(relative(10.0), relative(10.5), tolerance(0.49)).worse ==
             (Reasons{Reason::value, Reason::margin}));
}

BOOST_AUTO_TEST_CASE(the_bound_of_the_baseline_counts) {
  // A bound ten times as wide does not allow a change ten times as large.
  const CheckChange change = compared(measured("value", 1.0, 0.5), measured("value", 1.5, 5.0), tolerance(0.2));
  BOOST_TEST(change.moved == 1.0);
  BOOST_TEST(change.worse == Reasons{Reason::value});
}

BOOST_AUTO_TEST_CASE(an_exact_check_changes_by_its_reference) {
  const auto exact = [](double value, double reference) {
    return compare("value", value, reference, Tolerance::exact("the same way twice"), "lb");
  };
  const CheckChange both = compared(exact(200.0, 200.0), exact(201.0, 201.0));
  BOOST_TEST(both.moved == 0.005);
  BOOST_TEST(both.growth == 0.0);
  BOOST_TEST(both.worse == Reasons{Reason::value});
  BOOST_TEST(compared(exact(200.0, 200.0), exact(201.0, 201.0), tolerance(0.005)).worse == Reasons{});
  const CheckChange zero = compared(exact(0.0, 0.0), exact(1e-30, 1e-30), tolerance(1e9));
  BOOST_TEST(zero.moved == infinity);
  BOOST_TEST(zero.worse == Reasons{Reason::value});
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite) {
  const Check lost = measured("value", not_a_number), endless = measured("value", infinity);
  const Check sound = measured("value", 1.1), wrong = measured("value", 3.0);
  BOOST_TEST(compared(lost, lost).worse == Reasons{});
  BOOST_TEST(compared(endless, endless).worse == Reasons{});
  BOOST_TEST(compared(endless, endless).difference == 0.0);
  BOOST_TEST(compared(sound, lost, tolerance(1e9)).worse == (Reasons{Reason::verdict, Reason::value, Reason::margin}));
  BOOST_TEST(compared(sound, lost).moved == infinity);
  BOOST_TEST(compared(lost, sound).worse == Reasons{});  // It passes now.
  BOOST_TEST(compared(lost, wrong, tolerance(1e9)).worse == Reasons{Reason::value});
  BOOST_TEST(compared(wrong, endless, tolerance(1e9)).worse == (Reasons{Reason::value, Reason::margin}));
}

BOOST_AUTO_TEST_CASE(another_unit_is_worse) {
  Check feet = measured("value", 1.1);
  feet.unit = "ft";
  const CheckChange change = compared(measured("value", 1.1), feet, tolerance(1e9));
  BOOST_TEST(change.movement == Movement::changed);
  BOOST_TEST(change.worse == Reasons{Reason::unit});
}

BOOST_AUTO_TEST_CASE(of_the_tolerances_the_last_that_applies_is_taken) {
  const auto worse = [](std::vector<ChangeTolerance> tolerances) {
    return !compared(measured("value", 1.0), measured("value", 1.05),
                     {.tolerances = std::move(tolerances), .margin = {}})
                .worse.empty();
  };
  BOOST_TEST(!worse({{"", 0.2}}));
  BOOST_TEST(!worse({{"B: normal contact", 0.2}}));
  BOOST_TEST(!worse({{"B", 0.2}}));
  BOOST_TEST(!worse({{"a", 0.2}}));
  BOOST_TEST(worse({{"A", 0.2}, {"the fence", 0.2}, {"b", 0.2}}));
  BOOST_TEST(worse({{"", 0.2}, {"B", 0.0}}));
  BOOST_TEST(!worse({{"B", 0.0}, {"a", 0.2}}));
  BOOST_TEST(worse({{"a", 0.2}, {"", 0.01}}));
}

// --- Verdicts, bounds and margins -----------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(verdicts) {
  const CheckChange worse = compared(measured("value", 1.4), measured("value", 1.6), tolerance(1.0));
  BOOST_TEST(worse.worse == Reasons{Reason::verdict});
  BOOST_TEST(compared(measured("value", 1.6), measured("value", 1.4)).worse == Reasons{});
  BOOST_TEST(compared(measured("value", 1.6), measured("value", 1.6)).worse == Reasons{});
  BOOST_TEST(compared(measured("value", 1.6), measured("value", 1.7)).worse ==
             (Reasons{Reason::value, Reason::margin}));
  const auto results = [](double value) { return recorded_results({recorded_case("a", {measured("value", value)})}); };
  const Totals down = totals_of(compared(results(1.4), results(1.6)));
  BOOST_TEST(down.checks.worsened == 1u);
  BOOST_TEST(down.cases.worsened == 1u);
  const Totals up = totals_of(compared(results(1.6), results(1.4)));
  BOOST_TEST(up.checks.improved == 1u);
  BOOST_TEST(up.cases.improved == 1u);
  BOOST_TEST(up.worse() == 0u);
}

BOOST_AUTO_TEST_CASE(a_margin_limits_the_growth_of_error_over_bound) {
  const Check before = measured("value", 1.1, 0.5), tighter = measured("value", 1.1, 0.25);  // 0.2 -> 0.4
  BOOST_TEST(compared(before, tighter).movement == Movement::identical);
  BOOST_TEST(compared(before, tighter).growth == 0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(compared(before, tighter).worse == Reasons{Reason::margin});
  BOOST_TEST(compared(before, tighter, {.tolerances = {}, .margin = 0.19}).worse == Reasons{Reason::margin});
  BOOST_TEST(compared(before, tighter, {.tolerances = {}, .margin = 0.21}).worse == Reasons{});
  BOOST_TEST(compared(before, tighter, tolerance(0.21)).worse == Reasons{});  // The limit without --margin.
  // A given margin is the limit, whatever the tolerance.
  BOOST_TEST(compared(before, measured("value", 1.2), {.tolerances = {{"", 1.0}}, .margin = 0.1}).worse ==
             Reasons{Reason::margin});
  BOOST_TEST(compared(tighter, before).worse == Reasons{});
}

BOOST_AUTO_TEST_CASE(another_reference_counts_by_its_error) {
  const auto against = [](double reference) {
    return compare("value", 1.5, reference, Tolerance::model(0.5, "chosen"), "m");
  };
  BOOST_TEST(compared(against(1.5), against(1.25)).worse == Reasons{Reason::margin});
  BOOST_TEST(compared(against(1.25), against(1.5)).worse == Reasons{});
  const auto results = [&](double reference) { return recorded_results({recorded_case("a", {against(reference)})}); };
  BOOST_TEST(totals_of(compared(results(1.25), results(1.5))).references_changed == 1u);
}

BOOST_AUTO_TEST_CASE(bounds_are_counted) {
  const auto results = [](double bound) {
    return recorded_results({recorded_case("a", {measured("value", 1.0, bound)})});
  };
  BOOST_TEST(totals_of(compared(results(0.5), results(0.6))).bounds_widened == 1u);
  BOOST_TEST(totals_of(compared(results(0.6), results(0.5))).bounds_tightened == 1u);
  BOOST_TEST(totals_of(compared(results(0.5), results(0.6))).worse() == 0u);
}

BOOST_AUTO_TEST_CASE(controls) {
  const auto results = [](std::vector<Control> all) {
    return recorded_results({recorded_case("a", {measured("value", 1.1)}, std::move(all))});
  };
  const Comparison comparison =
      compared(results({control("kept"), control("blind"), control("mended", false), control("gone")}),
               results({control("kept"), control("blind", false), control("mended"), control("new")}));
  BOOST_TEST(find(comparison.controls, "a/control: kept").worse == Reasons{});
  BOOST_TEST(find(comparison.controls, "a/control: blind").worse == Reasons{Reason::verdict});
  BOOST_TEST(find(comparison.controls, "a/control: mended").worse == Reasons{});
  BOOST_TEST(find(comparison.controls, "a/control: gone").worse == Reasons{Reason::gone});
  BOOST_TEST(find(comparison.controls, "a/control: new").presence == Presence::added);
  const Totals totals = totals_of(comparison);
  BOOST_TEST(totals.controls.worse == 2u);
  BOOST_TEST(totals.controls.worsened == 1u);
  BOOST_TEST(totals.controls.improved == 1u);
  BOOST_TEST(totals.controls.gone == 1u);
  BOOST_TEST(totals.controls.added == 1u);
  BOOST_TEST(totals.controls.compared == 3u);
}

// --- Cases ----------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(checks_and_cases_that_are_gone_or_new) {
  const Comparison comparison =
      compared(recorded_results({recorded_case("a", {measured("kept", 1.1), measured("dropped", 1.1)}),
                                 recorded_case("b", {measured("value", 1.1)}, {control("fault")})}),
               recorded_results({recorded_case("a", {measured("kept", 1.1), measured("added", 1.1)}),
                                 recorded_case("c", {measured("value", 1.1)})}));
  BOOST_TEST(find(comparison.checks, "a/dropped").presence == Presence::gone);
  BOOST_TEST(find(comparison.checks, "a/dropped").worse == Reasons{Reason::gone});
  BOOST_TEST(find(comparison.checks, "a/added").presence == Presence::added);
  BOOST_TEST(find(comparison.checks, "a/added").worse == Reasons{});
  BOOST_TEST(find(comparison.cases, "a").checks_gone == 1u);
  const CaseChange gone = find(comparison.cases, "b");
  BOOST_TEST(gone.worse == Reasons{Reason::gone});
  BOOST_TEST(gone.checks_gone == 1u);
  BOOST_TEST(gone.controls_gone == 1u);
  BOOST_TEST(find(comparison.cases, "c").presence == Presence::added);
  BOOST_TEST(find(comparison.checks, "c/value").worse == Reasons{});
  const Totals totals = totals_of(comparison);
  BOOST_TEST(totals.checks.gone == 2u);
  BOOST_TEST(totals.checks.added == 2u);
  BOOST_TEST(totals.checks.compared == 1u);
  BOOST_TEST(totals.worse() == 4u);  // dropped; b, its check and its control
}

BOOST_AUTO_TEST_CASE(a_case_that_ends_otherwise) {
  const auto ended = [](Status status) {
    Record c = recorded_case("a", {});
    c.status = status;
    return recorded_results({c});
  };
  const auto worse = [&](Status before, Status after) { return compared(ended(before), ended(after)).cases[0].worse; };
  BOOST_TEST(worse(Status::pass, Status::timeout) == Reasons{Reason::status});
  BOOST_TEST(worse(Status::pass, Status::fail) == Reasons{Reason::status});
  BOOST_TEST(worse(Status::error, Status::pass) == Reasons{});
  BOOST_TEST(worse(Status::fail, Status::error) == Reasons{});
}

BOOST_AUTO_TEST_CASE(evaluations_and_seconds) {
  const auto spent = [](std::uint64_t evaluations, double seconds) {
    Record c = recorded_case("a", {});
    c.evaluations = evaluations;
    c.seconds = seconds;
    return recorded_results({c});
  };
  const auto worse = [&](std::uint64_t before, std::uint64_t after, double growth = 0.0) {
    return compared(spent(before, 1.0), spent(after, 1.0),
                    {.tolerances = {}, .margin = {}, .evaluation_growth = growth})
        .cases[0]
        .worse;
  };
  BOOST_TEST(worse(100, 100) == Reasons{});
  BOOST_TEST(worse(100, 101) == Reasons{Reason::evaluations});
  BOOST_TEST(worse(101, 100) == Reasons{});
  BOOST_TEST(worse(100, 110, 0.125) == Reasons{});
  BOOST_TEST(worse(100, 113, 0.125) == Reasons{Reason::evaluations});
  BOOST_TEST(worse(0, 50) == Reasons{});  // It counted none before.
  const Comparison slower = compared(spent(100, 1.0), spent(100, 1000.0));
  BOOST_TEST(totals_of(slower).worse() == 0u);
  BOOST_TEST(totals_of(slower).seconds_after == 1000.0);
  const Totals more = totals_of(compared(spent(100, 1.0), spent(150, 1.0)));
  BOOST_TEST(more.evaluations_grown == 1u);
  BOOST_TEST(more.evaluations_after == 150u);
}

BOOST_AUTO_TEST_CASE(only_the_cases_selected_are_compared) {
  const ResultsFile before = recorded_results(
      {recorded_case("a", {measured("value", 1.1)}, {control("f")}), recorded_case("b", {measured("value", 1.1)})});
  ResultsFile after = recorded_results({recorded_case("b", {measured("value", 1.1)})});
  BOOST_TEST(totals_of(compared(before, after)).worse() == 3u);  // Without --only, a is gone.
  after.results.only = {"b"};
  const Comparison by_run = compared(before, after);
  BOOST_TEST(totals_of(by_run).worse() == 0u);
  BOOST_TEST(by_run.unselected == std::vector<std::string>{"a"}, boost::test_tools::per_element());
  BOOST_TEST(by_run.checks.size() == 1u);
  // The same for two complete results.
  const Comparison by_option = compared(before, before, {.tolerances = {}, .margin = {}, .only = {"a"}});
  BOOST_TEST(by_option.cases.size() == 1u);
  BOOST_TEST(by_option.checks.size() == 1u);
  BOOST_TEST(by_option.controls.size() == 1u);
  BOOST_TEST(by_option.unselected == std::vector<std::string>{"b"}, boost::test_tools::per_element());
}

// --- Renames --------------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(renamed_items_are_compared) {
  const ResultsFile before = recorded_results({recorded_case(
      "old", {measured("x", 1.1), measured("y", 1.2), measured("z", 1.3)}, {control("f"), control("g")})});
  const ResultsFile after =
      recorded_results({recorded_case("new", {measured("x", 1.1), measured("why", 1.2)}, {control("f"), control("h")}),
                        recorded_case("other", {measured("z", 1.3)})});
  const Comparison comparison = compared(before, after, {},
                                         {{name("old"), name("new"), "r:1"},
                                          {name("old", "y"), name("new", "why"), "r:2"},
                                          {name("old", "z"), name("other", "z"), "r:3"},
                                          {name("old", "control: g"), name("new", "control: h"), "r:4"}});
  const Totals totals = totals_of(comparison);
  BOOST_TEST(totals.worse() == 0u);
  BOOST_TEST(totals.checks.compared == 3u);
  BOOST_TEST(totals.controls.compared == 2u);
  BOOST_TEST(totals.cases.compared == 1u);
  BOOST_TEST(totals.cases.added == 1u);
  BOOST_TEST(text_of(*find(comparison.checks, "new/why").renamed_from) == "old/y");
  BOOST_TEST(text_of(*find(comparison.checks, "new/x").renamed_from) == "old/x");
  BOOST_TEST(text_of(*find(comparison.cases, "new").renamed_from) == "old");
  BOOST_TEST(comparison.renaming_errors.empty());
}

BOOST_AUTO_TEST_CASE(a_rename_hides_no_difference) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("x", 1.1)})});
  const ResultsFile after = recorded_results({recorded_case("a", {measured("y", 1.2)})});
  const Comparison comparison = compared(before, after, {}, {{name("a", "x"), name("a", "y"), "r:1"}});
  BOOST_TEST(find(comparison.checks, "a/y").worse == (Reasons{Reason::value, Reason::margin}));
}

BOOST_AUTO_TEST_CASE(exchanged_names_are_compared_crosswise) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("x", 1.1), measured("y", 1.2)})});
  const ResultsFile after = recorded_results({recorded_case("a", {measured("x", 1.2), measured("y", 1.1)})});
  BOOST_TEST(totals_of(compared(before, after)).checks.worse == 2u);
  const Comparison comparison =
      compared(before, after, {}, {{name("a", "x"), name("a", "y"), "r:1"}, {name("a", "y"), name("a", "x"), "r:2"}});
  BOOST_TEST(totals_of(comparison).worse() == 0u);
  BOOST_TEST(comparison.renaming_errors.empty());
}

BOOST_AUTO_TEST_CASE(a_name_that_is_taken_by_a_rename_is_gone) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("y", 1.2), measured("x", 1.1)})});
  const ResultsFile after = recorded_results({recorded_case("a", {measured("y", 1.1)})});
  const Comparison comparison = compared(before, after, {}, {{name("a", "x"), name("a", "y"), "r:1"}});
  BOOST_REQUIRE(comparison.checks.size() == 2u);
  BOOST_TEST(comparison.checks[0].worse == Reasons{});
  BOOST_TEST(text_of(comparison.checks[1].name) == "a/y");
  BOOST_TEST(comparison.checks[1].worse == Reasons{Reason::gone});
}

BOOST_AUTO_TEST_CASE(what_was_removed_on_purpose_is_not_worse) {
  const ResultsFile before =
      recorded_results({recorded_case("a", {measured("x", 1.1), measured("y", 1.1)}, {control("f")}),
                        recorded_case("b", {measured("x", 1.1)})});
  const ResultsFile after = recorded_results({recorded_case("a", {measured("y", 1.1)})});
  const Comparison comparison = compared(before, after, {},
                                         {{name("a", "x"), std::nullopt, "r:1"},
                                          {name("a", "control: f"), std::nullopt, "r:2"},
                                          {name("b"), std::nullopt, "r:3"}});
  const Totals totals = totals_of(comparison);
  BOOST_TEST(totals.worse() == 0u);
  BOOST_TEST(totals.checks.removed == 2u);
  BOOST_TEST(totals.controls.removed == 1u);
  BOOST_TEST(totals.cases.removed == 1u);
}

BOOST_AUTO_TEST_CASE(renames_that_the_new_results_contradict) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("x", 1.1), measured("y", 1.1)})});
  const auto errors = [&](const ResultsFile& after, std::vector<Renaming> renames) {
    return compared(before, after, {}, renames).renaming_errors;
  };
  const ResultsFile after =
      recorded_results({recorded_case("a", {measured("x", 1.1), measured("z", 1.1)})}, "new.json");
  const auto absent = errors(after, {{name("a", "y"), name("a", "w"), "r:1"}});
  BOOST_REQUIRE(absent.size() == 1u);
  BOOST_TEST(absent[0] == "r:1: found 'a/w' on the right; it must be a name of new.json");
  const auto still = errors(after, {{name("a", "x"), name("a", "z"), "r:2"}});
  BOOST_REQUIRE(still.size() == 1u);
  BOOST_TEST(still[0].starts_with("r:2: found 'a/x'; new.json still has it"));
  BOOST_TEST(errors(after, {{name("a", "x"), std::nullopt, "r:3"}}).size() == 1u);
  BOOST_TEST(errors(after, {{name("a", "y"), name("a", "z"), "r:4"}}).empty());
  // A case that did not finish makes no check; and names that are not compared are not required.
  ResultsFile stopped = recorded_results({recorded_case("a", {})});
  stopped.results.records[0].status = Status::timeout;
  BOOST_TEST(errors(stopped, {{name("a", "y"), name("a", "w"), "r:1"}}).empty());
  ResultsFile partial = recorded_results({recorded_case("b", {})});
  partial.results.only = {"b"};
  BOOST_TEST(errors(partial, {{name("a", "y"), name("a", "w"), "r:1"}}).empty());
}

// --- Refused before a run ------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(what_is_refused_before_a_run) {
  const ResultsFile before = recorded_results({recorded_case("a", {measured("x", 1.1)}, {control("f")})});
  const auto refused = [&](const std::vector<ChangeTolerance>& tolerances, const std::vector<Renaming>& renames,
                           Tier tier = Tier::quick) -> std::string {
    try {
      validate(before, tier, {.tolerances = tolerances, .margin = {}}, renames, {"D: cables", "the fence"}, {"a", "b"});
    } catch (const talus::InputError& fault) {
      return fault.what();
    }
    return "";
  };
  BOOST_TEST(refused({{"", 1.0}, {"a", 1.0}, {"b", 1.0}, {"D", 1.0}, {"the fence", 1.0}}, {}) == "");
  BOOST_TEST(refused({}, {{name("a", "x"), name("b", "y"), "r:1"}, {name("a", "control: f"), std::nullopt, "r:2"}}) ==
             "");
  BOOST_TEST(refused({}, {}, Tier::full) ==
             "old.json: tier: found \"quick\"; it must be \"full\", the tier that it is compared with");
  const std::string family = refused({{"the fances", 1.0}}, {});
  BOOST_TEST(family.starts_with("--tolerance: family or case 'the fances' is not known; nearest: the fence; known: "),
             family);
  BOOST_TEST(!refused({{"Z", 1.0}}, {}).empty());
  BOOST_TEST(refused({}, {{name("a", "z"), name("a", "y"), "r:7"}})
                 .starts_with("r:7: found 'a/z' on the left; it must be a "));
  BOOST_TEST(refused({}, {{name("c"), std::nullopt, "r:8"}}).starts_with("r:8: found 'c' on the left"));
  BOOST_TEST(refused({}, {{name("a", "control: g"), std::nullopt, "r:8"}}).starts_with("r:8: found 'a/control: g'"));
  BOOST_TEST(
      refused({}, {{name("a", "x"), name("c", "x"), "r:9"}}).starts_with("r:9: case 'c' is not known; nearest: "));
  BOOST_TEST(refused({}, {{name("a"), name("b"), "r:10"}}).starts_with("r:10: found 'a'; this program still has it"));
  BOOST_TEST(
      refused({}, {{name("a"), std::nullopt, "r:10"}}).starts_with("r:10: found 'a'; this program still has it"));
  BOOST_CHECK_EXCEPTION(validate(recorded_results({}), Tier::quick, {}, {}, {}, {"a"}), talus::InputError,
                        [](const talus::InputError& fault) {
                          return std::string(fault.what()) == "old.json: cases: found none; there must be at least one";
                        });
}

BOOST_AUTO_TEST_SUITE_END()
