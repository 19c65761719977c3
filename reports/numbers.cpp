#include "reports/numbers.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "verification/record/audits.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;
using records::read_whole;

/// Integers up to this number figures, tables, rows and references.
constexpr double maximum_ordinal = 250;

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

/// The counts and percentages of the chapter on the interface.
void collect_counts(const json& interface, std::set<double>& numbers) {
  std::map<std::string, std::map<std::string, double>> counts;
  for (const json& item : interface.at("items")) {
    for (const std::string& kind : {item.at("kind").get<std::string>(), std::string("all")})
      counts[kind][item.at("status").get<std::string>()] += 1.0;
  }
  for (auto& [kind, by_status] : counts) {
    for (const auto& [status, count] : by_status)
      numbers.insert(count);
    numbers.insert(100.0 * by_status["killed"] / (by_status["killed"] + by_status["survived"]));
  }
}

/// Numbers and killed percentages of the chapter on mutants: of all, of written bugs, of each folder, file and
/// operation, with and without cases that compare with recorded results, and with those not tried to the end; and the
/// limits of the interval.
void collect_scores(const json& mutants, std::set<double>& numbers) {
  std::set<std::string> recorded;
  for (const json& one : mutants.at("cases"))
    if (one.value("recorded", false)) recorded.insert(one.at("id"));
  struct Counts {
    double killed{}, independent{}, counted{}, pending{};
  };
  std::map<std::string, Counts> counts;
  double tried = 0.0;
  for (const json& mutant : mutants.at("mutants")) {
    tried += mutant.at("status") == "pending" ? 0.0 : 1.0;
    const std::string status = mutant.at("status"), file = mutant.at("file"), operation = mutant.at("operation");
    if (status == "equivalent") continue;
    bool independent = false;
    for (const json& trial : mutant.at("trials"))
      independent = independent || (trial.at("end") != "pass" && !recorded.contains(trial.at("case")));
    std::vector<std::string> groups{"operation " + operation};
    if (operation != "bug") groups.insert(groups.end(), {"all", file, file.substr(0, file.rfind('/'))});
    for (const std::string& group : groups) {
      Counts& of = counts[group];
      of.pending += status == "pending" ? 1.0 : 0.0, of.counted += status == "pending" ? 0.0 : 1.0;
      if (status == "killed") of.killed += 1.0, of.independent += independent ? 1.0 : 0.0;
    }
  }
  numbers.insert(tried);
  for (const auto& [group, of] : counts) {
    numbers.insert({of.killed, of.counted, of.pending});
    for (const double killed : {of.killed, of.independent})
      numbers.insert({100.0 * killed / of.counted, 100.0 * killed / (of.counted + of.pending)});
  }
  // Wilson 1927, 95 %.
  constexpr double z = 1.959963984540054;
  const Counts& all = counts["all"];
  const double fraction = all.killed / all.counted, per_count = z * z / all.counted;
  const double middle = (fraction + 0.5 * per_count) / (1.0 + per_count);
  const double half = z / (1.0 + per_count) * std::sqrt((fraction * (1.0 - fraction) + 0.25 * per_count) / all.counted);
  numbers.insert({100.0 * (middle - half), 100.0 * (middle + half)});
}

/// The sums of the members of equal rows: readers of mutated files, files that were changed.
void collect_sums_of(const json& rows, std::set<double>& numbers) {
  std::map<std::string, double> sums;
  for (const json& row : rows) {
    for (const auto& [name, value] : row.items())
      if (value.is_number()) sums[name] += value.get<double>();
  }
  for (const auto& [name, sum] : sums)
    numbers.insert(sum);
}

/// The fractions of executed lines and branches of each file, each folder and all, and their sums.
void collect_lines(const json& lines, std::set<double>& numbers) {
  std::map<std::string, std::map<std::string, double>> sums;
  for (const json& source : lines.at("files")) {
    const std::string file = source.at("filename");
    for (const std::string& group : {std::string("all"), file, file.substr(0, file.rfind('/'))}) {
      for (const char* count : {"line_total", "line_covered", "branch_total", "branch_covered"})
        sums[group][count] += source.at(count).get<double>();
    }
  }
  for (auto& [group, of] : sums) {
    for (const std::string kind : {"line", "branch"}) {
      const double total = of[kind + "_total"];
      numbers.insert({total, total > 0.0 ? 100.0 * of[kind + "_covered"] / total : 100.0});
    }
  }
}

}  // namespace

std::size_t count_of_numbers(const std::string& markdown) { return numbers_in(visible(markdown)).size(); }

std::set<double> numbers_of_records(const fs::path& verify, const fs::path& templates, const fs::path& audits) {
  std::set<double> numbers{1.5};  // by which the details perturb references
  const json results = json::parse(read_whole(verify / "results.json"));
  collect(results, numbers);
  collect_sums(results, numbers);
  for (const std::string audit : records::audit_names) {
    const fs::path file = records::audit_file(audit, verify, audits);
    if (file.empty()) continue;
    const json found = json::parse(read_whole(file));
    collect(found, numbers);
    if (audit == "mutants" || audit == "gate") collect_scores(found, numbers);
    if (audit == "interface") collect_counts(found, numbers);
    if (audit == "fuzz") collect_sums_of(found.at("readers"), numbers);
    if (audit == "inputs") collect_sums_of(found.at("files"), numbers);
    if (audit == "lines") collect_lines(found, numbers);
  }
  for (const char* name : {"origins.json", "defects.json"}) {
    if (!audits.empty() && fs::exists(audits / name)) collect(json::parse(read_whole(audits / name)), numbers);
  }
  for (const auto& entry : fs::directory_iterator(templates / "chapters"))
    collect(read_whole(entry.path()), numbers);
  return numbers;
}

std::vector<std::string> unfounded_numbers(const std::string& markdown, const std::set<double>& known) {
  std::vector<std::string> wrong;
  for (const Written& written : numbers_in(visible(markdown))) {
    if (written.value == std::floor(written.value) && written.value <= maximum_ordinal) continue;
    const double half = 0.5 * written.last_digit * (1.0 + 1e-6);
    const auto next = known.lower_bound(written.value - half);
    if (next == known.end() || *next > written.value + half) wrong.push_back(written.text);
  }
  return wrong;
}

std::vector<std::string> unfounded_numbers(const fs::path& verify, const fs::path& report, const fs::path& templates,
                                           const fs::path& audits) {
  const std::set<double> known = numbers_of_records(verify, templates, audits);
  std::vector<std::string> wrong;
  for (const char* name : {"verification.md", "verification-details.md"}) {
    for (const std::string& number : unfounded_numbers(read_whole(report / name), known))
      wrong.push_back(name + (": " + number));
  }
  return wrong;
}

}  // namespace talus::reports
