#pragma once

#include "verification/check/case.hpp"
#include "verification/reference/stepped_latch.hpp"

/// Two equal discs that meet head on through latching springs in the engine of discs, and what they keep of their speed
/// over the phases of a step. Mass 1, K1 = 1/2: the frequency of loading is 1.
namespace talus::verification::problems {

struct Meeting {
  double ratio{};  ///< K1/K2
  double step{};   ///< [T]
  double phase{};  ///< share of a step that passes before the touch
  const char* method{"velocity_verlet"};
  double speed{1.0};   ///< of approach [L/T]
  double radius{8.0};  ///< [L]
};

struct Parting {
  double restitution{};   ///< not a number if they do not part
  double contact_time{};  ///< until the force has gone [T]; of a method whose modes are those of the step's end
  double largest{};       ///< overlap [L]
  double residual{};      ///< overlap at which the force has gone [L]
};
[[nodiscard]] Parting parting(const Meeting& meeting, Findings& findings, const Setup& setup);

inline constexpr int latch_phases = 200;
/// Evenly spread over a step.
[[nodiscard]] double latch_phase(int i);

/// w1 h at so many steps in a contact.
[[nodiscard]] double latch_step(double steps_in_contact, double ratio);

/// What the phases do.
struct PhasesOfLatch {
  double mean{}, deviation{};       ///< of e
  double least{}, most{};           ///< of e
  PhaseError found{}, predicted{};  ///< of ln e, from the predicted mean
  double beyond{};                  ///< largest difference of ln e and the prediction for that impact
};
[[nodiscard]] PhasesOfLatch phases_of(const reference::SteppedLatch& latch, const char* method, Findings& findings,
                                      const Setup& setup);

}  // namespace talus::verification::problems
