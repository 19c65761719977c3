#include "tests/interface/known_gaps.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <stdexcept>

namespace talus::interface_audit {

using records::InterfaceStatus;

KnownGaps read_known_gaps(const std::string& text) {
  KnownGaps known;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t reason = line.find(" -- ");
    const bool has_status = line.starts_with("survived: ") || line.starts_with("unused: ");
    if (!has_status || reason == std::string::npos || reason + 4 == line.size()) {
      throw std::runtime_error(
          fmt::format("known gaps, line {}: found '{}'; allowed: survived: ITEM -- REASON, or unused: ITEM -- REASON",
                      number, line));
    }
    if (!known.emplace(line.substr(0, reason), line.substr(reason + 4)).second)
      throw std::runtime_error(fmt::format("known gaps, line {}: '{}' is there twice", number, line.substr(0, reason)));
  }
  return known;
}

std::vector<std::string> unexpected_gaps(const std::vector<records::InterfaceItem>& items, const KnownGaps& known) {
  std::vector<std::string> unexpected;
  std::set<std::string> found;
  for (const records::InterfaceItem& item : items) {
    if (item.status != InterfaceStatus::survived && item.status != InterfaceStatus::unused) continue;
    const std::string gap = fmt::format("{}: {} {}", name_of(item.status), item.kind, item.name);
    found.insert(gap);
    if (!known.contains(gap)) unexpected.push_back("not known: " + gap);
  }
  for (const auto& [gap, reason] : known)
    if (!found.contains(gap)) unexpected.push_back("no longer: " + gap);
  return unexpected;
}

}  // namespace talus::interface_audit
