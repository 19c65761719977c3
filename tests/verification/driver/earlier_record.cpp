// Records of an earlier run that are not made again (--reuse).
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tests/verification/driver/driver_run.hpp"
#include "tests/verification/driver/synthetic_cases.hpp"
#include "verification/check/case_file.hpp"

BOOST_AUTO_TEST_SUITE(earlier_record_tests)

using namespace talus::verification;
namespace fs = std::filesystem;

namespace {

/// A folder whose files can be taken out.
struct Scratch : Folder {
  /// Text of a file, which is then removed; empty if there is none.
  std::string take(const std::string& name) const {
    const std::string taken = text(name);
    fs::remove(path / name);
    return taken;
  }
};

/// A case that records how it is run: a letter for the right setup, the coarse one, and each fault; in capitals in the
/// full tier.
Case noted(const std::string& id, double full_seconds) {
  Case one = synthetic(id, [](Findings& f, const Setup& setup) {
    std::string letter = !setup.fault.empty() ? "f" : setup.coarse ? "c" : "r";
    if (setup.tier == Tier::full) letter[0] = static_cast<char>(std::toupper(letter[0]));
    std::ofstream(spoiled_folder, std::ios::app) << letter;
    f.expect("value", setup.fault.empty() ? 1.0 : 2.0, 1.0, Tolerance::model(0.1, "chosen"));
  });
  one.full_seconds = full_seconds;
  return one;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_the_same_program_found_is_taken_over) {
  const Scratch scratch;
  const std::string out = (scratch.path / "out").string(), letters = "letters", data = "data";
  spoiled_folder = (scratch.path / letters).string();
  scratch.file(data, "1\n");
  const auto letters_of = [&](const Case& one, std::vector<const char*> options) {
    options.insert(options.begin(), {"talus_verify", "--out", out.c_str()});
    BOOST_TEST(
        verify({one}, TALUS_CATALOGUE, static_cast<int>(options.size()), options.data(), {scratch.path / data}) == 0);
    return scratch.take(letters);
  };
  const Case plain = noted("plain", 0.0), longer = noted("longer", 1.0);
  BOOST_TEST(letters_of(plain, {}) == "rcf");
  BOOST_TEST(letters_of(longer, {}) == "rcf");
  // A case without a full part is the same in both tiers; for another case the controls are.
  BOOST_TEST(letters_of(plain, {"--full", "--reuse"}) == "");
  BOOST_TEST(letters_of(longer, {"--full", "--reuse"}) == "R");
  BOOST_TEST(letters_of(plain, {"--full"}) == "rcf");
  BOOST_TEST(letters_of(longer, {"--full"}) == "Rcf");
  // A file that cases read has changed.
  scratch.file(data, "2\n");
  BOOST_TEST(letters_of(plain, {"--reuse"}) == "rcf");
  BOOST_TEST(letters_of(plain, {"--reuse"}) == "");
  // The record has changed, or a file of it is missing.
  const fs::path record = fs::path{out} / "plain" / "record.json";
  std::ofstream(record, std::ios::app) << "\n";
  BOOST_TEST(letters_of(plain, {"--reuse"}) == "rcf");
  fs::remove(record);
  BOOST_TEST(letters_of(plain, {"--reuse"}) == "rcf");
  // Records of other rounding modes are not reused.
  BOOST_TEST(letters_of(plain, {"--rounding", "upward"}) == "rcf");
  BOOST_TEST(letters_of(plain, {"--reuse"}) == "rcf");
}

BOOST_AUTO_TEST_CASE(a_failed_case_is_run_again) {
  const Scratch scratch;
  const std::string out = (scratch.path / "out").string();
  const Case failing = synthetic("failing", [](Findings& f, const Setup&) {
    std::ofstream(spoiled_folder, std::ios::app) << "x";
    f.expect("value", 3.0, 1.0, Tolerance::model(0.1, "chosen"));
  });
  spoiled_folder = (scratch.path / "letters").string();
  const std::vector<const char*> options{"talus_verify", "--out", out.c_str(), "--reuse"};
  for (int run = 0; run < 2; ++run) {
    BOOST_TEST(verify({failing}, TALUS_CATALOGUE, 4, options.data()) == 1);
    BOOST_TEST(!scratch.take("letters").empty());
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_taken_over_under_another_rounding) {
  BOOST_TEST(Run({synthetic("sound", sound)}, {"--reuse", "--rounding", "upward"}).status == 2);
}

// Cases read the changed copy of cases/, and what they found there is not taken over.
BOOST_AUTO_TEST_CASE(another_folder_of_cases_is_read) {
  const Scratch scratch;
  const fs::path before = case_file("");
  const std::string out = (scratch.path / "out").string(), copy = (scratch.path / "copy").string();
  fs::create_directory(copy);
  scratch.file("copy/number.txt", "3");
  const Case reading = synthetic("reading", [](Findings& f, const Setup& setup) {
    double number = 1.0;
    std::ifstream(case_file("number.txt")) >> number;
    f.expect("value", setup.fault.empty() ? number : 2.0, 1.0, Tolerance::model(0.1, "chosen"));
  });
  const auto status = [&](std::vector<const char*> options) {
    options.insert(options.begin(), {"talus_verify", "--out", out.c_str()});
    return verify({reading}, TALUS_CATALOGUE, static_cast<int>(options.size()), options.data());
  };
  BOOST_TEST(status({}) == 0);
  BOOST_TEST(status({"--inputs", copy.c_str()}) == 1);
  BOOST_TEST(scratch.take("out/results.json").find(" --inputs ") != std::string::npos);
  scratch.file("copy/number.txt", "1");
  BOOST_TEST(status({"--inputs", copy.c_str()}) == 0);
  replace_case_folder(before);
  BOOST_TEST(status({"--reuse", "--inputs", copy.c_str()}) == 2);
  BOOST_TEST(status({"--inputs", "absent"}) == 2);
}

BOOST_AUTO_TEST_SUITE_END()
