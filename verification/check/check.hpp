#pragma once

#include <string>

#include "verification/check/tolerance.hpp"

namespace talus::verification {

/// One comparison of a measured number with a reference, and its verdict, derived once when the check is made.
struct Check {
  std::string name;           ///< Unique in its case; controls name it.
  std::string unit;           ///< Unit of measured and reference; "1" for a pure number.
  double measured = 0.0;      ///< What the code under test gave [unit].
  double reference = 0.0;     ///< What it should be [unit]; the middle of an interval.
  double error = 0.0;         ///< |measured - reference| [unit], divided by |reference| if relative.
  double bound = 0.0;         ///< Largest admitted error, in the unit of `error`; half the width of an interval.
  double margin = 0.0;        ///< error / bound; 0 if both are zero, infinite if only the bound is.
  bool relative = false;      ///< Error and bound are divided by |reference|.
  Kind kind = Kind::exact;    ///< The kind of argument behind the bound.
  std::string why;            ///< The argument in words.
  bool pass = false;          ///< error <= bound, all numbers finite.
  bool slack = false;         ///< margin below 1/50 where the bound was chosen (truncation, model, interval).
  bool order = false;         ///< Measured is an order of convergence.
  std::string text_measured;  ///< Measured in words ("true", "false"); empty: print the number.
  std::string message;        ///< Why the check failed when the numbers alone do not say; empty otherwise.
};

/// A margin below this marks a bound as slack: it is so wide that it would hide a fault fifty times the error.
inline constexpr double slack_margin = 1.0 / 50.0;

/// error/bound of a check in `digits` significant digits, on the right side of 1: below it for a check that passes,
/// above it for one that fails. Where rounding would hide the verdict there are three decimals, 0.999 and 1.001 nearest
/// to 1. "nan" and "inf" as words. (reports/markdown.hpp has the same for the report.)
[[nodiscard]] std::string margin_text(double margin, bool pass, int digits);

/// Compares `measured` with `reference`. A number that is not finite fails, and so does a relative error from zero.
[[nodiscard]] Check compare(std::string name, double measured, double reference, const Tolerance& tolerance,
                            std::string unit);

/// Demands `low <= measured <= high`, as the error from the middle against half the width.
/// std::invalid_argument if the range is empty or not finite, or if the words are missing.
[[nodiscard]] Check compare_between(std::string name, double measured, double low, double high, std::string why,
                                    std::string unit);

}  // namespace talus::verification
