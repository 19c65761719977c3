#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// Bounds of effective mass and frequency of a contact over all poses in which the bodies touch.
///
/// A body has the mobility (inverse effective mass) sum(g_i^2 / inertia_i) at a contact point C along the normal n,
/// with the derivatives g_i of n . p_WC with respect to its coordinates. For a free body that is 1/m + l^2/I with the
/// lever l = (C - centre of mass) x n, for a pinned one l^2/I with the lever about the pin, and 1/m for one that does
/// not turn. Where two convex outlines touch, the normal of the contact is normal to both, so l is the distance of a
/// normal line of the outline from the centre of mass or the pin: 0 for a circle about its centre of mass, at most the
/// larger half side for a rectangle. The effective mass lies between 1 over the sums of both largest and of both
/// smallest mobilities. Two free bodies reach both bounds.
struct ContactRange {
  ContactId contact{};
  double smallest_mass{};      ///< smallest effective mass [M]
  double largest_mass{};       ///< infinite if the contact can act where no motion of the bodies closes it [M]
  double highest_frequency{};  ///< sqrt(k/m) with the smallest effective mass [rad/T]
  double damping_ratio{};      ///< with the smallest effective mass
  double shortest_time{};      ///< of a contact with the smallest effective mass [T]
};

/// Ranges of all contacts of a model, in their order.
[[nodiscard]] std::vector<ContactRange> contact_ranges(const Dynamics& dynamics);

/// Duration of an impact on a contact law [T]; for a law that is not a one-sided linear spring, half the period of its
/// stiffest branch. Infinite for an infinite effective mass.
[[nodiscard]] double contact_time(const ContactLaw& law, double effective_mass);

/// Largest distance of a normal line of a convex outline from a point in body coordinates [L]; zero for ground and for
/// a body without an outline.
[[nodiscard]] double largest_lever(const Shape& shape, Vec2 point);

}  // namespace talus
