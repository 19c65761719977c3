#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// A table of the report; cells are text as they are to be printed.
struct Table {
  std::string name;     ///< Unique in its case.
  std::string caption;  ///< What the rows show; Markdown.
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows{};  ///< Each as long as `columns`.
};

/// std::invalid_argument, naming the table, if name or caption is missing or a row has another length than `columns`.
void demand_well_formed(const Table& table);

}  // namespace talus::verification
