#include "verification/record/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace talus::records {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

double margin_of(double error, double bound) {
  using Limits = std::numeric_limits<double>;
  if (std::isnan(error)) return Limits::quiet_NaN();
  if (bound > 0.0) return error / bound;
  return error == 0.0 ? 0.0 : Limits::infinity();
}

std::string margin_text(double margin, bool pass, int digits) {
  if (std::isnan(margin)) return "nan";
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

std::string contradiction(const Check& check) {
  const bool holds = std::isfinite(check.measured) && std::isfinite(check.reference) && std::isfinite(check.error) &&
                     check.error <= check.bound;
  if (check.pass != holds) return "its verdict does not follow from its numbers";
  double error = std::abs(check.measured - check.reference);
  if (check.relative) error /= std::abs(check.reference);
  if (holds && error != check.error) return "its error does not follow from its numbers";
  if (!same(check.margin, margin_of(check.error, check.bound))) return "its margin does not follow from its numbers";
  if (check.slack != (check.pass && !exempt_from_slack(check.kind) && check.margin < slack_margin)) {
    return "its mark of slack does not follow from its numbers";
  }
  return "";
}

}  // namespace talus::records
