#include "reports/pages/audits_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {

namespace {

using markdown::cell;
using records::ExecutedSource;
using Rows = std::vector<std::vector<std::string>>;

/// Files below this fraction of executed lines are listed.
constexpr double demanded_lines = 0.95;

double fraction(std::size_t part, std::size_t all) {
  return all == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(all);
}

std::string percent(std::size_t part, std::size_t all) { return fmt::format("{:.1f} %", 100.0 * fraction(part, all)); }

void add(ExecutedSource& sum, const ExecutedSource& source) {
  sum.lines += source.lines, sum.executed_lines += source.executed_lines;
  sum.branches += source.branches, sum.executed_branches += source.executed_branches;
}

std::vector<std::string> executed_row(const std::string& name, const ExecutedSource& source) {
  return {name, fmt::format("{}", source.lines), percent(source.executed_lines, source.lines),
          fmt::format("{}", source.branches), percent(source.executed_branches, source.branches)};
}

/// The name of a unit test, "suite: what it shows" as a sentence, which lines can be broken in; or the file of a test.
std::string test_text(const std::string& test) {
  const std::size_t slash = test.find("_tests/");
  if (slash == std::string::npos) return markdown::code(test);
  std::string text = test.substr(0, slash) + ": " + test.substr(slash + 7);
  std::ranges::replace(text, '_', ' ');
  return cell(text);
}

}  // namespace

std::string origin_text(const records::Audits& audits, const std::string& audit, const std::string& command) {
  const records::AuditOrigin* const origin = audits.origin(audit);
  if (origin == nullptr)
    return fmt::format("*The last result of {} in this build; it may be of an earlier revision.*\n\n",
                       markdown::code(command));
  return fmt::format("*Recorded on {} at revision {}, not measured in this run; {} repeats it.*\n\n", origin->date,
                     origin->revision, markdown::code(command));
}

std::string fuzz_text(const records::FuzzAudit& audit) {
  Rows rows;
  records::FuzzedReader all{.reader = "**all**"};
  const auto row = [&](const std::string& name, const records::FuzzedReader& of) {
    rows.push_back({name, fmt::format("{}", of.inputs), fmt::format("{}", of.accepted), fmt::format("{}", of.refused),
                    fmt::format("{}", of.cut_short), fmt::format("{:.0f}", of.seconds),
                    of.findings == 0 ? "0" : fmt::format("**{}**", of.findings)});
  };
  for (const records::FuzzedReader& each : audit.readers) {
    row(cell(each.reader), each);
    all.inputs += each.inputs, all.accepted += each.accepted, all.refused += each.refused;
    all.cut_short += each.cut_short, all.seconds += each.seconds, all.findings += each.findings;
  }
  row(all.reader, all);
  return markdown::table({{"reader"},
                          {"inputs", true},
                          {"accepted", true},
                          {"refused", true},
                          {"cut short", true},
                          {"seconds", true},
                          {"findings", true}},
                         rows, "");
}

std::string faults_text(const records::FaultAudit& audit) {
  return fmt::format(
      "{} kills: {} before the first checkpoint, after which the run was started again, {} later, after which it was "
      "resumed; some runs ended before their kill. **{} of {} runs ended with the files of an undisturbed run, byte by "
      "byte.** Kills left {} temporary files, which the next run removed.\n",
      audit.kills, audit.before_checkpoint, audit.resumed, audit.identical, audit.runs, audit.temporary_files);
}

std::string inputs_text(const records::InputAudit& audit) {
  Rows rows;
  records::ChangedInput all{.file = "**all**"};
  const auto row = [&](const std::string& name, const records::ChangedInput& of) {
    const std::string detected = fmt::format("{}", of.detected);
    rows.push_back({name, cell(of.case_id), fmt::format("{}", of.changes),
                    of.detected == of.changes ? detected : "**" + detected + "**"});
  };
  for (const records::ChangedInput& each : audit.files) {
    row(cell(each.file), each);
    all.changes += each.changes, all.detected += each.detected;
  }
  row(all.file, all);
  return markdown::table({{"file"}, {"case"}, {"changes", true}, {"detected", true}}, rows, "");
}

std::string defects_text(const std::vector<records::Defect>& defects, const Results& results) {
  std::map<std::string, std::map<std::string, std::size_t>> counts;  // by what found them, by area
  std::map<std::string, Rows> areas;
  for (const records::Defect& defect : defects) {
    ++counts[defect.found_by][defect.area];
    areas[defect.area].push_back({markdown::text(defect.what), cell(defect.found_by),
                                  defect.test.empty() ? link_of(results, defect.case_id) : test_text(defect.test)});
  }
  std::vector<markdown::Column> columns{{"found by"}};
  for (const auto& [area, rows] : areas)
    columns.push_back({cell(area), true});
  columns.push_back({"all", true});
  Rows rows;
  for (const auto& [found_by, by_area] : counts) {
    std::size_t sum = 0;
    rows.push_back({cell(found_by)});
    for (const auto& [area, listed] : areas) {
      const auto found = by_area.find(area);
      const std::size_t count = found == by_area.end() ? 0 : found->second;
      rows.back().push_back(fmt::format("{}", count));
      sum += count;
    }
    rows.back().push_back(fmt::format("{}", sum));
  }
  std::string text = markdown::table(columns, rows, "") + "\n";
  for (const auto& [area, listed] : areas) {
    std::string heading = area;
    heading.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(heading.front())));
    text += fmt::format("## {}\n\n{}\n", markdown::text(heading),
                        markdown::table({{"defect"}, {"found by"}, {"now red"}}, listed, ""));
  }
  return text;
}

std::string lines_text(const records::ExecutedLines& lines) {
  std::map<std::string, ExecutedSource> folders;
  ExecutedSource all;
  Rows rows, low;
  for (const ExecutedSource& source : lines.files) {
    add(folders[source.file.substr(0, source.file.rfind('/'))], source);
    add(all, source);
    if (fraction(source.executed_lines, source.lines) < demanded_lines)
      low.push_back(executed_row(cell(source.file), source));
  }
  for (const auto& [folder, sum] : folders)
    rows.push_back(executed_row(cell(folder), sum));
  rows.push_back(executed_row("**all**", all));
  const auto table = [](const char* name, const Rows& of) {
    return markdown::table({{name}, {"lines", true}, {"executed", true}, {"branches", true}, {"executed", true}}, of,
                           "");
  };
  return table("folder", rows) +
         (low.empty() ? "\nNo file has fewer than 95 % of its lines executed.\n"
                      : "\n**Files with fewer than 95 % of their lines executed.**\n\n" + table("file", low));
}

}  // namespace talus::reports
