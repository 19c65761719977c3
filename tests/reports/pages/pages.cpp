/// Text of the report from records made by hand: counts, and statements about missing parts.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "reports/base/error.hpp"
#include "reports/pages/claims.hpp"
#include "reports/pages/comparisons.hpp"
#include "reports/pages/coverage.hpp"
#include "reports/pages/front_page.hpp"
#include "reports/pages/pages.hpp"
#include "reports/pages/summary.hpp"

BOOST_AUTO_TEST_SUITE(pages_tests)

using namespace talus::reports;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Check check(const std::string& name, bool pass = true) {
  Check made;
  made.name = name;
  made.pass = pass;
  made.margin = pass ? 0.5 : 3.0;
  made.kind = Kind::model;
  return made;
}

Check order(const std::string& name, double measured) {
  Check made = check(name);
  made.order = true;
  made.measured = measured;
  return made;
}

Record record(const std::string& id, const std::string& family, std::vector<Check> checks) {
  Record made;
  made.id = id;
  made.title = "Title of " + id;
  made.family = family;
  made.checks = std::move(checks);
  made.seconds = 0.25;
  made.status = Status::pass;
  for (const Check& one : made.checks) {
    if (!one.pass) made.status = Status::fail;
  }
  return made;
}

Requirement requirement(const std::string& id, const std::string& group, std::vector<ShownBy> shown = {},
                        int order = 0) {
  Requirement made;
  made.id = id;
  made.group = group;
  made.text = group == "law" ? "contact law" : "text";
  made.shown_by = std::move(shown);
  made.order = order;
  return made;
}

Results results() {
  Results all;
  all.families = {"A: motion", "B: contact", "C: friction"};
  all.records = {record("bounce", "B: contact",
                        {order("order of rk4", 1.98), order("order of rk4, damped", 1.02), check("depth, clamped"),
                         order("order of the stiffness", 0.5), order("false order of rk4", 4.01)}),
                 record("flight", "A: motion", {check("height"), check("speed", false)})};
  all.requirements = {
      requirement("law.spring", "law", {{"bounce", {"depth, clamped", "order of rk4"}}}),
      requirement("end_rule.clamped", "end_rule", {{"bounce", {"depth, clamped"}}}),
      requirement("end_rule.attractive", "end_rule"),
      requirement("regime.spring.touching", "regime", {{"bounce", {"depth, clamped", "order of rk4"}}}),
      requirement("regime.spring.released", "regime"),
      requirement(
          "integrator.rk4", "integrator",
          {{"bounce", {"order of rk4", "order of rk4, damped", "order of the stiffness", "false order of rk4"}}}, 4),
      requirement("pair.circle.circle", "pair"),
      requirement("pair.circle.half_plane", "pair", {{"bounce", {"depth, clamped"}}}),
  };
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_summary_goes_by_families_and_adds_them_up) {
  const std::string text = summary_by_family(results());
  BOOST_TEST(contains(text, "| **A: motion** | *0 of 1 case* |"), text);
  BOOST_TEST(contains(text, "| **B: contact** | *1 case* |"), text);
  BOOST_TEST(contains(text, "**1 of 2**"), text);
  BOOST_TEST(contains(text, "**fail**"), text);
  BOOST_TEST(!contains(text, "C: friction"), text);
  BOOST_TEST(text.find("A: motion") < text.find("[flight]"));
  BOOST_TEST(text.find("[flight]") < text.find("B: contact"));
  BOOST_TEST(text.find("B: contact") < text.find("[bounce]"));
}

// A template that no page uses is a chapter that the report has lost.
BOOST_AUTO_TEST_CASE(the_report_has_each_chapter) {
  Results all = results();
  all.records.clear();
  std::string text;
  for (const ReportPage& page : report_pages(all, talus::records::Audits{}, Drawn{}, TALUS_TEMPLATES, "", ""))
    text += page.main + "\n" + page.details + "\n";
  std::size_t chapters = 0;
  for (const auto& entry : std::filesystem::directory_iterator{std::filesystem::path{TALUS_TEMPLATES} / "chapters"}) {
    std::string heading;
    std::getline(std::ifstream{entry.path()}, heading);
    BOOST_TEST(contains(text, heading + "\n"), entry.path().filename());
    ++chapters;
  }
  BOOST_TEST(chapters >= 14U);
}

BOOST_AUTO_TEST_CASE(the_ladder_counts_cases_by_their_evidence) {
  Results all = results();
  all.records[0].evidence = {Evidence::closed_form, Evidence::property};
  all.records[0].page = "**Conclusion.** It\nholds\\!\n\n**Problem.** A disc.";
  all.records[0].not_shown = "friction | spin.";
  all.records[1].evidence = {Evidence::property};
  const std::string ladder = ladder_of_claims(all);
  BOOST_TEST(contains(ladder, "| 1 | 1 |\n| independent integration"), ladder);
  BOOST_TEST(contains(ladder, "| 2 | 1 |\n| earlier result"), ladder);
  BOOST_TEST(contains(ladder, "| A: motion | - | - | - | - | - | 1 | - |"), ladder);
  BOOST_TEST(contains(ladder, "| B: contact | - | 1 | - | - | - | - | - |"), ladder);
  const std::string claims = claims_of_cases(all);
  BOOST_TEST(contains(claims, "| closed form, property | It holds\\! | friction \\| spin. |"), claims);
  BOOST_TEST(contains(claims, "| property | \u2013 | \u2013 |"), claims);
}

BOOST_AUTO_TEST_CASE(verified_is_what_has_checks_and_none_that_failed) {
  Results all = results();
  all.requirements.push_back(requirement("A1", "A: motion", {{"flight", {"height"}}}));
  all.requirements.push_back(requirement("A2", "A: motion", {{"flight", {"height", "speed"}}}));  // speed failed
  all.requirements.push_back(requirement("B1", "B: contact", {{"bounce", {"height"}}}));
  all.requirements.push_back(requirement("C1", "C: friction", {{"flight", {}}}));  // claimed, no check ran
  BOOST_TEST(verified(all) ==
             "1 force laws, 1 of 2 of their regimes, 1 integrators, 1 of 2 pairs of shapes in contact, "
             "2 of 4 problems of the catalogue have checks in this run, all of which pass.");
  const std::string open = not_verified(all);
  BOOST_TEST(contains(open,
                      "end rule attractive; mode released of the law spring; a circle in contact with a circle; "
                      "text (A2); text (C1) ("),
             open);
  all.requirements = {requirement("B1", "B: contact", {{"bounce", {"depth, clamped"}}})};
  BOOST_TEST(contains(not_verified(all), "Every listed requirement has checks, all of which pass."));
  all.requirements.clear();
  for (int i = 1; i <= 15; ++i)
    all.requirements.push_back(requirement("A" + std::to_string(i), "A: motion"));
  BOOST_TEST(contains(not_verified(all), "text (A11); text (A12); 3 more ("), not_verified(all));
}

BOOST_AUTO_TEST_CASE(findings_show_what_their_checks_measured) {
  Results all = results();
  all.findings = {{"bounce", "Order <<order of rk4>>, damped <<order of rk4, damped>>: $x_1$."},
                  {"elsewhere", "Not selected: <<nothing>>."},
                  {"flight", "Second."}};
  BOOST_TEST(findings(all) ==
             "1. Order 1.98, damped 1.02: $x_1$. ([bounce](page:bounce))\n1. Second. ([flight](page:flight))\n");
  all.records[0].status = Status::timeout;  // of a case that broke off nothing is quoted
  BOOST_TEST(findings(all) == "1. Second. ([flight](page:flight))\n");
  all.findings = {{"flight", "<<no such check>>"}};
  BOOST_CHECK_EXCEPTION(static_cast<void>(findings(all)), RecordError, [](const RecordError& wrong) {
    return std::string(wrong.what()) == "findings: case 'flight' has no check 'no such check'";
  });
  all.findings = {{"flight", "<<height"}};
  BOOST_CHECK_THROW(static_cast<void>(findings(all)), RecordError);
}

BOOST_AUTO_TEST_CASE(the_pictures_of_the_first_page_are_in_rows_of_two) {
  Results all = results();
  for (Record& each : all.records)
    each.figures = {{.name = "f", .title = "F", .caption = "", .x = {}, .y = {}}};
  all.highlights = {
      {"bounce", "f", "One."}, {"elsewhere", "f", "No."}, {"flight", "f", "Two."}, {"bounce", "f", "Three."}};
  const std::string text = highlights(all);
  const auto row = [&](const std::string& cells) { BOOST_TEST(contains(text, cells), text); };
  row("| ![](figures/front-bounce-f.svg){alt=\"bounce\" width=48%} | ![](figures/front-flight-f.svg){alt=\"flight\" "
      "width=48%} |");
  row("| One. [bounce](page:bounce) | Two. [flight](page:flight) |");
  row("| Three. [bounce](page:bounce) | ");
  all.highlights = {{"flight", "g", "None."}};
  BOOST_CHECK_EXCEPTION(static_cast<void>(highlights(all)), RecordError, [](const RecordError& wrong) {
    return std::string(wrong.what()) == "highlights: case 'flight' has no figure 'g'";
  });
}

BOOST_AUTO_TEST_CASE(links_lead_within_a_volume_to_the_other_and_to_pages) {
  const std::vector<ReportPage> pages{
      {"index", "First", "", "# First\n[a](page:a) [d](details:a)\n", "# Second\n"},
      {"a", "A", "family", "# a: A\n![](figures/a.svg)\n", "## Details of a\n[m](page:m)\n"},
      {"b", "B", "family", "# b\n", "## Details of b\n[a](page:a)\n"},
      {"m", "Mutants", "", "", "# Mutants\n"}};
  const std::string main = volume_text(pages, Volume::main), details = volume_text(pages, Volume::details);
  BOOST_TEST(contains(main, "[a](#a-a) [d](verification-details.md#details-of-a)"), main);
  BOOST_TEST(contains(details, "[m](#mutants)"), details);
  BOOST_TEST(contains(details, "[a](verification.md#a-a)"), details);
  BOOST_TEST(details.find("# family\n") == details.rfind("# family\n"));  // once for its cases
  BOOST_TEST(site_text(pages, pages[0]) == "# First\n[a](a.html) [d](a.html#details-of-a)\n");
  BOOST_TEST(site_text(pages, pages[1]) == "# a: A\n![](../figures/a.svg)\n\n## Details of a\n[m](m.html)\n");
  const std::vector<ReportPage> dead{{"index", "First", "", "# First\n[x](page:x)\n", ""}};
  BOOST_CHECK_THROW(static_cast<void>(volume_text(dead, Volume::main)), OutputError);
}

BOOST_AUTO_TEST_CASE(a_case_without_a_family_is_not_lost) {
  Results all = results();
  all.records.push_back(record("stray", "", {check("value")}));
  BOOST_TEST(contains(summary_by_family(all), "| **others** | *1 case* |"));
}

BOOST_AUTO_TEST_CASE(the_worst_margin_shows_the_verdict) {
  Results all = results();
  const auto worst_of = [&](std::vector<Check> checks) {
    all.records = {record("near", "A: motion", std::move(checks))};
    return summary_by_family(all);
  };
  Check passes = check("passes"), fails = check("fails", false);
  passes.margin = 0.9996;
  fails.margin = 1.0;  // error > bound; the quotient was rounded
  BOOST_TEST(contains(worst_of({check("value"), passes}), "| 0.999 | 0.25 |"), worst_of({check("value"), passes}));
  BOOST_TEST(contains(worst_of({passes, fails, check("value")}), "| 1.001 | 0.25 |"));
  BOOST_TEST(contains(failures(all), "| **1.001** |"), failures(all));
}

BOOST_AUTO_TEST_CASE(coverage_counts_checks_and_names_empty_cells) {
  const std::string text = coverage(results(), nullptr);
  BOOST_TEST(contains(text, "| spring | touching 2, released **none** |"), text);
  // One of the law's two checks is of the clamped end rule, none of the attractive one.
  BOOST_TEST(contains(text, "| spring | 1 | **none** |"), text);
  // A declared order 4 that no check shows, and orders 2 and 1 with contacts; the order in the stiffness is not counted
  // as one of the method, nor as a false one.
  BOOST_TEST(contains(text, "| rk4 | 4 | **none** | 1.02 (1); 1.98 (1) | 4 |"), text);
  BOOST_TEST(contains(text, "| circle | **none** | 1 |"), text);
}

BOOST_AUTO_TEST_CASE(coverage_counts_the_mutants_that_checks_noticed) {
  Results all = results();
  all.records.push_back(record("files", "G: the program", {check("history.csv: rows"), check("history.csv: names")}));
  talus::records::Mutants mutants;
  const auto mutant = [](const std::string& id, const std::string& case_id, std::vector<std::string> failed) {
    talus::records::MutantRecord made{.id = id, .status = talus::records::MutantStatus::killed};
    made.trials.push_back({.case_id = case_id, .end = talus::records::TrialEnd::fail, .failed = std::move(failed)});
    return made;
  };
  const ShownBy touching = std::ranges::find(all.requirements, "regime.spring.touching", &Requirement::id)->shown_by[0];
  mutants.mutants = {mutant("one", touching.case_id, {touching.checks[0], "another"}),
                     mutant("two", "files", {"history.csv: rows", "history.csv: names"}),
                     mutant("three", "other", {"history.csv: rows"})};
  const std::string text = coverage(all, &mutants);
  BOOST_TEST(contains(text, "how many of 3 [mutants]"), text);
  BOOST_TEST(contains(text, "| spring | touching 2 (1), released **none** |"), text);
  BOOST_TEST(contains(text, "| circle | **none** | 1 (1) |"), text);
  BOOST_TEST(contains(text, "| 4 (**0**) |"), text);  // the integrator
  BOOST_TEST(contains(text, "| history.csv | `files` | 2 (1) |"), text);
  // Only if each was run with each case, a 0 is a gap.
  BOOST_TEST(contains(text, "A **0** may be a gap"), text);
  mutants.whole_matrix = true;
  BOOST_TEST(contains(coverage(all, &mutants), "A **0** is a gap"));
  mutants.cases = {{.id = "files"}};
  BOOST_TEST(contains(coverage(all, &mutants), "A **0** may be a gap"));
  mutants.cases.clear();
  mutants.mutants[2].status = talus::records::MutantStatus::pending;
  BOOST_TEST(contains(coverage(all, &mutants),
                      "how many of 2 [mutants](page:mutants) at least one of these checks "
                      "noticed. A **0** may be a gap"));
}

BOOST_AUTO_TEST_CASE(common_formulas_are_gathered_from_the_cases) {
  Results all = results();
  BOOST_TEST(common_formulas(all) == "None so far.\n");
  all.records[0].tables = {{"speeds", "Not this one.", {"a"}, {{"1"}}},
                           {"common_formula_e", "**Restitution.**", {"where", "exact"}, {{"$e$ = 0.5", "0.550"}}}};
  const std::string text = common_formulas(all);
  BOOST_TEST(contains(text, "**Restitution.** Case [bounce]"), text);
  BOOST_TEST(contains(text, "| $e$ = 0.5 | 0.550 |"), text);
  BOOST_TEST(!contains(text, "Not this one"));
}

BOOST_AUTO_TEST_CASE(what_peers_check_and_we_do_not_says_none) {
  Results all = results();
  all.peers = {{"code", "test 1", "falls", "$gt$", {"A1"}, "", {"flight"}},
               {"code", "test 2", "sticks", "glue", {}, "no glue", {}}};
  const std::string text = checks_of_peers(all);
  BOOST_TEST(contains(text, "| code | test 1 | falls | $gt$ | [flight](page:flight) (A1) |"), text);
  BOOST_TEST(contains(text, "**none**: no glue"), text);
}

BOOST_AUTO_TEST_SUITE_END()
