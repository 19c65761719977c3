#pragma once

#include <cstddef>
#include <vector>

namespace talus::verification {

/// A power law error = constant * step^order, fitted to measured errors.
struct PowerLaw {
  double order = 0.0;     ///< Slope in the log-log plot.
  double constant = 0.0;  ///< Error at step 1.
  double scatter = 0.0;   ///< Root mean square of ln(error / fit): 0.1 means that points deviate by 10 % from the line.

  /// The fitted error at `step`.
  [[nodiscard]] double at(double step) const;
};

/// Errors at several steps, and their convergence order.
class Convergence {
 public:
  Convergence() = default;
  /// Errors: std::invalid_argument unless `steps` and `errors` have equal length.
  Convergence(std::vector<double> steps, std::vector<double> errors);

  /// Adds one point: a step (or any small parameter: 1/sqrt(k), node spacing) and its error.
  void add(double step, double error);

  [[nodiscard]] const std::vector<double>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<double>& errors() const { return errors_; }
  [[nodiscard]] std::size_t size() const { return steps_.size(); }

  /// Only the last `count` points added (the finest, when refining); std::invalid_argument if there are fewer.
  [[nodiscard]] Convergence last(std::size_t count) const;

  /// Only the points with `smallest <= step <= largest`, e.g. to stay above the round-off floor.
  [[nodiscard]] Convergence between(double smallest, double largest) const;

  /// Least-squares line through (ln step, ln error).
  ///
  /// With s = ln step - mean, y = ln error: order = sum(s y) / sum(s^2), ln constant = mean(y) - order mean(ln step).
  /// NaN, which no check passes, if there are fewer than two different steps or if a step or error is not finite and
  /// positive.
  [[nodiscard]] PowerLaw fit() const;

 private:
  std::vector<double> steps_;
  std::vector<double> errors_;
};

/// Errors over many onset phases, reduced to the values that are checked. A NaN among them makes both results NaN.
class PhaseError {
 public:
  /// Adds the error (any sign) of one phase.
  void add(double error);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// Root mean square; NaN before the first error.
  [[nodiscard]] double rms() const;
  /// Largest absolute value; NaN before the first error.
  [[nodiscard]] double max() const;

 private:
  std::size_t count_ = 0;
  double sum_of_squares_ = 0.0;
  double largest_ = 0.0;
};

/// Minimum number of onset phases for a checked root mean square.
inline constexpr std::size_t fewest_phases = 64;

/// `count` onset phases evenly spread over one step: (i + 1/2) / count, each in (0, 1).
[[nodiscard]] std::vector<double> even_phases(std::size_t count);

/// `count` onset phases spread by the golden ratio: frac(0.6180339887 (i + 1/2)), evenly distributed for every count.
[[nodiscard]] std::vector<double> golden_phases(std::size_t count);

/// The step contact_time / (steps_per_contact + 0.381966): never an integer fraction of the contact time, so that the
/// errors of onset and release do not cancel.
[[nodiscard]] double incommensurate_step(double contact_time, double steps_per_contact);

/// A step with a different offset for each phase i: contact_time / (steps_per_contact + frac(0.6180339887 (i + 1/2))).
/// Required with damping, where a common offset still favours or hinders the release.
[[nodiscard]] double offset_step(double contact_time, double steps_per_contact, std::size_t phase);

/// first, 2 first, 4 first, ...: `count` numbers of steps per contact.
[[nodiscard]] std::vector<double> doublings(double first, std::size_t count);

}  // namespace talus::verification
