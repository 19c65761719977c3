#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>

#include "verification/record/audits.hpp"

/// Writes interface.json and killed.json, with a value in each of their members, to the folder of its argument:
/// scripts/test_schemas validates them. The audits that write the real ones take hours.
int main(int count, char** arguments) {
  using namespace talus::records;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (count != 2) {
    std::cerr << "usage: talus_audit_files FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = arguments[1];
    std::vector<InterfaceItem> items;
    for (const auto& [status, name] : Names<InterfaceStatus>::values)
      items.push_back({"option", name, {"case"}, status, "case", "check"});
    write_interface(items, folder / "interface.json");

    Mutants mutants{.candidates = 100,
                    .uncompiled = 2,
                    .seed = std::numeric_limits<std::uint64_t>::max(),
                    .whole_matrix = true,
                    .operator_count = 15,
                    .build_seconds = 120.0,
                    .run_seconds = 0.5,
                    .cases = {{"case", "family", 1.5, true, true}},
                    .mutants = {}};
    for (const auto& [status, name] : Names<MutantStatus>::values) {
      const bool is_compiled = status != MutantStatus::equivalent;
      mutants.mutants.push_back({.number = is_compiled ? static_cast<int>(mutants.mutants.size()) + 1 : 0,
                                 .id = name,
                                 .operation = "bug",
                                 .description = "The sign is wrong.",
                                 .file = "solver/laws/hertz.hpp",
                                 .range = {10, 3, 10, 9},
                                 .original = "a + b",
                                 .replacement = "a - b",
                                 .cases = {"*"},
                                 .status = status,
                                 .reason = "none",
                                 .covered_by = {"case"},
                                 .trials = {}});
    }
    for (const auto& [end, name] : Names<TrialEnd>::values)
      mutants.mutants.front().trials.push_back({"case", end, infinity, "check", {"check", "another"}});
    write_mutants(mutants, folder / "killed.json");

    write_rounding({.modes = {"upward"},
                    .kinds = {{Kind::exact, 3, {1}}},
                    .checks = {{"case", "check", Kind::exact, {true, 0.5, true}, {{true, infinity, false}}},
                               {"case", "another", Kind::round_off, {true, 0.5, true}, {{}}}}},
                   folder / "rounding.json");
    write_fuzz({.seed = 1, .readers = {{"fence_toml", 100, 20, 79, 1, 0.5, 0}}}, folder / "fuzz.json");
    write_faults({100, 46, 54, 3, 88, 88}, folder / "faults.json");
    write_inputs({{{"published/a.csv", "case", 12, 12}}}, folder / "inputs.json");
  } catch (const std::exception& error) {
    std::cerr << "talus_audit_files: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
