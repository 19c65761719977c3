#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/findings.hpp"

/// Checks of many numbers at once, reduced to the worst one.
namespace talus::verification::problems {

/// Stores the error in `worst`, with its sign, if it is larger in magnitude. A NaN persists.
inline void keep_worst(double& worst, double error) {
  if (!std::isnan(worst) && !(std::abs(error) <= std::abs(worst))) worst = error;
}

/// The error that is larger in magnitude than the others, with its sign. A NaN persists (std::max would drop it).
[[nodiscard]] inline double worst_of(std::initializer_list<double> errors) {
  double worst = 0.0;
  for (const double error : errors)
    keep_worst(worst, error);
  return worst;
}

/// Stores the magnitude of the error in `largest` if it is larger. A NaN persists (std::max would drop it).
inline void keep_largest(double& largest, double error) { keep_worst(largest, std::abs(error)); }

/// Stores the value in `smallest` if it is smaller. A NaN persists (std::min would drop it).
inline void keep_smallest(double& smallest, double value) {
  if (!std::isnan(smallest) && !(value >= smallest)) smallest = value;
}

/// Worst of measured - reference, component by component; NaN if one has more than the other.
[[nodiscard]] inline double worst_error(const std::vector<double>& measured, const std::vector<double>& reference) {
  double worst = measured.size() == reference.size() ? 0.0 : NAN;
  for (std::size_t i = 0; i < std::min(measured.size(), reference.size()); ++i)
    keep_worst(worst, measured[i] - reference[i]);
  return worst;
}

/// Compares each of `measured` with its reference in one check of the worst difference.
inline bool expect_each(Findings& findings, CheckName name, const std::vector<double>& measured,
                        const std::vector<double>& reference, const Tolerance& tolerance, std::string unit = "1") {
  return findings.expect(std::move(name), worst_error(measured, reference), 0.0, tolerance, std::move(unit));
}

/// The ratio that is farther from 1; a NaN persists.
[[nodiscard]] inline double worst_ratio(double ratio, double other) {
  return std::isnan(ratio) || std::abs(other - 1.0) < std::abs(ratio - 1.0) ? ratio : other;
}

/// Compares the last of the errors with constant step^order. The deviation of the ratio from 1 must decrease according
/// to the next power of the error: by 2^power from the previous one, at twice the step. `floor` is the accuracy to
/// which the prediction itself is integrated.
inline void expect_constant(Findings& findings, const std::string& name, const Convergence& errors, double constant,
                            int order, int power, double floor) {
  const auto off = [&](std::size_t i) { return errors.errors()[i] / (constant * std::pow(errors.steps()[i], order)); };
  const std::size_t last = errors.size() - 1;
  findings.expect("error over its prediction, " + name, off(last), 1.0,
                  Tolerance::truncation(std::max(std::abs(off(last - 1) - 1.0) / std::pow(2.0, power), floor),
                                        power == 1 ? 1.5 : 2.0,
                                        "what is left at twice the step falls by 2 to the next power of the error: a "
                                        "constant that is another stays. At least what the prediction itself is "
                                        "integrated to"));
}

}  // namespace talus::verification::problems
