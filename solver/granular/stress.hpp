#pragma once

#include <cstddef>

#include "solver/base/vec.hpp"
#include "solver/granular/discs.hpp"

namespace talus {

/// A mean flow along x, relative to which velocities of discs are measured: its velocity at y = 0 [L/T], and du/dy
/// [1/T].
struct MeanFlow {
  double speed{};
  double shear_rate{};
  double at(double y) const { return speed + shear_rate * y; }
};

/// The flow of the given shear rate that has the same momentum along x as the free discs.
[[nodiscard]] MeanFlow mean_flow(const DiscShapes& shapes, const Discs& discs, double shear_rate);

/// Granular temperature: kinetic energy of the free discs relative to the flow, per disc [F L], which is m <c^2>/2, c
/// the velocity relative to the flow. (Both directions together; the theory's k_B T.) 0 without free discs.
[[nodiscard]] double temperature(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow);

/// Sums that give stress when divided by an area [F L]; pressure is positive.
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

/// Kinetic part of the stress: sum of m c c over the free discs, c the velocity relative to the flow.
[[nodiscard]] Virial kinetic_virial(const DiscShapes& shapes, const Discs& discs, const MeanFlow& flow);

/// Contact part of the stress: sum of (force on b) (from a to b) over the contacts of the last evaluation (Love 1927;
/// Irving & Kirkwood 1950). First index: the force; second: the line between the centres. The discs must be at the
/// positions of that evaluation, as between a kick and the drift.
struct ContactSums {
  Virial virial;
  double stored{};         ///< energy in the contacts [F L]
  double largest_depth{};  ///< largest overlap [L]
  std::size_t contacts{};  ///< number of contacts whose force is not 0
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
