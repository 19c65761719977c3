#include "verification/check/record.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "verification/check/evidence.hpp"

namespace talus::verification {

namespace {

/// The claims of a case after it ran: the explicit ones and those that follow from its runs.
class Claims {
 public:
  explicit Claims(const std::vector<Claim>& named) : all_{named} {}

  /// Adds the checks to the claim of the requirement.
  void add(const std::string& requirement, const std::vector<std::string>& checks) {
    auto claim = std::find_if(all_.begin(), all_.end(), [&](const Claim& c) { return c.requirement == requirement; });
    if (claim == all_.end()) claim = all_.insert(all_.end(), {requirement, {}});
    for (const std::string& check : checks) {
      if (std::find(claim->checks.begin(), claim->checks.end(), check) == claim->checks.end())
        claim->checks.push_back(check);
    }
  }
  [[nodiscard]] const std::vector<Claim>& all() const { return all_; }

 private:
  std::vector<Claim> all_;
};

/// The only member of a kind that was used; empty if there is none or more than one.
std::string only_of_kind(const Usage& usage, std::string_view kind) {
  std::string only;
  for (const std::string& id : usage) {
    if (kind_of_use(id) != kind) continue;
    if (!only.empty()) return "";
    only = id;
  }
  return only;
}

/// Requirements verified by checks of the runs' numbers: the members that were the only one of their kind in use.
std::vector<std::string> shown_by_runs(const Usage& usage) {
  std::vector<std::string> ids;
  for (const char* kind : {"law", "shear_law", "end_rule", "method", "integrator", "shape", "pair"}) {
    const std::string only = only_of_kind(usage, kind);
    if (!only.empty()) ids.push_back(only);
    if (only.empty() || std::string_view{kind} != "pair") continue;
    const std::size_t first = only.find('.') + 1, second = only.find('.', first) + 1;
    const std::set<std::string> shapes{"shape." + only.substr(first, second - first - 1),
                                       "shape." + only.substr(second)};
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(ids),
                 [&](const std::string& shape) { return std::find(ids.begin(), ids.end(), shape) == ids.end(); });
  }
  return ids;
}

/// Whether `id` refers to the check with this index.
bool means(const std::string& id, const Findings& findings, std::size_t index) {
  const std::vector<std::string>& groups = findings.groups()[index];
  return findings.checks()[index].name == id || std::find(groups.begin(), groups.end(), id) != groups.end();
}

Trace traced(const Claim& claim, const Findings& findings, const Usage& usage) {
  Trace trace{.requirement = claim.requirement, .checks = {}};
  std::vector<bool> met(claim.checks.size(), false);
  for (std::size_t index = 0; index < findings.checks().size(); ++index) {
    bool touched = false;
    for (std::size_t i = 0; i < claim.checks.size(); ++i) {
      if (means(claim.checks[i], findings, index)) met[i] = touched = true;
    }
    if (touched) trace.checks.push_back(findings.checks()[index].name);
  }
  const auto missing = std::find(met.begin(), met.end(), false);
  if (missing != met.end()) trace.unmatched = claim.checks[static_cast<std::size_t>(missing - met.begin())];
  const std::string_view kind = kind_of_use(claim.requirement);
  if (!kind.empty() && usage.count(claim.requirement) == 0) trace.used_instead = used_of_kind(usage, kind);
  return trace;
}

/// The name of the check that `id` means: that of the only check with this name or of this group; otherwise `id`.
std::string check_name(const std::string& id, const Findings& findings) {
  std::string name;
  for (std::size_t index = 0; index < findings.checks().size(); ++index) {
    if (!means(id, findings, index)) continue;
    if (!name.empty()) return id;
    name = findings.checks()[index].name;
  }
  return name.empty() ? id : name;
}

}  // namespace

std::vector<Claim> claims_of(const Case& verification_case) {
  std::vector<Claim> claims;
  for (const Claim& claim : verification_case.requirements) {
    const std::string separator = ", ";
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
      end = claim.requirement.find(separator, begin);
      claims.push_back({claim.requirement.substr(begin, end == std::string::npos ? end : end - begin), claim.checks});
    }
  }
  return claims;
}

Case with_check_names(Case verification_case, const Findings& findings) {
  for (std::string& check : verification_case.main_checks)
    check = check_name(check, findings);
  for (Fault& fault : verification_case.faults)
    fault.turns_red = check_name(fault.turns_red, findings);
  return verification_case;
}

std::vector<Trace> traced(const Case& verification_case, const Findings& findings, const Usage& usage) {
  Claims claims{claims_of(verification_case)};
  for (const auto& groups : findings.groups()) {
    for (const std::string& group : groups) {
      if (!kind_of_use(group).empty()) claims.add(group, {group});
    }
  }
  if (!verification_case.checks_of_runs.empty()) {
    for (const std::string& requirement : shown_by_runs(usage))
      claims.add(requirement, verification_case.checks_of_runs);
  }
  std::vector<Trace> traces;
  for (const Claim& claim : claims.all())
    traces.push_back(traced(claim, findings, usage));
  return traces;
}

Record record_of(const Case& verification_case) {
  Record record;
  record.id = verification_case.id;
  record.title = verification_case.title;
  record.family = verification_case.family;
  for (const Claim& claim : claims_of(verification_case))
    record.requirements.push_back({.requirement = claim.requirement, .checks = {}});
  record.main_checks = verification_case.main_checks;
  record.source = verification_case.source;
  record.page = verification_case.page;
  EvidenceParagraph paragraph = evidence_of(record.page);
  record.evidence = std::move(paragraph.kinds);
  record.not_shown = std::move(paragraph.not_shown);
  record.tier = verification_case.tier;
  return record;
}

}  // namespace talus::verification
