#include "reports/pages/interface_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

using records::InterfaceItem;
using records::InterfaceStatus;

constexpr std::array interface_kinds{
    std::pair{"option", "options of commands"}, std::pair{"field", "fields of scenes and fences"},
    std::pair{"column", "columns of CSV files"}, std::pair{"member", "members of JSON files"},
    std::pair{"array", "arrays of states (VTK)"}};

std::size_t count_of(const std::vector<InterfaceItem>& items, const std::string& kind, InterfaceStatus status) {
  return static_cast<std::size_t>(std::ranges::count_if(
      items, [&](const InterfaceItem& item) { return item.kind == kind && item.status == status; }));
}

/// Names of the items of a kind with that status, grouped by what is before ": ".
std::string names_of(const std::vector<InterfaceItem>& items, const std::string& kind, InterfaceStatus status) {
  std::map<std::string, std::string> groups;
  for (const InterfaceItem& item : items) {
    if (item.kind != kind || item.status != status) continue;
    const std::size_t colon = item.name.find(": ");
    const std::string group = colon == std::string::npos ? "" : item.name.substr(0, colon);
    std::string& names = groups[group];
    names += (names.empty() ? "" : ", ") +
             markdown::code(colon == std::string::npos ? item.name : item.name.substr(colon + 2));
  }
  std::string text;
  for (const auto& [group, names] : groups)
    text += (text.empty() ? "" : "; ") + (group.empty() ? "" : markdown::code(group) + ": ") + names;
  return text;
}

}  // namespace

std::string interface_text(const std::vector<InterfaceItem>& items) {
  std::vector<std::vector<std::string>> rows;
  std::array<std::size_t, 5> all{};
  const auto row = [&](const std::string& name, const std::array<std::size_t, 5>& counts) {
    const std::size_t judged = counts[0] + counts[1];
    std::vector<std::string> cells{name};
    for (const std::size_t count : counts)
      cells.push_back(fmt::format("{}", count));
    cells.push_back(
        judged == 0 ? ""
                    : fmt::format("{:.1f} %", 100.0 * static_cast<double>(counts[0]) / static_cast<double>(judged)));
    rows.push_back(cells);
  };
  for (const auto& [kind, title] : interface_kinds) {
    std::array<std::size_t, 5> counts{};
    std::size_t i = 0;
    for (const InterfaceStatus status : {InterfaceStatus::killed, InterfaceStatus::survived, InterfaceStatus::unused,
                                         InterfaceStatus::refused, InterfaceStatus::unchanged}) {
      counts[i] = count_of(items, kind, status);
      all[i] += counts[i];
      ++i;
    }
    row(title, counts);
  }
  row("**all**", all);
  std::string text = markdown::table({{"interface"},
                                      {"killed", true},
                                      {"survived", true},
                                      {"unused", true},
                                      {"refused", true},
                                      {"unchanged", true},
                                      {"killed of changed", true}},
                                     rows, "");
  for (const auto& [status, heading] :
       {std::pair{InterfaceStatus::survived, "Not noticed: cases use these, and stay green when they are wrong"},
        std::pair{InterfaceStatus::unused, "Not used by a case that runs the program"}}) {
    std::string list;
    for (const auto& [kind, title] : interface_kinds) {
      const std::string names = names_of(items, kind, status);
      if (!names.empty()) list += fmt::format("- {}: {}\n", title, names);
    }
    if (!list.empty()) text += fmt::format("\n**{}.**\n\n{}", heading, list);
  }
  return text;
}

}  // namespace talus::reports
