#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_summary.hpp"

namespace talus::app {

/// final_state.json: bodies, cables and hangers at the last step.
struct FinalStateOutput {
  static constexpr std::string_view name = "final_state";
  static constexpr std::array<std::string_view, 1> fixed_files{"final_state.json"};
  std::filesystem::path folder;

  static std::optional<FinalStateOutput> make(const OutputRequest& request) { return FinalStateOutput{request.folder}; }
  void write(const OutputSource& source) const {
    write_whole(folder / "final_state.json", final_state_json(source.record), Durability::later);
  }
};

}  // namespace talus::app
