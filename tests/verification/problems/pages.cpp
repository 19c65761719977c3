#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "reports/base/record.hpp"
#include "reports/pages/sketch.hpp"
#include "verification/catalogue/catalogue.hpp"
#include "verification/check/evidence.hpp"
#include "verification/driver/case_list.hpp"

BOOST_AUTO_TEST_SUITE(pages_tests)

using namespace talus::verification;
namespace fs = std::filesystem;

namespace {

const fs::path root{TALUS_ROOT};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = all_cases();
  return all;
}
const Catalogue& known() {
  static const Catalogue read = read_catalogue(root / "verification/catalogue");
  return read;
}

std::string without(const std::string& text, const char* pattern) {
  return std::regex_replace(text, std::regex{pattern}, "");
}

std::vector<std::string> matches(const std::string& text, const char* pattern, int group) {
  const std::regex regex{pattern};
  std::vector<std::string> found;
  for (std::sregex_iterator it{text.begin(), text.end(), regex}, end; it != end; ++it)
    found.push_back((*it)[static_cast<std::size_t>(group)]);
  return found;
}

/// The page without its sketches.
std::string prose(const std::string& page) { return without(page, "```[^`]*```"); }

bool is_balanced(const std::string& formula) {
  int braces = 0;
  for (std::size_t i = 0; i < formula.size() && braces >= 0; ++i) {
    if (formula[i] == '\\') {
      ++i;  // braces after a backslash are printed
    } else {
      braces += formula[i] == '{' ? 1 : formula[i] == '}' ? -1 : 0;
    }
  }
  return braces == 0 && matches(formula, R"(\\left[^a-z])", 0).size() == matches(formula, R"(\\right[^a-z])", 0).size();
}

/// Describes what is wrong with a formula between one or two dollars; empty if nothing is. `after`: the character
/// behind it.
std::string fault_of_formula(const std::string& formula, bool display, char after) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  if (formula.empty()) return "a formula is empty";
  if (formula.find("\\rm ") != std::string::npos) return "\\rm, which HTML does not show, is in the formula " + formula;
  if (formula.find("\n\n") != std::string::npos) return "an empty line is in the formula " + formula;
  if (!is_balanced(formula)) return "braces, or \\left and \\right, do not match in the formula " + formula;
  if (!display && (blank(formula.front()) || blank(formula.back()))) return "a blank begins or ends $" + formula + "$";
  if (!display && std::isdigit(static_cast<unsigned char>(after)) != 0) return "a digit follows $" + formula + "$";
  return "";
}

/// Errors in formulas that LaTeX or pandoc would not accept.
std::vector<std::string> faults_of_formulas(const std::string& page) {
  const std::string text = without(prose(page), "`[^`]*`");
  std::vector<std::string> faults;
  for (std::size_t i = text.find('$'); i != std::string::npos; i = text.find('$', i)) {
    const bool display = text.compare(i, 2, "$$") == 0;
    const std::string mark = display ? "$$" : "$";
    const std::size_t begin = i + mark.size(), end = text.find(mark, begin);
    if (end == std::string::npos) {
      faults.push_back("a formula does not end: " + text.substr(i, 60));
      break;
    }
    i = end + mark.size();
    const std::string fault =
        fault_of_formula(text.substr(begin, end - begin), display, i < text.size() ? text[i] : ' ');
    if (!fault.empty()) faults.push_back(fault);
  }
  return faults;
}

/// Characters that the report's LaTeX does not accept, headings, and missing parts: a page is printed under the heading
/// of its case, and its parts begin with bold text, among them those required here.
std::vector<std::string> faults_of_form(const std::string& page) {
  std::vector<std::string> faults;
  for (const char c : page) {
    if (c != '\n' && (c < ' ' || c > '~')) faults.push_back("a character is not printable ASCII");
  }
  for (const std::string& heading : matches(prose(page), "\n(#+ [^\n]*)", 1))
    faults.push_back("a heading: " + heading);
  const std::vector<std::string> parts = matches(page, R"((^|\n)\*\*([^*]+)\*\*)", 2);
  if (parts.size() < 2 || parts[0] != "Conclusion." || parts[1] != "Problem.")
    faults.push_back("it does not begin with **Conclusion.** and **Problem.**");
  const std::vector<std::string> conclusions = matches(page, R"(^\*\*Conclusion\.\*\* ([^\n]+(\n[^\n]+)*))", 1);
  if (!conclusions.empty() && std::ranges::count(conclusions.front(), ' ') > 60)
    faults.push_back("its conclusion has more than 60 words");
  if (parts.empty() || parts.back().rfind("What would break", 0) != 0)
    faults.push_back("it does not end with **What would break it.**");
  if (std::set<std::string>(parts.begin(), parts.end()).size() < parts.size())
    faults.push_back("a part is there twice");
  return faults;
}

/// Everything that a page may name in `code`: cases, members of the solver's closed lists, the values `auto` and `off`
/// of a scene's keys, the program and the files of its runs, and the listing of 1993, whose numbers are in
/// cases/published.
std::set<std::string> known_names() {
  std::set<std::string> names{"auto",        "off",         "sample2.OUT",  "talus",
                              "history.csv", "impacts.csv", "summary.json", "final_state.json"};
  for (const Case& c : cases())
    names.insert(c.id);
  for (const Requirement& requirement : known().requirements) {
    for (const std::string& part : matches(requirement.id, "[^.]+", 0))
      names.insert(part);
  }
  return names;
}

/// Files and folders that a page may refer to, from the root, with '/' before and after.
std::set<std::string> known_files() {
  std::set<std::string> files;
  for (const char* tree : {"cases", "reports", "scripts", "solver", "tests", "verification"}) {
    files.insert("/" + std::string{tree} + "/");
    for (const auto& entry : fs::recursive_directory_iterator{root / tree})
      files.insert("/" + fs::relative(entry.path(), root).string() + (entry.is_directory() ? "/" : ""));
  }
  return files;
}

bool is_file(const std::set<std::string>& files, const std::string& word) {
  const bool folder = word.back() == '/';
  std::string pattern = std::regex_replace(word, std::regex{R"([.])"}, R"(\.)");
  pattern = ".*/" + std::regex_replace(pattern, std::regex{R"([*])"}, "[^/]*") + (folder ? "" : R"((\.\w+)?)");
  const std::regex regex{pattern};
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& file) { return std::regex_match(file, regex); });
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

/// Names, files, commands, links and citations on a page whose target does not exist.
std::vector<std::string> dead_references(const std::string& page) {
  static const std::set<std::string> names = known_names(), files = known_files();
  static const std::vector<std::string> targets = matches(text_of(root / "Makefile"), "\n([a-z-]+):", 1);
  std::vector<std::string> dead;
  for (const std::string& code : matches(prose(page), "`([^`]+)`", 1)) {
    const bool is_word = std::regex_match(code, std::regex{R"([\w./*]+)"});
    if (is_word && names.count(code) == 0 && !is_file(files, code)) dead.push_back("`" + code + "`");
    const std::string target = code.rfind("make ", 0) == 0 ? code.substr(5) : "";
    if (!target.empty() && std::find(targets.begin(), targets.end(), target) == targets.end())
      dead.push_back("`" + code + "`");
  }
  const std::string plain = without(without(prose(page), "`[^`]*`"), R"(\$[^$]*\$)");
  for (const std::string& link : matches(plain, R"(\]\(([^)]*)\))", 1)) {
    if (link.find("://") == std::string::npos && !is_file(files, link)) dead.push_back("the link " + link);
  }
  const std::vector<std::string> source = matches(page, R"(\n\*\*Source\.\*\*((.|\n.)*))", 1);
  if (source.empty()) return dead;
  for (const std::string& citation : citations_in(source.front(), known().bibliography).missing)
    dead.push_back("the citation " + citation);
  return dead;
}

}  // namespace

BOOST_AUTO_TEST_CASE(formulas_end_and_match) {
  for (const Case& c : cases()) {
    for (const std::string& fault : faults_of_formulas(c.page))
      BOOST_ERROR(c.id + ".md: " + fault);
  }
}

BOOST_AUTO_TEST_CASE(pages_say_what_their_case_rests_on_and_does_not_show) {
  std::set<std::string> limits;
  for (const Case& c : cases()) {
    const EvidenceParagraph paragraph = evidence_of(c.page);
    if (!paragraph.error.empty()) BOOST_ERROR(c.id + ".md: " + paragraph.error);
    if (std::ranges::count(paragraph.not_shown, ' ') > 40)
      BOOST_ERROR(c.id + ".md: what is not shown has more than 40 words");
    if (!limits.insert(paragraph.not_shown).second) BOOST_ERROR(c.id + ".md: another page does not show the same");
  }
}

BOOST_AUTO_TEST_CASE(pages_have_their_parts_and_letters_that_latex_takes) {
  for (const Case& c : cases()) {
    for (const std::string& fault : faults_of_form(c.page))
      BOOST_ERROR(c.id + ".md: " + fault);
  }
}

// A block that is not a sketch would be printed as typed.
BOOST_AUTO_TEST_CASE(sketches_can_be_drawn) {
  std::size_t sketches = 0;
  for (const Case& c : cases()) {
    try {
      const std::size_t found = talus::reports::page_sketches(c.page).size();
      if (2 * found != matches(c.page, "(^|\n)```", 0).size()) BOOST_ERROR(c.id + ".md: a block is not a sketch");
      sketches += found;
    } catch (const talus::reports::RecordError& wrong) {
      BOOST_ERROR(c.id + ".md: " + wrong.what());
    }
  }
  BOOST_TEST(sketches > 70u);
}

BOOST_AUTO_TEST_CASE(what_pages_refer_to_exists) {
  for (const Case& c : cases()) {
    for (const std::string& reference : dead_references(c.page))
      BOOST_ERROR(c.id + ".md refers to what does not exist: " + reference);
  }
}

BOOST_AUTO_TEST_CASE(faults_of_pages_are_found) {
  const auto number = [](const std::vector<std::string>& faults) { return faults.size(); };
  BOOST_TEST(number(faults_of_formulas("As $x_{1}$ and\n$$\\left(\\frac{a}{b}\\right)$$ and `$`.")) == 0u);
  for (const char* wrong : {"$x", "$$x$", "$x_{1$", "$\\frac{1}2}$", "$$\\left(x)$$", "$ x$", "$x$2", "$$a\n\nb$$",
                            "$$$$", "$m_{\\rm eff}$"})
    BOOST_TEST(number(faults_of_formulas(wrong)) == 1u, wrong);

  const std::string whole =
      "**Conclusion.** Yes.\n\n**Problem.** One.\n\n```\n# drawn\n```\n\n**What would break it.** All.\n";
  BOOST_TEST(number(faults_of_form(whole)) == 0u);
  for (const std::string& wrong :
       {whole + "\n# More\n", whole + "\n**More.** Yes.", "Before.\n\n**First.** One.\n\n" + whole, whole + "caf\xc3",
        whole + "a\tb", "**Conclusion.** Yes.\n\n**Problem.** One.\n\n**What would break it.** All.\n\n" + whole,
        whole.substr(whole.find("**Problem")), "**Conclusion.** Yes" + std::string(122, ' ') + whole.substr(19)})
    BOOST_TEST(number(faults_of_form(wrong)) == 1u, wrong);

  BOOST_TEST(number(dead_references(
                 "`friction`, `exact`, `table_2.DAT`, `reference/mathematics/jacobi.hpp`, `cases/`, `sample2`, "
                 "`cases/fence/appendix_*.DAT`, `make bench`, [a](CONTRIBUTING.md), "
                 "[b](https://example.org)")) == 1u);  // files in the root folder are not among them
  for (const char* wrong : {"`frictions`", "`table_9.DAT`", "`reference/nothing.hpp`", "`verification/none/`",
                            "`make nothing`", "[a](none.md)", "text\n\n**Source.** Nobody 1993."})
    BOOST_TEST(number(dead_references(wrong)) == 1u, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
