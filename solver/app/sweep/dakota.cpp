#include "solver/app/sweep/dakota.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

/// The lines of a parameters file, each with a value and a label.
class DakotaLines {
 public:
  struct Line {
    std::string value, label;
  };

  DakotaLines(std::string_view text, std::string_view name) : lines_{std::string{text}}, name_{name} {}

  [[noreturn]] void fail(std::string_view message) const {
    throw InputError{fmt::format("{}:{}: {}", name_, number_, message)};
  }

  Line next() {
    std::string text;
    ++number_;
    if (!std::getline(lines_, text)) fail("the file ends here; it must be a parameters file of Dakota, whole");
    std::istringstream tokens{text};
    Line line;
    std::string rest;
    if (!(tokens >> line.value >> line.label) || tokens >> rest) {
      fail(
          fmt::format("found \"{}\"; it must be a value and a label, as in the standard format of Dakota's parameters "
                      "files (not aprepro or json)",
                      text));
    }
    return line;
  }

  /// The length of the array with this tag, which the line begins.
  std::size_t count(std::string_view tag) {
    const Line line = next();
    std::size_t number = 0;
    const char* const end = line.value.data() + line.value.size();
    const auto read = std::from_chars(line.value.data(), end, number);
    constexpr std::size_t largest_count = 100'000;
    if (line.label != tag || read.ec != std::errc{} || read.ptr != end || number > largest_count) {
      fail(
          fmt::format("found \"{} {}\"; it must be a number, at most {}, and \"{}\", as in the standard format of "
                      "Dakota's parameters files (not aprepro or json)",
                      line.value, line.label, largest_count, tag));
    }
    return number;
  }

 private:
  std::istringstream lines_;
  std::string name_;
  int number_{};
};

}  // namespace

DakotaRequest read_dakota(std::string_view text, std::string_view name) {
  DakotaLines lines{text, name};
  DakotaRequest request;
  for (std::size_t left = lines.count("variables"); left > 0; --left) {
    const DakotaLines::Line line = lines.next();
    double value = 0.0;
    const char *const begin = line.value.data(), *const end = begin + line.value.size();
    const auto read = std::from_chars(begin, end, value);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value))
      lines.fail(fmt::format("variable '{}': found {}; it must be a finite number", line.label, line.value));
    if (std::ranges::find(request.variables, line.label, [](const auto& of) { return of.first; }) !=
        request.variables.end())
      lines.fail(fmt::format("variable '{}': it is the second one with this label", line.label));
    request.variables.emplace_back(line.label, value);
  }
  for (std::size_t i = 1, count = lines.count("functions"); i <= count; ++i) {
    const DakotaLines::Line line = lines.next();
    const std::string tag = fmt::format("ASV_{}:", i);
    if (!line.label.starts_with(tag))
      lines.fail(fmt::format("found \"{}\"; it must be {} and the label of a response", line.label, tag));
    const std::string label = line.label.substr(tag.size());
    if (line.value != "0" && line.value != "1") {
      lines.fail(
          fmt::format("response '{}': found the active set {}; it must be 0 or 1: there are values alone, no "
                      "gradients and Hessians (numerical_gradients has Dakota compute them)",
                      label, line.value));
    }
    request.responses.emplace_back(label, line.value == "1");
  }
  return request;
}

std::string dakota_results(const DakotaRequest& request, std::span<const double> values, const std::string& failure) {
  if (!failure.empty()) return fmt::format("FAIL {}\n", failure);
  std::string text;
  for (std::size_t i = 0; i < request.responses.size(); ++i)
    if (request.responses[i].second) text += fmt::format("{:.17g} {}\n", values[i], request.responses[i].first);
  return text;
}

}  // namespace talus::app
