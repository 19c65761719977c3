#include "tests/mutants/written_bugs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <stdexcept>

#include "tests/mutants/equivalent.hpp"
#include "tests/mutants/schemata.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/whole_file.hpp"

BOOST_AUTO_TEST_SUITE(written_bugs_tests)

namespace {

namespace fs = std::filesystem;
using namespace talus::mutants;

const fs::path root = TALUS_ROOT;

/// One file of bugs and one source.
struct Sources : Folder {
  explicit Sources(const std::string& bugs) {
    fs::create_directories(path / "bugs");
    file("bugs/some.toml", bugs);
    file("law.hpp", "double force = k * x;\ndouble power = k * x * v + k * x * v;\n");
  }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(written_bugs(path / "bugs", path));
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "";
  }
};

std::string table(const std::string& id, const std::string& old, const std::string& more = "") {
  return fmt::format(
      "[[bug]]\nid = '{}'\nfile = 'law.hpp'\nform = 'expression'\nold = '{}'\nnew = 'x'\nbug = 'No stiffness.'\n{}", id,
      old, more);
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(every_bug_applies_and_names_cases) {
  // Every case has a page of its name, and every page has a case (verification/problems/CMakeLists.txt).
  std::vector<std::string> cases;
  for (const auto& entry : fs::recursive_directory_iterator(root / "verification/problems")) {
    if (entry.path().extension() == ".md") cases.push_back(entry.path().stem().string());
  }
  cases.emplace_back("*");
  const auto bugs = written_bugs(root / "tests/mutants/bugs", root);
  BOOST_TEST(bugs.size() >= 60u);
  std::map<std::string, std::vector<Switched>> edits;
  int number = 0;
  for (const Mutant& bug : bugs) {
    ++number;
    for (const Edit& edit : bug.edits)
      edits[edit.file].push_back({edit, number});
    for (const std::string& name : bug.cases)
      BOOST_TEST((std::find(cases.begin(), cases.end(), name) != cases.end()), bug.id << ": there is no case " << name);
  }
  // They are compiled together, so none may cross another.
  for (const auto& [file, list] : edits)
    BOOST_CHECK_NO_THROW(static_cast<void>(with_switches(talus::records::read_whole(root / file), list)));
}

BOOST_AUTO_TEST_CASE(a_bug_is_found_in_its_file) {
  const Sources folder(table("no_stiffness", "k * x;", "cases = ['column']\n"));
  const auto bugs = written_bugs(folder.path / "bugs", folder.path);
  BOOST_REQUIRE(bugs.size() == 1u);
  BOOST_TEST(bugs[0].edits[0].begin == 15u);
  BOOST_TEST(bugs[0].edits[0].end == 21u);
  BOOST_TEST(bugs[0].operation == "bug");
}

BOOST_AUTO_TEST_CASE(what_does_not_apply_is_refused_with_its_line) {
  const std::string cases = "cases = ['column']\n";
  BOOST_TEST(holds(Sources(table("a", "k * y", cases)).refusal(), "some.toml:1: law.hpp does not hold 'old'"));
  BOOST_TEST(
      holds(Sources(table("a", "k * x * v", cases)).refusal(), "some.toml:1: law.hpp holds 'old' more than once"));
  BOOST_TEST(holds(Sources(table("a", "k * x;")).refusal(), "some.toml:1: cases is missing"));
  BOOST_TEST(
      holds(Sources(table("a", "k * x;", cases + "case = 1\n")).refusal(), "key 'case' is not known; allowed: id"));
  BOOST_TEST(holds(Sources(table("a", "k * x;", cases) + table("a", "k * x;", cases)).refusal(), "'a' is used twice"));
  BOOST_TEST(holds(Sources("[[bug]\n").refusal(), "some.toml:1:"));
}

BOOST_AUTO_TEST_CASE(every_equivalent_mutant_has_its_line_and_a_reason) {
  for (const Equivalent& one : equivalent_mutants(root / "tests/mutants/equivalent.toml")) {
    BOOST_TEST(holds(talus::records::read_whole(root / one.file), one.line), one.file << " does not hold " << one.line);
    BOOST_TEST(one.reason.size() > 20u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
