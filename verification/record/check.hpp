#pragma once

#include <array>
#include <string>
#include <utility>

#include "verification/record/names.hpp"

namespace talus::records {

/// The kind of argument behind the bound of a check.
enum class Kind {
  exact,       ///< The two numbers must be equal: no rounding enters, or it is the same on both sides.
  round_off,   ///< Only rounding separates them: n operations, each half an epsilon of the largest term.
  truncation,  ///< The step or mesh separates them: a predicted or measured constant times the step to its order.
  model,       ///< The models differ: a stiffness for a rigid wall, a printed number with three digits.
  interval,    ///< Two-sided range, e.g. for an observed order.
};

template <>
struct Names<Kind> {
  static constexpr std::array values{std::pair{Kind::exact, "exact"}, std::pair{Kind::round_off, "round_off"},
                                     std::pair{Kind::truncation, "truncation"}, std::pair{Kind::model, "model"},
                                     std::pair{Kind::interval, "interval"}};
};

/// True for the kinds whose bounds are not chosen, and whose checks are therefore never called slack.
[[nodiscard]] constexpr bool exempt_from_slack(Kind kind) { return kind == Kind::exact || kind == Kind::round_off; }

/// One comparison of a measured number with a reference, and its verdict, derived once when the check is made.
struct Check {
  std::string name;             ///< Unique in its case; controls name it.
  std::string unit;             ///< Unit of measured and reference; "1" for a pure number.
  double measured = 0.0;        ///< What the code under test gave [unit].
  double reference = 0.0;       ///< What it should be [unit]; the middle of an interval.
  double error = 0.0;           ///< |measured - reference| [unit], divided by |reference| if relative.
  double bound = 0.0;           ///< Largest admitted error, in the unit of `error`; half the width of an interval.
  double margin = 0.0;          ///< error / bound; 0 if both are zero, infinite if only the bound is.
  bool relative = false;        ///< Error and bound are divided by |reference|.
  Kind kind = Kind::exact;      ///< The kind of argument behind the bound.
  std::string why{};            ///< The argument as text.
  bool pass = false;            ///< error <= bound, all numbers finite.
  bool slack = false;           ///< margin below 1/50 where the bound was chosen (truncation, model, interval).
  bool order = false;           ///< Measured is an order of convergence.
  std::string text_measured{};  ///< Measured as text ("true", "false"); empty: print the number.
  std::string message{};        ///< Why the check failed when the numbers alone do not say; empty otherwise.
  bool main = false;            ///< Named by the case for the table of main checks.
};

/// A margin below this marks a bound as slack: it is so wide that it would hide a fault fifty times the error.
inline constexpr double slack_margin = 1.0 / 50.0;

/// error/bound of a check: 0 if both are zero, infinite if only the bound is, NaN for a NaN.
[[nodiscard]] double margin_of(double error, double bound);

/// error/bound of a check in `digits` significant digits, on the correct side of 1: below it for a check that passes,
/// above it for one that fails. Where rounding would hide the verdict there are three decimals, 0.999 and 1.001 nearest
/// to 1. "nan" and "inf" for those.
[[nodiscard]] std::string margin_text(double margin, bool pass, int digits);

/// Why the verdict of a check does not follow from its numbers; empty if it does.
[[nodiscard]] std::string contradiction(const Check& check);

}  // namespace talus::records
