#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/app/sweep/swept_scene.hpp"
#include "solver/io/cell/read_cell.hpp"

namespace talus::app {

/// A shear cell as the base of a sweep. Outputs: `cell.NAME` of a group or mean of its summary, and `cell.NAME.error`,
/// its standard error.
class SweptCell {
 public:
  /// Errors: InputError for a cell that is wrong.
  SweptCell(TomlValue document, std::string name);

  /// See SweepBase::choose().
  void choose(std::vector<std::string> outputs);

  const TomlValue& document() const { return document_; }
  const std::vector<SweepOutput>& outputs() const { return outputs_; }
  const UnitSystem& units() const { return *base_.units; }
  /// Time at which a run is planned to end [T]. Errors: InputError for a wrong field or value.
  [[nodiscard]] double end(const SweptRun& run) const { return cell(run).plan.end; }
  /// See SweepBase::result(). Warnings of `talus cell` are the reason of a run that finished.
  [[nodiscard]] SweepResult result(const SweptRun& run, const SweepLimits& limits,
                                   const std::function<bool()>& interrupted) const;

 private:
  [[nodiscard]] CellScene cell(const SweptRun& run) const;

  std::string name_;
  TomlValue document_;
  CellScene base_;
  std::vector<std::string> names_;
  std::vector<SweepOutput> outputs_;
};

}  // namespace talus::app
