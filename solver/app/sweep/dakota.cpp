#include "solver/app/sweep/dakota.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

/// The lines of a parameters file, each with a value and a label; blank ones do not count.
class DakotaLines {
 public:
  struct Line {
    std::string value, label;
  };

  DakotaLines(std::string_view text, std::string_view name) : name_{name} {
    std::istringstream stream{std::string{text}};
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
      if (line.find_first_not_of(" \t\r") != std::string::npos) lines_.emplace_back(number, line);
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw InputError{fmt::format("{}:{}: {}", name_, number_, message)};
  }

  bool ended() const { return read_ == lines_.size(); }
  /// Whether the next line has this label.
  bool at(std::string_view label) const {
    if (ended()) return false;
    const std::optional<Line> line = parsed(lines_[read_].second);
    return line && line->label == label;
  }

  Line next() {
    if (ended()) {
      ++number_;
      fail("the file ends here; it must be a parameters file of Dakota, whole");
    }
    const std::string& text = lines_[read_].second;
    number_ = lines_[read_++].first;
    const std::optional<Line> line = parsed(text);
    if (!line) {
      fail(
          fmt::format("found \"{}\"; it must be a value and a label, as in the standard format of Dakota's parameters "
                      "files (not aprepro or json)",
                      text));
    }
    return *line;
  }

  /// The length of the array with this tag, which the next line begins.
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

  /// The beginning of an array of which there must be none: `why`.
  void expect_none(std::string_view tag, std::string_view why) {
    if (const std::size_t found = count(tag); found > 0)
      fail(fmt::format("found {} {}; it must be 0: {}", found, tag, why));
  }

 private:
  /// Value and label of a line that has both and nothing else.
  static std::optional<Line> parsed(const std::string& text) {
    std::istringstream tokens{text};
    Line line;
    std::string rest;
    if (!(tokens >> line.value >> line.label) || tokens >> rest) return {};
    return line;
  }

  std::string name_;
  std::vector<std::pair<int, std::string>> lines_;  ///< with their numbers in the file
  std::size_t read_{};                              ///< number of lines read
  int number_{};                                    ///< of the last one in the file
};

DakotaRequest read_request(DakotaLines& lines) {
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
      lines.fail(
          fmt::format("variable '{}': it is the second one with this label; give each another descriptor", line.label));
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
  for (std::size_t left = lines.count("derivative_variables"); left > 0; --left)
    static_cast<void>(lines.next());
  lines.expect_none("analysis_components", "nothing would use them; remove analysis_components of the interface");
  if (const DakotaLines::Line id = lines.next(); id.label != "eval_id")
    lines.fail(fmt::format("found \"{} {}\"; it must be a number and \"eval_id\"", id.value, id.label));
  return request;
}

}  // namespace

std::vector<DakotaRequest> read_dakota(std::string_view text, std::string_view name) {
  DakotaLines lines{text, name};
  std::vector<DakotaRequest> requests;
  do {
    requests.push_back(read_request(lines));
    // Written by Dakota 6.16 and newer.
    if (lines.at("metadata"))
      lines.expect_none("metadata", "give these numbers as responses; remove metadata of the responses");
  } while (!lines.ended());
  return requests;
}

std::string dakota_results(const DakotaRequest& request, std::span<const double> values, const std::string& failure) {
  if (!failure.empty()) return fmt::format("FAIL {}\n", failure);
  std::string text;
  for (std::size_t i = 0; i < request.responses.size(); ++i)
    if (request.responses[i].second) text += fmt::format("{:.17g} {}\n", values[i], request.responses[i].first);
  return text;
}

}  // namespace talus::app
