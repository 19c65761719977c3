#pragma once

#include <set>
#include <string>
#include <vector>

#include "reports/json_node.hpp"
#include "reports/record.hpp"

/// What case records and plot records have in common: figures, and names that also name files. Heavy: include it in
/// .cpp files only.
namespace talus::reports {

/// A file stem that cannot lead out of its folder. Throws RecordError when the words are none.
[[nodiscard]] std::string file_name(const Node& node);

/// A figure as record and plot tell it. Throws RecordError (file and field) when it is not what the schema says.
[[nodiscard]] Figure figure_of(const Node& node);

/// The same for a page, a film and a player of a plot record.
[[nodiscard]] Page page_of(const Node& node);
[[nodiscard]] Film film_of(const Node& node);
[[nodiscard]] Player player_of(const Node& node);

/// Names within a case are what failures, controls and files are told by: each may occur once.
/// Throws RecordError when one of `things` has another's name.
template <class Things>
void demand_distinct_names(const Node& node, const char* key, const Things& things) {
  std::set<std::string> seen;
  for (const auto& thing : things) {
    if (!seen.insert(thing.name).second) node.at(key).complain(fmt::format("'{}' occurs twice", thing.name));
  }
}

}  // namespace talus::reports
