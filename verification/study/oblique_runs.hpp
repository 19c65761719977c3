#pragma once

#include "verification/check/case.hpp"
#include "verification/study/sliding_scenes.hpp"

/// Oblique impacts of the case `friction`, one for each phase at which the surfaces can meet within a step.
namespace talus::verification::problems {

inline constexpr double oblique_friction = 0.3;

/// A disc with k = m = v_n = 1, its slip rate in units of mu v_n k/k_s; kappa = k_s/k.
[[nodiscard]] reference::ObliqueImpact oblique_disc(double kappa, double ratio);

/// The scene of an impact, with the setup's fault in it.
[[nodiscard]] Scene oblique_scene_told(const reference::ObliqueImpact& impact, const Setup& setup);

/// The free motion before the touch taken back by t.
void go_back(State& state, double t);

/// One impact by velocity Verlet.
struct ObliqueRun {
  State end;
  double slip_rate{};  ///< afterwards
  double closure{};    ///< of the energy at the end
};

/// The impact that touches at phase number `phase` of 64 even shares of a step, with a step of its own (offset_step).
[[nodiscard]] ObliqueRun run_oblique(const Scene& scene, double contact_time, double count, std::size_t phase,
                                     Findings& findings);

/// The same with a step of this length.
[[nodiscard]] ObliqueRun run_oblique_at_step(const Scene& scene, double contact_time, double step, std::size_t phase,
                                             Findings& findings);

/// Kinetic energy of the disc of mass 1 [F L].
[[nodiscard]] double kinetic_energy(const State& end);

}  // namespace talus::verification::problems
