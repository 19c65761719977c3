#include "verification/check/check.hpp"

#include <fmt/format.h>

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

double margin_of(double error, double bound) {
  if (std::isnan(error)) return not_a_number;
  if (bound > 0.0) return error / bound;
  return error == 0.0 ? 0.0 : infinity;
}

Check judged(Check check) {
  check.error = error_of(check);
  check.margin = margin_of(check.error, check.bound);
  check.pass = std::isfinite(check.error) && check.error <= check.bound;
  const bool bound_was_chosen =
      check.kind == Kind::truncation || check.kind == Kind::model || check.kind == Kind::interval;
  check.slack = check.pass && bound_was_chosen && check.margin < slack_margin;
  return check;
}

}  // namespace

std::string margin_text(double margin, bool pass, int digits) {
  const auto shows_verdict = [&](const std::string& text) {
    const double shown = std::stod(text);
    return pass ? shown < 1.0 : !(shown <= 1.0);
  };
  const std::string rounded = fmt::format("{:.{}g}", margin, digits);
  if (shows_verdict(rounded)) return rounded;
  const std::string decimals = fmt::format("{:.3f}", margin);
  if (shows_verdict(decimals)) return decimals;
  return pass ? "0.999" : "1.001";
}

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
  // The bound is half the width, and the words are demanded as for every tolerance.
  Check check = compare(std::move(name), measured, 0.5 * (low + high), Tolerance::model(half_width, std::move(why)),
                        std::move(unit));
  check.kind = Kind::interval;
  return judged(std::move(check));
}

}  // namespace talus::verification
