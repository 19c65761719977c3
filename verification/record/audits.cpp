#include "verification/record/audits.hpp"

#include <algorithm>

#include "verification/record/json_fields.hpp"

namespace talus::records {

namespace fs = std::filesystem;

namespace {

struct Origins {
  std::vector<AuditOrigin> audits;
};

struct Defects {
  std::vector<Defect> defects;
};

RoundedResult rounded_result(const Check* check) {
  return check == nullptr ? RoundedResult{} : RoundedResult{true, check->margin, check->pass};
}

}  // namespace

void fields(auto& f, Like<RoundedResult> auto& result) {
  f.value("made", result.made);
  f.number_or_null(result.made, "margin", result.margin);
  f.value("pass", result.holds);
}

void fields(auto& f, Like<RoundedCheck> auto& check) {
  f.nonempty_text("case", check.case_id);
  f.nonempty_text("check", check.check);
  f.value("kind", check.kind);
  f.value("nearest", check.nearest);
  f.value("rounded", check.rounded);
}

void fields(auto& f, Like<RoundedKind> auto& kind) {
  f.value("kind", kind.kind);
  f.value("checks", kind.checks);
  f.value("failed", kind.failed);
}

void fields(auto& f, Like<RoundingAudit> auto& audit) {
  f.derived("schema", std::string("talus rounding 1"));
  f.value("modes", audit.modes);
  f.value("kinds", audit.kinds);
  f.value("checks", audit.checks);
}

void demand_sound(const Node& node, const RoundingAudit& audit) {
  const auto demand = [&](std::size_t found) {
    if (found != audit.modes.size()) node.fail("each kind and check must have one result for each of the modes");
  };
  for (const RoundedKind& kind : audit.kinds)
    demand(kind.failed.size());
  for (const RoundedCheck& check : audit.checks)
    demand(check.rounded.size());
}

void fields(auto& f, Like<FuzzedReader> auto& reader) {
  f.nonempty_text("reader", reader.reader);
  f.value("inputs", reader.inputs);
  f.value("accepted", reader.accepted);
  f.value("refused", reader.refused);
  f.value("cut_short", reader.cut_short);
  f.value("seconds", reader.seconds);
  f.value("findings", reader.findings);
}

void fields(auto& f, Like<FuzzAudit> auto& audit) {
  f.derived("schema", std::string("talus fuzz 2"));
  f.value("seed", audit.seed);
  f.value("readers", audit.readers);
}

void fields(auto& f, Like<FaultAudit> auto& audit) {
  f.derived("schema", std::string("talus faults 1"));
  f.value("kills", audit.kills);
  f.value("before_checkpoint", audit.before_checkpoint);
  f.value("resumed", audit.resumed);
  f.value("temporary_files", audit.temporary_files);
  f.value("runs", audit.runs);
  f.value("identical", audit.identical);
}

void fields(auto& f, Like<ChangedInput> auto& input) {
  f.nonempty_text("file", input.file);
  f.nonempty_text("case", input.case_id);
  f.value("changes", input.changes);
  f.value("detected", input.detected);
}

void fields(auto& f, Like<InputAudit> auto& audit) {
  f.derived("schema", std::string("talus inputs 1"));
  f.value("files", audit.files);
}

/// The names of `gcovr --json-summary`.
void fields(auto& f, Like<ExecutedSource> auto& source) {
  f.nonempty_text("filename", source.file);
  f.value("line_total", source.lines);
  f.value("line_covered", source.executed_lines);
  f.value("branch_total", source.branches);
  f.value("branch_covered", source.executed_branches);
}

void fields(auto& f, Like<ExecutedLines> auto& lines) { f.value("files", lines.files); }

void fields(auto& f, Like<Defect> auto& defect) {
  f.nonempty_text("what", defect.what);
  f.nonempty_text("area", defect.area);
  f.nonempty_text("found_by", defect.found_by);
  f.nonempty_text("commit", defect.commit);
  f.value("case", defect.case_id);
  f.value("test", defect.test);
}

void demand_sound(const Node& node, const Defect& defect) {
  if (defect.case_id.empty() == defect.test.empty()) node.fail("must have either a case or a test");
}

void fields(auto& f, Like<Defects> auto& list) { f.value("defects", list.defects); }

void fields(auto& f, Like<AuditOrigin> auto& origin) {
  f.nonempty_text("audit", origin.audit);
  f.nonempty_text("revision", origin.revision);
  f.nonempty_text("date", origin.date);
}

void fields(auto& f, Like<Origins> auto& origins) { f.value("audits", origins.audits); }

RoundingAudit rounding_audit(const Results& nearest, const std::vector<std::pair<std::string, Results>>& rounded) {
  RoundingAudit audit;
  for (const auto& [mode, results] : rounded)
    audit.modes.push_back(mode);
  for (const Record& record : nearest.records) {
    for (const Check& check : record.checks) {
      auto kind = std::ranges::find(audit.kinds, check.kind, &RoundedKind::kind);
      if (kind == audit.kinds.end())
        kind = audit.kinds.insert(kind, {check.kind, 0, std::vector<std::size_t>(rounded.size())});
      ++kind->checks;
      RoundedCheck row{record.id, check.name, check.kind, rounded_result(&check), {}};
      for (std::size_t i = 0; i < rounded.size(); ++i) {
        row.rounded.push_back(rounded_result(check_of(rounded[i].second, record.id, check.name)));
        kind->failed[i] += row.rounded.back().holds ? 0 : 1;
      }
      if (!std::ranges::all_of(row.rounded, &RoundedResult::holds)) audit.checks.push_back(std::move(row));
    }
  }
  return audit;
}

const AuditOrigin* Audits::origin(const std::string& audit) const {
  const auto found = std::ranges::find(origins, audit, &AuditOrigin::audit);
  return found == origins.end() ? nullptr : &*found;
}

fs::path audit_file(const std::string& audit, const fs::path& run, const fs::path& recorded) {
  for (const fs::path& folder : {run, recorded}) {
    if (!folder.empty() && fs::exists(folder / (audit + ".json"))) return folder / (audit + ".json");
  }
  return {};
}

Audits read_audits(const fs::path& run, const fs::path& recorded) {
  Audits audits;
  std::vector<AuditOrigin> known;
  const auto read = [&](const char* audit, auto& into, auto&& reading) {
    const fs::path file = audit_file(audit, run, recorded);
    if (file.empty()) return;
    into = reading(file);
    if (file.parent_path() == run) return;
    if (known.empty()) known = read_file<Origins>(recorded / "origins.json", "origins").audits;
    const auto origin = std::ranges::find(known, audit, &AuditOrigin::audit);
    if (origin == known.end())
      throw RecordError((recorded / "origins.json").string() + ": audits: '" + audit + "' is missing");
    audits.origins.push_back(*origin);
  };
  read("mutants", audits.mutants, read_mutants);
  read("gate", audits.gate, read_mutants);
  read("interface", audits.interface, read_interface);
  read("rounding", audits.rounding, [](const fs::path& file) { return read_file<RoundingAudit>(file, "rounding"); });
  read("fuzz", audits.fuzz, [](const fs::path& file) { return read_file<FuzzAudit>(file, "fuzz"); });
  read("faults", audits.faults, [](const fs::path& file) { return read_file<FaultAudit>(file, "faults"); });
  read("inputs", audits.inputs, [](const fs::path& file) { return read_file<InputAudit>(file, "inputs"); });
  read("lines", audits.lines, [](const fs::path& file) { return read_file<ExecutedLines>(file, "lines"); });
  if (!recorded.empty() && fs::exists(recorded / "defects.json"))
    audits.defects = read_file<Defects>(recorded / "defects.json", "defects").defects;
  return audits;
}

void write_rounding(const RoundingAudit& audit, const fs::path& file) { write_file(audit, file); }
void write_fuzz(const FuzzAudit& audit, const fs::path& file) { write_file(audit, file); }
void write_faults(const FaultAudit& audit, const fs::path& file) { write_file(audit, file); }
void write_inputs(const InputAudit& audit, const fs::path& file) { write_file(audit, file); }

}  // namespace talus::records
