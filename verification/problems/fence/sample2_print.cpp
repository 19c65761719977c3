#include "verification/problems/fence/sample2_print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "solver/io/file/fortran.hpp"
#include "solver/io/file/toml_document.hpp"
#include "verification/check/case_file.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems {
namespace {

constexpr std::array quantities{"x", "y", "theta", "vx", "vy", "omega"};
constexpr double round_off_of_1993 = 1e-11;  // [ft/s, rad/s]

records::Csv states() { return records::read_csv(case_file("published/sample2_states.csv")); }

std::string published(const char* file) { return read_text(case_file("published") / file); }

/// Lines that are not comments, with single spaces between words and none at the ends.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("# ", 0) == 0) continue;
    std::istringstream tokens{line};
    std::string joined;
    for (std::string word; tokens >> word;)
      joined += joined.empty() ? word : " " + word;
    if (!joined.empty()) lines.push_back(joined);
  }
  return lines;
}

/// Value that the listing gives for a quantity: after its name and " = ", or in the table of masses.
std::string listed(const std::vector<std::string>& lines, const std::string& quantity, const std::string& element) {
  bool masses = false;
  for (const std::string& line : lines) {
    if (line == "element mass m.o.i.") {
      masses = true;
    } else if (element.empty()) {
      const std::size_t at = line.find(quantity + " = ");
      if (at != std::string::npos) return line.substr(at + quantity.size() + 3);
    } else if (masses && line.rfind(element + " ", 0) == 0) {
      const std::size_t second = line.rfind(' ');
      const std::size_t first = line.find(' ') + 1;
      return quantity == "mass" ? line.substr(first, second - first) : line.substr(second + 1);
    }
  }
  return "missing";
}

/// Unit of a derived quantity in the listing. Errors: RecordError for a quantity that it does not have.
std::string unit_of(const std::string& quantity) {
  if (quantity == "initial height") return "ft";
  if (quantity == "mass") return "slug";
  if (quantity == "m.o.i.") return "slug ft^2";
  if (quantity == "S/R chekdt - time step" || quantity == "max. stable time step") return "s";
  if (quantity.starts_with("Normal contact stiffness (")) return "lbf/ft";
  throw records::RecordError{fmt::format("sample2_derived.csv: the listing has no quantity '{}'", quantity)};
}

/// Value of one unit of the last digit: 0.1 for ".490E+02".
double last_digit(const std::string& printed) {
  const std::size_t point = printed.find('.'), mark = printed.find('E');
  const double digits = static_cast<double>(mark - point - 1);
  return std::pow(10.0, std::strtod(printed.c_str() + mark + 1, nullptr) - digits);
}

}  // namespace

std::vector<DerivedNumber> derived_numbers(const Sample2Run& run) {
  const std::vector<std::string> lines = lines_of(run.listing);
  std::vector<DerivedNumber> numbers;
  const records::Csv csv = records::read_csv(case_file("published/sample2_derived.csv"));
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::string quantity{csv.cell(row, "quantity")}, element{csv.cell(row, "element")};
    DerivedNumber number{.name = element.empty() ? quantity : fmt::format("{} of element {}", quantity, element),
                         .unit = std::string{csv.cell(row, "unit")},
                         .printed = std::string{csv.cell(row, "printed")},
                         .ours = {}};
    if (number.unit != unit_of(quantity)) {
      throw records::RecordError{fmt::format("{}: line {}: unit: found '{}', allowed: '{}' of {}", csv.file().string(),
                                             csv.line(row), number.unit, unit_of(quantity), number.name)};
    }
    if (quantity == "initial height") {
      const auto member = static_cast<std::size_t>(std::atoi(element.c_str()) - 1);
      number.ours = fortran_e(run.made.members.at(member).position.y, 3);
    } else {
      number.ours = listed(lines, quantity, element);
    }
    numbers.push_back(std::move(number));
  }
  return numbers;
}

HeadLines head_lines(const Sample2Run& run) {
  const std::vector<std::string> ours = lines_of(run.listing), printed = lines_of(published("sample2_head.txt"));
  HeadLines lines{printed.size(), 0};
  for (std::size_t i = 0; i < std::min(ours.size(), printed.size()); ++i)
    lines.same += ours[i] == printed[i] ? 1 : 0;
  return lines;
}

std::size_t rows_of_states() { return states().rows(); }

std::vector<Deviation> deviations(const Sample2Run& run) {
  std::vector<Deviation> all;
  const records::Csv csv = states();
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::size_t print = csv.number(row, "t") == csv.number(0, "t") ? 0 : 1;
    const int element = static_cast<int>(csv.number(row, "element"));
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const std::string text{csv.cell(row, quantities[i])};
      const double value = csv.number(row, quantities[i]);
      const double speed = csv.number(row, quantities[i % 3 + 3]);
      const bool slow = std::abs(speed) < round_off_of_1993;
      // An element that hardly moves is at its initial position, which is checked as a derived number.
      if (value == 0.0 || slow) continue;
      const double ours = print < run.states.size() ? run.states[print].at(static_cast<std::size_t>(element - 1))[i]
                                                    : std::numeric_limits<double>::quiet_NaN();
      all.push_back({print, element, quantities[i], text, ours, (ours - value) / last_digit(text)});
    }
  }
  return all;
}

double largest_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last) {
  double largest = 0.0;
  int count = 0;
  for (const Deviation& d : all) {
    if (d.print != print || d.element < first || d.element > last) continue;
    keep_largest(largest, d.units);
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : largest;
}

double mean_deviation(const std::vector<Deviation>& all, std::size_t print, int first, int last) {
  double sum = 0.0;
  int count = 0;
  for (const Deviation& d : all) {
    if (d.print != print || d.element < first || d.element > last) continue;
    sum += std::abs(d.units);
    ++count;
  }
  return sum / count;
}

}  // namespace talus::verification::problems
