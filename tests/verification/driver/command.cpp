// The driver from its command line to its exit status.
#include "verification/driver/command.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tests/verification/driver/driver_run.hpp"
#include "tests/verification/driver/synthetic_cases.hpp"

BOOST_AUTO_TEST_SUITE(command_tests)

using namespace talus::verification;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What `work` writes to a standard stream (STDOUT_FILENO or STDERR_FILENO).
template <class Work>
std::string printed(int stream, Work&& work) {
  std::fflush(nullptr);
  const int saved = ::dup(stream);
  std::FILE* const file = std::tmpfile();
  ::dup2(::fileno(file), stream);
  work();
  std::fflush(nullptr);
  ::dup2(saved, stream), ::close(saved);
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file))
    text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(wrong_options_are_reported_like_other_names) {
  const std::string help = "\nhelp: talus_verify --help\n";
  const auto message = [](const std::vector<std::string>& options) {
    return printed(STDERR_FILENO, [&] { BOOST_TEST(Run({synthetic("sound", sound)}, options).status == 2); });
  };
  const std::string unknown = message({"--cases", "sound"});
  BOOST_TEST(unknown.starts_with("talus_verify: option '--cases' is not known; nearest: "), unknown);
  BOOST_TEST(unknown.ends_with(help), unknown);
  BOOST_TEST(message({"sound", "--cases"}) == "talus_verify: 'sound' is one argument too many" + help);
  BOOST_TEST(message({"--only", "soud"}) ==
             "talus_verify: --only: case 'soud' is not known; nearest: sound; known: sound\n");
}

BOOST_AUTO_TEST_CASE(the_lines_of_a_failure_give_bound_and_rounding) {
  const Case wrong = synthetic("wrong", [](Findings& f, const Setup&) {
    f.expect("near", 1.3, 1.0, Tolerance::model(0.25, "chosen"));
    f.expect("far", 3.0, 1.0, Tolerance::model(0.25, "chosen"), "m");
  });
  const std::string text = printed(STDOUT_FILENO, [&] {
    BOOST_TEST(Run({wrong}, {"--rounding", "upward"}).status == 1);
  });
  const std::string far = "wrong.far: measured 3 m, reference 1 m, bound 0.25 m, error/bound 8 (chosen)";
  BOOST_TEST(text.find("         " + far + "; rounding upward\n") != std::string::npos, text);
  BOOST_TEST(
      text.find("wrong.near: measured 1.3, reference 1, bound 0.25, error/bound 1.2 (chosen); rounding upward\n") !=
          std::string::npos,
      text);
  BOOST_TEST(text.find("; rounding upward\nread first: " + far + "\nresults: ") != std::string::npos, text);
}

// An exact check, whose error/bound is infinite, comes after those with a bound.
BOOST_AUTO_TEST_CASE(failed_cases_are_listed_by_their_largest_finite_error) {
  const auto with_error = []<int quarters>(const std::string& id, std::integral_constant<int, quarters>) {
    return synthetic(id, [](Findings& f, const Setup&) {
      f.expect("count", 1.0, 0.0, Tolerance::exact("counted"));
      if (quarters > 0) f.expect("far", 0.25 * quarters, 0.0, Tolerance::model(0.25, "chosen"));
    });
  };
  const std::vector<Case> cases{with_error("counted", std::integral_constant<int, 0>{}),
                                with_error("near", std::integral_constant<int, 2>{}),
                                with_error("far", std::integral_constant<int, 12>{})};
  const std::string text = printed(STDOUT_FILENO, [&] { BOOST_TEST(Run(cases, {}).status == 1); });
  BOOST_TEST(
      text.find("\nread first: far.far: measured 3, reference 0, bound 0.25, error/bound 12 (chosen)\n"
                "then: near.far: error/bound 2\nthen: counted.count: error/bound inf\nresults: ") != std::string::npos,
      text);
}

BOOST_AUTO_TEST_CASE(cases_that_end_by_an_error_are_named_at_the_end) {
  const auto broken = [](const std::string& id) {
    return synthetic(id, [](Findings&, const Setup&) { throw std::runtime_error{"no file"}; });
  };
  const std::vector<Case> cases{broken("first"), synthetic("whole", sound), broken("second")};
  const std::string text = printed(STDOUT_FILENO, [&] { BOOST_TEST(Run(cases, {}).status == 1); });
  BOOST_TEST(
      text.find("\nwithout a verdict, ended by an error or a limit: first, second\nresults: ") != std::string::npos,
      text);
}

BOOST_AUTO_TEST_CASE(eight_failures_and_the_controls_that_are_not_judged_are_printed) {
  const Case wrong = synthetic("wrong", [](Findings& f, const Setup&) {
    f.expect("value", 3.0, 1.0, Tolerance::model(0.25, "chosen"));
    for (int i = 2; i <= 10; ++i)
      f.expect(std::string(static_cast<std::size_t>(i), 'x'), i, 0.0, Tolerance::model(1.0, "chosen"));
  });
  const std::string text = printed(STDOUT_FILENO, [&] { BOOST_TEST(Run({wrong}, {}).status == 1); });
  const auto has = [&](const std::string& line) { return text.find("         " + line) != std::string::npos; };
  BOOST_TEST(has("wrong.xxxxxxxxxx: measured 10, "), text);
  BOOST_TEST(has("wrong.xxxx: measured 4, "), text);
  BOOST_TEST(!has("wrong.xxx: "), text);
  BOOST_TEST(has("and 2 more, in its record\n"), text);
  BOOST_TEST(has("wrong: controls whose checks fail without the fault, too: shifted\n"), text);
  BOOST_TEST(!has("wrong: control 'shifted'"), text);
}

BOOST_AUTO_TEST_CASE(no_case_at_all_fails) {
  const Run run({});
  BOOST_TEST(run.status == 1);
  BOOST_TEST(run.results.at("verdict") == "fail");
}

BOOST_AUTO_TEST_CASE(measurements_are_cases_beside_the_others) {
  const std::vector<Case> cases{synthetic("first", sound)};
  const Folder empty;
  BOOST_TEST(Run(cases, {"--data", empty.path.string()}).status == 2);  // no file
  BOOST_TEST(Run(cases, {"--data", (empty.path / "none").string()}).status == 4);
  const Run measured(cases, {"--data", TALUS_MEASURED, "--only", "rebound"});
  BOOST_TEST(measured.status == 0);
  BOOST_TEST(measured.results.at("registered") == json({"first", "rebound"}));
  BOOST_TEST(measured.record().at("family") == "V: validation by measurements");
  BOOST_TEST(measured.record().at("evidence") == json({"measurement"}));
  BOOST_TEST(Run(cases, {"--only", "rebound"}).status == 2);
  BOOST_TEST(Run({synthetic("rebound", sound)}, {"--data", TALUS_MEASURED}).status == 1);  // the id is used twice
}

BOOST_AUTO_TEST_CASE(only_selects_and_says_so) {
  const std::vector<Case> cases{synthetic("first", sound), synthetic("second", sound), synthetic("third", sound)};
  const Run run(cases, {"--only", "third,first"});
  BOOST_TEST(run.status == 0);
  BOOST_TEST(run.results.at("registered").size() == 3u);
  BOOST_TEST(run.results.at("selected") == json({"first", "third"}));
  BOOST_TEST(run.results.at("cases").size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_wrong_command_line_is_two) {
  const std::vector<Case> cases{synthetic("first", sound)};
  BOOST_TEST(Run(cases, {"--only", "frist"}).status == 2);
  BOOST_TEST(Run(cases, {"--bogus"}).status == 2);
  BOOST_TEST(Run(cases, {"--jobs", "0"}).status == 2);
  BOOST_TEST(Run(cases, {"--jobs", "many"}).status == 2);
  BOOST_TEST(Run(cases, {"--quick", "--full"}).status == 2);
  BOOST_TEST(Run(cases, {"--help"}).status == 0);
  BOOST_TEST(Run(cases, {"--list"}).status == 0);
}

BOOST_AUTO_TEST_CASE(a_case_of_the_full_tier_waits_for_it) {
  Case longer = synthetic("longer", sound);
  longer.tier = Tier::full;
  const std::vector<Case> cases{synthetic("first", sound), longer};
  BOOST_TEST(Run(cases).results.at("selected") == json({"first"}));
  BOOST_TEST(Run(cases, {"--full"}).results.at("selected") == json({"first", "longer"}));
  BOOST_TEST(Run(cases, {"--only", "longer"}).status == 2);
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_is_four) {
  const char* argv[] = {"talus_verify", "--out", "/dev/null/results"};
  BOOST_TEST(verify({synthetic("first", sound)}, TALUS_CATALOGUE, 3, argv) == 4);
}

// No case runs, and no results are written; those of an earlier run remain.
BOOST_AUTO_TEST_CASE(a_wrong_catalogue_is_two_and_one_that_is_not_there_four) {
  const Folder made;
  const fs::path& folder = made.path;
  const std::string out = (folder / "out").string();
  const char* argv[] = {"talus_verify", "--out", out.c_str()};
  BOOST_TEST(verify({synthetic("first", sound)}, folder / "none", 3, argv) == 4);
  fs::copy(TALUS_CATALOGUE, folder / "wrong", fs::copy_options::recursive);
  std::ofstream(folder / "wrong" / "errata.toml", std::ios::app) << "\n[[eratum]]\n";
  BOOST_TEST(verify({synthetic("first", sound)}, folder / "wrong", 3, argv) == 2);
  BOOST_TEST(!fs::exists(out));
}

BOOST_AUTO_TEST_CASE(the_results_do_not_depend_on_the_number_of_jobs) {
  const std::vector<Case> cases{synthetic("first", sound), synthetic("second", sound), synthetic("third", sound)};
  json one = Run(cases, {"--jobs", "1"}).results;
  json three = Run(cases, {"--jobs", "3"}).results;
  for (json* results : {&one, &three}) {
    for (auto& record : results->at("cases"))
      record.erase("seconds");
    results->erase("provenance");
  }
  BOOST_TEST(one == three);
}

BOOST_AUTO_TEST_SUITE_END()
