#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/write_history.hpp"

namespace talus::app {

/// history.csv: all quantities at the plan's interval. The rows are stored by the recorder.
struct HistoryOutput {
  static constexpr std::string_view name = "history";
  static constexpr std::array<std::string_view, 1> fixed_files{"history.csv"};
  std::filesystem::path folder;

  static std::optional<HistoryOutput> make(const OutputRequest& request) { return HistoryOutput{request.folder}; }
  void write(const OutputSource& source) const {
    write_whole(folder / "history.csv", csv(source.record.history, source.record.units), Durability::later);
  }
};

}  // namespace talus::app
