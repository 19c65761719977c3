#include "verification/driver/baseline_gate.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "solver/base/error.hpp"
#include "verification/driver/baseline_json.hpp"
#include "verification/driver/baseline_markdown.hpp"
#include "verification/driver/baseline_table.hpp"
#include "verification/record/record_files.hpp"
#include "verification/record/utf8.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

constexpr const char* json_name = "baseline.json";
constexpr const char* markdown_name = "baseline.md";

/// Parses all of `text` as a finite number >= 0; no value otherwise.
std::optional<double> number_from(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc{} || rest != end || !std::isfinite(value) || value < 0.0) return std::nullopt;
  return value;
}

double number_of(const char* option, const std::string& text) {
  const auto value = number_from(text);
  if (!value) throw InputError(fmt::format("{}: found '{}'; it must be a number of at least 0", option, text));
  return *value;
}

ChangeTolerance tolerance_from(const std::string& text) {
  const auto equals = text.rfind('=');
  const auto value = number_from(equals == std::string::npos ? text : text.substr(equals + 1));
  if (!value || equals == 0) {
    throw InputError(fmt::format(
        "--tolerance: found '{}'; it must be a number of at least 0, or NAME=NUMBER with a family or case", text));
  }
  return {equals == std::string::npos ? "" : text.substr(0, equals), *value};
}

/// Rejects an input that the comparison would overwrite.
void demand_separate(const char* option, const std::string& file, const fs::path& out) {
  for (const char* const name : {json_name, markdown_name}) {
    std::error_code none;
    if (!file.empty() && fs::equivalent(file, out / name, none)) {
      throw InputError(fmt::format("{}: found {}, which the comparison writes; it must be another file", option, file));
    }
  }
}

}  // namespace

ResultsFile read_results_file(const fs::path& file) {
  try {
    return {file, records::read_results(file)};
  } catch (const records::RecordError& fault) {
    throw InputError(fault.what());
  } catch (const records::FileError& fault) {
    throw IoError(fault.what());
  }
}

BaselineGate read_gate(const BaselineOptions& options, const std::vector<std::string>& only, const fs::path& out) {
  BaselineGate gate;
  for (const std::string& tolerance : options.tolerances)
    gate.allowance.tolerances.push_back(tolerance_from(tolerance));
  if (!options.margin.empty()) gate.allowance.margin = number_of("--margin", options.margin);
  gate.allowance.evaluation_growth = number_of("--evaluation-growth", options.evaluation_growth);
  gate.allowance.round_off = options.allow_round_off;
  gate.allowance.only = only;
  demand_separate("--baseline", options.baseline, out);
  demand_separate("--compare", options.compare, out);
  demand_separate("--renamed", options.renamed, out);
  gate.before = read_results_file(options.baseline);
  if (!options.renamed.empty()) gate.renames = read_renames(options.renamed);
  return gate;
}

void remove_comparison(const fs::path& out) {
  fs::remove(out / json_name);
  fs::remove(out / markdown_name);
}

GateVerdict finish(const BaselineGate& gate, const ResultsFile& after, const fs::path& out) {
  const Comparison comparison = compare(gate.before, after, gate.allowance, gate.renames);
  records::write_whole(out / json_name, json_of(comparison));
  records::write_whole(out / markdown_name, markdown_of(comparison));
  fmt::print("{}comparison: {} and {}\n", table_of(comparison), (out / json_name).string(), markdown_name);
  std::fflush(stdout);
  for (const std::string& error : comparison.renaming_errors)
    fmt::print(stderr, "talus_verify: {}\n", records::shown_lines(error));
  if (!comparison.renaming_errors.empty()) return GateVerdict::wrong_renames;
  return totals_of(comparison).worse() > 0 ? GateVerdict::worse : GateVerdict::not_worse;
}

}  // namespace talus::verification
