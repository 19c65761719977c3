#include "reports/pages/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;
/// Checks as case and name.
using Checks = std::set<std::pair<std::string, std::string>>;

Checks checks_of(const Requirement& requirement) {
  Checks checks;
  for (const ShownBy& shown : requirement.shown_by) {
    for (const std::string& name : shown.checks)
      checks.emplace(shown.case_id, name);
  }
  return checks;
}

std::vector<const Requirement*> group(const Results& results, const std::string& name) {
  std::vector<const Requirement*> members;
  for (const Requirement& requirement : results.requirements) {
    if (requirement.group == name) members.push_back(&requirement);
  }
  return members;
}

/// "law.hertz" -> {"law", "hertz"}.
std::vector<std::string> parts_of(const std::string& id) {
  std::vector<std::string> parts{""};
  for (const char letter : id) {
    if (letter == '.') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

std::string last_part(const Requirement& requirement) { return parts_of(requirement.id).back(); }

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return cell(name);
}

/// Number of checks of a feature, and of the mutants they detected if known.
class Counter {
 public:
  explicit Counter(const records::Mutants* mutants) : known_{mutants != nullptr} {
    if (!known_) return;
    for (const records::MutantRecord& mutant : mutants->mutants) {
      for (const records::Trial& trial : mutant.trials) {
        for (const std::string& name : trial.failed)
          noticed_[{trial.case_id, name}].insert(mutant.id);
      }
    }
  }
  std::string text(const Checks& checks) const {
    if (checks.empty()) return "**none**";
    if (!known_) return fmt::format("{}", checks.size());
    const std::size_t mutants = noticed_by(checks);
    return mutants == 0 ? fmt::format("{} (**0**)", checks.size()) : fmt::format("{} ({})", checks.size(), mutants);
  }

 private:
  std::size_t noticed_by(const Checks& checks) const {
    std::set<std::string> mutants;
    for (const auto& check : checks) {
      if (const auto found = noticed_.find(check); found != noticed_.end())
        mutants.insert(found->second.begin(), found->second.end());
    }
    return mutants.size();
  }

  bool known_{};
  std::map<std::pair<std::string, std::string>, std::set<std::string>> noticed_;
};

/// One row per law, with its regimes and the number of their checks.
std::string regimes(const Results& results, const Counter& counter) {
  std::vector<std::pair<std::string, std::string>> laws;
  for (const Requirement* regime : group(results, "regime")) {
    const std::vector<std::string> parts = parts_of(regime->id);
    if (parts.size() != 3) continue;
    if (laws.empty() || laws.back().first != parts[1]) laws.emplace_back(parts[1], "");
    std::string& text = laws.back().second;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", spaced(parts[2]), counter.text(checks_of(*regime)));
  }
  Rows rows;
  for (const auto& [law, text] : laws)
    rows.push_back({spaced(law), text});
  return markdown::table({{"law"}, {"regimes, and how many checks run in each"}}, rows, "");
}

/// Checks that cover both requirements.
Checks common(const Requirement& a, const Requirement& b) {
  const Checks of_a = checks_of(a), of_b = checks_of(b);
  Checks both;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::inserter(both, both.begin()));
  return both;
}

/// Table of contact laws against end rules, methods and friction laws.
std::string contact_laws(const Results& results, const Counter& counter) {
  std::vector<const Requirement*> across = group(results, "end_rule");
  for (const char* const other : {"method", "shear_law"}) {
    for (const Requirement* each : group(results, other))
      across.push_back(each);
  }
  std::vector<markdown::Column> columns{{"law of contacts"}};
  for (const Requirement* rule : across)
    columns.push_back({spaced(last_part(*rule)), true});
  Rows rows;
  for (const Requirement* law : group(results, "law")) {
    if (law->text != "contact law") continue;
    rows.push_back({spaced(last_part(*law))});
    for (const Requirement* rule : across)
      rows.back().push_back(counter.text(common(*law, *rule)));
  }
  return markdown::table(columns, rows, "");
}

/// Measured orders of an integrator, grouped by the nearest integer. Only checks that name the method count: a check
/// whose case merely uses the method measures another order, for example with stiffness; checks that show a false order
/// on purpose are excluded.
std::map<int, std::vector<double>> measured_orders(const Results& results, const Requirement& integrator) {
  std::string name = last_part(integrator);
  if (name.rfind("odeint_", 0) == 0) name.erase(0, 7);
  std::map<int, std::vector<double>> orders;
  for (const auto& [case_id, check_name] : checks_of(integrator)) {
    const Check* check = check_of(results, case_id, check_name);
    if (check == nullptr || !check->order || !check->pass) continue;
    if (check_name.find("false order") != std::string::npos) continue;
    const std::size_t offset = check_name.find(name);
    // "central_difference" is also the end of "lagged_central_difference".
    if (offset == std::string::npos || (offset > 0 && check_name[offset - 1] == '_')) continue;
    orders[static_cast<int>(std::lround(check->measured))].push_back(check->measured);
  }
  return orders;
}

std::string range_text(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string text =
      values.size() == 1 ? fmt::format("{:.2f}", *low) : fmt::format("{:.2f} to {:.2f}", *low, *high);
  return fmt::format("{} ({})", text, values.size());
}

std::string integrators(const Results& results, const Counter& counter) {
  Rows rows;
  for (const Requirement* integrator : group(results, "integrator")) {
    const auto orders = measured_orders(results, *integrator);
    std::string others;
    for (const auto& [order, values] : orders) {
      if (order != integrator->order) others += (others.empty() ? "" : "; ") + range_text(values);
    }
    const auto declared = orders.find(integrator->order);
    rows.push_back({spaced(last_part(*integrator)), integrator->order > 0 ? fmt::format("{}", integrator->order) : "",
                    declared == orders.end() ? "**none**" : range_text(declared->second), others,
                    counter.text(checks_of(*integrator))});
  }
  return markdown::table({{"integrator"},
                          {"declared", true},
                          {"measured as declared"},
                          {"other orders measured"},
                          {"checks in all", true}},
                         rows, "");
}

/// Pairs of shapes, only above the diagonal because pairs are unordered.
std::string pairs(const Results& results, const Counter& counter) {
  std::vector<std::string> names;
  std::map<std::pair<std::string, std::string>, std::string> counts;
  const auto note = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Requirement* pair : group(results, "pair")) {
    const std::vector<std::string> parts = parts_of(pair->id);
    if (parts.size() != 3) continue;
    note(parts[1]);
    note(parts[2]);
    counts[{parts[1], parts[2]}] = counter.text(checks_of(*pair));
  }
  std::vector<markdown::Column> columns{{"with"}};
  Rows rows;
  for (const std::string& name : names) {
    columns.push_back({spaced(name), true});
    const auto first = [&](const auto& pair) { return pair.first.first == name; };
    if (std::none_of(counts.begin(), counts.end(), first)) continue;
    rows.push_back({spaced(name)});
    for (const std::string& other : names) {
      const auto found = counts.find({name, other});
      rows.back().push_back(found == counts.end() ? " " : found->second);
    }
  }
  return markdown::table(columns, rows, "");
}

/// Terms of the energy balance.
std::string mechanisms(const Results& results, const Counter& counter) {
  Rows rows;
  for (const Requirement* mechanism : group(results, "mechanism"))
    rows.push_back({spaced(last_part(*mechanism)), counter.text(checks_of(*mechanism))});
  return markdown::table({{"energy lost by"}, {"checks", true}}, rows, "");
}

/// Family of the cases that run the program and read its output.
constexpr const char* program = "G: the program";

/// Output files and texts, as named by the checks of the program's cases: "history.csv: rows".
std::string outputs(const Results& results, const Counter& counter) {
  std::map<std::pair<std::string, std::string>, Checks> files;
  for (const Record& record : results.records) {
    if (record.family != program) continue;
    for (const Check& check : record.checks) {
      const std::size_t end = check.name.find(": ");
      if (end != std::string::npos) files[{record.id, check.name.substr(0, end)}].emplace(record.id, check.name);
    }
  }
  Rows rows;
  for (const auto& [key, checks] : files)
    rows.push_back({cell(key.second), markdown::code(key.first), counter.text(checks)});
  return markdown::table({{"output"}, {"case"}, {"checks", true}}, rows, "");
}

}  // namespace

std::string coverage(const Results& results, const records::Mutants* mutants) {
  const Counter counter{mutants};
  std::string text =
      "Each number counts checks of this run that a case claims for a requirement, or for both of two; requirements "
      "without a check show **none**. The lists of laws, modes, rules, integrators and shapes are the solver's own.";
  if (mutants != nullptr) {
    records::Score score;
    for (const records::MutantRecord& mutant : mutants->mutants)
      records::count(score, mutant);
    const bool each_with_each = mutants->whole_matrix && score.pending == 0 &&
                                std::ranges::all_of(mutants->cases, &records::UnchangedCase::in_matrix);
    text += fmt::format(
        " In parentheses: how many of {} [mutants](page:mutants) at least one of these checks noticed. {}",
        mutants->mutants.size() - score.pending,
        each_with_each ? "A **0** is a gap: what these checks measure was not shown to fail by any of them."
                       : "A **0** may be a gap: none of them made these checks fail, but not each was run with each "
                         "case that evaluates it.");
  }
  return text + "\n\n## Laws and regimes\n\n" + regimes(results, counter) + "\n" + contact_laws(results, counter) +
         "\n## Integrators and orders\n\n" + integrators(results, counter) +
         "\nIn parentheses after orders: how many fits. Other orders: a contact begins and ends within a step, which "
         "costs every method its order (2 without a dashpot, 1 with one); the energy balance; the order in the "
         "tolerance, of methods under step control; rounding. False orders, which steps that divide the contact time "
         "show, are left out.\n\n## Shapes in contact\n\n" +
         pairs(results, counter) + "\nAn empty cell is elsewhere in the table, or ground would meet ground.\n" +
         "\n## Energy balance\n\n" + mechanisms(results, counter) + "\n## Outputs\n\n" + outputs(results, counter);
}

}  // namespace talus::reports
