#include "tests/mutants/schema_report.hpp"

#include <nlohmann/json.hpp>

#include "verification/record/whole_file.hpp"

namespace talus::mutants {

namespace {

using Json = nlohmann::ordered_json;
using records::MutantRecord;
using records::MutantStatus;
using records::Trial;
using records::TrialEnd;

const char* status_of(const MutantRecord& mutant) {
  switch (mutant.status) {
    case MutantStatus::pending:
      return "Pending";
    case MutantStatus::survived:
      return "Survived";
    case MutantStatus::unreached:
      return "NoCoverage";
    case MutantStatus::equivalent:
      return "Ignored";
    case MutantStatus::killed:
      break;
  }
  for (const Trial& trial : mutant.trials) {
    if (records::kills(trial) && trial.end != TrialEnd::timeout) return "Killed";
  }
  return "Timeout";
}

Json json_of(const MutantRecord& mutant) {
  Json killed_by = Json::array();
  std::string reason = mutant.reason;
  for (const Trial& trial : mutant.trials) {
    if (!records::kills(trial)) continue;
    killed_by.push_back(trial.case_id);
    if (reason.empty()) reason = trial.case_id + ": " + trial.check;
  }
  Json json{{"id", mutant.id},
            {"mutatorName", mutant.operation},
            {"replacement", mutant.replacement},
            {"location",
             {{"start", {{"line", mutant.range.line}, {"column", mutant.range.column}}},
              {"end", {{"line", mutant.range.end_line}, {"column", mutant.range.end_column}}}}},
            {"status", status_of(mutant)},
            {"coveredBy", mutant.covered_by},
            {"killedBy", killed_by},
            {"testsCompleted", mutant.trials.size()}};
  if (!reason.empty()) json["statusReason"] = reason;
  if (!mutant.description.empty()) json["description"] = mutant.description;
  return json;
}

}  // namespace

std::string schema_report(const records::Mutants& mutants, const std::filesystem::path& root) {
  Json files = Json::object();
  for (const MutantRecord& mutant : mutants.mutants) {
    Json& file = files[mutant.file];
    if (file.is_null()) {
      file = {{"language", "cpp"}, {"source", records::read_whole(root / mutant.file)}, {"mutants", Json::array()}};
    }
    file["mutants"].push_back(json_of(mutant));
  }
  Json tests = Json::array();
  for (const records::UnchangedCase& one : mutants.cases)
    tests.push_back({{"id", one.id}, {"name", one.id}});
  const Json report{{"schemaVersion", "2"},
                    {"thresholds", {{"high", 98}, {"low", 90}}},
                    {"files", files},
                    {"testFiles", {{"verification cases", {{"tests", tests}}}}},
                    {"framework", {{"name", "talus mutants"}}}};
  return report.dump() + "\n";
}

}  // namespace talus::mutants
