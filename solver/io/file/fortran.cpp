#include "solver/io/file/fortran.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "solver/base/error.hpp"
#include "verification/record/utf8.hpp"

namespace talus {
namespace {

/// A rounded number: sign, digits d of 0.ddd, and exponent of ten.
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
  ++made.exponent;  // the decimal point moves one digit to the left
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

std::string found_text(std::string_view text) {
  return fmt::format("found \"{}{}\"", records::shown_text(text.substr(0, 40)), text.size() > 40 ? "..." : "");
}

bool parse_fortran_real(std::string_view text, double& number) {
  std::string digits{text.substr(text.front() == '+' ? 1 : 0)};
  const std::size_t exponent = digits.find_first_of("dD");
  if (exponent != std::string::npos) digits[exponent] = 'e';
  const std::size_t first = !digits.empty() && digits.front() == '-' && text.front() == '-' ? 1 : 0;
  if (first >= digits.size() || !((digits[first] >= '0' && digits[first] <= '9') || digits[first] == '.')) return false;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error == std::errc::result_out_of_range && stop == end) {
    throw InputError{found_text(text) + "; the number is too large or too small for a double"};
  }
  return error == std::errc{} && stop == end;
}

}  // namespace talus
