#pragma once

#include <array>
#include <string>
#include <utility>

#include "verification/record/names.hpp"

namespace talus::records {

/// The kind of justification of a check's bound.
enum class Kind {
  exact,       ///< The two numbers must be equal: no rounding enters, or it is the same on both sides.
  round_off,   ///< They differ only by rounding: n operations, each half an epsilon of the largest term.
  truncation,  ///< They differ by discretisation: a predicted or measured constant times the step to the power of the
               ///< order.
  model,       ///< The models differ: a stiffness for a rigid wall, a printed number with three digits.
  interval,    ///< Two-sided range, e.g. for an observed order.
};

template <>
struct Names<Kind> {
  static constexpr std::array values{std::pair{Kind::exact, "exact"}, std::pair{Kind::round_off, "round_off"},
                                     std::pair{Kind::truncation, "truncation"}, std::pair{Kind::model, "model"},
                                     std::pair{Kind::interval, "interval"}};
};

/// Whether the kind's bounds are not chosen, so that its checks are never marked as slack.
[[nodiscard]] constexpr bool exempt_from_slack(Kind kind) { return kind == Kind::exact || kind == Kind::round_off; }

/// One comparison of a measured number with a reference, and its verdict, determined once when the check is made.
struct Check {
  std::string name;             ///< Unique in its case; used by controls to refer to it.
  std::string unit;             ///< Unit of measured and reference; "1" for a pure number.
  double measured = 0.0;        ///< Result of the code under test [unit].
  double reference = 0.0;       ///< Expected value [unit]; the midpoint of an interval.
  double error = 0.0;           ///< |measured - reference| [unit], divided by |reference| if relative.
  double bound = 0.0;           ///< Largest allowed error, in the unit of `error`; half the width of an interval.
  double margin = 0.0;          ///< error / bound; 0 if both are zero, infinite if only the bound is.
  bool relative = false;        ///< Error and bound are divided by |reference|.
  Kind kind = Kind::exact;      ///< The kind of justification of the bound.
  std::string why{};            ///< The justification as text.
  bool pass = false;            ///< error <= bound, all numbers finite.
  bool slack = false;           ///< margin below 1/50 where the bound was chosen (truncation, model, interval).
  bool order = false;           ///< Measured is an order of convergence.
  std::string text_measured{};  ///< Measured as text ("true", "false"); empty: print the number.
  std::string message{};        ///< Why the check failed if the numbers alone do not show it; otherwise empty.
  bool main = false;            ///< Named by the case for the table of main checks.
};

/// A smaller margin marks a bound as slack: it is so wide that it would hide a fault of fifty times the error.
inline constexpr double slack_margin = 1.0 / 50.0;

/// error/bound of a check: 0 if both are zero, infinite if only the bound is, NaN for a NaN.
[[nodiscard]] double margin_of(double error, double bound);

/// error/bound of a check with `digits` significant digits, on the correct side of 1: below 1 if the check passes,
/// above 1 if it fails. Where rounding would hide the verdict, three decimals are used, with 0.999 and 1.001 as the
/// values nearest to 1. "nan" and "inf" for values that are not finite.
[[nodiscard]] std::string margin_text(double margin, bool pass, int digits);

/// Why the verdict of a check does not follow from its numbers; empty if it does.
[[nodiscard]] std::string contradiction(const Check& check);

}  // namespace talus::records
