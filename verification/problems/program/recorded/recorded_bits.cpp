#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/recorded/recorded_runs.hpp"
#include "verification/record/csv.hpp"
#include "verification/study/runs/fingerprint.hpp"

namespace talus::verification::problems::recorded_bits {
namespace {

/// Fingerprints by group, then by run and part.
using Fingerprints = std::map<std::string, std::map<std::pair<std::string, std::string>, std::string>>;

Fingerprints read_recorded() {
  const records::Csv csv = records::read_csv(case_file("recorded/fingerprints.csv"));
  const std::size_t group = csv.column("group"), run = csv.column("run"), part = csv.column("part"),
                    fingerprint = csv.column("fingerprint");
  Fingerprints all;
  for (std::size_t row = 0; row < csv.rows(); ++row)
    all[std::string{csv.cell(row, group)}][{std::string{csv.cell(row, run)}, std::string{csv.cell(row, part)}}] =
        csv.cell(row, fingerprint);
  return all;
}

void run(Findings& findings, const Setup& setup) {
  Fingerprints recorded = read_recorded(), found;
  if (setup.has("one_record_lost")) recorded["integrators"].erase({"yard, velocity_verlet", "history"});
  if (setup.has("one_record_of_another"))
    recorded["integrators"][{"yard, velocity_verlet", "history"}] = recorded["integrators"][{"yard, rk4", "history"}];
  std::map<std::string, int> not_restored, runs;
  run_all(findings, setup, [&](const RunResult& one) {
    for (const auto& [part, items] : one.parts)
      found[one.group][{one.name, part}] = fingerprint(items);
    not_restored[one.group] += one.not_restored;
    ++runs[one.group];
  });
  // All results of a recorded group that is no longer run count as differing.
  for (const auto& [group, parts] : recorded) {
    if (!setup.coarse) found[group];
  }
  DataFile data{.name = "fingerprints", .columns = {"group", "run", "part", "fingerprint"}, .rows = {}};
  Table table{.name = "differences",
              .caption = "Results that differ from the recorded ones, at most the first twenty of each group.",
              .columns = {"group", "run", "part", "recorded", "found"}};
  Table counts{
      .name = "runs", .caption = "Runs and fingerprints by group.", .columns = {"group", "runs", "fingerprints"}};
  for (const auto& entry : found) {
    const std::string& group = entry.first;
    const auto& parts = entry.second;
    std::map<std::pair<std::string, std::string>, std::string>& known = recorded[group];
    int differing = 0;
    const auto differ = [&](const auto& key, const std::string& was, const std::string& is) {
      if (++differing <= 20) table.rows.push_back({group, key.first, key.second, was, is});
    };
    for (const auto& [key, fingerprint] : parts) {
      data.rows.push_back({group, key.first, key.second, fingerprint});
      const auto match = known.find(key);
      if (match == known.end()) {
        differ(key, "none", fingerprint);
      } else if (match->second != fingerprint) {
        differ(key, match->second, fingerprint);
      }
    }
    for (const auto& [key, fingerprint] : known) {
      if (!setup.coarse && !parts.contains(key)) differ(key, fingerprint, "none");
    }
    findings.in("recorded")
        ->expect(fmt::format("results that differ from the recorded ones, {}", group), differing, 0.0,
                 Tolerance::exact("the same input gives the same bits"));
    findings.in("restored")
        ->expect(fmt::format("restored objects that differ from the saved ones, {}", group), not_restored[group], 0.0,
                 Tolerance::exact("the items saved at the end of a run are its complete state"));
    counts.rows.push_back({group, fmt::format("{}", runs[group]), fmt::format("{}", parts.size())});
  }
  findings.data(data);
  findings.table(counts);
  if (!table.rows.empty()) findings.table(table);
}

}  // namespace

Case definition() {
  return {.id = "recorded_bits",
          .title = "Bitwise reproducibility of recorded results",
          .requirements = {{"G8", {"recorded"}}, {"F5", {"restored"}}},
          .main_checks = {"results that differ from the recorded ones, integrators",
                          "restored objects that differ from the saved ones, integrators"},
          .source = "IEEE 754",
          .faults = {{"gravity_one_ulp", "gravity of one scene changed by one unit in the last place",
                      "results that differ from the recorded ones, integrators"},
                     {"one_record_lost", "one result missing in the record",
                      "results that differ from the recorded ones, integrators"},
                     {"one_record_of_another", "one result compared with that of another method",
                      "results that differ from the recorded ones, integrators"}},
          .recorded = true,
          .seconds = 5.0,
          .run = run};
}

}  // namespace talus::verification::problems::recorded_bits
