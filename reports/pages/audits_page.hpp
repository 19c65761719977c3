/// Chapters of the report on audits: mutated input, killed runs, changed references and executed lines. All results are
/// Markdown.
#pragma once

#include <string>
#include <vector>

#include "reports/base/record.hpp"
#include "verification/record/audits.hpp"

namespace talus::reports {

/// When an audit was made, and the command that repeats it.
[[nodiscard]] std::string origin_text(const records::Audits& audits, const std::string& audit,
                                      const std::string& command);

/// Readers, the mutated files that each was given, and the findings.
[[nodiscard]] std::string fuzz_text(const records::FuzzAudit& audit);

/// Kills, and what became of the runs.
[[nodiscard]] std::string faults_text(const records::FaultAudit& audit);

/// Files that cases compare with, and the changes of each that turn the case red.
[[nodiscard]] std::string inputs_text(const records::InputAudit& audit);

/// Defects by area, with the case or test that guards each, and their numbers by what found them. `results`: of the
/// reported run, whose cases are linked.
[[nodiscard]] std::string defects_text(const std::vector<records::Defect>& defects, const Results& results);

/// Executed lines and branches by folder, and the files with fewer than 95 % of their lines.
[[nodiscard]] std::string lines_text(const records::ExecutedLines& lines);

}  // namespace talus::reports
