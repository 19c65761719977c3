#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/cell/shear_cell.hpp"

namespace talus {

/// How discs act across the borders of a field that repeats itself.
enum class Images {
  nearest,        ///< of each pair the images that are nearest, from a list by cells
  virtual_discs,  ///< as in 1989, by all pairs (VirtualDiscs): slow, a check of the other
};
template <>
struct Names<Images> {
  static constexpr std::array<std::string_view, 2> list{"nearest", "virtual"};
};

/// How a cell is run; the names of CNTRL.DAT stand beside. Times [T].
struct CellPlan {
  /// Discs of which all pairs may be tried at each step.
  static constexpr std::size_t most_virtual = 2000;

  std::string integrator{"central_difference"};
  double step{};      ///< STEP > 0
  double every{};     ///< LOOP: what is written, is written so often; >= step
  double end{};       ///< TIME >= every: how long it runs
  bool historical{};  ///< a run as that of 1989 may have been: steps that change the restitution are not refused
  bool jump{};        ///< whether time in which nothing can touch is passed at once
  Images images{};

  /// Share of a LOOP that sums of steps may be off by.
  static constexpr double round_off = 1e-12;
  /// LOOPs in the run, of which the last may not be whole.
  double outputs() const { return std::ceil(end / every * (1.0 - round_off)); }

  static constexpr std::array<Field<CellPlan>, 3> fields() {
    return {{{"step", dimension::time, &CellPlan::step, Range::positive, "step STEP"},
             {"every", dimension::time, &CellPlan::every, Range::positive, "time LOOP between outputs"},
             {"end", dimension::time, &CellPlan::end, Range::positive, "time TIME that the run takes"}}};
  }
};

/// All that keeps a cell from being run so. A leapfrog needs 10 steps in a contact, and of a
/// latching spring one of at most 1/w2, w2 = sqrt(2 K2/m); Euler and Taylor may move the
/// restitution by .05, in a historical run by any amount, which is known of the law of 1989 alone: other laws and
/// friction go with leapfrogs.
[[nodiscard]] std::vector<CellError> validation_errors(const ShearCell& cell, const CellPlan& plan);

}  // namespace talus
