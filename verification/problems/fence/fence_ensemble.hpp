#pragma once

#include "verification/problems/fence/fence_impact.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

/// Runs of the rows of Tables 2 and 3, each with its twins: the same fence with small changes of settings that the
/// report does not state. The motion is chaotic, so that a printed number can only be compared with the spread of the
/// twins.
namespace talus::verification::problems {

/// A change of settings that the report does not state.
struct FenceShift {
  std::string name;
  double spin{};     ///< added to the rock's angular velocity [rad/s]
  double height{};   ///< added to the rock's height [ft]
  double angle{};    ///< added to the rock's orientation, which turns its 12 nodes [rad]
  double step{1.0};  ///< factor of the time step
};

/// omega0 +-2 rad/s, yc +-0.02 ft, nodes turned by a quarter, a half and three quarters of their spacing of 30 degrees,
/// step halved and doubled.
[[nodiscard]] std::vector<FenceShift> declared_shifts();

/// A printed quantity and the member of FenceSample that corresponds to it.
struct FenceQuantity {
  std::string name;
  std::string unit;
  double FenceSample::*ours;
  std::optional<PrintedNumber> (*printed)(const PrintedRow&);
  bool relative;  ///< distances are in percent of the printed value, otherwise in `unit`

  /// Difference `value` - `print`, in percent or in `unit`.
  [[nodiscard]] double distance(double value, double print) const {
    return relative ? 100.0 * (value / print - 1.0) : value - print;
  }
  [[nodiscard]] std::string distance_unit() const { return relative ? "%" : unit; }
};

/// Joint force, top cable force, bottom cable force, and speed of the rock after the impact.
[[nodiscard]] const std::vector<FenceQuantity>& fence_quantities();

/// One row with its runs.
struct RowRun {
  PrintedRow printed;
  FenceRun run;
  std::vector<FenceSample> twins;  ///< peaks of the shifted runs; empty if they were not run

  /// Minimum and maximum of a quantity over the run and its twins.
  [[nodiscard]] double low(const FenceQuantity& quantity) const;
  [[nodiscard]] double high(const FenceQuantity& quantity) const;
  /// True if the printed number, within half a unit of its last digit, lies between them.
  [[nodiscard]] bool inside(const FenceQuantity& quantity) const;
};

/// Runs all rows at the report's step times `coarsening`. The full tier runs the twins of all rows, the quick tier
/// those of the elastic rows with yc = 0 and the bottom cable, coarse setups none.
[[nodiscard]] std::vector<RowRun> run_rows(const Setup& setup, double coarsening);

/// The fence of a row with the faults of `setup`: `mass_doubled`, `limits_ignored`, `height_downwards`,
/// `bottom_wrapped_once`.
[[nodiscard]] scenes::Fence fence_of(const PrintedRow& row, const Setup& setup);

/// Distances over a group of rows.
struct FenceDistance {
  double mean{};   ///< mean |distance| of run and print
  double twins{};  ///< mean |distance| of run and twin, over rows and twins; NaN without twins
  int inside{};    ///< printed numbers inside the spread, of those with twins
  int spread{};    ///< printed numbers with twins
  int count{};     ///< printed numbers
};

/// Distances of the rows with or without bottom cable.
[[nodiscard]] FenceDistance distance_of(const std::vector<RowRun>& rows, const FenceQuantity& quantity,
                                        bool bottom_cable);

}  // namespace talus::verification::problems
