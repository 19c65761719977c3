#pragma once

#include "solver/granular/disc_method.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus {

/// Contact of two discs by a latching spring, with its method and step. Nothing else affects their restitution: not the
/// speed, and the masses only through the effective mass.
struct SteppedContact {
  double stiffness{};       ///< K1 [F/L] > 0
  double effective_mass{};  ///< [M] > 0
  double step{};            ///< [T] > 0
  DiscMethod method;

  /// w1 h, w1 = sqrt(K1/m_eff): the phase angle of one step while the contact is loaded [rad].
  double loading_angle() const;
  /// Steps in a contact: (pi/2) (1/w1 + 1/w2) over the step (Walton & Braun 1986).
  double steps_in_contact(double ratio) const;
};

/// Restitution of an impact in steps, to leading order: sqrt(K1/K2) exp[c pi (w1 + w2) h] with the method's
/// amplitude_growth_rate c. Ratio: K1/K2 in (0, 1].
[[nodiscard]] double stepped_restitution(const SteppedContact& contact, double ratio);

/// Minimum restitution by that formula: c pi w1 h exp(1 + c pi w1 h). The stiffer K2, the more a step of euler or
/// taylor gains during unloading. For the leapfrog methods w1 h/2: below, w2 h > 2 and the contact does not rebound.
[[nodiscard]] double minimum_restitution(const SteppedContact& contact);

/// K1/K2 that gives a restitution by that formula, the larger of the two solutions. Errors: InputError with the range,
/// for e outside it or outside (0, 1].
[[nodiscard]] double ratio_by_formula(const SteppedContact& contact, double restitution);

/// Restitution of two discs that meet head on, simulated by the disc engine with evenly spread phases of the step at
/// which they first touch.
struct SimulatedRestitution {
  double mean{};
  double deviation{};  ///< standard deviation of one phase
};
[[nodiscard]] SimulatedRestitution simulated_restitution(const SteppedContact& contact, double ratio, int phases = 200);

/// K1/K2 whose simulated restitution has the given mean. Errors: as ratio_by_formula(), and if the simulated
/// restitution does not fall that far.
[[nodiscard]] double ratio_by_simulation(const SteppedContact& contact, double restitution);

}  // namespace talus
