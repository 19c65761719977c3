#include "verification/record/mutants.hpp"

#include "verification/record/json_fields.hpp"

namespace talus::records {

void fields(auto& f, Like<Trial> auto& trial) {
  f.nonempty_text("case", trial.case_id);
  f.value("end", trial.end);
  f.number("ratio", trial.ratio);
  f.value("check", trial.check);
  f.value("failed", trial.failed);
}

void fields(auto& f, Like<SourceRange> auto& range) {
  f.value("line", range.line);
  f.value("column", range.column);
  f.value("end_line", range.end_line);
  f.value("end_column", range.end_column);
}

void fields(auto& f, Like<MutantRecord> auto& mutant) {
  f.value("number", mutant.number);
  f.nonempty_text("id", mutant.id);
  f.nonempty_text("operation", mutant.operation);
  f.value("description", mutant.description);
  f.nonempty_text("file", mutant.file);
  f.value("range", mutant.range);
  f.nonempty_text("original", mutant.original);
  f.value("replacement", mutant.replacement);
  f.value("cases", mutant.cases);
  f.value("status", mutant.status);
  f.value("reason", mutant.reason);
  f.value("covered_by", mutant.covered_by);
  f.value("trials", mutant.trials);
}

void fields(auto& f, Like<UnchangedCase> auto& unchanged) {
  f.nonempty_text("id", unchanged.id);
  f.value("family", unchanged.family);
  f.value("seconds", unchanged.seconds);
  f.value("recorded", unchanged.recorded);
  f.value("in_matrix", unchanged.in_matrix);
}

void fields(auto& f, Like<Mutants> auto& mutants) {
  f.derived("schema", std::string("talus mutants 5"));
  f.value("candidates", mutants.candidates);
  f.value("uncompiled", mutants.uncompiled);
  f.value("seed", mutants.seed);
  f.value("whole_matrix", mutants.whole_matrix);
  f.value("operator_count", mutants.operator_count);
  f.value("build_seconds", mutants.build_seconds);
  f.value("run_seconds", mutants.run_seconds);
  f.value("cases", mutants.cases);
  f.value("mutants", mutants.mutants);
}

bool kills(const Trial& trial) { return trial.end != TrialEnd::pass; }

void count(Score& score, const MutantRecord& mutant) {
  switch (mutant.status) {
    case MutantStatus::killed:
      ++score.killed;
      return;
    case MutantStatus::survived:
      ++score.survived;
      return;
    case MutantStatus::unreached:
      ++score.unreached;
      return;
    case MutantStatus::equivalent:
      ++score.equivalent;
      return;
    case MutantStatus::pending:
      ++score.pending;
      return;
  }
}

void write_mutants(const Mutants& mutants, const std::filesystem::path& file) { write_file(mutants, file); }

Mutants read_mutants(const std::filesystem::path& file) { return read_file<Mutants>(file, "mutants"); }

}  // namespace talus::records
