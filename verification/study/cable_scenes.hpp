#pragma once

#include <vector>

#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"
#include "verification/reference/hanger_break.hpp"

/// Scenes of the case `cables`: masses on one line with cables between them.
namespace talus::verification::problems {

/// Length of every cable when it is just taut.
inline constexpr double cable_length = 8.0;

/// A mass that slides along x on a cable from the origin, just taut at the start, thrown outward with this speed;
/// `gravity` along x. Body "mass", cable "cable".
[[nodiscard]] Scene thrown_mass(const CableLaw& law, double mass, double speed, double gravity = 0.0);

/// The pair of the reference, masses "b" and "c" at rest lengths, cables "one" and "two", hanger "hanger" on b.
[[nodiscard]] Scene hung_pair(const reference::HungPair& pair, double strength);

/// The same after the break: one cable of the two in a row, b free.
[[nodiscard]] Scene parted_pair_scene(const reference::HungPair& pair, const State& at_break);

/// A run until its time is up, or until the first cable, having pulled, is slack or broken.
struct CableSpan {
  State end;
  std::vector<double> time, elongation, tension;  ///< of the first cable, every step, if it is watched
  std::vector<double> second_tension;             ///< of the second, if there is one
  double closure{};                               ///< of the energy at the end
  bool hanger_broken{};                           ///< at the end
};

struct CableRunPlan {
  double step{}, end{};
  bool until_slack{true};
  bool watched{false};
};

[[nodiscard]] CableSpan run_cables(const Scene& scene, const State& start, const Integrator& method,
                                   const CableRunPlan& plan, Findings& findings);

/// Work booked under one mechanism.
[[nodiscard]] double booked(const State& state, Mechanism mechanism);

}  // namespace talus::verification::problems
