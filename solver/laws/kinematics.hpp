#pragma once

#include <limits>
#include <string_view>

#include "solver/state/mode.hpp"

namespace talus {

/// What a one-dimensional law sees of its surroundings: how far it is stretched or pressed, and how fast.
/// A contact passes its overlap (`depth`, > 0 when the surfaces interpenetrate), a cable its elongation (> 0 when
/// taut).
struct Kinematics {
  double deformation{};       ///< overlap or elongation [L]
  double deformation_rate{};  ///< its rate [L/T]; > 0 while the contact closes or the cable lengthens
};

/// The force of a law, split by what becomes of its work: `elastic` can be had back, `dissipative` cannot.
struct LawForce {
  double elastic{};      ///< [F]; > 0 pushes the surfaces of a contact apart, pulls the ends of a cable together
  double dissipative{};  ///< [F]; same sign

  constexpr double total() const { return elastic + dissipative; }
};

/// The stiffest linear piece of a law while it acts: what step limits are made of.
struct Tangent {
  double stiffness{};  ///< [F/L]
  double damping{};    ///< [F T/L]
};

/// What a law is in one mode where that is a straight line and the rate has no part in it:
///
///   F = stiffness (deformation - natural), nothing lost,   and the mode lasts while low < deformation < high
///
/// It may last beyond: the law's own guard decides there. As it stands, an empty range: the mode has no such line.
struct LinearBranch {
  double stiffness{};                                     ///< [F/L]
  double natural{};                                       ///< deformation without force [L]
  double low{std::numeric_limits<double>::infinity()};    ///< [L]
  double high{-std::numeric_limits<double>::infinity()};  ///< [L]
};

/// The parameter of a contact law that sets the restitution of its impacts.
struct RestitutionField {
  std::string_view name;     ///< among the law's fields()
  std::string_view meaning;  ///< how the restitution follows from it, in words
};

/// A point of a yield force that grows with the plastic stretch.
struct YieldPoint {
  double stretch{};  ///< [L]
  double force{};    ///< [F]
  friend constexpr bool operator==(const YieldPoint&, const YieldPoint&) = default;
};

/// What follows when a mode ends.
struct Reset {
  Mode mode{};        ///< the mode to go on with; the present one again if the kinematics say so
  double released{};  ///< stored energy that the bodies never get back through this change [F L]
};

}  // namespace talus
