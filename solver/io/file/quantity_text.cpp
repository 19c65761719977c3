#include "solver/io/file/quantity_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>

#include "solver/base/error.hpp"

namespace talus {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

double read_back(const std::string& text, std::string_view unit, Dimension dimension, const UnitSystem& system) {
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return consistent(number, unit, dimension, system);
}

}  // namespace

Decimal decimal(double value, std::string_view unit, Dimension dimension, const UnitSystem& system) {
  const double quotient = value / consistent(1.0, unit, dimension, system);
  for (int digits = 15; digits < 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", quotient, digits);
    if (same_bits(read_back(text, unit, dimension, system), value)) return {text, true};
  }
  // The quotient and the product are rounded separately: the number sought may differ by a few units in the last place.
  Decimal nearest;
  double error = INFINITY;
  for (const int ulps : {0, -1, 1, -2, 2}) {
    double number = quotient;
    for (int i = 0; i < std::abs(ulps); ++i)
      number = std::nextafter(number, ulps > 0 ? INFINITY : -INFINITY);
    const std::string text = fmt::format("{:.17g}", number);
    const double read = read_back(text, unit, dimension, system);
    if (same_bits(read, value)) return {text, true};
    if (std::abs(read - value) < error) {
      error = std::abs(read - value);
      nearest.text = text;
    }
  }
  return nearest;
}

std::string deck_unit(Dimension dimension) {
  if (dimension == dimension::number) return "";
  if (dimension == dimension::pressure) return "psi";
  return dimension == dimension::area ? "in^2" : symbol(us, dimension);
}

double option_quantity(const std::string& option, const std::string& text, Dimension dimension, const UnitSystem& units,
                       bool positive) {
  double value = 0.0;
  try {
    value = parse_quantity(text, dimension, units);
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: {}", option, error.what())};
  }
  if (positive && !(value > 0.0)) throw InputError{fmt::format("{}: found \"{}\"; it must be > 0", option, text)};
  return value;
}

}  // namespace talus
