#include "verification/study/program_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

void Differences::expect_none(Findings& findings, const std::string& check, const std::string& why) const {
  const std::string found = differing_.empty() ? "" : fmt::format(". Differing: {}", fmt::join(differing_, ", "));
  findings.expect(check, static_cast<double>(differing_.size()), 0.0,
                  Tolerance::exact(fmt::format("{} comparisons: {}{}", compared_, why, found)));
}

}  // namespace talus::verification::problems
