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

/// How much is run: `quick` for every change, `full` with the long studies as well.
enum class Tier { quick, full };

template <>
struct Names<Tier> {
  static constexpr std::array values{std::pair{Tier::quick, "quick"}, std::pair{Tier::full, "full"}};
};

/// How a case ended.
enum class Status {
  pass,     ///< Every check holds and every control turned red.
  fail,     ///< A check does not hold, a control stayed green, or there was nothing to check.
  error,    ///< The case threw, crashed, or left a record that cannot be read.
  timeout,  ///< The case was stopped at its time limit.
  missing,  ///< The case left no record.
};

template <>
struct Names<Status> {
  static constexpr std::array values{std::pair{Status::pass, "pass"}, std::pair{Status::fail, "fail"},
                                     std::pair{Status::error, "error"}, std::pair{Status::timeout, "timeout"},
                                     std::pair{Status::missing, "missing"}};
};

/// Whether a case ran to its end.
[[nodiscard]] constexpr bool finished(Status status) { return status == Status::pass || status == Status::fail; }

/// What a check did in a setup: held (green), failed (red), or was not made.
enum class Colour { green, red, missing };

template <>
struct Names<Colour> {
  static constexpr std::array values{std::pair{Colour::green, "green"}, std::pair{Colour::red, "red"},
                                     std::pair{Colour::missing, "missing"}};
};

/// The outcome of one planted fault. Red is demanded with the fault, and green without it at the same resolution, so
/// that it is the fault that turned the check red.
struct Control {
  std::string name;                    ///< Name of the fault.
  std::string what;                    ///< What is made wrong.
  std::string turns_red;               ///< The check it must turn red.
  Colour observed = Colour::missing;   ///< With the fault; red is demanded.
  Colour unplanted = Colour::missing;  ///< Without the fault, equally coarse; green is demanded.
  double measured = 0.0;               ///< With the fault; as `reference`, `error`, `bound` only if not missing.
  double reference = 0.0;
  double error = 0.0;
  double bound = 0.0;
  std::string message{};  ///< Why it did not turn red, or what was thrown after it did.

  [[nodiscard]] bool pass() const { return observed == Colour::red && unplanted == Colour::green; }
};

/// A requirement and the checks that touch it.
struct Trace {
  std::string requirement;          ///< Id of the requirement.
  std::vector<std::string> checks;  ///< Names of the checks made that show it.
  std::string unmatched{};     ///< A check or group of checks that the case names and does not have; empty if none.
  std::string used_instead{};  ///< What the case's runs used in place of the requirement; empty if they used it.

  /// There is a check for it, each check that the case names exists, and a run used what is claimed.
  [[nodiscard]] bool shown() const { return !checks.empty() && unmatched.empty() && used_instead.empty(); }
};

/// All that one case leaves behind; `record.json` and the CSV files it names.
struct Record {
  std::string id;     ///< snake_case.
  std::string title;  ///< One line.
  std::string family{};
  std::vector<Trace> requirements;       ///< With the checks made so far.
  std::vector<std::string> main_checks;  ///< Names of the checks on the first page.
  std::string source;                    ///< Full citation.
  std::string page;                      ///< Markdown.
  Tier tier = Tier::quick;               ///< The lowest tier that runs this case.
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

/// Whether `main_checks` names the check.
[[nodiscard]] bool is_main(const Record& record, const Check& check);

/// Marks the checks that `main_checks` names.
void mark_main_checks(Record& record);

}  // namespace talus::records
