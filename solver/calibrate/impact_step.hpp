#pragma once

#include <functional>
#include <limits>

namespace talus {

/// Error of an impact that is simulated with this step [T], if the surfaces meet at this fraction of a step; infinite
/// if the contact does not end.
using ImpactError = std::function<double(double step, double phase)>;

/// A step and the largest error of impacts with about this step.
struct StepOfImpact {
  double step{};  ///< [T]
  /// At all phases at which the surfaces meet and part: 1.25 times the largest of 64 pairs, an upper estimate.
  double largest_error{};
};

/// Finds a step of the form contact time/(2^n + 0.38), n >= 3, at most `longest` [T], at which impacts of this contact
/// time [T] have errors of at most 0.8 of the bound for 64 pairs of phases at which the surfaces meet and part. Errors:
/// InputError if bound is not > 0, too small to be reached with 2^18 steps in a contact, or if no impact ends.
[[nodiscard]] StepOfImpact accurate_step(const ImpactError& error, double contact_time, double bound,
                                         double longest = std::numeric_limits<double>::infinity());

/// A step for several impacts, found one by one.
class CommonStep {
 public:
  explicit CommonStep(double bound) : bound_{bound} {}

  /// Shortens the step to accurate_step() of an impact that is not as accurate at the present one; the first impact
  /// sets it. Returns whether the step has changed. Impacts with shorter contacts should come first: fewer are
  /// simulated twice. Errors: as accurate_step().
  bool require(const ImpactError& error, double contact_time);

  /// Infinite before the first impact [T].
  double step() const { return found_.step; }
  const StepOfImpact& found() const { return found_; }

 private:
  double bound_;
  StepOfImpact found_{std::numeric_limits<double>::infinity(), 0.0};
};

}  // namespace talus
