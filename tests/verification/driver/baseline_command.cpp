// `talus_verify --baseline` and `--compare` from the command line to the exit status.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tests/verification/driver/synthetic_cases.hpp"
#include "tests/verification/driver/text_parts.hpp"
#include "verification/driver/command.hpp"

BOOST_AUTO_TEST_SUITE(baseline_command_tests)

using namespace talus::verification;
using nlohmann::json;

namespace {

int run(const std::vector<Case>& cases, std::vector<std::string> options) {
  options.insert(options.begin(), "talus_verify");
  std::vector<const char*> argv;
  for (const auto& option : options)
    argv.push_back(option.c_str());
  return verify(cases, TALUS_CATALOGUE, static_cast<int>(argv.size()), argv.data());
}

/// A case that measures another value than `sound`, within its bound of 0.1 or not.
template <int hundredths>
void measuring(Findings& findings, const Setup& setup) {
  findings.expect("value", setup.has("shifted") ? 2.0 : 1.0 + 0.01 * hundredths, 1.0, Tolerance::model(0.1, "chosen"));
}

/// The same as `sound`, under another name.
void renamed(Findings& findings, const Setup& setup) {
  findings.expect("value of the same", setup.has("shifted") ? 2.0 : 1.05, 1.0, Tolerance::model(0.1, "chosen"));
}

/// `sound` with n evaluations.
template <unsigned n>
void counting(Findings& findings, const Setup& setup) {
  sound(findings, setup);
  findings.count(n);
}

Case renamed_case(const std::string& id = "a") {
  Case c = synthetic(id, renamed);
  c.requirements = {{"Eq. 14", {"value of the same"}}};
  c.main_checks = {"value of the same"};
  c.faults[0].turns_red = "value of the same";
  return c;
}

/// A folder with the results of cases a and b as baseline, in old/results.json.
struct Baseline {
  Folder folder;
  std::string file = (folder.path / "old" / "results.json").string();
  std::string out = (folder.path / "new").string();

  explicit Baseline(const std::vector<Case>& cases = {synthetic("a", sound), synthetic("b", sound)},
                    std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--out", (folder.path / "old").string()});
    BOOST_REQUIRE(run(cases, options) == 0);
  }

  /// Runs cases and compares them with the baseline.
  int against(const std::vector<Case>& cases, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"--out", out, "--baseline", file});
    return run(cases, options);
  }

  json comparison() const { return json::parse(folder.text("new/baseline.json")); }
};

const std::vector<Case> same{synthetic("a", sound), synthetic("b", sound)};
const std::vector<Case> other{synthetic("a", measuring<3>), synthetic("b", sound)};  // 0.2 bounds nearer

}  // namespace

BOOST_AUTO_TEST_CASE(an_identical_run_is_zero) {
  const Baseline baseline;
  BOOST_TEST(baseline.against(same) == 0);
  BOOST_TEST(baseline.comparison().at("verdict") == "not worse");
  BOOST_TEST(baseline.comparison().at("totals").at("values").at("identical") == 2);
  BOOST_TEST(holds_text(baseline.folder.text("new/baseline.md"), "nothing is worse than the baseline"));
  BOOST_TEST(!std::filesystem::exists(baseline.out + "/baseline.json.part"));
}

BOOST_AUTO_TEST_CASE(a_changed_value_is_six) {
  const Baseline baseline;
  BOOST_TEST(baseline.against(other) == 6);
  BOOST_TEST(baseline.comparison().at("checks").at(0).at("worse") == json({"value"}));
  BOOST_TEST(holds_text(baseline.folder.text("new/results.json"), "\"verdict\": \"pass\""));
}

BOOST_AUTO_TEST_CASE(a_run_that_fails_is_one_whatever_the_comparison_says) {
  const Baseline baseline;
  BOOST_TEST(baseline.against({synthetic("a", measuring<30>), synthetic("b", sound)}) == 1);
  BOOST_TEST(baseline.comparison().at("verdict") == "worse");
  BOOST_TEST(baseline.comparison().at("results").at("verdict") == "fail");
}

BOOST_AUTO_TEST_CASE(tolerances_of_a_family_a_case_and_all) {
  const Baseline baseline;
  const auto status = [&](std::initializer_list<std::string> options) { return baseline.against(other, options); };
  BOOST_TEST(status({"--tolerance", "0.21"}) == 0);
  BOOST_TEST(status({"--tolerance", "0.19"}) == 6);
  BOOST_TEST(status({"--tolerance", "founding problems=0.21"}) == 0);
  BOOST_TEST(status({"--tolerance", "founding problems=0.19"}) == 6);
  BOOST_TEST(status({"--tolerance=a=0.21"}) == 0);
  BOOST_TEST(status({"--tolerance", "b=0.21"}) == 6);
  BOOST_TEST(status({"--tolerance", "0.21", "--tolerance", "a=0"}) == 6);
  BOOST_TEST(status({"--tolerance", "a=0", "--tolerance", "0.21"}) == 0);
  BOOST_TEST(baseline.comparison().at("allowed").at("tolerances").size() == 2u);
}

BOOST_AUTO_TEST_CASE(margin_and_round_off_and_evaluations) {
  const Baseline baseline({synthetic("a", counting<100>)});
  const std::vector<Case> farther{synthetic("a", measuring<7>)};  // error/bound 0.5 -> 0.7, no evaluations
  BOOST_TEST(baseline.against(farther, {"--tolerance", "0.3"}) == 0);
  BOOST_TEST(baseline.against(farther, {"--tolerance", "0.3", "--margin", "0.1"}) == 6);
  BOOST_TEST(baseline.comparison().at("checks").at(0).at("worse") == json({"error/bound"}));
  const std::vector<Case> rounded{synthetic("a", [](Findings& findings, const Setup& setup) {
    findings.expect("value", setup.has("shifted") ? 2.0 : 1.05 - 1e-15, 1.0, Tolerance::model(0.1, "chosen"));
  })};
  BOOST_TEST(baseline.against(rounded) == 6);
  BOOST_TEST(baseline.comparison().at("checks").at(0).at("worse") == json({"round_off"}));
  BOOST_TEST(baseline.against(rounded, {"--allow-round-off"}) == 0);
  BOOST_TEST(baseline.against(farther, {"--allow-round-off"}) == 6);
  BOOST_TEST(baseline.against({synthetic("a", counting<110>)}) == 6);
  BOOST_TEST(baseline.against({synthetic("a", counting<110>)}, {"--evaluation-growth", "0.1"}) == 0);
  BOOST_TEST(baseline.against({synthetic("a", counting<90>)}) == 0);
}

BOOST_AUTO_TEST_CASE(cases_that_are_gone_and_new) {
  const Baseline baseline;
  BOOST_TEST(baseline.against({synthetic("a", sound)}) == 6);
  BOOST_TEST(baseline.comparison().at("totals").at("cases").at("gone") == 1);
  BOOST_TEST(baseline.against({synthetic("a", sound), synthetic("b", sound), synthetic("c", sound)}) == 0);
  BOOST_TEST(baseline.comparison().at("totals").at("cases").at("new") == 1);
}

BOOST_AUTO_TEST_CASE(only_compares_the_selected_cases) {
  const Baseline baseline;
  BOOST_TEST(baseline.against(same, {"--only", "b"}) == 0);
  BOOST_TEST(baseline.comparison().at("totals").at("cases").at("gone") == 0);
  BOOST_TEST(baseline.comparison().at("unselected") == json({"a"}));
  BOOST_TEST(baseline.against(other, {"--only", "b"}) == 0);
  BOOST_TEST(baseline.against(other, {"--only", "a"}) == 6);
}

BOOST_AUTO_TEST_CASE(a_case_that_moved_to_the_full_tier_is_gone_from_the_quick_one) {
  const Baseline baseline;
  Case longer = synthetic("b", sound);
  longer.tier = Tier::full;
  BOOST_TEST(baseline.against({synthetic("a", sound), longer}) == 6);
  BOOST_TEST(baseline.comparison().at("totals").at("cases").at("gone") == 1);
}

BOOST_AUTO_TEST_CASE(tiers_must_be_equal) {
  const Baseline full(same, {"--full"});
  BOOST_TEST(full.against(same) == 2);
  BOOST_TEST(!std::filesystem::exists(full.out));  // No case was run.
  BOOST_TEST(full.against(same, {"--full"}) == 0);
}

BOOST_AUTO_TEST_CASE(renames) {
  const Baseline baseline({synthetic("old", sound)});
  const std::vector<Case> now{renamed_case("new")};
  const auto status = [&](const std::string& text) {
    return baseline.against(now, {"--renamed", baseline.folder.file("renames.txt", text)});
  };
  BOOST_TEST(baseline.against(now) == 6);
  BOOST_TEST(status("old -> new\nold/value -> new/value of the same\n") == 0);
  BOOST_TEST(baseline.comparison().at("checks").at(0).at("renamed_from") == "old/value");
  BOOST_TEST(status("old -> new\n") == 6);
  BOOST_TEST(status("old -> -\n") == 0);
  std::filesystem::remove_all(baseline.out);
  BOOST_TEST(status("older -> new\n") == 2);
  BOOST_TEST(status("old -> newer\n") == 2);
  BOOST_TEST(status("old = new\n") == 2);
  BOOST_TEST(!std::filesystem::exists(baseline.out));  // All three were refused before any case was run.
  // The name of a check is known only after it was made.
  BOOST_TEST(status("old -> new\nold/value -> new/valeu\n") == 2);
  BOOST_TEST(baseline.comparison().at("renaming_errors").size() == 1u);
}

BOOST_AUTO_TEST_CASE(the_baseline_may_be_in_the_output_folder) {
  const Baseline baseline;
  const auto old = baseline.folder.path / "old";
  BOOST_TEST(run(other, {"--out", old.string(), "--baseline", baseline.file}) == 6);
  BOOST_TEST(run(other, {"--out", old.string(), "--baseline", baseline.file}) == 0);  // It is the new baseline now.
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(old);
  BOOST_TEST(run(same, {"--out", ".", "--baseline", "results.json"}) == 6);
  std::filesystem::current_path(here);
}

BOOST_AUTO_TEST_CASE(a_comparison_left_from_before_is_removed) {
  const Baseline baseline;
  BOOST_TEST(baseline.against(same) == 0);
  BOOST_TEST(run(same, {"--out", baseline.out}) == 0);
  BOOST_TEST(!std::filesystem::exists(baseline.out + "/baseline.json"));
  BOOST_TEST(!std::filesystem::exists(baseline.out + "/baseline.md"));
}

BOOST_AUTO_TEST_CASE(a_baseline_that_cannot_be_read_runs_nothing) {
  const Baseline baseline;
  const auto status = [&](const std::string& file) { return run(same, {"--out", baseline.out, "--baseline", file}); };
  BOOST_TEST(status(baseline.file + ".none") == 4);
  BOOST_TEST(status(baseline.folder.path.string()) == 4);
  BOOST_TEST(status(baseline.folder.file("empty.json", "")) == 2);
  BOOST_TEST(status(baseline.folder.file("text.json", "results")) == 2);
  BOOST_TEST(status(baseline.folder.file("schema.json", "{\"schema\": 7}")) == 2);
  json wrong = json::parse(baseline.folder.text("old/results.json"));
  wrong["verdict"] = "fail";
  BOOST_TEST(status(baseline.folder.file("verdict.json", wrong.dump())) == 2);
  wrong = json::parse(baseline.folder.text("old/results.json"));
  wrong["cases"][0]["checks"][0]["measured"] = "1.0";
  BOOST_TEST(status(baseline.folder.file("measured.json", wrong.dump())) == 2);
  for (const char* const list : {"checks", "controls"}) {
    wrong = json::parse(baseline.folder.text("old/results.json"));
    json& twice = wrong["cases"][0][list];
    twice.push_back(twice[0]);
    ++wrong["counts"][list].get_ref<json::number_unsigned_t&>();
    BOOST_TEST(status(baseline.folder.file("twice.json", wrong.dump())) == 2, list);
  }
  BOOST_TEST(baseline.against(same, {"--renamed", baseline.file + ".none"}) == 4);
  BOOST_TEST(!std::filesystem::exists(baseline.out));
}

BOOST_AUTO_TEST_CASE(wrong_options_are_two) {
  const Baseline baseline;
  for (const std::vector<std::string>& options :
       std::initializer_list<std::vector<std::string>>{{"--tolerance", "much"},
                                                       {"--tolerance", "nan"},
                                                       {"--tolerance", "inf"},
                                                       {"--tolerance=-1"},
                                                       {"--tolerance", "=1"},
                                                       {"--tolerance", "a="},
                                                       {"--tolerance", "no such family=1"},
                                                       {"--margin", "x"},
                                                       {"--margin=-0.1"},
                                                       {"--evaluation-growth", "1 %"},
                                                       {"--only", "frist"}}) {
    BOOST_TEST_CONTEXT(options.back()) {
      BOOST_TEST(baseline.against(same, options) == 2);
      BOOST_TEST(!std::filesystem::exists(baseline.out));
    }
  }
  for (const std::vector<std::string>& options :
       std::initializer_list<std::vector<std::string>>{{"--tolerance", "0.1"},
                                                       {"--margin", "0.1"},
                                                       {"--renamed", "x"},
                                                       {"--allow-round-off"},
                                                       {"--evaluation-growth", "0.1"},
                                                       {"--compare", baseline.file}})
    BOOST_TEST_CONTEXT(options.front()) BOOST_TEST(run(same, options) == 2);
  for (const char* const other_option : {"--quick", "--full", "--list"})
    BOOST_TEST(baseline.against(same, {"--compare", baseline.file, other_option}) == 2, other_option);
  BOOST_TEST(baseline.against(same, {"--compare", baseline.file, "--jobs", "1"}) == 2);
}

BOOST_AUTO_TEST_CASE(an_input_that_would_be_overwritten_is_refused) {
  const Baseline baseline;
  std::filesystem::create_directories(baseline.out);
  const std::string file = baseline.out + "/baseline.json";
  std::filesystem::copy_file(baseline.file, file);
  BOOST_TEST(run(same, {"--out", baseline.out, "--baseline", file}) == 2);
  BOOST_TEST(baseline.folder.text("new/baseline.json") == baseline.folder.text("old/results.json"));
}

BOOST_AUTO_TEST_CASE(two_files_are_compared_without_a_run) {
  const Baseline baseline;
  const Baseline changed(other);
  const std::string out = (baseline.folder.path / "comparison").string();
  const auto status = [&](const std::string& file, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"--compare", file, "--baseline", baseline.file, "--out", out});
    return run({}, options);
  };
  BOOST_TEST(status(baseline.file) == 0);
  BOOST_TEST(status(changed.file) == 6);
  BOOST_TEST(std::filesystem::exists(out + "/baseline.json"));
  BOOST_TEST(std::filesystem::exists(out + "/baseline.md"));
  BOOST_TEST(!std::filesystem::exists(out + "/results.json"));
  BOOST_TEST(std::filesystem::exists(baseline.file));
  BOOST_TEST(status(changed.file, {"--tolerance", "0.21"}) == 0);
  BOOST_TEST(status(changed.file, {"--only", "b"}) == 0);
  BOOST_TEST(status(changed.file, {"--only", "z"}) == 2);
  BOOST_TEST(status(changed.file + ".none") == 4);
  BOOST_TEST(status(baseline.folder.file("text.json", "results")) == 2);
  const Baseline full(same, {"--full"});
  BOOST_TEST(status(full.file) == 2);
  const Baseline partial(same, {"--only", "a"});
  BOOST_TEST(status(partial.file) == 0);  // The file records that only a was run.
  BOOST_TEST(baseline.against({synthetic("a", measuring<30>), synthetic("b", sound)}) == 1);
  BOOST_TEST(status(baseline.out + "/results.json") == 1);
}

BOOST_AUTO_TEST_CASE(a_comparison_that_cannot_be_written_is_four) {
  const Baseline baseline;
  BOOST_TEST(run({}, {"--compare", baseline.file, "--baseline", baseline.file, "--out", "/dev/null/none"}) == 4);
}

BOOST_AUTO_TEST_SUITE_END()
