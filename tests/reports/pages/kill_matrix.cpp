#include "reports/pages/kill_matrix.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "reports/pages/mutants_page.hpp"

BOOST_AUTO_TEST_SUITE(kill_matrix_tests)

namespace {

using namespace talus::reports;
using talus::records::MutantStatus;
using talus::records::TrialEnd;

constexpr double infinity = std::numeric_limits<double>::infinity();

MutantRecord mutant(const std::string& id, const std::string& operation, std::vector<Trial> trials) {
  MutantRecord one;
  one.id = id;
  one.operation = operation;
  one.file = "solver/laws/hertz.hpp";
  one.original = "a + b";
  one.replacement = "a - b";
  one.range = {1, 1, 1, 6};
  one.trials = std::move(trials);
  one.status = one.trials.empty() ? MutantStatus::unreached : MutantStatus::survived;
  for (const Trial& trial : one.trials) {
    one.covered_by.push_back(trial.case_id);
    if (kills(trial)) one.status = MutantStatus::killed;
  }
  return one;
}

/// Four mutants that count, of which three are killed; one equivalent mutant; one bug.
Mutants some() {
  Mutants all;
  all.candidates = 100;
  all.whole_matrix = true;
  all.cases = {{"column", "contact", 2.0, false, true},
               {"hertz", "contact", 1.0, false, true},
               {"fence", "fences", 0.5, false, true}};
  all.mutants.push_back(
      mutant("m1", "sign", {{"column", TrialEnd::fail, 3.0, "force"}, {"hertz", TrialEnd::fail, 7.0, "depth"}}));
  all.mutants.push_back(mutant(
      "m2", "sign", {{"column", TrialEnd::fail, infinity, "same bits"}, {"fence", TrialEnd::pass, 0.4, "peak"}}));
  all.mutants.push_back(
      mutant("m3", "factor", {{"hertz", TrialEnd::timeout, infinity, ""}, {"column", TrialEnd::pass, 0.9, "force"}}));
  all.mutants.push_back(mutant("m4", "factor", {{"fence", TrialEnd::pass, 0.2, "peak"}}));
  all.mutants.push_back(mutant("m5", "factor", {}));
  all.mutants.back().status = MutantStatus::equivalent;
  all.mutants.push_back(mutant("b1", "bug", {{"fence", TrialEnd::fail, 1.5, "peak"}}));
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_score_leaves_out_what_is_equivalent) {
  const Mutants all = some();
  const Score score = score_of(generated(all));
  BOOST_TEST(score.killed == 3u);
  BOOST_TEST(score.survived == 1u);
  BOOST_TEST(score.equivalent == 1u);
  BOOST_TEST(score.fraction() == 0.75);
  BOOST_TEST(score_of(written(all)).killed == 1u);
  const auto by_operation = scores_by(generated(all), [](const MutantRecord& one) { return one.operation; });
  BOOST_TEST(by_operation.at("sign").fraction() == 1.0);
  BOOST_TEST(by_operation.at("factor").fraction() == 0.5);
}

BOOST_AUTO_TEST_CASE(what_recorded_results_alone_notice_is_counted_apart) {
  Mutants all = some();
  all.cases.push_back({"record", "program", 9.0, true});
  all.mutants[0].trials.push_back({"record", TrialEnd::fail, infinity, "bits"});
  MutantRecord& survivor = all.mutants[3];
  survivor.trials.push_back({"record", TrialEnd::fail, infinity, "bits"});
  survivor.covered_by.push_back("record");
  survivor.status = MutantStatus::killed;
  all.mutants.push_back(mutant("m6", "sign", {{"record", TrialEnd::fail, infinity, "bits"}}));
  BOOST_TEST(score_of(generated(all)).killed == 5u);
  const Mutants others = without_recorded(all);
  const Score score = score_of(generated(others));
  BOOST_TEST(score.killed == 3u);
  BOOST_TEST(score.survived == 1u);
  BOOST_TEST(score.unreached == 1u);
  BOOST_TEST(others.cases.size() == 3u);
  const std::string text = mutants_text(all, {}, false);
  BOOST_TEST(text.find("**5 of 5 generated mutants were killed: 100.0 %**") != std::string::npos);
  BOOST_TEST(text.find("Of them 2 are noticed by comparison with recorded results alone") != std::string::npos);
  BOOST_TEST(text.find("**Without it 3 are killed: 60.0 %**") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(curves_are_of_the_cases_of_the_matrix) {
  Mutants all = some();
  all.cases.push_back({"study", "fences", 40.0, false, false});
  all.mutants[3].trials.push_back({"study", TrialEnd::fail, infinity, "order"});
  all.mutants[3].covered_by.push_back("study");
  all.mutants[3].status = MutantStatus::killed;
  BOOST_TEST(score_of(generated(all)).killed == 4u);
  const Mutants matrix = of_matrix(all);
  BOOST_TEST(score_of(generated(matrix)).killed == 3u);
  BOOST_TEST(matrix.cases.size() == 3u);
  const std::vector<Figure> figures = mutants_figures(all);
  BOOST_REQUIRE(figures.size() == 3u);
  BOOST_TEST(figures[1].series[0].y.back() == 75.0);
  BOOST_TEST(figures[2].series[0].y.front() == 75.0);
}

BOOST_AUTO_TEST_CASE(wider_bounds_kill_less) {
  const Mutants all = some();
  const auto of = generated(all);
  BOOST_TEST(fraction_at(all, of, 1.0, "") == 0.75);
  BOOST_TEST(fraction_at(all, of, 5.0, "") == 0.75);
  BOOST_TEST(fraction_at(all, of, 10.0, "") == 0.5);
  BOOST_TEST(fraction_at(all, of, 1.0, "fences") == 0.0);
  BOOST_TEST(fraction_at(all, of, 1.0, "contact") == 0.75);
}

BOOST_AUTO_TEST_CASE(the_greedy_order_takes_the_best_first_and_of_equal_ones_the_faster) {
  const Mutants all = some();
  const auto order = greedy_order(all, generated(all));
  BOOST_REQUIRE(order.size() == 2u);
  BOOST_TEST(order[0].case_id == "hertz");
  BOOST_TEST(order[0].more == 2u);
  BOOST_TEST(order[1].case_id == "column");
  BOOST_TEST(order[1].more == 1u);
}

BOOST_AUTO_TEST_CASE(a_case_names_the_bugs_that_turn_it_red) {
  Mutants all = some();
  all.mutants.back().description = "The fence is doubled.";
  BOOST_TEST(bugs_text(all, "fence") == "- The fence is doubled.\n");
  BOOST_TEST(bugs_text(all, "column") == "- Generated [mutants](page:mutants): 2.\n");
  BOOST_TEST(bugs_text(all, "another") == "");
}

BOOST_AUTO_TEST_CASE(who_kills_alone) {
  const Mutants all = some();
  const auto alone = lone_killers(generated(all));
  BOOST_TEST(alone.size() == 2u);
  BOOST_TEST(alone.at("column") == 1u);
  BOOST_TEST(alone.at("hertz") == 1u);
  BOOST_TEST(killers(generated(all)).count("fence") == 0u);
}

BOOST_AUTO_TEST_CASE(wilsons_interval) {
  // Newcombe (1998), table of method 3: 81 of 263 gives 0.2553 to 0.3662.
  const Interval range = wilson(81, 263);
  BOOST_TEST(std::abs(range.low - 0.2553) < 5e-5);
  BOOST_TEST(std::abs(range.high - 0.3662) < 5e-5);
  BOOST_TEST(wilson(0, 0).high == 1.0);
}

BOOST_AUTO_TEST_CASE(what_was_not_tried_to_the_end_does_not_count) {
  Mutants stopped = some();
  stopped.mutants[3].status = MutantStatus::pending;
  const std::string text = mutants_text(stopped, {}, true);
  BOOST_TEST(text.find("3 of 3 generated mutants were killed: 100.0 %") != std::string::npos);
  BOOST_TEST(text.find("1 generated mutants were not tried to the end, and do not count. If none of them is killed the "
                       "score is 75.0 %.") != std::string::npos);
  MutantRecord other = stopped.mutants.back();
  other.id = "other", other.status = MutantStatus::pending, other.trials.clear();
  stopped.mutants.push_back(other);
  const std::string with_bug = mutants_text(stopped, {}, true);
  for (const char* part : {"Of 1 bugs written by hand 1 were killed", "1 other written bugs were not tried to the end.",
                           "Red: not tried to the end.\n"})
    BOOST_TEST(with_bug.find(part) != std::string::npos, with_bug);
  stopped.mutants.pop_back();
  const auto rows = [](const Mutants& of) { return mutants_figures(of)[0].y.max; };
  BOOST_TEST(*rows(stopped) == *rows(some()) - 1.0);
}

BOOST_AUTO_TEST_CASE(the_chapter_names_survivors_and_bugs) {
  const std::string text = mutants_text(some(), {}, true);
  const auto holds = [&](const char* part) { return text.find(part) != std::string::npos; };
  BOOST_TEST(holds("3 of 4 generated mutants were killed: 75.0 %"));
  BOOST_TEST(holds("## Survivors"));
  BOOST_TEST(holds("factor: `a + b`\\\n  becomes `a - b`\n"));
  BOOST_TEST(holds("Of 1 bugs written by hand 1 were killed"));
  BOOST_TEST(holds("| solver/laws/hertz.hpp | 3 | 1 | 0 | 1 | 75.0 % |"));
  BOOST_TEST(!holds("not tried to the end"));
  const auto figures = mutants_figures(some());
  BOOST_REQUIRE(figures.size() == 3u);
  BOOST_TEST(figures[1].series[0].y.back() == 75.0);
}

BOOST_AUTO_TEST_SUITE_END()
