#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_impact.hpp"
#include "verification/study/fence_table.hpp"

/// The rows of Tables 2 and 3 as runs, each with its twins: the same fence with settings that the report does not tell
/// moved a little. The motion is chaotic, so a printed number can only be compared with what the twins spread over.
namespace talus::verification::problems {

/// A change of what the report leaves open.
struct FenceShift {
  std::string name;
  double spin{};     ///< added to the rock's angular velocity [rad/s]
  double height{};   ///< added to the rock's height [ft]
  double angle{};    ///< added to the rock's orientation, which turns its 12 nodes [rad]
  double step{1.0};  ///< factor of the time step
};

/// omega0 +-2 rad/s, yc +-.02 ft, nodes turned by a quarter, a half and three quarters of their spacing of 30 degrees,
/// step halved and doubled.
[[nodiscard]] std::vector<FenceShift> declared_shifts();

/// A printed quantity, and where a run has it.
struct FenceQuantity {
  std::string name;
  std::string unit;
  double FenceSample::*ours;
  std::optional<PrintedNumber> (*printed)(const PrintedRow&);
  bool relative;  ///< distances are told in per cent of the print, else in `unit`

  /// Ours less the printed one, in per cent or in `unit`.
  [[nodiscard]] double distance(double value, double print) const {
    return relative ? 100.0 * (value / print - 1.0) : value - print;
  }
  [[nodiscard]] std::string distance_unit() const { return relative ? "%" : unit; }
};

/// Joint, top cable, bottom cable, speed of the rock after the impact.
[[nodiscard]] const std::vector<FenceQuantity>& fence_quantities();

/// One row, run.
struct RowRun {
  PrintedRow printed;
  FenceRun run;
  std::vector<FenceSample> twins;  ///< peaks of the shifted runs; empty if they were not run

  /// Least and largest value of a quantity over the run and its twins.
  [[nodiscard]] double low(const FenceQuantity& quantity) const;
  [[nodiscard]] double high(const FenceQuantity& quantity) const;
  /// Whether the printed number, give or take half a unit of its last digit, lies between them.
  [[nodiscard]] bool inside(const FenceQuantity& quantity) const;
};

/// All rows at the report's step times `coarsening`. The full tier runs the twins of all rows, the quick tier those of
/// the elastic rows with yc = 0 and the bottom cable; coarse setups none.
[[nodiscard]] std::vector<RowRun> run_rows(const Setup& setup, double coarsening);

/// A row's fence as `setup` has it: faults `mass_doubled`, `limits_ignored`, `height_downwards`,
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

/// Of the rows with or without bottom cable.
[[nodiscard]] FenceDistance distance_of(const std::vector<RowRun>& rows, const FenceQuantity& quantity,
                                        bool bottom_cable);

}  // namespace talus::verification::problems
