#include "verification/check/record.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace talus::verification {

std::vector<Trace> traced(const std::vector<Claim>& claims, const std::vector<Check>& checks) {
  std::vector<Trace> traces;
  for (const auto& claim : claims) {
    Trace trace{claim.requirement, {}};
    std::vector<bool> used(claim.parts.size(), false);
    for (const auto& check : checks) {
      bool touched = false;
      for (std::size_t i = 0; i < claim.parts.size(); ++i) {
        if (check.name.find(claim.parts[i]) == std::string::npos) continue;
        used[i] = touched = true;
      }
      if (touched) trace.checks.push_back(check.name);
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) trace.unmatched = claim.parts[static_cast<std::size_t>(unused - used.begin())];
    traces.push_back(std::move(trace));
  }
  return traces;
}

Record record_of(const Case& verification_case) {
  Record record;
  record.id = verification_case.id;
  record.title = verification_case.title;
  record.family = verification_case.family;
  record.requirements = traced(verification_case.requirements, {});
  record.main_checks = verification_case.main_checks;
  record.source = verification_case.source;
  record.page = verification_case.page;
  record.tier = verification_case.tier;
  return record;
}

}  // namespace talus::verification
