#include "solver/calibrate/impact_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Number of pairs of a phase of first contact and a phase of separation by which a step is judged, each evenly spread
/// (the second by the golden ratio). At a single step both phases change together: the errors of contact and separation
/// may then cancel at nearly all phases and add up in a narrow window that no sample hits (measured: 0.007 at 32
/// phases, 0.049 at a thirty-third).
constexpr int pair_count = 64;
constexpr double golden = 0.6180339887498949;
/// Fraction of a step by which a contact of an advised step ends after a whole number of steps.
constexpr double advised_fraction = 0.381966;
/// Fraction of the error at all phases that the samples find. They miss the corner where both errors are largest by up
/// to an eighth in each phase; a fifth of the bound is reserved for it.
constexpr double kept = 0.8;

/// Whether impacts with `whole` to `whole` + 1 steps in a contact are accurate. Raises `largest` to an upper
/// estimate of the largest error at all phases.
bool is_accurate(const ImpactError& error, double contact_time, double whole, double bound, double& largest) {
  for (int i = 0; i < pair_count; ++i) {
    const double phase = (i + 0.5) / pair_count;
    const double step = contact_time / (whole + golden * (i + 0.5) - std::floor(golden * (i + 0.5)));
    const double found = error(step, phase);
    largest = std::max(largest, found / kept);
    if (!(found <= kept * bound)) return false;
  }
  return true;
}

}  // namespace

StepOfImpact accurate_step(const ImpactError& error, double contact_time, double bound, double longest) {
  if (!(bound > 0.0)) throw InputError{fmt::format("error bound is {}; it must be > 0", bound)};
  for (int n = 3; n <= 18; ++n) {
    StepOfImpact found{contact_time / (std::ldexp(1.0, n) + advised_fraction), 0.0};
    if (found.step > longest) continue;
    if (is_accurate(error, contact_time, std::ldexp(1.0, n), bound, found.largest_error)) return found;
  }
  throw InputError{fmt::format(
      "an error of e below {} is not reached with 2^18 steps in a contact; allow a larger error, or choose another "
      "integrator",
      bound)};
}

bool CommonStep::require(const ImpactError& error, double contact_time) {
  double largest = found_.largest_error;
  if (std::isfinite(found_.step) &&
      is_accurate(error, contact_time, contact_time / found_.step - advised_fraction, bound_, largest)) {
    found_.largest_error = largest;
    return false;
  }
  const StepOfImpact shorter = accurate_step(error, contact_time, bound_, found_.step);
  found_ = {shorter.step, std::max(found_.largest_error, shorter.largest_error)};
  return true;
}

}  // namespace talus
