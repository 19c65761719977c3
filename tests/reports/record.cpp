#define BOOST_TEST_MODULE reports_record
#include "reports/record.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "reports/error.hpp"
#include "tests/reports/scratch.hpp"

using nlohmann::json;
using talus::reports::RecordError;

namespace {

json sample() {
  std::ifstream stream(std::string(TALUS_TEST_DATA) + "/pass/results.json");
  return json::parse(stream);
}

/// Reads the sample after a change to it.
talus::reports::Results read_changed(const std::function<void(json&)>& change) {
  const Scratch scratch("record");
  json document = sample();
  change(document);
  std::ofstream(scratch.folder / "results.json") << document;
  return talus::reports::read_results(scratch.folder / "results.json");
}

/// The complaint about a changed sample, empty when there is none.
std::string complaint(const std::function<void(json&)>& change) {
  try {
    static_cast<void>(read_changed(change));
  } catch (const RecordError& wrong) {
    return wrong.what();
  }
  return {};
}

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(a_good_record_is_read) {
  const auto results = read_changed([](json&) {});
  BOOST_TEST(results.cases.size() == 2U);
  BOOST_TEST(results.cases[0].id == "two_cable");
  BOOST_TEST(results.cases[0].checks[0].main);
  BOOST_TEST(results.cases[0].figures[1].slopes[0].order == 0.5);
}

BOOST_AUTO_TEST_CASE(complaints_name_file_and_field) {
  const std::string missing = complaint([](json& d) { d["cases"][0]["checks"][2].erase("why"); });
  BOOST_TEST(names(missing, "results.json"));
  BOOST_TEST(names(missing, "cases[0].checks[2].why: is missing"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"][0]["why"] = " "; }), "why: must not be empty"));
  BOOST_TEST(
      names(complaint([](json& d) { d["cases"][0]["checks"][0]["kind"] = "guess"; }), "known: exact, round_off"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"][0]["bound"] = "big"; }), "must be a number"));
  BOOST_TEST(names(complaint([](json& d) { d["schema"] = 2; }), "schema 1 only"));
  BOOST_TEST(names(complaint([](json& d) { d["provenance"]["date"] = "today"; }), "provenance.date"));
  BOOST_TEST(names(complaint([](json& d) { d["provenance"]["date"] = "2026-02-30"; }), "is not a date"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["figures"][0]["csv"] = "../x.csv"; }), "plain file name"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["tables"][0]["rows"][0].erase(0); }), "has 3 cells"));
}

BOOST_AUTO_TEST_CASE(records_that_contradict_themselves_are_refused) {
  BOOST_TEST(names(complaint([](json& d) { d["counts"]["checks"] = 99; }), "counts.checks: says 99"));
  BOOST_TEST(names(complaint([](json& d) { d["counts"]["exempt"] = 99; }), "counts.exempt: says 99"));
  BOOST_TEST(
      names(complaint([](json& d) { d["registered"].push_back("lost"); }), "selected case 'lost' has 0 records"));
  BOOST_TEST(names(complaint([](json& d) { d["registered"].erase(1); }), "'pendulum' was not registered"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"][0]["margin"] = 1.5; }), "passes although"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"][0]["margin"] = "nan"; }), "passes although"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"].clear(); }), "passes without a check"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["controls"][0]["pass"] = false; }), "green control"));
  BOOST_TEST(names(complaint([](json& d) { d["cases"][0]["checks"][1]["name"] = d["cases"][0]["checks"][0]["name"]; }),
                   "occurs twice"));
  const auto failed_but_passing = [](json& d) {
    d["cases"][0]["status"] = "fail";
    d["cases"][0]["message"] = "x";
    d["counts"]["passed"] = 1;
    d["counts"]["failed"] = 1;
  };
  BOOST_TEST(names(complaint(failed_but_passing), "verdict: is pass"));
}

BOOST_AUTO_TEST_CASE(a_selection_of_the_registered_cases_may_run) {
  const auto select_one_more = [](json& d) {
    d["registered"].push_back("timestep");
    d["selected"] = {"two_cable", "pendulum"};
  };
  const auto results = read_changed(select_one_more);
  BOOST_TEST(results.registered.size() == 3U);
  BOOST_TEST(results.selected.size() == 2U);
  BOOST_TEST(names(complaint([](json& d) { d["selected"] = {"two_cable"}; }), "'pendulum' was not registered"));
  BOOST_TEST(names(complaint([](json& d) {
                     d["selected"] = {"two_cable", "pendulum", "x"};
                   }),
                   "'x' is not registered"));
}

BOOST_AUTO_TEST_CASE(what_a_control_measured_and_what_shows_a_requirement_are_read) {
  const auto results = read_changed([](json& d) {
    d["tier"] = "full";
    d["cases"][0]["controls"][0].update({{"measured", 2.0}, {"reference", 1.0}, {"error", 1.0}, {"bound", nullptr}});
    d["requirements"][0]["shown_by"] = json::array({{{"case", "two_cable"}, {"checks", {"a", "b"}}}});
  });
  BOOST_TEST(results.tier == "full");
  BOOST_TEST(results.cases[0].controls[0].measured == 2.0);
  BOOST_TEST(std::isnan(results.cases[0].controls[0].bound));
  BOOST_TEST(results.requirements[0].shown_by[0].checks.size() == 2U);
}

BOOST_AUTO_TEST_CASE(a_null_margin_is_told_by_the_error) {
  const auto results = read_changed([](json& d) { d["cases"][0]["checks"][4]["margin"] = nullptr; });
  BOOST_TEST(results.cases[0].checks[4].margin == 0.0);
}

BOOST_AUTO_TEST_CASE(broken_json_is_the_records_fault) {
  const Scratch scratch("record");
  std::ofstream(scratch.folder / "results.json") << "{\"schema\": 1,";
  BOOST_CHECK_THROW(static_cast<void>(talus::reports::read_results(scratch.folder / "results.json")), RecordError);
  BOOST_CHECK_THROW(static_cast<void>(talus::reports::read_results(scratch.folder / "none.json")),
                    talus::reports::OutputError);
}

BOOST_AUTO_TEST_CASE(dates_are_seconds) {
  BOOST_TEST(talus::reports::epoch_seconds("1970-01-02T00:00:01Z") == 86401);
  BOOST_TEST(talus::reports::epoch_seconds("2000-03-01") == 951868800);
}
