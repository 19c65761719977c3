#include "verification/check/table.hpp"

#include <stdexcept>

namespace talus::verification {

void demand_well_formed(const Table& table) {
  if (table.name.empty() || table.caption.empty() || table.columns.empty()) {
    throw std::invalid_argument("table '" + table.name + "' needs a name, a caption and columns");
  }
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size()) {
      throw std::invalid_argument("table '" + table.name + "': a row has another length than the columns");
    }
  }
}

}  // namespace talus::verification
