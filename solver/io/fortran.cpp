#include "solver/io/fortran.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// A number rounded to .ddd times ten to an exponent.
struct Rounded {
  std::string sign;
  std::string digits;
  int exponent{};
};

Rounded rounded(double value, int digits) {
  TALUS_DEMAND(std::isfinite(value) && digits >= 1 && digits <= 17);
  if (value == 0.0) return {"", std::string(static_cast<std::size_t>(digits), '0'), 0};
  const std::string text = fmt::format("{:.{}e}", std::abs(value), digits - 1);  // d.dde+XX
  const std::size_t mark = text.find('e');
  Rounded made{value < 0.0 ? "-" : "", text.substr(0, 1), 0};
  if (digits > 1) made.digits += text.substr(2, mark - 2);
  const char* exponent = text.data() + mark + (text[mark + 1] == '+' ? 2 : 1);
  std::from_chars(exponent, text.data() + text.size(), made.exponent);
  ++made.exponent;  // the point stands one place further left
  return made;
}

}  // namespace

std::string fortran_e(double value, int digits) {
  const Rounded r = rounded(value, digits);
  const int size = std::abs(r.exponent);
  return fmt::format("{}.{}{}{}{:02}", r.sign, r.digits, size < 100 ? "E" : "", r.exponent < 0 ? '-' : '+', size);
}

std::string fortran_g(double value, int digits) {
  const Rounded r = rounded(value, digits);
  if (r.exponent < 0 || r.exponent > digits) return fortran_e(value, digits);
  const auto point = static_cast<std::size_t>(r.exponent);
  return r.sign + r.digits.substr(0, point) + "." + r.digits.substr(point);
}

}  // namespace talus
