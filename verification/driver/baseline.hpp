#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/provenance.hpp"
#include "verification/driver/renames.hpp"
#include "verification/driver/results.hpp"
#include "verification/record/names.hpp"

namespace talus::verification {

/// A results.json and its content.
struct ResultsFile {
  std::filesystem::path file;
  Results results;
};

/// The case with this id, or nullptr.
[[nodiscard]] const Record* find_case(const Results& results, const std::string& id);

/// Allowed change of measured values, in units of the check's error bound.
struct ChangeTolerance {
  std::string name;    ///< A family, the letter of a family ("B") or a case; empty: all checks.
  double value = 0.0;  ///< |new - old| <= value * bound; not negative.
};

/// Allowed differences from the baseline.
struct Allowance {
  std::vector<ChangeTolerance> tolerances;  ///< The last one that applies to a check is used; none: 0.
  std::optional<double> margin;             ///< Allowed growth of error/bound; none: the tolerance of the check.
  bool round_off = false;                   ///< Allow changes of class Movement::round_off.
  double evaluation_growth = 0.0;   ///< Allowed growth of a case's evaluations, as a fraction of the baseline's.
  std::vector<std::string> only{};  ///< Compare only these cases; empty: all that both programs should have.
};

/// In which of the two results an item occurs.
enum class Presence {
  both,
  added,    ///< In the new results only.
  gone,     ///< In the baseline only.
  removed,  ///< In the baseline only, and listed as removed in the renames.
};

/// Kind of difference between a measured value and that of the baseline.
enum class Movement {
  identical,  ///< Bit-identical; two NaNs are identical.
  round_off,  ///< Too small to be anything but rounding: see `round_off_limit`.
  changed,    ///< All else.
};

/// Reasons why an item is worse than in the baseline, the most severe first.
enum class Reason {
  status,       ///< The case passed and no longer does.
  verdict,      ///< The check passed and now fails, or the control passed and now does not.
  gone,         ///< The item is in the baseline only.
  unit,         ///< Measured in a different unit: the values cannot be compared.
  value,        ///< The measured value changed by more than its tolerance, and by more than round-off.
  margin,       ///< error/bound grew by more than allowed.
  evaluations,  ///< The case used more force evaluations than allowed.
  round_off,    ///< The measured value changed by more than its tolerance, but within round-off.
};

/// Of the enums above: their names in baseline.json.
using records::name_of;

/// Largest change of a measured value that counts as round-off, in units of the check's bound: 1e-9, so that it takes
/// 1e9 such changes in the same direction to use up the bound once, and no verdict depends on one; 1 for checks of kind
/// round_off, whose bound is itself a count of roundings.
[[nodiscard]] double round_off_limit(Kind kind);

/// Scale of a change of the measured value [unit]: the bound, times |reference| if the check is relative. An exact
/// check has no bound; its scale is |reference|.
[[nodiscard]] double change_scale(const Check& before);

/// An item and its change; T holds its values in results.json.
template <class T>
struct Change {
  ItemName name;                         ///< In the new results; in the baseline if it is only there.
  std::optional<ItemName> renamed_from;  ///< Name in the baseline, if different.
  Presence presence = Presence::both;
  std::optional<T> before, after;
  std::vector<Reason> worse{};  ///< Empty: not worse.
};

using ControlChange = Change<Control>;

/// A check and its change. The numbers are 0 unless it is in both results.
struct CheckChange : Change<Check> {
  Movement movement = Movement::identical;
  double difference = 0.0;  ///< Measured value: new - old [unit].
  double moved = 0.0;       ///< |difference| / change_scale: change/bound; infinite if a number is not finite.
  double growth = 0.0;      ///< error/bound: new - old.
  double tolerance = 0.0;   ///< Largest `moved` allowed.
};

/// Status and cost of a case.
struct CaseOutcome {
  Status status = Status::missing;
  std::string message;            ///< Why the case did not pass; empty if it did.
  double seconds = 0.0;           ///< Wall-clock time [s].
  std::uint64_t evaluations = 0;  ///< Counted force evaluations; 0: the case counts none.
};

/// A case and its change.
struct CaseChange : Change<CaseOutcome> {
  std::size_t checks_gone = 0;    ///< Checks of this case that are in the baseline but not in the new results.
  std::size_t controls_gone = 0;  ///< The same for its controls.
};

/// Origin of a results.json.
struct ResultsSource {
  std::filesystem::path file;
  Provenance provenance;
  Tier tier = Tier::quick;
  bool holds = false;               ///< Whether its verdict is "pass".
  std::vector<std::string> only{};  ///< The cases given with --only; empty: the whole tier was run.
};

/// Two results and all their differences.
struct Comparison {
  ResultsSource before, after;
  Allowance allowance;
  std::vector<CaseChange> cases;             ///< In the order of the new results, followed by those in the baseline
                                             ///< only.
  std::vector<CheckChange> checks;           ///< The same.
  std::vector<ControlChange> controls;       ///< The same.
  std::vector<std::string> unselected;       ///< Cases of the baseline that are excluded from the comparison (--only).
  std::vector<std::string> renaming_errors;  ///< Renames that contradict the new results, with file and line.
};

/// Sums over a comparison.
struct Totals {
  struct Items {
    std::size_t compared = 0, added = 0, gone = 0, removed = 0, worsened = 0,
                improved = 0;  ///< The last two count verdicts.
    std::size_t worse = 0;     ///< For any reason.
  };
  Items cases, checks, controls;
  std::size_t identical = 0, round_off = 0, changed = 0;  ///< Measured values of the compared checks.
  std::size_t margins_grown = 0, margins_shrunk = 0;      ///< error/bound of the compared checks.
  std::size_t bounds_widened = 0, bounds_tightened = 0;   ///< Bounds of the compared checks.
  std::size_t references_changed = 0;  ///< References of the compared checks that are not bit-identical.
  std::size_t evaluations_grown = 0, evaluations_shrunk = 0;    ///< Cases.
  std::uint64_t evaluations_before = 0, evaluations_after = 0;  ///< Evaluations of the compared cases.
  double seconds_before = 0.0, seconds_after = 0.0;             ///< Duration of the compared cases [s].

  [[nodiscard]] std::size_t worse() const { return cases.worse + checks.worse + controls.worse; }
};

/// Compares `after` with the baseline `before`. A pure function: reads and writes no file. Cases are matched by id,
/// checks and controls by case and name, or according to `renames`.
[[nodiscard]] Comparison compare(const ResultsFile& before, const ResultsFile& after, const Allowance& allowance,
                                 const std::vector<Renaming>& renames);

[[nodiscard]] Totals totals_of(const Comparison& comparison);

/// Validates the inputs before anything runs. InputError if `tier` is not that of the baseline, the baseline has no
/// case, a tolerance names neither a family (one of `families` or of the baseline) nor a case, a rename begins with a
/// name that the baseline does not have, or a rename ends with a case that is not in `registered`, the ids of all
/// present cases.
void validate(const ResultsFile& before, Tier tier, const Allowance& allowance, const std::vector<Renaming>& renames,
              const std::vector<std::string>& families, const std::vector<std::string>& registered);

}  // namespace talus::verification

namespace talus::records {
template <>
struct Names<verification::Presence> {
  using enum verification::Presence;
  static constexpr std::array values{std::pair{both, "both"}, std::pair{added, "new"}, std::pair{gone, "gone"},
                                     std::pair{removed, "removed"}};
};
template <>
struct Names<verification::Movement> {
  using enum verification::Movement;
  static constexpr std::array values{std::pair{identical, "identical"}, std::pair{round_off, "round_off"},
                                     std::pair{changed, "changed"}};
};
template <>
struct Names<verification::Reason> {
  using enum verification::Reason;
  static constexpr std::array values{std::pair{status, "status"},
                                     std::pair{verdict, "verdict"},
                                     std::pair{gone, "gone"},
                                     std::pair{unit, "unit"},
                                     std::pair{value, "value"},
                                     std::pair{margin, "error/bound"},
                                     std::pair{evaluations, "evaluations"},
                                     std::pair{round_off, "round_off"}};
};
}  // namespace talus::records
