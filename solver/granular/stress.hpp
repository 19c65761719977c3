#pragma once

#include <cstddef>

#include "solver/base/vec.hpp"
#include "solver/granular/discs.hpp"

namespace talus {

/// A flow along x that discs are seen from: its velocity at y = 0 [L/T], and du/dy [1/T].
struct MeanFlow {
  double speed{};
  double shear_rate{};
  double at(double y) const { return speed + shear_rate * y; }
};

/// The flow of that shear rate which carries as much momentum along x as the free discs do.
[[nodiscard]] MeanFlow mean_flow(const DiscShapes& shapes, const Discs& discs, double shear_rate);

/// Granular temperature: the free discs' energy of motion relative to the flow, for each disc [F L], which is
/// m <c^2>/2, c the velocity relative to the flow. (Of two directions; the theory's k_B T.) 0 without free discs.
[[nodiscard]] double temperature(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow);

/// Sums that make stress once they are divided by an area [F L]; what presses outwards is positive.
struct Virial {
  double xx{}, xy{}, yx{}, yy{};

  void add(Vec2 a, Vec2 b) { xx += a.x * b.x, xy += a.x * b.y, yx += a.y * b.x, yy += a.y * b.y; }
  friend Virial operator+(const Virial& a, const Virial& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy};
  }
  friend Virial operator*(double s, const Virial& a) { return {s * a.xx, s * a.xy, s * a.yx, s * a.yy}; }
  /// Pressure times area [F L].
  double pressure() const { return 0.5 * (xx + yy); }
};

/// Sum of m c c over the free discs, c relative to the flow: what motion carries.
[[nodiscard]] Virial kinetic_virial(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow);

/// Sum of (force on b) (from a to b) over the contacts of the last evaluation: what forces carry (Love 1927; Irving &
/// Kirkwood 1950). First letter: the force, second: the line between the centres. Discs must stand where they stood at
/// that evaluation, as between a kick and the drift.
struct ContactSums {
  Virial virial;
  double stored{};         ///< energy in the contacts [F L]
  double largest_depth{};  ///< [L]
  std::size_t contacts{};  ///< whose force is not 0
};
template <class System>
[[nodiscard]] ContactSums contact_sums(const System& system, const Discs& discs) {
  ContactSums sums;
  system.for_each_contact(discs, [&](const auto& contact) {
    sums.stored += contact.stored;
    sums.largest_depth = contact.depth > sums.largest_depth ? contact.depth : sums.largest_depth;
    if (contact.force == 0.0) return;
    ++sums.contacts;
    sums.virial.add(contact.force_on_b(), contact.distance * contact.n_ab);
  });
  return sums;
}

}  // namespace talus
