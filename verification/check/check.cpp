#include "verification/check/check.hpp"

#include <cfenv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace talus::verification {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double error_of(Check& check) {
  if (!std::isfinite(check.measured) || !std::isfinite(check.reference)) {
    check.message = std::isfinite(check.measured) ? "the reference is not finite" : "the measured value is not finite";
    return not_a_number;
  }
  const double distance = std::abs(check.measured - check.reference);
  if (!check.relative) return distance;
  if (check.reference == 0.0) {
    check.message = "a relative error needs a reference other than zero";
    return infinity;
  }
  return distance / std::abs(check.reference);
}

/// Not inlined, so that no arithmetic moves past a change of the rounding mode.
[[gnu::noinline]] void judge(Check& check) {
  check.error = error_of(check);
  check.margin = records::margin_of(check.error, check.bound);
  check.pass = std::isfinite(check.error) && check.error <= check.bound;
  check.slack = check.pass && !exempt_from_slack(check.kind) && check.margin < records::slack_margin;
}

/// Rounds error and margin to nearest even if a case runs under another rounding mode, because readers of the record
/// recompute them.
Check judged(Check check) {
  const int rounding = std::fegetround();
  std::fesetround(FE_TONEAREST);
  judge(check);
  std::fesetround(rounding);
  return check;
}

}  // namespace

Check compare(std::string name, double measured, double reference, const Tolerance& tolerance, std::string unit) {
  Check check;
  check.name = std::move(name);
  check.unit = std::move(unit);
  check.measured = measured;
  check.reference = reference;
  check.bound = tolerance.bound();
  check.relative = tolerance.is_relative();
  check.kind = tolerance.kind();
  check.why = tolerance.why();
  return judged(std::move(check));
}

Check compare_between(std::string name, double measured, double low, double high, std::string why, std::string unit) {
  const double half_width = 0.5 * (high - low);
  if (!(std::isfinite(half_width) && half_width > 0.0)) {
    throw std::invalid_argument("check '" + name + "': an interval needs two finite ends, the lower one first");
  }
  // The bound is half the width; a justification is required as for every tolerance.
  Check check = compare(std::move(name), measured, 0.5 * (low + high), Tolerance::model(half_width, std::move(why)),
                        std::move(unit));
  check.kind = Kind::interval;
  return judged(std::move(check));
}

}  // namespace talus::verification
