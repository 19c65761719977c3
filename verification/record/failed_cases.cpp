#include "verification/record/failed_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace talus::records {
namespace {

double urgency(const Check* check) { return std::isfinite(check->margin) ? check->margin : 0.0; }

}  // namespace

std::vector<FailedCase> failed_cases(std::span<const Record> records) {
  std::vector<FailedCase> failed;
  for (const Record& record : records) {
    FailedCase of{&record, {}};
    for (const Check& check : record.checks)
      if (!check.pass) of.checks.push_back(&check);
    if (of.checks.empty()) continue;
    std::ranges::stable_sort(of.checks, std::greater{}, urgency);
    failed.push_back(std::move(of));
  }
  std::ranges::stable_sort(failed, std::greater{}, [](const FailedCase& of) { return urgency(of.checks.front()); });
  return failed;
}

}  // namespace talus::records
