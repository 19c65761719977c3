#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"

namespace talus {

/// End rule of a contact with a dashpot.
enum class EndRule {
  attractive,  ///< the law acts while the surfaces overlap; before they part its force is tensile (FENCE 1993, Eq. 17)
  clamped,     ///< zero-tension cut-off (LAMMPS `limit_damping`): the contact ends when the force falls to zero
};
template <>
struct Names<EndRule> {
  static constexpr std::array<std::string_view, 2> list{"attractive", "clamped"};
};

/// A spring and a dashpot in parallel that act in one direction only:
///
///   F = k s + c ds/dt   while acting,   0 otherwise,      s = deformation [L]
///
/// Modes and what ends them (a mode lasts while its guard is > 0):
///
///   open      guard -s             -> acting, unless the gap is just opening
///   acting    guard s              (attractive)  -> open
///             guard min(s, F/k)    (clamped)     -> released where s > 0, else open
///   released  guard min(s, -F/k)   (clamped)     -> acting where the force would push again, else open
///
/// In `released` the surfaces still overlap, but spring and dashpot together would pull, so the law does not act. The
/// energy of the spring is then not recoverable: the change into `released` counts k s^2/2 as released, and the change
/// back to `acting` counts it as stored again.
struct UnilateralSpring {
  enum : Mode { open, acting, released };

  double stiffness{};  ///< k [F/L] > 0
  double damping{};    ///< c [F T/L] >= 0
  EndRule end_rule{EndRule::clamped};

  static constexpr bool acts(Mode mode) { return mode == acting; }

  constexpr LawForce operator()(Kinematics x, Mode mode) const {
    if (mode != acting) return {};
    return {stiffness * x.deformation, damping * x.deformation_rate};
  }

  /// Recoverable energy of the spring in this mode [F L]; the elastic force is its derivative.
  constexpr double stored_energy(Kinematics x, Mode mode) const { return mode == acting ? energy(x) : 0.0; }

  /// Positive while the mode lasts.
  constexpr double guard(Kinematics x, Mode mode) const {
    if (mode == open) return -x.deformation;
    if (end_rule == EndRule::attractive) return x.deformation;
    return std::min(x.deformation, (mode == acting ? pull(x) : -pull(x)) / stiffness);
  }

  /// Linear branch of the law: in `open`, and in `acting` without a dashpot.
  constexpr LinearBranch linear_branch(Mode mode) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (mode == open) return {.low = -infinity, .high = 0.0};
    if (mode == acting && damping == 0.0) return {.stiffness = stiffness, .low = 0.0, .high = infinity};
    return {};
  }

  /// The mode that follows `mode` when its guard is no longer positive.
  constexpr Reset reset(Kinematics x, Mode mode) const {
    if (mode == open) return {x.deformation > 0.0 || x.deformation_rate >= 0.0 ? acting : open, 0.0};
    if (x.deformation == 0.0 && x.deformation_rate >= 0.0) return {acting, 0.0};
    if (x.deformation <= 0.0) return {open, 0.0};
    return mode == acting ? Reset{released, energy(x)} : Reset{acting, -energy(x)};
  }

 private:
  constexpr double pull(Kinematics x) const { return stiffness * x.deformation + damping * x.deformation_rate; }
  constexpr double energy(Kinematics x) const { return 0.5 * stiffness * x.deformation * x.deformation; }
};

}  // namespace talus
