#pragma once

#include <limits>
#include <string_view>

#include "solver/state/mode.hpp"

namespace talus {

/// Kinematic input of a one-dimensional law: the overlap of a contact (> 0 when the surfaces interpenetrate) or the
/// elongation of a cable (> 0 when taut), and its rate.
struct Kinematics {
  double deformation{};       ///< overlap or elongation [L]
  double deformation_rate{};  ///< its rate [L/T]; > 0 while the contact closes or the cable lengthens
};

/// The force of a law, split by its work: work of `elastic` is recoverable, work of `dissipative` is not.
struct LawForce {
  double elastic{};      ///< [F]; > 0 pushes the surfaces of a contact apart, pulls the ends of a cable together
  double dissipative{};  ///< [F]; same sign

  constexpr double total() const { return elastic + dissipative; }
};

/// Stiffness and damping of a law, by default of its stiffest branch; used for step limits.
struct Tangent {
  double stiffness{};  ///< [F/L]
  double damping{};    ///< [F T/L]
};

/// A law in a mode in which its force is linear in the deformation and independent of the rate:
///
///   F = stiffness (deformation - natural), no dissipation,   and the mode lasts while low < deformation < high
///
/// The stored energy is stiffness/2 (deformation - natural)^2, multiplied from left to right: a row of cables gets the
/// bits of the law.
/// The mode may last beyond this range; there the law's guard decides. The default range is empty: the mode has no such
/// linear branch.
struct LinearBranch {
  double stiffness{};                                     ///< [F/L]
  double natural{};                                       ///< deformation without force [L]
  double low{std::numeric_limits<double>::infinity()};    ///< [L]
  double high{-std::numeric_limits<double>::infinity()};  ///< [L]
};

/// The parameter of a contact law that sets the restitution of its impacts.
struct RestitutionField {
  std::string_view name;     ///< among the law's fields()
  std::string_view meaning;  ///< how the restitution follows from it (text)
  bool is_required{true};    ///< whether a scene must give it or the restitution
};

/// A point of the yield force as a function of the plastic stretch.
struct YieldPoint {
  double stretch{};  ///< [L]
  double force{};    ///< [F]
  friend constexpr bool operator==(const YieldPoint&, const YieldPoint&) = default;
};

/// Result of a reset, when a mode ends.
struct Reset {
  Mode mode{};        ///< the next mode; may be the present mode again
  double released{};  ///< stored energy that the mode change dissipates [F L]; < 0: it becomes recoverable again
};

}  // namespace talus
