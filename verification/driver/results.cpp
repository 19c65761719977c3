#include "verification/driver/results.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace talus::verification {

namespace {

using records::Record;
using records::Trace;

bool listed(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// For each requirement, the cases that claim it and their checks that verify it.
std::vector<records::Requirement> traceability(const std::vector<Record>& all, const Catalogue& catalogue) {
  std::vector<records::Requirement> list;
  for (const auto& requirement : catalogue.requirements) {
    list.push_back({requirement.id, requirement.group, requirement.text, {}, requirement.order});
    for (const Record& record : all) {
      for (const Trace& trace : record.requirements) {
        if (trace.requirement == requirement.id) list.back().shown_by.push_back({record.id, trace.checks});
      }
    }
  }
  return list;
}

/// The checks of peers, and the cases that verify the same.
std::vector<records::Peer> checks_of_peers(const std::vector<Record>& all, const Catalogue& catalogue) {
  std::vector<records::Peer> list;
  for (const auto& peer : catalogue.peers) {
    list.push_back({peer.suite, peer.id, peer.what, peer.form, peer.problems, peer.remark, {}});
    for (const Record& record : all) {
      const auto same = [&](const Trace& trace) { return trace.shown() && listed(peer.problems, trace.requirement); };
      if (std::any_of(record.requirements.begin(), record.requirements.end(), same))
        list.back().cases.push_back(record.id);
    }
  }
  return list;
}

/// The family that a case names, or the one that follows from its problems.
std::string resolved_family(const Record& record, const Catalogue& catalogue) {
  std::vector<std::string> ids;
  for (const Trace& trace : record.requirements)
    ids.push_back(trace.requirement);
  return catalogue.family_of(record.family, ids);
}

/// The errata proved by registered cases; only these are printed.
std::vector<records::Erratum> proved_errata(const std::vector<std::string>& registered, const Catalogue& catalogue) {
  std::vector<records::Erratum> list;
  for (const auto& each : catalogue.errata) {
    if (listed(registered, each.proved_by))
      list.push_back({each.id, each.where, each.printed, each.corrected, each.evidence, each.proved_by});
  }
  return list;
}

}  // namespace

void complete(Results& results, const Catalogue& catalogue) {
  for (Record& record : results.records)
    record.family = resolved_family(record, catalogue);
  results.requirements = traceability(results.records, catalogue);
  results.families = catalogue.families;
  results.errata = proved_errata(results.registered, catalogue);
  for (const CatalogueFinding& finding : catalogue.findings)
    if (listed(results.registered, finding.case_id)) results.findings.push_back({finding.case_id, finding.text});
  for (const CatalogueHighlight& shown : catalogue.highlights) {
    if (listed(results.registered, shown.case_id))
      results.highlights.push_back({shown.case_id, shown.figure, shown.caption});
  }
  results.peers = checks_of_peers(results.records, catalogue);
  results.bibliography = catalogue.bibliography.text;
}

}  // namespace talus::verification
