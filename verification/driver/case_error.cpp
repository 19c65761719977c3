#include "verification/driver/case_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "verification/check/evidence.hpp"
#include "verification/check/paragraph.hpp"
#include "verification/check/record.hpp"

namespace talus::verification {

namespace {

bool is_snake_case(const std::string& word) {
  const auto plain = [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_'; };
  return !word.empty() && std::all_of(word.begin(), word.end(), plain);
}

std::string requirements_error(const Case& verification_case, const Catalogue& catalogue) {
  const std::vector<Claim> claims = claims_of(verification_case);
  for (const auto& claim : claims) {
    const std::string& id = claim.requirement;
    if (catalogue.requirement(id) == nullptr) return fmt::format("requirement '{}' is in no closed list", id);
    if (claim.checks.empty()) return fmt::format("it names no check for requirement '{}'", id);
    const auto same = [&](const Claim& other) { return other.requirement == id; };
    if (std::count_if(claims.begin(), claims.end(), same) > 1)
      return fmt::format("requirement '{}' is listed twice", id);
  }
  return "";
}

std::string family_error(const Case& verification_case, const Catalogue& catalogue) {
  std::vector<std::string> ids;
  for (const auto& claim : claims_of(verification_case))
    ids.push_back(claim.requirement);
  const std::string family = catalogue.family_of(verification_case.family, ids);
  if (family.empty()) return "it names no family and claims no problem of the catalogue";
  const auto& known = catalogue.families;
  if (std::find(known.begin(), known.end(), family) == known.end()) {
    return fmt::format("its family '{}' is not known; known: {}", family, fmt::join(known, ", "));
  }
  return "";
}

/// Missing citations in the case's source and in the paragraph "Source" of its page.
std::string flaw_of_citations(const Case& verification_case, const Catalogue& catalogue) {
  if (!verification_case.data_set.empty()) return "";
  const std::string paragraph = paragraph_of(verification_case.page, "Source");
  const auto missing = citations_in(verification_case.source + "; " + paragraph, catalogue.bibliography).missing;
  return missing.empty() ? "" : fmt::format("the bibliography has no entry for '{}'", missing.front());
}

/// A page without a complete paragraph "Evidence", or one that contradicts the case.
std::string flaw_of_evidence(const Case& verification_case) {
  const EvidenceParagraph paragraph = evidence_of(verification_case.page);
  if (!paragraph.error.empty()) return "its page: " + paragraph.error;
  const auto& kinds = paragraph.kinds;
  const bool recorded = std::find(kinds.begin(), kinds.end(), Evidence::earlier_result) != kinds.end();
  if (recorded == verification_case.recorded) return "";
  return fmt::format("its page says that it {} on earlier results, but it is {}declared as recorded",
                     recorded ? "rests" : "does not rest", verification_case.recorded ? "" : "not ");
}

std::string flaw_of_main_checks(const Case& verification_case) {
  const auto& names = verification_case.main_checks;
  if (names.empty()) return "it names no main check";
  for (const auto& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1) return fmt::format("main check '{}' is listed twice", name);
  }
  return "";
}

std::string flaw_of_faults(const Case& verification_case) {
  const auto& faults = verification_case.faults;
  if (faults.empty()) return "it plants no fault: a case that cannot turn red shows nothing";
  for (const auto& fault : faults) {
    if (fault.name.empty() || fault.what.empty() || fault.turns_red.empty()) {
      return fmt::format("fault '{}' needs a name, words and the check it turns red", fault.name);
    }
    const auto uses = std::count_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.name == fault.name; });
    if (uses > 1) return fmt::format("fault '{}' is listed twice", fault.name);
  }
  return "";
}

}  // namespace

std::string case_error(const Case& verification_case, const std::vector<Case>& all, const Catalogue& catalogue) {
  const Case& c = verification_case;
  if (!is_snake_case(c.id)) return fmt::format("its id '{}' is not snake_case", c.id);
  if (std::count_if(all.begin(), all.end(), [&](const Case& other) { return other.id == c.id; }) > 1) {
    return "its id is used twice";
  }
  if (c.title.empty()) return "it has no title";
  if (c.source.empty()) return "it cites no source";
  if (c.page.empty()) return "its page is empty";
  if (!c.run) return "it has nothing to run";
  if (!(std::isfinite(c.time_limit) && c.time_limit > 0.0))
    return "its time limit must be finite and greater than zero";
  if (!(std::isfinite(c.memory_limit) && c.memory_limit > 0.0))
    return "its memory limit must be finite and greater than zero";
  for (const std::string& flaw :
       {requirements_error(c, catalogue), family_error(c, catalogue), flaw_of_citations(c, catalogue),
        flaw_of_evidence(c), flaw_of_main_checks(c), flaw_of_faults(c)}) {
    if (!flaw.empty()) return flaw;
  }
  return "";
}

}  // namespace talus::verification
