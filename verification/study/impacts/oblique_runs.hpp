#pragma once

#include "verification/check/case.hpp"
#include "verification/study/scenes/sliding_scenes.hpp"

/// Oblique impacts of the case `friction`, one for each phase of touch within a step.
namespace talus::verification::problems {

inline constexpr double oblique_friction = 0.3;

/// A disc with k = m = v_n = 1, its slip rate in units of mu v_n k/k_s; kappa = k_s/k.
[[nodiscard]] reference::ObliqueImpact oblique_disc(double kappa, double ratio);

/// Scene of an impact as given to the solver, with the setup's fault planted.
[[nodiscard]] Scene oblique_scene_of(const reference::ObliqueImpact& impact, const Setup& setup);

/// Moves the state back by t along the free motion before touch.
void go_back(State& state, double t);

/// Result of one impact with velocity Verlet.
struct ObliqueRun {
  State end;
  double slip_rate{};      ///< afterwards
  double balance_error{};  ///< energy balance error at the end
};

/// Runs the impact that touches at phase number `phase` of 64 equal parts of a step, with a separate step for each
/// phase (offset_step).
[[nodiscard]] ObliqueRun run_oblique(const Scene& scene, double contact_time, double count, std::size_t phase,
                                     Findings& findings);

/// Runs the impact with the given step.
[[nodiscard]] ObliqueRun run_oblique_at_step(const Scene& scene, double contact_time, double step, std::size_t phase,
                                             Findings& findings);

/// Kinetic energy of the disc of mass 1 [F L].
[[nodiscard]] double kinetic_energy(const State& end);

}  // namespace talus::verification::problems
