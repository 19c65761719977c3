#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/check/convergence.hpp"
#include "verification/check/figure.hpp"

/// Errors at several steps with their predictions.
namespace talus::verification::problems {

/// Measured and predicted errors at the same steps (or values of any small parameter).
class PredictedErrors {
 public:
  void add(double step, double found, double predicted) {
    found_.add(step, found);
    predicted_.push_back(predicted);
  }

  [[nodiscard]] const Convergence& found() const { return found_; }
  /// Ratio of measured to predicted error, at the last step added.
  [[nodiscard]] double last_ratio() const { return found_.errors().back() / predicted_.back(); }
  /// The measured errors as points.
  [[nodiscard]] Series points(std::string label) const {
    return {std::move(label), found_.steps(), found_.errors(), Style::points};
  }
  /// The predicted errors as a line.
  [[nodiscard]] Series line(std::string label = "predicted") const {
    return {std::move(label), found_.steps(), predicted_, Style::lines};
  }

 private:
  Convergence found_;
  std::vector<double> predicted_;
};

/// Measured errors for each of `parameters`: study(parameter) gives the step and its error.
template <class Study>
[[nodiscard]] Convergence convergence(const std::vector<double>& parameters, Study&& study) {
  Convergence found;
  for (const double parameter : parameters) {
    const auto [step, error] = study(parameter);
    found.add(step, error);
  }
  return found;
}

/// Measured and predicted errors: study(parameter) gives the step, its error and the predicted error.
template <class Study>
[[nodiscard]] PredictedErrors predicted_errors(const std::vector<double>& parameters, Study&& study) {
  PredictedErrors all;
  for (const double parameter : parameters) {
    const auto [step, found, predicted] = study(parameter);
    all.add(step, found, predicted);
  }
  return all;
}

}  // namespace talus::verification::problems
