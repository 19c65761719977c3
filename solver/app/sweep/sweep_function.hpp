#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/app/sweep/sweep_file.hpp"
#include "solver/app/sweep/sweep_runs.hpp"

namespace talus::app {

/// A number that a SweepFunction takes: a field of an axis, in the unit in which the axis is written.
struct SweepInput {
  std::string field;
  std::string unit;  ///< empty for pure numbers
};

/// The runs of a sweep as a function, for programs that choose their points: numbers of the axes' fields give the
/// outputs. An axis with one point is no input: all runs have its values. Other points and the design of the file are
/// not used; its constraints and limits are.
class SweepFunction {
 public:
  /// Reads a sweep and its base. Errors: IoError; InputError for a wrong sweep, or an axis whose values are not numbers
  /// in one unit.
  explicit SweepFunction(const std::filesystem::path& file);

  const std::vector<SweepInput>& inputs() const { return inputs_; }
  const std::vector<SweepOutput>& outputs() const { return base_.outputs(); }
  /// Symbol of an output's unit; empty for pure numbers.
  [[nodiscard]] std::string unit(const SweepOutput& output) const;

  /// The run with these numbers, one for each input. A point that breaks a constraint is refused. `interrupted` as of
  /// SweepBase::result().
  [[nodiscard]] SweepResult operator()(std::span<const double> numbers, const std::function<bool()>& interrupted) const;

 private:
  SweepFile sweep_;
  SweepBase base_;
  std::vector<SweepInput> inputs_;
  SweptRun fixed_;  ///< values of the axes with one point
};

/// Why a result has no numbers to be used, as text; empty if it has: the run finished, and all outputs are finite.
[[nodiscard]] std::string failure_of(const SweepResult& result);

}  // namespace talus::app
