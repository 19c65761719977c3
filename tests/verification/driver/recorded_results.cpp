// The reader of results.json for comparisons: all values that the driver writes are read with the same bits, and
// anything else is refused with its path.
#include "verification/driver/recorded_results.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "tests/verification/driver/synthetic_cases.hpp"
#include "tests/verification/driver/temporary_folder.hpp"
#include "verification/driver/case_run.hpp"
#include "verification/driver/results.hpp"

BOOST_AUTO_TEST_SUITE(recorded_results_tests)

using namespace talus::verification;
using nlohmann::json;

namespace {

/// Two cases, as the driver writes them.
Results two_cases() {
  Results results;
  results.provenance = provenance();
  results.registered = {"a", "b", "c"};
  results.selected = {"a", "b"};
  results.records = {run_case(synthetic("a", sound), Tier::quick),
                     unfinished(synthetic("b", sound), Status::timeout, "stopped")};
  results.records[0].seconds = 1.25;
  results.records[0].evaluations = 1234;
  return results;
}

std::string message_of(const std::string& file) {
  try {
    static_cast<void>(read_results(file));
  } catch (const talus::InputError& fault) {
    return fault.what();
  }
  return "it was read";
}

/// Checks that `text` of a results.json is refused by a message that begins with the file's name and `expected`.
void demand_refused(const std::string& text, const std::string& expected) {
  const TemporaryFolder folder;
  const std::string file = folder.write("results.json", text);
  const std::string message = message_of(file);
  BOOST_TEST(message.find(file + ": " + expected) == 0u,
             "'" << message << "' does not begin with '" << expected << "'");
}

void demand_refused(const std::function<void(json&)>& spoil, const std::string& expected) {
  json results = json::parse(text_of(two_cases()));
  spoil(results);
  demand_refused(results.dump(), expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_the_driver_writes_is_read_with_the_same_bits) {
  Results written = two_cases();
  const double awkward = 0.1 + 0.2;
  written.records[0].checks.push_back(
      compare("awkward", awkward, -0.0, Tolerance::round_off(1e-300, "chosen").relative(), "m/s"));
  written.records[0].checks.push_back(compare("lost", std::nan(""), 1.0, Tolerance::model(0.1, "chosen"), "m"));
  written.records[0].checks.push_back(
      compare("endless", -std::numeric_limits<double>::infinity(), 1.0, Tolerance::exact("chosen"), "m"));
  written.only = {"a", "b"};
  const TemporaryFolder folder;
  const RecordedResults results = read_results(folder.write("results.json", text_of(written)));
  BOOST_TEST((results.source.tier == Tier::quick));
  BOOST_TEST(!results.source.holds);
  BOOST_TEST(results.source.provenance.compiler == written.provenance.compiler);
  BOOST_TEST(results.source.provenance.libraries.size() == written.provenance.libraries.size());
  BOOST_TEST(results.registered == written.registered, boost::test_tools::per_element());
  BOOST_TEST(results.source.only == written.only, boost::test_tools::per_element());
  BOOST_REQUIRE(results.cases.size() == 2u);
  const RecordedCase& first = results.cases[0];
  BOOST_TEST(first.id == "a");
  BOOST_TEST(first.family == "founding problems");
  BOOST_TEST(first.outcome.seconds == 1.25);
  BOOST_TEST(first.outcome.evaluations == 1234u);
  BOOST_REQUIRE(first.checks.size() == 4u);
  BOOST_TEST(first.checks[0].measured == 1.05);
  BOOST_TEST(first.checks[0].pass);
  BOOST_TEST(first.checks[1].measured == awkward);
  BOOST_TEST(std::signbit(first.checks[1].reference));
  BOOST_TEST(first.checks[1].bound == 1e-300);
  BOOST_TEST(first.checks[1].relative);
  BOOST_TEST((first.checks[1].kind == Kind::round_off));
  BOOST_TEST(first.checks[1].unit == "m/s");
  BOOST_TEST(std::isnan(first.checks[2].measured));
  BOOST_TEST(std::isinf(first.checks[3].measured));
  BOOST_REQUIRE(first.controls.size() == 1u);
  BOOST_TEST(first.controls[0].pass);
  BOOST_TEST((results.cases[1].outcome.status == Status::timeout));
  BOOST_TEST(results.cases[1].outcome.message == "stopped");
  BOOST_TEST((results.cases[1].controls.at(0).observed == Colour::missing));
  BOOST_TEST((find_case(results, "b") == &results.cases[1]));
  BOOST_TEST((find_case(results, "c") == nullptr));
}

BOOST_AUTO_TEST_CASE(names_that_repeat_are_numbered) {
  json results = json::parse(text_of(two_cases()));
  json& checks = results["cases"][0]["checks"];
  checks.push_back(checks[0]);
  checks.push_back(checks[0]);
  results["cases"][0]["controls"].push_back(results["cases"][0]["controls"][0]);
  results["cases"][1]["id"] = "a";
  const TemporaryFolder folder;
  const RecordedResults read = read_results(folder.write("results.json", results.dump()));
  BOOST_TEST(read.cases[0].checks[0].name == "value");
  BOOST_TEST(read.cases[0].checks[1].name == "value #2");
  BOOST_TEST(read.cases[0].checks[2].name == "value #3");
  BOOST_TEST(read.cases[0].controls[1].name == "shifted #2");
  BOOST_TEST(read.cases[1].id == "a #2");
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_no_input_error) {
  const TemporaryFolder folder;
  const auto missing = (folder.path / "none.json").string();
  BOOST_CHECK_EXCEPTION(static_cast<void>(read_results(missing)), talus::IoError, [&](const talus::IoError& fault) {
    return std::string(fault.what()) == missing + ": No such file or directory";
  });
  BOOST_CHECK_EXCEPTION(static_cast<void>(read_results(folder.path)), talus::IoError,
                        [](const talus::IoError& fault) { return holds_text(fault.what(), "is a folder"); });
}

BOOST_AUTO_TEST_CASE(what_is_not_json_is_refused_with_its_place) {
  demand_refused("", "is empty");
  demand_refused("{\"schema\": 1,\n", "is truncated or not JSON: parse error at line 2, column 1");
  demand_refused("[]", "top level: found an array; it must be an object");
  demand_refused("{\"schema\": 1e999}", "is truncated or not JSON: number overflow");
  const std::string whole = text_of(two_cases());
  demand_refused(whole.substr(0, whole.size() / 2), "is truncated or not JSON");
}

BOOST_AUTO_TEST_CASE(another_schema_is_refused) {
  demand_refused([](json& r) { r["schema"] = 2; }, "schema: found 2; it must be 1");
  demand_refused([](json& r) { r.erase("schema"); }, "schema: found nothing; it must be 1");
  demand_refused([](json& r) { r["schema"] = "1"; }, "schema: found \"1\"; it must be 1");
}

BOOST_AUTO_TEST_CASE(a_field_of_another_type_is_refused_with_its_path) {
  demand_refused([](json& r) { r.erase("cases"); }, "cases: found nothing; it must be an array");
  demand_refused([](json& r) { r["tier"] = "slow"; }, "tier: found \"slow\"; it must be \"quick\" or \"full\"");
  demand_refused([](json& r) { r["tier"] = 1; }, "tier: found 1; it must be \"quick\" or \"full\"");
  demand_refused([](json& r) { r["verdict"] = "maybe"; }, "verdict: found \"maybe\"; it must be \"pass\" or \"fail\"");
  demand_refused([](json& r) { r["registered"][1] = 3; }, "registered[1]: found 3; it must be a string");
  demand_refused([](json& r) { r["only"] = "a"; }, "only: found \"a\"; it must be an array");
  demand_refused([](json& r) { r["provenance"]["libraries"] = 3; },
                 "provenance.libraries: found 3; it must be an object");
  demand_refused([](json& r) { r["provenance"].erase("flags"); },
                 "provenance.flags: found nothing; it must be a string");
  demand_refused([](json& r) { r["cases"][1] = nullptr; }, "cases[1]: found null; it must be an object");
  demand_refused([](json& r) { r["cases"][1]["id"] = ""; },
                 "cases[1].id: found \"\"; it must be a string that is not empty");
  demand_refused([](json& r) { r["cases"][1]["status"] = "lost"; }, "cases[1].status: found \"lost\"; it must be");
  demand_refused([](json& r) { r["cases"][0]["seconds"] = "nan"; },
                 "cases[0].seconds: found \"nan\"; it must be a number of at least 0");
  demand_refused([](json& r) { r["cases"][0]["evaluations"] = -1; },
                 "cases[0].evaluations: found -1; it must be an integer of at least 0");
  demand_refused([](json& r) { r["cases"][0]["evaluations"] = 1.5; },
                 "cases[0].evaluations: found 1.5; it must be an integer of at least 0");
}

BOOST_AUTO_TEST_CASE(a_check_or_control_that_is_not_one_is_refused) {
  const auto check = [](json& r) -> json& { return r["cases"][0]["checks"][0]; };
  demand_refused([&](json& r) { check(r)["measured"] = nullptr; },
                 "cases[0].checks[0].measured: found null; it must be a number, \"nan\", \"inf\" or \"-inf\"");
  demand_refused([&](json& r) { check(r)["measured"] = "1.0"; }, "cases[0].checks[0].measured: found \"1.0\"");
  demand_refused([&](json& r) { check(r).erase("margin"); }, "cases[0].checks[0].margin: found nothing; it must be");
  demand_refused([&](json& r) { check(r)["bound"] = "inf"; },
                 "cases[0].checks[0].bound: found \"inf\"; it must be a number of at least 0");
  demand_refused([&](json& r) { check(r)["kind"] = "guess"; }, "cases[0].checks[0].kind: found \"guess\"");
  demand_refused([&](json& r) { check(r)["relative"] = 0; },
                 "cases[0].checks[0].relative: found 0; it must be true or false");
  demand_refused([&](json& r) { check(r)["pass"] = false; },
                 "cases[0].checks[0].pass: found false; it must be true, because measured is 1.05");
  demand_refused([&](json& r) { check(r)["error"] = "nan"; },
                 "cases[0].checks[0].pass: found true; it must be false, because");
  const auto control = [](json& r) -> json& { return r["cases"][0]["controls"][0]; };
  demand_refused([&](json& r) { control(r)["observed"] = "blue"; },
                 "cases[0].controls[0].observed: found \"blue\"; it must be \"green\", \"red\" or \"missing\"");
  demand_refused([&](json& r) { control(r)["pass"] = false; },
                 "cases[0].controls[0].pass: found false; it must be true, because observed is \"red\"");
}

BOOST_AUTO_TEST_SUITE_END()
