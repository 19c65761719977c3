#pragma once

#include "solver/granular/disc_method.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus {

/// A contact of two discs by a latching spring, as it is stepped. Nothing else enters their restitution: not their
/// speed, and of their masses only the effective one.
struct SteppedContact {
  double stiffness{};       ///< K1 [F/L] > 0
  double effective_mass{};  ///< [M] > 0
  double step{};            ///< [T] > 0
  DiscMethod method;

  /// w1 h, w1 = sqrt(K1/m_eff): the angle by which a step swings the contact while it is pressed.
  double loading_angle() const;
  /// (pi/2) (1/w1 + 1/w2) over the step (Walton & Braun 1986).
  double steps_in_contact(double ratio) const;
};

/// Restitution of stepped impacts by their leading terms: sqrt(K1/K2) exp[c pi (w1 + w2) h] with the method's
/// amplitude_growth_rate c. Ratio: K1/K2 in (0, 1].
[[nodiscard]] double stepped_restitution(const SteppedContact& contact, double ratio);

/// Least restitution by that formula: c pi w1 h exp(1 + c pi w1 h). The stiffer K2, the more a step of euler or taylor
/// gains in it. For the leapfrog methods w1 h/2: below, w2 h > 2 and nothing swings back.
[[nodiscard]] double least_restitution(const SteppedContact& contact);

/// K1/K2 that gives a restitution by that formula, the larger of the two. Errors: InputError with the range, for e
/// outside of it or of (0, 1].
[[nodiscard]] double ratio_by_formula(const SteppedContact& contact, double restitution);

/// Restitution of two discs that meet head on, simulated by the disc engine: over so many phases of the step at which
/// they touch, evenly spread.
struct SimulatedRestitution {
  double mean{};
  double deviation{};  ///< standard, of one phase
};
[[nodiscard]] SimulatedRestitution simulated_restitution(const SteppedContact& contact, double ratio, int phases = 200);

/// K1/K2 of which the simulated restitution has that mean. Errors: as ratio_by_formula(), and where the simulation does
/// not come down to it.
[[nodiscard]] double ratio_by_simulation(const SteppedContact& contact, double restitution);

}  // namespace talus
