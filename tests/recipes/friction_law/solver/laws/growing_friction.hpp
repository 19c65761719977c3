#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/kinematics.hpp"

namespace talus {

/// Friction with a tangential stiffness in proportion to the overlap d, as of a cone on a plane: the radius of its
/// contact area is. As by Mindlin, new area carries no force yet, and area that is lost takes its force along:
///
///   sticking   k_s = g d,   ds/dt = u - s max(dk_s/dt, 0)/k_s,   F = k_s s + c_s (d/d_r)^(1/2) u
///   slipping, open          as CoulombFriction, with this k_s
///
/// With constant speeds k_s grows as t, and s is half of the slip since touch.
struct GrowingFriction {
  static constexpr std::string_view name = "growing";
  static constexpr std::size_t memory_size = 2;  ///< stretch [L], and k_s at the last update of the modes [F/L]
  static constexpr double onset = 0.5;           ///< stretch at the first evaluation over the slip since touch
  static constexpr std::string_view stiffness_rule = "shear_gradient times the overlap";

  double coefficient{};        ///< mu >= 0
  double gradient{};           ///< g [F/L^2] > 0
  double reference_overlap{};  ///< d_r [L] > 0, of the contact's law
  double damping{};            ///< c_s [F T/L] >= 0: dashpot of sticking friction at the reference overlap

  static constexpr std::array<Field<GrowingFriction>, 4> fields() {
    return {{{"friction", dimension::number, &GrowingFriction::coefficient, Range::non_negative,
              "coefficient of Coulomb friction"},
             {"shear_gradient", dimension::stiffness / dimension::length, &GrowingFriction::gradient, Range::positive,
              "tangential stiffness for each unit of overlap"},
             {"reference_overlap", dimension::length, &GrowingFriction::reference_overlap, Range::positive,
              "overlap at which the dashpot is stated"},
             {"shear_damping", dimension::damping, &GrowingFriction::damping, Range::non_negative,
              "tangential dashpot of friction that sticks, at the reference overlap"}}};
  }

  double stiffness(double overlap) const { return gradient * std::max(overlap, 0.0); }
  CoulombFriction at(double overlap) const {
    return {coefficient, stiffness(overlap), damping * std::sqrt(std::max(overlap, 0.0) / reference_overlap)};
  }
  /// Spring, dashpot and slider at the reference overlap; larger overlaps are stiffer.
  CoulombFriction stiffest() const { return at(reference_overlap); }
  double stretch_rate(double stretch, double slip_rate, Kinematics x) const {
    if (!(x.deformation > 0.0 && x.deformation_rate > 0.0)) return slip_rate;
    return slip_rate - stretch * x.deformation_rate / x.deformation;
  }
  /// Exact: while approaching, s d has the rate u d.
  double stretch_after(double stretch, double slip_rate, Kinematics x, double h) const {
    const double half = 0.5 * h * x.deformation_rate;
    const double before = std::max(x.deformation - half, 0.0), after = x.deformation + half;
    if (!(x.deformation_rate > 0.0 && after > 0.0)) return stretch + h * slip_rate;
    return (stretch * before + 0.5 * h * slip_rate * (before + after)) / after;
  }
  double area_power(double stretch, Kinematics x) const {
    if (!(x.deformation > 0.0)) return 0.0;
    return 0.5 * gradient * std::abs(x.deformation_rate) * stretch * stretch;
  }

  friend constexpr bool operator==(const GrowingFriction&, const GrowingFriction&) = default;
};

}  // namespace talus
