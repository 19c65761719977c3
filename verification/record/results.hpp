#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/case_record.hpp"

namespace talus::records {

/// Origin of results, sufficient to reproduce them.
struct Provenance {
  std::string revision;                                        ///< Git commit of the sources, or "unknown".
  bool dirty = false;                                          ///< The sources differ from that commit.
  std::string compiler;                                        ///< Name and version.
  std::string flags;                                           ///< Compiler options of the build.
  std::string build_type;                                      ///< "Release", "Debug", ...
  std::string cpu;                                             ///< Model name.
  unsigned cores = 0;                                          ///< Processors that the process may use.
  std::string os;                                              ///< Distribution and kernel.
  std::vector<std::pair<std::string, std::string>> libraries;  ///< Name and version.
  std::string date;                                            ///< UTC, ISO 8601; see epoch_seconds().
};

/// Seconds since 1970 for an ISO date such as 2026-03-01T12:00:00Z (UTC; the time may be absent). RecordError for any
/// other text.
[[nodiscard]] long long epoch_seconds(const std::string& iso_date);

/// Numbers of cases, checks and controls.
struct Counts {
  std::size_t cases = 0;
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t checks = 0;
  std::size_t checks_failed = 0;
  std::size_t slack = 0;   ///< Checks with a chosen bound that is more than fifty times the error.
  std::size_t exempt = 0;  ///< Exact and round-off checks, whose bound was not chosen; they are never marked as slack.
  std::size_t controls = 0;
  std::size_t controls_failed = 0;  ///< with those that are not judged
};

/// The checks of one case that verify a requirement.
struct ShownBy {
  std::string case_id;
  std::vector<std::string> checks;
};

/// A requirement of the catalogue, and the checks that verify it.
struct Requirement {
  std::string id;
  std::string group;
  std::string text;               ///< One line.
  std::vector<ShownBy> shown_by;  ///< Includes cases that claim it without a check.
  int order = 0;                  ///< The declared order of an integrator; 0 for all others.
};

/// A check of another code or a published benchmark set, and the cases that cover it.
struct Peer {
  std::string suite;                  ///< Key in the bibliography.
  std::string id;                     ///< Its name there.
  std::string what;                   ///< The setup.
  std::string form;                   ///< The reference that it is compared with.
  std::vector<std::string> problems;  ///< Ids of requirements.
  std::string remark;
  std::vector<std::string> cases;
};

/// An error in a printed source that a case demonstrates.
struct Erratum {
  std::string id;
  std::string where;
  std::string printed;
  std::string corrected;
  std::string evidence;
  std::string case_id;
};

/// A sentence of the report's summary. `<<NAME>>` in it is replaced by what the check of that name measured.
struct Finding {
  std::string case_id;
  std::string text;
};

/// A figure of a case that the report's first page shows.
struct Highlight {
  std::string case_id;
  std::string figure;   ///< Its name.
  std::string caption;  ///< One sentence.
};

/// All that one run of the driver found; `results.json`.
struct Results {
  Provenance provenance;
  Tier tier = Tier::quick;
  std::vector<std::string> registered;  ///< Ids of all cases.
  std::vector<std::string> selected;    ///< Ids of the cases that were to run.
  std::vector<std::string> only{};      ///< Ids given with --only; empty: all of the tier.
  std::vector<Record> records;          ///< One for each selected case.
  std::vector<Requirement> requirements;
  std::vector<std::string> families;  ///< Families of cases, in the order of the report.
  std::vector<Erratum> errata;
  std::vector<Peer> peers;
  std::vector<Finding> findings{};      ///< Findings of registered cases.
  std::vector<Highlight> highlights{};  ///< Figures of the first page, from registered cases.
  std::string bibliography;             ///< The works that are cited, in BibTeX; may be empty.
};

/// The check of that name in the case; null if there is none.
[[nodiscard]] const Check* check_of(const Results& results, const std::string& case_id, const std::string& name);

[[nodiscard]] Counts counts_of(const Results& results);

/// True if something was run, each selected case has one record, in that order, and each of these passed.
[[nodiscard]] bool holds(const Results& results);

}  // namespace talus::records
