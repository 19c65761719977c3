#include "verification/record/case_record.hpp"

#include <algorithm>

namespace talus::records {

bool is_main(const Record& record, const Check& check) {
  const auto& names = record.main_checks;
  return std::find(names.begin(), names.end(), check.name) != names.end();
}

void mark_main_checks(Record& record) {
  for (Check& check : record.checks)
    check.main = is_main(record, check);
}

}  // namespace talus::records
