#include "verification/study/program/program_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace talus::verification::problems {

std::vector<std::string> with_options(std::vector<std::string> command, const Options& options, const Setup& setup) {
  for (const auto& [name, values] : options) {
    std::string fault = "without_" + name.substr(2);
    std::ranges::replace(fault, '-', '_');
    if (setup.has(fault)) continue;
    command.push_back(name);
    command.insert(command.end(), values.begin(), values.end());
  }
  return command;
}

std::string Program::run(const std::vector<std::string>& command, const Options& options) const {
  return talus_output(folder_, with_options(command, options, *setup_));
}
records::Json Program::json(const std::vector<std::string>& command, const Options& options) const {
  return records::Json::parse(run(command, options));
}
ProgramEnd Program::end(const std::vector<std::string>& command, const Options& options) const {
  return run_talus(folder_, with_options(command, options, *setup_));
}
bool Program::has(const std::string& name) const { return std::filesystem::exists(folder_.path() / name); }
std::vector<std::string> Program::files(const std::string& name) const {
  std::vector<std::string> names;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator{folder_.path() / name})
    names.push_back(entry.path().lexically_relative(folder_.path()).string());
  std::ranges::sort(names);
  return names;
}
std::string Program::read(const std::string& name) const { return has(name) ? folder_.read(name) : "missing " + name; }
records::Json Program::file(const std::string& name) const { return records::read_json(folder_.path() / name); }
records::Csv Program::csv(const std::string& name) const { return records::read_csv(folder_.path() / name); }

void replace(std::string& text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is expected in a text", old));
  text.replace(at, old.size(), with);
}

std::string squeezed(const std::string& text) {
  std::string result;
  for (const char letter : text)
    if (letter != ' ' || result.empty() || result.back() != ' ') result += letter;
  return result;
}

double number_after(const std::string& text, const std::string& before) {
  const std::size_t at = text.find(before);
  return at == std::string::npos ? std::nan("") : std::strtod(text.c_str() + at + before.size(), nullptr);
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> found;
  for (std::size_t at = 0; at < text.size();) {
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    const bool begins = at == 0 || std::string_view{" \"[,\t\n="}.find(text[at - 1]) != std::string_view::npos;
    if (failure == std::errc{} && begins) {
      found.push_back(value);
      at = static_cast<std::size_t>(end - text.data());
    } else {
      ++at;
    }
  }
  return found;
}

std::vector<double> numbers_on_line_after(const std::string& text, const std::string& before) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) throw std::runtime_error("'" + before + "' is expected in the text");
  const std::size_t from = at + before.size();
  return numbers_in(std::string_view{text}.substr(from, text.find('\n', from) - from));
}

void Differences::expect_none(Findings& findings, const std::string& check, const std::string& why) const {
  std::string found;
  int differing = 0;
  for (const auto& [name, count] : differing_) {
    found += (found.empty() ? ". Differing: " : ", ") + name + (count > 1 ? fmt::format(" ({})", count) : "");
    differing += count;
  }
  const double count = compared_ > 0 ? static_cast<double>(differing) : std::numeric_limits<double>::quiet_NaN();
  findings.expect(check, count, 0.0, Tolerance::exact(fmt::format("{} comparisons: {}{}", compared_, why, found)));
}

}  // namespace talus::verification::problems
