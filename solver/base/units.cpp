#include "solver/base/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/unit_table.hpp"

namespace talus {
namespace {

using namespace unit_table;

const NamedDimension* find_named(Dimension wanted) {
  for (const NamedDimension& named : named_dimensions) {
    if (named.dimension == wanted) return &named;
  }
  return nullptr;
}

const Unit* find_unit(std::string_view name) {
  for (const Unit& unit : units) {
    if (unit.symbol == name) return &unit;
  }
  return nullptr;
}

double power(double base, int exponent) {
  double result = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i)
    result *= base;
  return exponent < 0 ? 1.0 / result : result;
}

/// Dimension and size of a product of units, accumulated while it is read.
struct Product {
  Dimension dimension;
  Size size;

  void multiply(const Unit& unit, int exponent) {
    const Dimension d = unit.dimension;
    dimension = dimension * Dimension{d.mass * exponent, d.length * exponent, d.time * exponent, d.angle * exponent};
    const int count = std::abs(exponent);
    (exponent > 0 ? size.numerator : size.denominator) *= power(unit.size.numerator, count);
    (exponent > 0 ? size.denominator : size.numerator) *= power(unit.size.denominator, count);
    size.foot += unit.size.foot * exponent;
    size.pound += unit.size.pound * exponent;
    size.gravity += unit.size.gravity * exponent;
  }
};

/// Converts `value` in a unit of the given size to SI (or to consistent units, once the size is divided by that of the
/// system's unit).
double scaled(double value, const Size& size) {
  double numerator = size.numerator;
  double denominator = size.denominator;
  const auto collect = [&](double constant, int exponent) {
    (exponent > 0 ? numerator : denominator) *= power(constant, std::abs(exponent));
  };
  collect(exact::foot_in_m, size.foot);
  collect(exact::pound_in_kg, size.pound);
  collect(exact::standard_gravity, size.gravity);
  return value * numerator / denominator;
}

/// Divides by the consistent unit of `dimension` in the system.
void divide_by_own(Product& product, const UnitSystem& system) {
  const Dimension d = product.dimension;
  const auto divide = [&](std::string_view own, int exponent) {
    const Unit* unit = find_unit(own);
    TALUS_DEMAND(unit != nullptr);
    product.multiply(*unit, -exponent);
  };
  divide(system.mass, d.mass);
  divide(system.length, d.length);
  divide(system.time, d.time);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads a quantity from left to right: number, then units joined by blanks, "*" and "/", each with an optional "^" and
/// integer.
class QuantityText {
 public:
  QuantityText(std::string_view text, Dimension wanted, const UnitSystem& system)
      : text_{text}, wanted_{wanted}, system_{system} {}

  double value() { return times_units(read_number()); }

  AnyQuantity any() {
    const double number = read_number();
    Product product;
    if (!at_end()) read_units(product);
    const Dimension dimension = product.dimension;
    divide_by_own(product, system_);
    return {scaled(number, product.size), dimension};
  }

  /// `number` times the units that follow, in consistent units.
  double times_units(double number) {
    Product product;
    if (!at_end()) read_units(product);
    if (product.dimension != wanted_) fail_dimension(product.dimension);
    divide_by_own(product, system_);
    return scaled(number, product.size);
  }

 private:
  [[noreturn]] void fail(std::string_view why) const { throw InputError{fmt::format("found \"{}\"; {}", text_, why)}; }

  std::string example(std::string_view number) const {
    if (wanted_ == dimension::number) return fmt::format("e.g. \"{}\"", number);
    return fmt::format("e.g. \"{} {}\"", number, symbol(system_, wanted_));
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
      ++at_;
  }
  bool at_end() {
    skip_blanks();
    return at_ == text_.size();
  }

  double read_number() {
    skip_blanks();
    const std::size_t sign = at_;
    if (at_ < text_.size() && text_[at_] == '+') ++at_;
    const std::size_t first = at_ + (at_ < text_.size() && text_[at_] == '-' && at_ == sign ? 1 : 0);
    if (first >= text_.size() || !(is_digit(text_[first]) || text_[first] == '.')) fail_number();
    double number = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error == std::errc::result_out_of_range) fail("the number is too large or too small for a double");
    if (error != std::errc{}) fail_number();
    at_ = static_cast<std::size_t>(end - text_.data());
    number_ = text_.substr(sign, at_ - sign);
    return number;
  }

  void read_units(Product& product) {
    int direction = 1;
    do {
      read_unit(product, direction);
      skip_blanks();
      direction = 1;
      if (at_ < text_.size() && (text_[at_] == '*' || text_[at_] == '/')) {
        direction = text_[at_] == '/' ? -1 : 1;
        ++at_;
        if (at_end()) fail(fmt::format("a unit must follow '{}'", text_[at_ - 1]));
      }
    } while (!at_end());
  }

  void read_unit(Product& product, int direction) {
    skip_blanks();
    // "1/s": a 1 takes the place of the missing unit before the slash.
    if (text_[at_] == '1' && text_.substr(at_ + 1).find_first_not_of(" \t") != std::string_view::npos &&
        text_[text_.find_first_not_of(" \t", at_ + 1)] == '/') {
      ++at_;
      return;
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && is_letter(text_[at_]))
      ++at_;
    if (at_ == start) fail(fmt::format("'{}' is not a unit; write {}", text_.substr(at_), example(number_)));
    const std::string_view name = text_.substr(start, at_ - start);
    const Unit* unit = find_unit(name);
    if (unit == nullptr) fail(unknown_name("unit", name, unit_symbols()).what());
    product.multiply(*unit, direction * read_exponent());
  }

  int read_exponent() {
    if (at_ == text_.size() || text_[at_] != '^') return 1;
    ++at_;
    int exponent = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
    if (error != std::errc{} || exponent < -9 || exponent > 9) fail("a power must be a whole number between -9 and 9");
    at_ = static_cast<std::size_t>(end - text_.data());
    if (at_ < text_.size() && text_[at_] == '.') fail("a power must be a whole number between -9 and 9");
    return exponent;
  }

  [[noreturn]] void fail_number() const {
    fail(fmt::format("it must be {}, {}", wanted_ == dimension::number ? "a number" : "a number with a unit",
                     example("1")));
  }

  [[noreturn]] void fail_dimension(Dimension found) const {
    if (found == dimension::number) fail(fmt::format("the unit is missing; write {}", example(number_)));
    fail(fmt::format("that is {}; it must be {}, {}", text_of(found), text_of(wanted_), example(number_)));
  }

  std::string_view text_;
  Dimension wanted_;
  const UnitSystem& system_;
  std::size_t at_{0};
  std::string_view number_;
};

}  // namespace

std::vector<std::string> unit_system_names() { return {std::string{si.name}, std::string{us.name}}; }

UnitSystem unit_system(std::string_view name) {
  for (const UnitSystem& system : {si, us}) {
    if (system.name == name) return system;
  }
  throw unknown_name("unit system", name, unit_system_names());
}

std::vector<std::string> unit_symbols() {
  std::vector<std::string> symbols;
  for (const Unit& unit : units)
    symbols.emplace_back(unit.symbol);
  return symbols;
}

double si_size(const UnitSystem& system, Dimension dimension) {
  return power(system.mass_in_kg, dimension.mass) * power(system.length_in_m, dimension.length);
}

std::string symbol(const UnitSystem& system, Dimension dimension) {
  std::string text;
  if (const NamedDimension* named = find_named(dimension)) {
    for (const char c : named->pattern) {
      switch (c) {
        case 'M':
          text += system.mass;
          break;
        case 'L':
          text += system.length;
          break;
        case 'T':
          text += system.time;
          break;
        case 'F':
          text += system.force;
          break;
        default:
          text += c;
      }
    }
    return text;
  }
  const auto append = [&text](std::string_view own, int exponent) {
    if (exponent == 0) return;
    if (!text.empty()) text += ' ';
    text += exponent == 1 ? std::string{own} : fmt::format("{}^{}", own, exponent);
  };
  append(system.mass, dimension.mass);
  append(system.length, dimension.length);
  append(system.time, dimension.time);
  append("rad", dimension.angle);
  return text;
}

std::string text_of(Dimension dimension) {
  if (const NamedDimension* named = find_named(dimension)) return std::string{named->text};
  return fmt::format("of dimension {}", symbol({"", "M", "L", "T", "F", 1.0, 1.0}, dimension));
}

double parse_quantity(std::string_view text, Dimension wanted, const UnitSystem& system) {
  return QuantityText{text, wanted, system}.value();
}

AnyQuantity parse_any_quantity(std::string_view text, const UnitSystem& system) {
  return QuantityText{text, dimension::number, system}.any();
}

double consistent(double number, std::string_view unit, Dimension wanted, const UnitSystem& system) {
  return QuantityText{unit, wanted, system}.times_units(number);
}

}  // namespace talus
