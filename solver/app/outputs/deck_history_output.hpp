#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/fence_history.hpp"

namespace talus::app {

/// NAME.history.csv and NAME.history.json: the histories requested by a fence (history_elements, history_codes).
class DeckHistoryOutput {
 public:
  static constexpr std::string_view name = "deck_history";
  static constexpr std::array<std::string_view, 0> fixed_files{};

  explicit DeckHistoryOutput(const OutputRequest& request)
      : folder_{request.folder},
        name_{request.name + ".history"},
        history_{request.file.fence->fence, request.file.fence->made, request.dynamics} {}

  static std::optional<DeckHistoryOutput> make(const OutputRequest& request) {
    if (!request.file.fence) return std::nullopt;
    DeckHistoryOutput output{request};
    // A file of times alone would look as if its values were lost.
    if (!request.file.fence->fence.requests_histories()) return std::nullopt;
    return output;
  }
  void operator()(const Snapshot& snapshot, const StepInfo& info) { history_(snapshot, info); }
  void write(const OutputSource&) const {
    write_whole(folder_ / (name_ + ".csv"), history_.csv_text(), Durability::later);
    write_whole(folder_ / (name_ + ".json"), history_.json_text(), Durability::later);
  }
  std::vector<std::string> files() const { return {name_ + ".csv", name_ + ".json"}; }
  void serialize(Archive& archive) { history_.serialize(archive); }
  /// Requested histories that do not exist are notes of the summary.
  void report(RunRecord& record) const {
    record.notes.insert(record.notes.end(), history_.skipped().begin(), history_.skipped().end());
  }

 private:
  std::filesystem::path folder_;
  std::string name_;
  FenceHistory history_;
};

}  // namespace talus::app
