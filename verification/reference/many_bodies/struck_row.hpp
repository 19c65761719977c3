#pragma once

#include <array>
#include <vector>

/// Exact motion of three equal discs in a row, the first thrown against the second (undamped linear contacts).
///
/// With u = (x_1, x_2, x_3 + gap), shifted so that the contact overlaps are d_1 = u_1 - u_2, d_2 = u_2 - u_3, the
/// motion while a set of contacts is closed is a sum of modes, shape times (a + b t) or (a cos w t + b/w sin w t):
///   none       (1,0,0), (0,1,0), (0,0,1) free
///   first      (1,1,0), (0,0,1) free;      (1,-1,0) at w^2 = 2k/m        (second: the mirror image)
///   both       (1,1,1) free;  (1,0,-1) at w^2 = k/m;  (1,-2,1) at w^2 = 3k/m
/// The shapes are orthogonal, so amplitudes are projections. A segment ends where d_1 or d_2 changes sign; the change
/// is bracketed on a grid of a fiftieth of the shortest period, bisected, and refined by Newton's method to 50 digits.
/// Rigid balls would only pass on the speed: (0, 0, v). Soft discs in contact do not, because both contacts act at
/// once.
namespace talus::verification::reference {

struct StruckRow {
  double mass{};       ///< m of each disc [M] > 0
  double stiffness{};  ///< k of each contact [F/L] > 0
  double speed{};      ///< of the first disc at touch, t = 0 [L/T] > 0
  double gap{};        ///< between second and third [L] >= 0
};

struct RowState {
  std::array<double, 3> position{};  ///< displacement of each disc since t = 0 [L]
  std::array<double, 3> velocity{};  ///< [L/T]
};

/// Outcome when no further contact will occur.
struct RowRebound {
  std::array<double, 3> velocity{};  ///< final velocities [L/T]
  double end_time{};                 ///< end of the last contact [T]
  struct Change {
    double time{};                 ///< [T]
    std::array<bool, 2> closed{};  ///< contacts that act from this time on
  };
  std::vector<Change> changes;  ///< from t = 0 on
};

/// Rebound and state of the row. std::invalid_argument outside the ranges above.
[[nodiscard]] RowRebound rebound(const StruckRow& row);
[[nodiscard]] RowState row_at(const StruckRow& row, double t);

}  // namespace talus::verification::reference
