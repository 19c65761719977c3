/// The fields of results.json, schema 1; see json_fields.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verification/record/case_fields.hpp"
#include "verification/record/results.hpp"

namespace talus::records {

void fields(auto& f, Like<Provenance> auto& provenance) {
  f.value("revision", provenance.revision);
  f.value("dirty", provenance.dirty);
  f.value("compiler", provenance.compiler);
  f.value("flags", provenance.flags);
  f.value("build_type", provenance.build_type);
  f.value("cpu", provenance.cpu);
  f.value("cores", provenance.cores);
  f.value("os", provenance.os);
  f.value("libraries", provenance.libraries);
  f.nonempty_text("date", provenance.date);
}

/// Checks that the date is valid.
void demand_sound(const Node& node, const Provenance& provenance);

void fields(auto& f, Like<Counts> auto& counts) {
  f.value("cases", counts.cases);
  f.value("passed", counts.passed);
  f.value("failed", counts.failed);
  f.value("checks", counts.checks);
  f.value("checks_failed", counts.checks_failed);
  f.value("slack", counts.slack);
  f.value("exempt", counts.exempt);
  f.value("controls", counts.controls);
  f.value("controls_failed", counts.controls_failed);
}

void fields(auto& f, Like<ShownBy> auto& shown) {
  f.nonempty_text("case", shown.case_id);
  f.value("checks", shown.checks);
}

void fields(auto& f, Like<Requirement> auto& requirement) {
  f.nonempty_text("id", requirement.id);
  f.nonempty_text("group", requirement.group);
  f.value("text", requirement.text);
  f.reserve("cases");
  f.reserve("checks");
  f.value("shown_by", requirement.shown_by);
  f.value_if(requirement.order > 0, "order", requirement.order);
  std::vector<std::string> cases;
  std::size_t checks = 0;
  for (const ShownBy& shown : requirement.shown_by) {
    cases.push_back(shown.case_id);
    checks += shown.checks.size();
  }
  f.derived("cases", cases, ", those of shown_by");
  f.derived("checks", checks, ", the number of those in shown_by");
}

void fields(auto& f, Like<Peer> auto& peer) {
  f.nonempty_text("suite", peer.suite);
  f.nonempty_text("id", peer.id);
  f.nonempty_text("what", peer.what);
  f.nonempty_text("form", peer.form);
  f.value("problems", peer.problems);
  f.value("remark", peer.remark);
  f.value("cases", peer.cases);
}

void fields(auto& f, Like<Erratum> auto& erratum) {
  f.nonempty_text("id", erratum.id);
  f.value("where", erratum.where);
  f.value("printed", erratum.printed);
  f.value("corrected", erratum.corrected);
  f.value("evidence", erratum.evidence);
  f.value("case", erratum.case_id);
}

void fields(auto& f, Like<Finding> auto& finding) {
  f.nonempty_text("case", finding.case_id);
  f.nonempty_text("text", finding.text);
}

void fields(auto& f, Like<Highlight> auto& highlight) {
  f.nonempty_text("case", highlight.case_id);
  f.nonempty_text("figure", highlight.figure);
  f.value("caption", highlight.caption);
}

void fields(auto& f, Like<Results> auto& results) {
  f.derived("schema", schema);
  f.value("provenance", results.provenance);
  f.value("tier", results.tier);
  f.value("registered", results.registered);
  f.value("selected", results.selected);
  f.reserve("counts");
  f.reserve("verdict");
  f.value("requirements", results.requirements);
  f.value("families", results.families);
  f.value("cases", results.records);
  f.value("errata", results.errata);
  f.value("peers", results.peers);
  f.value_if(!results.findings.empty(), "findings", results.findings);
  f.value_if(!results.highlights.empty(), "highlights", results.highlights);
  f.value_if(!results.bibliography.empty(), "bibliography", results.bibliography);
  f.value_if(!results.only.empty(), "only", results.only);
  f.derived("counts", counts_of(results), ", which the cases hold");
  f.derived("verdict", std::string(holds(results) ? "pass" : "fail"), ", which follows from the cases");
}

/// Checks that each selected case is registered and has one record, and that each case's family is listed.
void demand_sound(const Node& node, const Results& results);

}  // namespace talus::records
