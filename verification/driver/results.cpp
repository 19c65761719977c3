#include "verification/driver/results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "verification/driver/errata.hpp"
#include "verification/driver/peers.hpp"
#include "verification/driver/references.hpp"
#include "verification/driver/requirements.hpp"

namespace talus::verification {

namespace {

using Json = nlohmann::ordered_json;

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

Json to_json(const Provenance& from) {
  Json libraries = Json::object();
  for (const auto& library : from.libraries)
    libraries[library.first] = library.second;
  return {{"revision", from.revision},     {"dirty", from.dirty}, {"compiler", from.compiler}, {"flags", from.flags},
          {"build_type", from.build_type}, {"cpu", from.cpu},     {"cores", from.cores},       {"os", from.os},
          {"libraries", libraries},        {"date", from.date}};
}

Json to_json(const Counts& counts) {
  return {{"cases", counts.cases},
          {"passed", counts.passed},
          {"failed", counts.failed},
          {"checks", counts.checks},
          {"checks_failed", counts.checks_failed},
          {"slack", counts.slack},
          {"exempt", counts.exempt},
          {"controls", counts.controls},
          {"controls_failed", counts.controls_failed}};
}

/// Requirement -> cases that name it, and the checks in them that touch it.
Json traceability(const std::vector<Record>& records) {
  Json list = Json::array();
  for (const auto& requirement : all_requirements()) {
    Json cases = Json::array();
    Json shown_by = Json::array();
    std::size_t checks = 0;
    for (const auto& record : records) {
      for (const auto& trace : record.requirements) {
        if (trace.requirement != requirement.id) continue;
        cases.push_back(record.id);
        shown_by.push_back({{"case", record.id}, {"checks", trace.checks}});
        checks += trace.checks.size();
      }
    }
    list.push_back({{"id", requirement.id},
                    {"group", requirement.group},
                    {"text", requirement.text},
                    {"cases", cases},
                    {"checks", checks},
                    {"shown_by", shown_by}});
    if (requirement.order > 0) list.back()["order"] = requirement.order;
  }
  return list;
}

/// What peers check, and the cases that show the same.
Json checks_of_peers(const std::vector<Record>& records) {
  Json list = Json::array();
  for (const auto& peer : all_peer_checks()) {
    Json cases = Json::array();
    for (const auto& record : records) {
      const auto same = [&](const Trace& trace) { return trace.shown() && contains(peer.problems, trace.requirement); };
      if (std::any_of(record.requirements.begin(), record.requirements.end(), same)) cases.push_back(record.id);
    }
    list.push_back({{"suite", peer.suite},
                    {"id", peer.id},
                    {"what", peer.what},
                    {"form", peer.form},
                    {"problems", peer.problems},
                    {"remark", peer.remark},
                    {"cases", cases}});
  }
  return list;
}

/// A record with the family that its case names or that follows from its problems.
Json in_its_family(const Record& record) {
  Json json = Json::parse(text_of(record));
  json["family"] = family_of(record.family, json.at("requirements").get<std::vector<std::string>>());
  return json;
}

/// Only what a registered case proves is printed.
Json proved_errata(const std::vector<std::string>& registered) {
  Json list = Json::array();
  for (const auto& erratum : all_errata()) {
    if (!contains(registered, erratum.proved_by)) continue;
    list.push_back({{"id", erratum.id},
                    {"where", erratum.where},
                    {"printed", erratum.printed},
                    {"corrected", erratum.corrected},
                    {"evidence", erratum.evidence},
                    {"case", erratum.proved_by}});
  }
  return list;
}

}  // namespace

Counts counts_of(const Results& results) {
  Counts counts;
  for (const auto& record : results.records) {
    ++counts.cases;
    ++(record.status == Status::pass ? counts.passed : counts.failed);
    for (const auto& check : record.checks) {
      ++counts.checks;
      if (!check.pass) ++counts.checks_failed;
      if (check.slack) ++counts.slack;
      if (check.kind == Kind::exact || check.kind == Kind::round_off) ++counts.exempt;
    }
    for (const auto& control : record.controls) {
      ++counts.controls;
      if (!control.pass()) ++counts.controls_failed;
    }
  }
  return counts;
}

bool holds(const Results& results) {
  if (results.selected.empty() || results.records.size() != results.selected.size()) return false;
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    if (results.records[i].id != results.selected[i] || results.records[i].status != Status::pass) return false;
  }
  return true;
}

std::string text_of(const Results& results) {
  Json json{{"schema", 1},
            {"provenance", to_json(results.provenance)},
            {"tier", name_of(results.tier)},
            {"registered", results.registered},
            {"selected", results.selected},
            {"counts", to_json(counts_of(results))},
            {"verdict", holds(results) ? "pass" : "fail"},
            {"requirements", traceability(results.records)},
            {"families", all_families()},
            {"cases", Json::array()},
            {"errata", proved_errata(results.registered)},
            {"peers", checks_of_peers(results.records)},
            {"references", Json::array()}};
  if (!results.only.empty()) json["only"] = results.only;
  for (const auto& record : results.records)
    json["cases"].push_back(in_its_family(record));
  for (const auto& reference : all_references()) {
    json["references"].push_back({{"key", reference.key}, {"text", reference.text}});
  }
  return json.dump(1) + "\n";
}

}  // namespace talus::verification
