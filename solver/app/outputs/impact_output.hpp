#pragma once

#include "solver/app/outputs/run_output.hpp"
#include "solver/run/impact_log.hpp"

namespace talus::app {

/// impacts.csv: a row for each impact of the run, with --impacts. The record of the run receives the impacts, for its
/// summary.
class ImpactOutput {
 public:
  static constexpr std::string_view name = "impacts";
  static constexpr std::array<std::string_view, 1> fixed_files{"impacts.csv"};

  explicit ImpactOutput(const OutputRequest& request)
      : folder_{request.folder}, scene_{&request.file.scene}, log_{request.dynamics} {}

  static std::optional<ImpactOutput> make(const OutputRequest& request) {
    if (!request.options.impacts) return std::nullopt;
    return ImpactOutput{request};
  }
  void operator()(const Snapshot& snapshot, const StepInfo& info) { log_(snapshot, info); }
  void report(RunRecord& record) const;
  void write(const OutputSource& source) const;
  void serialize(Archive& archive) { log_.serialize(archive); }

 private:
  std::filesystem::path folder_;
  const Scene* scene_;
  ImpactLog log_;
};

}  // namespace talus::app
