#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/cell/shear_cell.hpp"

namespace talus {

/// How discs interact across the borders of a periodic field.
enum class Images {
  nearest,        ///< nearest image of each pair, from a neighbour list
  virtual_discs,  ///< as in 1989, over all pairs (VirtualDiscs): slow, for checking
};
template <>
struct Names<Images> {
  static constexpr std::array<std::string_view, 2> list{"nearest", "virtual"};
};

/// Plan of a cell's run. The names of CNTRL.DAT are given with the members. Times [T].
struct CellPlan {
  /// Maximum number of discs for which all pairs are tested at each step.
  static constexpr std::size_t maximum_virtual = 2000;

  std::string integrator{"central_difference"};
  double step{};      ///< STEP > 0
  double every{};     ///< LOOP: interval between outputs; >= step
  double end{};       ///< TIME: duration of the run; >= every
  bool historical{};  ///< imitates a run of 1989: steps that change the restitution are allowed
  bool jump{};        ///< whether time in which nothing can touch is passed at once
  Images images{};

  /// Rounding allowance of summed steps, as a fraction of a LOOP.
  static constexpr double round_off = 1e-12;
  /// Number of LOOPs in the run; the last may be incomplete.
  double outputs() const { return std::ceil(end / every * (1.0 - round_off)); }

  static constexpr std::array<Field<CellPlan>, 3> fields() {
    return {{{"step", dimension::time, &CellPlan::step, Range::positive, "step STEP"},
             {"every", dimension::time, &CellPlan::every, Range::positive, "time LOOP between outputs"},
             {"end", dimension::time, &CellPlan::end, Range::positive, "time TIME that the run takes"}}};
  }
};

/// All errors that prevent a cell from being run with this plan. A leapfrog requires 10 steps in a contact, with laws
/// that are stiffer than while they load a step of at most 1/w2, w2 = sqrt(2 K2/m), and with friction one of at most
/// 1/w_s, w_s = sqrt(6 k_s/m). Euler and Taylor may change
/// the restitution by 0.05, in a historical run by any amount. This change is known only for the law of 1989: other
/// laws and friction require leapfrogs.
[[nodiscard]] std::vector<CellError> validation_errors(const ShearCell& cell, const CellPlan& plan);

}  // namespace talus
