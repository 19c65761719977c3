#pragma once

/// A circle that strikes a flat wall through springs and dashpots spread evenly along its outline: what a contact by
/// nodes tends to when each node has its share of the outline.
///
/// With the depth d of the circle's lowest point below the wall, u = R - d and cos(a) = u/R, the outline at the angle f
/// from that point is R cos f - u deep, and per length of outline pushes by k (depth + t depth'), never pulling:
///   closing:  F = k [A(d) + t d' B(d)],    A = int_-a^a (R cos f - u) R df = 2 R (R sin a - u a),   B = A' = 2 R a
///   parting:  F = k A(d + t d')            (where depth + t d' > 0 the outline still pushes)
/// U = int F dd = (k/2) int (R cos f - u)^2 R df = (k R/2) (R^2 (a + sin a cos a) - 4 R u sin a + 2 u^2 a) undamped.
namespace talus::verification::reference {

struct BedOfSprings {
  double radius{};      ///< R [L] > 0
  double stiffness{};   ///< k: of a length of outline [F/L^2] > 0
  double relaxation{};  ///< t: dashpot over spring [T] >= 0
};

/// Force of the springs alone at a depth [F], 0 <= depth < R.
[[nodiscard]] double bed_force(const BedOfSprings& bed, double depth);

/// What the springs hold at a depth [F L].
[[nodiscard]] double bed_energy(const BedOfSprings& bed, double depth);

struct BedImpact {
  double restitution{};    ///< speed of parting over that of approach
  double largest_force{};  ///< [F]
};

/// A central impact at that speed [L/T] > 0 of two bodies with that effective mass [M] > 0; tight integration.
[[nodiscard]] BedImpact bed_impact(const BedOfSprings& bed, double effective_mass, double speed);

}  // namespace talus::verification::reference
