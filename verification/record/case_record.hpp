#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/check.hpp"
#include "verification/record/figure.hpp"
#include "verification/record/names.hpp"
#include "verification/record/table.hpp"

namespace talus::records {

/// Scope of a run: `quick` for every change, `full` adds the long studies.
enum class Tier { quick, full };

template <>
struct Names<Tier> {
  static constexpr std::array values{std::pair{Tier::quick, "quick"}, std::pair{Tier::full, "full"}};
};

/// What a check's reference rests on, the strongest first.
enum class Evidence {
  measurement,              ///< Measured in nature or in a laboratory.
  closed_form,              ///< An exact solution of the same equations.
  independent_integration,  ///< The same equations, integrated by code that shares nothing with the solver.
  historical_program,       ///< Printed by FENCE (1993) or SNOFLO (1989).
  other_code,               ///< Of a program in use today.
  property,                 ///< What every solution satisfies, or two ways of Talus that must agree.
  earlier_result,           ///< Recorded from an earlier revision of Talus.
};

template <>
struct Names<Evidence> {
  static constexpr std::array values{std::pair{Evidence::measurement, "measurement"},
                                     std::pair{Evidence::closed_form, "closed form"},
                                     std::pair{Evidence::independent_integration, "independent integration"},
                                     std::pair{Evidence::historical_program, "historical program"},
                                     std::pair{Evidence::other_code, "other code"},
                                     std::pair{Evidence::property, "property"},
                                     std::pair{Evidence::earlier_result, "earlier result"}};
};

/// Final status of a case.
enum class Status {
  pass,     ///< Every check passes and every control turns red.
  fail,     ///< A check fails, a control stays green, or there is nothing to check.
  error,    ///< The case threw, crashed, or produced a record that cannot be read.
  timeout,  ///< The case was stopped at its time limit.
  missing,  ///< The case produced no record.
};

template <>
struct Names<Status> {
  static constexpr std::array values{std::pair{Status::pass, "pass"}, std::pair{Status::fail, "fail"},
                                     std::pair{Status::error, "error"}, std::pair{Status::timeout, "timeout"},
                                     std::pair{Status::missing, "missing"}};
};

/// Whether a case ran to completion.
[[nodiscard]] constexpr bool finished(Status status) { return status == Status::pass || status == Status::fail; }

/// Result of a check in a setup: passed (green), failed (red), or not made.
enum class Colour { green, red, missing };

template <>
struct Names<Colour> {
  static constexpr std::array values{std::pair{Colour::green, "green"}, std::pair{Colour::red, "red"},
                                     std::pair{Colour::missing, "missing"}};
};

/// Result of one injected fault. The check must be red with the fault and green without it at the same resolution, so
/// that the fault is the cause of the failure.
struct Control {
  std::string name;                    ///< Name of the fault.
  std::string what;                    ///< Description of the error.
  std::string turns_red;               ///< The check that must fail.
  Colour observed = Colour::missing;   ///< With the fault; must be red.
  Colour unplanted = Colour::missing;  ///< Without the fault at the same resolution; must be green.
  double measured = 0.0;               ///< With the fault; like `reference`, `error`, `bound`, only if not missing.
  double reference = 0.0;
  double error = 0.0;
  double bound = 0.0;
  std::string message{};  ///< Why the check did not fail, or what was thrown after it did.

  [[nodiscard]] bool pass() const { return observed == Colour::red && unplanted == Colour::green; }
  /// Whether the check passes without the fault: if it does not, its colour with the fault shows nothing.
  [[nodiscard]] bool is_judged() const { return unplanted != Colour::red; }
};

/// A requirement and the checks that verify it.
struct Trace {
  std::string requirement;          ///< Id of the requirement.
  std::vector<std::string> checks;  ///< Names of the checks made that verify it.
  std::string unmatched{};     ///< A check or group of checks that the case names but does not have; empty if none.
  std::string used_instead{};  ///< Members that the case's runs used instead of the required one; empty if they used
                               ///< it.

  /// Whether at least one check verifies it, all checks named by the case exist, and a run used what is claimed.
  [[nodiscard]] bool shown() const { return !checks.empty() && unmatched.empty() && used_instead.empty(); }
};

/// All results of one case: `record.json` and the CSV files that it names.
struct Record {
  std::string id;     ///< snake_case.
  std::string title;  ///< One line.
  std::string family{};
  std::vector<Trace> requirements;       ///< With the checks made so far.
  std::vector<std::string> main_checks;  ///< Names of the checks on the first page.
  std::string source;                    ///< Full citation.
  std::string page;                      ///< Markdown.
  std::vector<Evidence> evidence{};      ///< What its checks rest on, the strongest first.
  std::string not_shown{};               ///< What must not be concluded from it.
  Tier tier = Tier::quick;               ///< The lowest tier in which this case runs.
  Status status = Status::missing;
  std::string message;   ///< Why the case did not pass; empty if it did.
  double seconds = 0.0;  ///< Wall-clock time of the case.
  std::uint64_t evaluations = 0;
  std::vector<Check> checks;
  std::vector<Control> controls;
  std::vector<Figure> figures;
  std::vector<Table> tables;
  std::vector<DataFile> data;
  std::vector<std::string> notes;  ///< Markdown.
};

/// Whether `main_checks` contains the check.
[[nodiscard]] bool is_main(const Record& record, const Check& check);

/// Marks the checks named in `main_checks`.
void mark_main_checks(Record& record);

}  // namespace talus::records
