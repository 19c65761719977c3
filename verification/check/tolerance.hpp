#pragma once

#include <string>

#include "verification/record/check.hpp"

namespace talus::verification {

using records::Kind;

/// An error bound and its justification.
///
/// There is no default and no plain number: each constructor requires the justification. Errors: std::invalid_argument
/// for an empty text or a bound that is not finite and positive.
class Tolerance {
 public:
  /// Equality of two doubles; the bound is zero.
  [[nodiscard]] static Tolerance exact(std::string why);

  /// `bound` follows from counting roundings.
  [[nodiscard]] static Tolerance round_off(double bound, std::string why);

  /// The bound is `factor * predicted_error`, where the prediction is the next Taylor term or a measured constant times
  /// the step to the power of the order. `factor` lies in [1, 3]: a bound wider than three times the measured constant
  /// shows nothing.
  [[nodiscard]] static Tolerance truncation(double predicted_error, double factor, std::string why);

  /// `bound` is the size of an effect that only one side models, or half a unit of the last printed digit.
  [[nodiscard]] static Tolerance model(double bound, std::string why);

  /// The same bound applied to |measured - reference| / |reference|. (A zero reference then fails the check.)
  [[nodiscard]] Tolerance relative() const;

  /// Largest allowed error, in the unit of the quantity, or dimensionless when relative; zero only if exact.
  [[nodiscard]] double bound() const { return bound_; }
  [[nodiscard]] bool is_relative() const { return relative_; }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  Tolerance(Kind kind, double bound, std::string why);

  Kind kind_;
  double bound_;
  bool relative_ = false;
  std::string why_;
};

}  // namespace talus::verification
