/// Every number of the report is one of results.json or a sum of such numbers. After `--` the test takes two folders
/// instead of its data: of a verification run and of the report made from it.
#define BOOST_TEST_MODULE reports_numbers
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "reports/process.hpp"
#include "tests/reports/scratch.hpp"
#include "verification/record/whole_file.hpp"

namespace fs = std::filesystem;
using nlohmann::json;
using talus::records::read_whole;

namespace {

/// Integers up to this number figures, tables, rows and references.
constexpr double most_ordinal = 250;

/// A number as written: its value and the weight of its last digit.
struct Written {
  std::string text;
  double value{}, last_digit{};
};

/// Numbers in a text; digits of names such as rk4, `fence_1993` or 2D are not numbers.
std::vector<Written> numbers_in(const std::string& text) {
  static const std::regex number(R"((\d+)(\.(\d+))?([eE]([-+]?\d+))?)");
  const auto part_of_name = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::vector<Written> found;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) {
    const auto at = static_cast<std::size_t>(it->position());
    const std::size_t after = at + static_cast<std::size_t>(it->length());
    if ((at > 0 && part_of_name(text[at - 1])) || (after < text.size() && part_of_name(text[after]))) continue;
    const int exponent = (*it)[5].matched ? std::stoi((*it)[5].str()) : 0;
    found.push_back({it->str(), std::strtod(it->str().c_str(), nullptr),
                     std::pow(10.0, exponent - static_cast<int>((*it)[3].length()))});
  }
  return found;
}

/// All numbers of a JSON value, those in its strings as well, and the sizes of its lists.
void collect(const json& value, std::set<double>& numbers) {
  if (value.is_number()) numbers.insert(std::abs(value.get<double>()));
  if (value.is_string()) {
    for (const Written& written : numbers_in(value.get<std::string>()))
      numbers.insert(written.value);
  }
  if (!value.is_structured()) return;
  numbers.insert(static_cast<double>(value.size()));
  for (const json& part : value)
    collect(part, numbers);
}

/// What the report sums over the cases of a family, and over checks of a kind; and error over bound of the controls.
void collect_sums(const json& results, std::set<double>& numbers) {
  std::map<std::string, double> seconds, checks, of_kind, robust;
  for (const json& record : results.at("cases")) {
    const std::string family = record.at("family");
    seconds[family] += record.at("seconds").get<double>();
    checks[family] += static_cast<double>(record.at("checks").size());
    for (const json& check : record.at("checks")) {
      if (!check.at("pass").get<bool>()) continue;
      const bool either = check.at("margin").is_number() && check.at("margin").get<double>() < 0.5;
      for (const std::string& kind : {check.at("kind").get<std::string>(), std::string("all")}) {
        of_kind[kind] += 1;
        robust[kind] += either ? 1 : 0;
      }
    }
    for (const json& control : record.at("controls")) {
      const json &error = control.at("error"), &bound = control.at("bound");
      if (error.is_number() && bound.is_number()) numbers.insert(error.get<double>() / bound.get<double>());
    }
  }
  for (const auto& sums : {seconds, checks, of_kind, robust}) {
    for (const auto& [name, sum] : sums)
      numbers.insert(sum);
  }
  for (const auto& [kind, count] : of_kind)
    numbers.insert(count - robust[kind]);
}

/// The Markdown text as a reader sees it: without targets of links and attributes, and without the numbers of figures
/// and tables and the versions of the tools.
std::string visible(const std::string& markdown) {
  std::string text = std::regex_replace(markdown, std::regex(R"(\]\([^)]*\))"), "]");
  text = std::regex_replace(text, std::regex(R"(\{[^{}\n]*width=[^{}\n]*\})"), "");
  text = std::regex_replace(text, std::regex(R"(\\([^A-Za-z0-9]))"), "$1");
  text = std::regex_replace(text, std::regex(R"((Figure|Table) \d+\.\d+)"), "$1");
  return std::regex_replace(text, std::regex(R"(Tools: [^\n]*)"), "");
}

/// Numbers of the text that are neither among `known`, rounded as they are written, nor ordinals.
std::vector<std::string> unfounded(const std::string& text, const std::set<double>& known) {
  std::vector<std::string> wrong;
  for (const Written& written : numbers_in(visible(text))) {
    if (written.value == std::floor(written.value) && written.value <= most_ordinal) continue;
    const double half = 0.5 * written.last_digit * (1.0 + 1e-6);
    const auto next = known.lower_bound(written.value - half);
    if (next == known.end() || *next > written.value + half) wrong.push_back(written.text);
  }
  return wrong;
}

struct Reported {
  std::string text;
  std::set<double> numbers;
};

Reported reported(const fs::path& verify, const fs::path& report) {
  Reported made;
  const json results = json::parse(read_whole(verify / "results.json"));
  collect(results, made.numbers);
  collect_sums(results, made.numbers);
  if (fs::exists(verify / "mutants.json")) collect(json::parse(read_whole(verify / "mutants.json")), made.numbers);
  made.numbers.insert(1.5);  // bounds by which the appendix perturbs references
  for (const auto& entry : fs::directory_iterator(fs::path(TALUS_TEMPLATES) / "chapters"))
    collect(read_whole(entry.path()), made.numbers);
  for (const char* name : {"verification.md", "verification-details.md"})
    made.text += read_whole(report / name);
  return made;
}

Reported example(const char* name, const Scratch& scratch) {
  const fs::path verify = fs::path(TALUS_TEST_DATA) / name;
  const auto finished = talus::reports::run({TALUS_REPORT_PROGRAM, {verify.string(), scratch.folder.string()}, {}, {}});
  BOOST_TEST_REQUIRE(finished.status == 0, finished.messages);
  return reported(verify, scratch.folder);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_of_the_report_is_in_the_results) {
  const auto& arguments = boost::unit_test::framework::master_test_suite();
  if (arguments.argc == 3) {
    const Reported given = reported(arguments.argv[1], arguments.argv[2]);
    for (const std::string& number : unfounded(given.text, given.numbers))
      BOOST_ERROR(number);
    return;
  }
  for (const char* name : {"pass", "fail"}) {
    const Scratch scratch("numbers");
    const Reported given = example(name, scratch);
    BOOST_TEST(numbers_in(visible(given.text)).size() > 200U);
    for (const std::string& number : unfounded(given.text, given.numbers))
      BOOST_ERROR(name << ": " << number);
  }
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_in_the_results_is_found) {
  const Scratch scratch("numbers");
  Reported given = example("pass", scratch);
  const std::string shown = "3.8266";
  const std::size_t at = given.text.find(shown);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  given.text.replace(at, shown.size(), "3.8276");
  BOOST_TEST(unfounded(given.text, given.numbers) == std::vector<std::string>{"3.8276"},
             boost::test_tools::per_element());
  BOOST_TEST(unfounded("rk4, a_12345, 2D and 3.14 [of](page-99999.html)", {3.1416}).empty());
  BOOST_TEST(unfounded("3.14, 3.15, 2.5e+03, 2.6e+03", {3.1416, 2512.0}).size() == 2U);
}
