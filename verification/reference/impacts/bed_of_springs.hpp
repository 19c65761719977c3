#pragma once

/// A circle that strikes a flat wall through springs and dashpots spread evenly along its outline: the limit of a nodal
/// contact in which each node represents its part of the outline.
///
/// With the overlap d (depth of the circle's lowest point below the wall), u = R - d and cos(a) = u/R, the outline at
/// the angle f from that point overlaps by R cos f - u. Per length of outline the force is k (overlap + t overlap'),
/// never attractive:
///   closing:  F = k [A(d) + t d' B(d)],    A = int_-a^a (R cos f - u) R df = 2 R (R sin a - u a),   B = A' = 2 R a
///   parting:  F = k A(d + t d')            (the outline still pushes where overlap + t d' > 0)
/// Undamped, U = int F dd = (k/2) int (R cos f - u)^2 R df = (k R/2) (R^2 (a + sin a cos a) - 4 R u sin a + 2 u^2 a).
namespace talus::verification::reference {

struct BedOfSprings {
  double radius{};      ///< R [L] > 0
  double stiffness{};   ///< k: stiffness per length of outline [F/L^2] > 0
  double relaxation{};  ///< t: ratio of dashpot to spring [T] >= 0
};

/// Force of the springs alone at an overlap [F], 0 <= depth < R.
[[nodiscard]] double bed_force(const BedOfSprings& bed, double depth);

/// Stored energy of the springs at an overlap [F L].
[[nodiscard]] double bed_energy(const BedOfSprings& bed, double depth);

struct BedImpact {
  double restitution{};    ///< separation speed over approach speed
  double largest_force{};  ///< [F]
};

/// Central impact at an approach speed [L/T] > 0 with an effective mass [M] > 0; integrated with a tight tolerance.
[[nodiscard]] BedImpact bed_impact(const BedOfSprings& bed, double effective_mass, double speed);

}  // namespace talus::verification::reference
