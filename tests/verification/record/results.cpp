#include "verification/record/results.hpp"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "tests/verification/record/fields.hpp"
#include "verification/record/record_files.hpp"
#include "verification/record/results_fields.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(results_tests)

using namespace talus::records;

namespace {

const fs::path sample_file = fs::path(TALUS_TEST_DATA) / "pass" / "results.json";

Json sample() { return Json::parse(read_whole(sample_file)); }

Results read(const Json& document) {
  Results results;
  read_into(Node{document, "results.json: results"}, results, Completeness::complete);
  return results;
}

/// Error message for a changed sample; empty if there is none.
std::string refused(const std::function<void(Json&)>& change) {
  Json document = sample();
  change(document);
  return error_message([&] { (void)read(document); });
}

/// Results in which no field has its default value; the case has one check.
Results full_results() {
  Results results;
  results.provenance = {.revision = "8ca10df",
                        .dirty = true,
                        .compiler = "GNU",
                        .flags = "-O3",
                        .build_type = "Release",
                        .cpu = "a processor",
                        .cores = 8,
                        .os = "Debian",
                        .libraries = {{"fmt", "9.1.0"}, {"Boost", "1.74.0"}},
                        .date = "2026-03-01T12:00:00Z"};
  results.tier = Tier::full;
  results.registered = {"b", "a"};
  results.selected = {"a"};
  results.only = results.selected;
  Record record;
  record.id = "a";
  record.title = "A";
  record.family = "founding problems";
  record.page = "Page.";
  record.status = Status::pass;
  record.checks = {{.name = "value", .unit = "1", .why = "same", .pass = true}};
  results.records = {record};
  results.requirements = {{"Eq. 21", "equation", "one line", {{"a", {"value"}}}, 0},
                          {"integrator.rk4", "integrator", "Runge", {}, 4}};
  results.families = {"founding problems", "the fence"};
  results.errata = {{"E1", "p. 63", "printed", "corrected", "evidence", "a"}};
  results.peers = {{"lammps", "test", "what", "form", {"Eq. 21"}, "remark", {"a"}}};
  results.findings = {{"a", "It is <<value>>."}};
  results.highlights = {{"a", "f", "See."}};
  results.bibliography = "@misc{a,\n}\n";
  return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(results_come_back_the_same) {
  const Folder folder;
  const Results all = full_results();
  write_whole(folder.path / "results.json", text_of(all));
  const Results back = read_results(folder.path / "results.json");
  BOOST_TEST(text_of(back) == text_of(all));
  const Provenance &p = back.provenance, &q = all.provenance;
  BOOST_TEST((p.revision == q.revision && p.dirty == q.dirty && p.compiler == q.compiler && p.flags == q.flags));
  BOOST_TEST((p.build_type == q.build_type && p.cpu == q.cpu && p.cores == q.cores && p.os == q.os));
  BOOST_TEST((p.libraries == q.libraries && p.date == q.date));  // libraries in their order
  BOOST_TEST((back.tier == all.tier && back.registered == all.registered && back.selected == all.selected));
  BOOST_TEST((back.records.size() == 1u && back.records[0].checks.size() == 1u));
  const Requirement &shown = back.requirements[0], &order = back.requirements[1];
  BOOST_TEST((shown.id == "Eq. 21" && shown.group == "equation" && shown.text == "one line" && shown.order == 0));
  BOOST_TEST((shown.shown_by.at(0).case_id == "a" && shown.shown_by[0].checks.at(0) == "value"));
  BOOST_TEST((order.order == 4 && order.shown_by.empty()));
  BOOST_TEST(back.families == all.families);
  const Erratum& e = back.errata.at(0);
  BOOST_TEST((e.id == "E1" && e.where == "p. 63" && e.printed == "printed" && e.corrected == "corrected"));
  BOOST_TEST((e.evidence == "evidence" && e.case_id == "a"));
  const Peer& peer = back.peers.at(0);
  BOOST_TEST((peer.suite == "lammps" && peer.id == "test" && peer.what == "what" && peer.form == "form"));
  BOOST_TEST((peer.problems.at(0) == "Eq. 21" && peer.remark == "remark" && peer.cases.at(0) == "a"));
  BOOST_TEST((back.findings.at(0).case_id == "a" && back.findings[0].text == "It is <<value>>."));
  const Highlight& seen = back.highlights.at(0);
  BOOST_TEST((seen.case_id == "a" && seen.figure == "f" && seen.caption == "See."));
  BOOST_TEST(back.bibliography == "@misc{a,\n}\n");
}

BOOST_AUTO_TEST_CASE(each_absent_or_wrong_field_is_refused_by_its_path) {
  demand_strict(Json::parse(text_of(full_results())), "results.json: results",
                {"order", "fmt", "Boost", "message", "bibliography", "only", "findings", "highlights"},
                [](const Json& json) { (void)read(json); });
}

BOOST_AUTO_TEST_CASE(a_good_file_is_read_and_written_to_the_same_bytes) {
  const Results results = read_results(sample_file);
  BOOST_TEST(results.records.size() == 2u);
  BOOST_TEST(results.records[0].id == "two_cable");
  BOOST_TEST(results.records[0].checks[0].main);
  BOOST_TEST(results.records[0].figures[1].slopes[0].order == 0.5);
  BOOST_TEST(results.records[0].figures[1].series[0].columns.where == "attractive end");
  const Folder folder;
  write_whole(folder.path / "once.json", text_of(results));
  BOOST_TEST(text_of(read_results(folder.path / "once.json")) == read_whole(folder.path / "once.json"));
}

BOOST_AUTO_TEST_CASE(errors_name_file_and_path) {
  BOOST_TEST(refused([](Json& d) { d["cases"][0]["checks"][2].erase("why"); }) ==
             "results.json: results.cases[0].checks[2].why: is missing");
  BOOST_TEST(holds(refused([](Json& d) { d["schema"] = 2; }), "results.schema: must be 1, found 2"));
  BOOST_TEST(holds(refused([](Json& d) { d["provenance"]["date"] = "today"; }), "provenance.date: 'today' is not"));
  BOOST_TEST(holds(refused([](Json& d) { d["provenance"]["date"] = "2026-02-30"; }), "is not a date"));
  BOOST_TEST(holds(refused([](Json& d) { d["cases"][0]["figures"][0]["csv"] = "../x.csv"; }), "plain file name"));
  BOOST_TEST(holds(refused([](Json& d) { d["cases"][0]["tables"][0]["rows"][0].erase(0); }), "has 3 cells"));
  const Folder folder;
  BOOST_TEST(holds(error_message([&] { (void)read_results(folder.file("results.json", "{\"schema\": 1,")); }),
                   "results.json: is truncated or not JSON"));
  BOOST_CHECK_THROW((void)read_results(folder.path / "none.json"), FileError);
}

BOOST_AUTO_TEST_CASE(results_that_contradict_themselves_are_refused) {
  for (const char* count :
       {"cases", "passed", "failed", "checks", "checks_failed", "slack", "exempt", "controls", "controls_failed"}) {
    const std::string expected = refused([&](Json& d) { d["counts"][count] = 99; });
    BOOST_TEST(holds(expected, fmt::format("results.counts.{}: must be ", count)), expected);
    BOOST_TEST(holds(expected, ", which the cases hold, found 99"), expected);
  }
  BOOST_TEST(holds(refused([](Json& d) { d["verdict"] = "fail"; }),
                   "results.verdict: must be \"pass\", which follows from the cases, found \"fail\""));
  BOOST_TEST(holds(refused([](Json& d) { d["requirements"][12]["checks"] = 6; }), "checks: must be 7"));
  BOOST_TEST(holds(refused([](Json& d) { d["requirements"][12]["cases"] = Json::array(); }), "cases: must be [\"two_"));
  BOOST_TEST(holds(refused([](Json& d) { d["registered"].push_back("pendulum"); }), "registered: names a case twice"));
  const auto twice = [](Json& d) {
    d["selected"].push_back("pendulum");
    d["verdict"] = "fail";
  };
  BOOST_TEST(holds(refused(twice), "selected: names a case twice"));
  const auto lost = [](Json& d) {
    d["registered"].push_back("lost");
    d["selected"].push_back("lost");
    d["verdict"] = "fail";
  };
  BOOST_TEST(holds(refused(lost), "selected case 'lost' has 0 records"));
  BOOST_TEST(holds(refused([](Json& d) { d["registered"].erase(1); }), "'pendulum' is not registered"));
  const auto unselected = [](Json& d) {
    d["selected"].erase(1);
    d["verdict"] = "fail";
  };
  BOOST_TEST(holds(refused(unselected), "'pendulum' was not registered and selected"));
  BOOST_TEST(holds(refused([](Json& d) { d["cases"][0]["family"] = "fences"; }),
                   "case 'two_cable' is of family 'fences', which is not listed; listed: cables, motion"));
  BOOST_TEST(holds(refused([](Json& d) { d["cases"][0]["checks"][0]["margin"] = 1.5; }), "its margin does not follow"));
}

BOOST_AUTO_TEST_CASE(a_selection_of_the_registered_cases_may_run) {
  BOOST_TEST(refused([](Json& d) { d["registered"].push_back("timestep"); }) == "");
}

BOOST_AUTO_TEST_CASE(dates_are_seconds) {
  BOOST_TEST(epoch_seconds("1970-01-02T00:00:01Z") == 86401);
  BOOST_TEST(epoch_seconds("2000-03-01") == 951868800);
  for (const char* text : {"", "2000-13-01", "2000-02-30", "2000-01-01T25:00:00Z", "yesterday"})
    BOOST_CHECK_THROW((void)epoch_seconds(text), RecordError);
}

BOOST_AUTO_TEST_SUITE_END()
