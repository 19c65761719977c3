#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verification/driver/recorded_results.hpp"
#include "verification/driver/renames.hpp"

namespace talus::verification {

/// How much a measured value may change, in units of its check's error bound.
struct ChangeTolerance {
  std::string name;    ///< A family, the letter of a family ("B") or a case; empty: all checks.
  double value = 0.0;  ///< |new - old| <= value * bound; not negative.
};

/// What may differ from the baseline.
struct Allowance {
  std::vector<ChangeTolerance> tolerances;  ///< The last that applies to a check is taken; none: 0.
  std::optional<double> margin;             ///< Allowed growth of error/bound; none: the tolerance of the check.
  bool round_off = false;                   ///< Changes of class Movement::round_off are admitted.
  double evaluation_growth = 0.0;   ///< Allowed growth of a case's evaluations, as a fraction of the baseline's.
  std::vector<std::string> only{};  ///< Compare these cases only; empty: all that both programs should have.
};

/// In which of the two results an item is.
enum class Presence {
  both,
  added,    ///< In the new results only.
  gone,     ///< In the baseline only.
  removed,  ///< In the baseline only, and the renames say that it was removed on purpose.
};

/// How a measured value differs from that of the baseline.
enum class Movement {
  identical,  ///< The same bits; two NaNs are identical.
  round_off,  ///< Too small for any argument but rounding: see `round_off_limit`.
  changed,    ///< All else.
};

/// Why an item is worse than in the baseline; the gravest first.
enum class Reason {
  status,       ///< The case passed and no longer does.
  verdict,      ///< The check passed and fails, or the control turned its check red and no longer does.
  gone,         ///< It is in the baseline only.
  unit,         ///< Measured in another unit: the values cannot be compared.
  value,        ///< The measured value changed by more than its tolerance, and by more than round-off.
  margin,       ///< error/bound grew by more than is allowed.
  evaluations,  ///< The case counted more force evaluations than are allowed.
  round_off,    ///< The measured value changed by more than its tolerance, but within round-off.
};

/// The words for these in baseline.json.
[[nodiscard]] const char* name_of(Presence presence);
[[nodiscard]] const char* name_of(Movement movement);
[[nodiscard]] const char* name_of(Reason reason);

/// Largest change of a measured value that counts as round-off, in units of the check's bound: 1e-9, because a thousand
/// million such changes in one direction use up the bound once, so that no verdict depends on one; 1 for a check of
/// kind round_off, because its bound is itself a count of roundings.
[[nodiscard]] double round_off_limit(Kind kind);

/// What a change of the measured value is divided by [unit]: the bound, times |reference| if the check is relative.
/// An exact check has no bound; then |reference|.
[[nodiscard]] double change_scale(const RecordedCheck& before);

/// An item and what became of it; T is what results.json says of it.
template <class T>
struct Change {
  ItemName name;                         ///< In the new results; in the baseline where it is there only.
  std::optional<ItemName> renamed_from;  ///< In the baseline, if that is another name.
  Presence presence = Presence::both;
  std::optional<T> before, after;
  std::vector<Reason> worse{};  ///< Empty: not worse.
};

using ControlChange = Change<RecordedControl>;

/// A check and what became of it. The numbers are 0 unless it is in both.
struct CheckChange : Change<RecordedCheck> {
  Movement movement = Movement::identical;
  double difference = 0.0;  ///< Measured: new - old [unit].
  double moved = 0.0;       ///< |difference| / change_scale: change/bound; infinite if a number is not finite.
  double growth = 0.0;      ///< error/bound: new - old.
  double tolerance = 0.0;   ///< Largest `moved` allowed.
};

/// A case and what became of it.
struct CaseChange : Change<CaseOutcome> {
  std::size_t checks_gone = 0;    ///< Checks of this case in the baseline that the new results lack.
  std::size_t controls_gone = 0;  ///< The same of its controls.
};

/// Two results and everything that differs.
struct Comparison {
  ResultsSource before, after;
  Allowance allowance;
  std::vector<CaseChange> cases;             ///< In the order of the new results, then what is in the baseline only.
  std::vector<CheckChange> checks;           ///< The same.
  std::vector<ControlChange> controls;       ///< The same.
  std::vector<std::string> unselected;       ///< Cases of the baseline that were not to be compared (--only).
  std::vector<std::string> renaming_errors;  ///< Renames that contradict the new results, with file and line.
};

/// The sums over a comparison.
struct Totals {
  struct Items {
    std::size_t compared = 0, added = 0, gone = 0, removed = 0, worsened = 0,
                improved = 0;  ///< The last two: verdicts.
    std::size_t worse = 0;     ///< For any reason.
  };
  Items cases, checks, controls;
  std::size_t identical = 0, round_off = 0, changed = 0;        ///< Measured values of the checks compared.
  std::size_t margins_grown = 0, margins_shrunk = 0;            ///< error/bound of the checks compared.
  std::size_t bounds_widened = 0, bounds_tightened = 0;         ///< Bounds of the checks compared.
  std::size_t references_changed = 0;                           ///< Of the checks compared, not the same bits.
  std::size_t evaluations_grown = 0, evaluations_shrunk = 0;    ///< Cases.
  std::uint64_t evaluations_before = 0, evaluations_after = 0;  ///< Of the cases compared.
  double seconds_before = 0.0, seconds_after = 0.0;             ///< Of the cases compared [s].

  [[nodiscard]] std::size_t worse() const { return cases.worse + checks.worse + controls.worse; }
};

/// Compares `after` with the baseline `before`. A pure function: reads and writes no file. Cases match by id, checks
/// and controls by case and name, or as `renames` say.
[[nodiscard]] Comparison compare(const RecordedResults& before, const RecordedResults& after,
                                 const Allowance& allowance, const std::vector<Renaming>& renames);

[[nodiscard]] Totals totals_of(const Comparison& comparison);

/// What can be refused before anything is run. InputError if `tier` is not that of the baseline, if it has no case, if
/// a tolerance names neither a family (one of `families` or of the baseline) nor a case, if a rename begins with a name
/// that the baseline does not have, or ends with a case that is not in `registered`, the ids of all present cases.
void validate(const RecordedResults& before, Tier tier, const Allowance& allowance,
              const std::vector<Renaming>& renames, const std::vector<std::string>& families,
              const std::vector<std::string>& registered);

}  // namespace talus::verification
