#pragma once

#include <tuple>

#include "solver/app/outputs/deck_history_output.hpp"
#include "solver/app/outputs/final_state_output.hpp"
#include "solver/app/outputs/geometry_output.hpp"
#include "solver/app/outputs/history_output.hpp"
#include "solver/app/outputs/impact_output.hpp"
#include "solver/app/outputs/listing_output.hpp"
#include "solver/app/outputs/plot_output.hpp"
#include "solver/app/outputs/run_output.hpp"
#include "solver/app/outputs/sheet_output.hpp"

namespace talus::app {

/// The outputs of one run, at most one of each kind.
template <CompleteOutput... Kinds>
class OutputList {
 public:
  /// An empty list: nothing is written.
  OutputList() = default;
  /// Errors: InputError and IoError of the outputs.
  explicit OutputList(const OutputRequest& request) : outputs_{Kinds::make(request)...} {}

  void operator()(const Snapshot& snapshot, const StepInfo& info) {
    for_each(*this, [&]<class T>(T& output) {
      if constexpr (StepwiseOutput<T>) output(snapshot, info);
    });
  }
  /// Writes all files. Errors: IoError.
  void write(const OutputSource& source) const {
    for_each(*this, [&](const auto& output) { output.write(source); });
  }
  /// Saves or restores the outputs' state between two steps; outputs of a resumed run continue from it.
  void serialize(Archive& archive) {
    for_each(*this, [&]<class T>(T& output) {
      if constexpr (SerializableOutput<T>) archive.scope(T::name, [&] { output.serialize(archive); });
    });
  }
  /// Copies the files written so far from the folder of the interrupted run; called after restoring. Errors: IoError.
  void bring_files(const std::filesystem::path& from) {
    for_each(*this, [&]<class T>(T& output) {
      if constexpr (ResumableOutput<T>) output.bring_files(from);
    });
  }
  /// Names of the files, in the order of the kinds.
  std::vector<std::string> files() const {
    std::vector<std::string> all;
    for_each(*this, [&]<class T>(const T& output) {
      if constexpr (NamesFiles<T>) {
        for (std::string& file : output.files())
          all.push_back(std::move(file));
      } else {
        all.insert(all.end(), T::fixed_files.begin(), T::fixed_files.end());
      }
    });
    return all;
  }
  /// Names of the files of all kinds that do not depend on the scene.
  static std::vector<std::string_view> fixed_files() {
    std::vector<std::string_view> all;
    (all.insert(all.end(), Kinds::fixed_files.begin(), Kinds::fixed_files.end()), ...);
    return all;
  }
  /// Adds the outputs' results and notes to the record of the run.
  void report(RunRecord& record) const {
    for_each(*this, [&]<class T>(const T& output) {
      if constexpr (ReportingOutput<T>) output.report(record);
    });
  }

 private:
  template <class List, class Visit>
  static void for_each(List& list, Visit&& visit) {
    std::apply(
        [&](auto&... output) {
          const auto visit_one = [&](auto& one) {
            if (one) visit(*one);
          };
          (visit_one(output), ...);
        },
        list.outputs_);
  }

  std::tuple<std::optional<Kinds>...> outputs_;
};

/// The kinds of output files of `talus run`, in the order of the summary's list. To add one, see RunOutput.
using RunOutputs = OutputList<HistoryOutput, FinalStateOutput, PlotOutput, ListingOutput, DeckHistoryOutput,
                              GeometryOutput, ImpactOutput, SheetOutput>;

}  // namespace talus::app
