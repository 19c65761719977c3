#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/io/cell/write_cell.hpp"
#include "solver/python/advancing.hpp"
#include "solver/python/script_document.hpp"

namespace talus::python {

/// The file of a shear cell. Errors: InputError, also for a scene of bodies.
[[nodiscard]] CellScene read_cell_document(const TomlValue& document, const std::string& name);

/// A shear cell.
using ScriptCell = ScriptDocument<CellScene, read_cell_document>;

/// The run of a shear cell, as a script advances it.
class ScriptCellRun {
 public:
  /// At the start.
  explicit ScriptCellRun(const ScriptCell& cell);
  ScriptCellRun(const ScriptCellRun&) = delete;
  ScriptCellRun& operator=(const ScriptCellRun&) = delete;

  /// Needed to advance; the run is not idle as long as it exists. Errors: as idle().
  [[nodiscard]] Advancing begin() { return Advancing{is_advancing_}; }
  /// Advances by up to this number of intervals between outputs, fewer if `interrupted` returns true; false if none is
  /// left: the run has ended or failed. `advancing`: of begin().
  bool advance(const Advancing& advancing, long intervals, const std::function<bool()>& interrupted = {});
  /// The run. Errors: std::runtime_error while it advances: another thread, or a handler of a signal, must not use it
  /// then.
  CellRun& idle() const;

  /// Saves or restores the run.
  void serialize(Archive& archive);

  const ScriptCell& cell() const { return cell_; }
  const CellScene& scene() const { return cell_.file(); }
  bool has_ended() const { return idle().finished() || !idle().failure().empty(); }
  /// The discs, with velocities at the time of their positions.
  const Discs& discs() const { return static_cast<void>(idle()), discs_; }
  [[nodiscard]] CellOutcome outcome() const;

 private:
  void show(const Discs& discs);

  ScriptCell cell_;
  std::unique_ptr<CellRun> run_;
  Discs discs_;
  std::atomic<bool> is_advancing_{false};
};

}  // namespace talus::python
