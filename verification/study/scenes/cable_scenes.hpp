#pragma once

#include <vector>

#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"
#include "verification/reference/cables/hanger_break.hpp"

/// Scenes of the case `cables`: masses on one line with cables between them.
namespace talus::verification::problems {

/// Length of every cable when it is just taut, without elongation.
inline constexpr double cable_length = 8.0;

/// A mass that slides along x on a cable from the origin, just taut at the start, thrown outward with `speed`;
/// `gravity` acts along x. Body "mass", cable "cable".
[[nodiscard]] Scene thrown_mass(const CableLaw& law, double mass, double speed, double gravity = 0.0);

/// The pair of the reference, with masses "b" and "c", cables "one" and "two" at their rest lengths, and hanger
/// "hanger" on b. With a `relaxation` [T] the cables have dashpots: their stiffness times this.
[[nodiscard]] Scene hung_pair(const reference::HungPair& pair, double strength, double relaxation = 0.0);

/// The pair after the break: the two cables joined into one between the origin and c, b free.
[[nodiscard]] Scene parted_pair_scene(const reference::HungPair& pair, const State& at_break, double relaxation = 0.0);

/// Result of a run up to its end time, or until the first cable, having been taut, is slack or broken.
struct CableRunResult {
  State end;
  std::vector<double> time, elongation, tension;  ///< of the first cable, every step, if `watched`
  std::vector<double> second_tension;             ///< of the second cable, if there is one
  double balance_error{};                         ///< energy balance error at the end
  bool hanger_broken{};                           ///< at the end
};

struct CableRunPlan {
  double step{}, end{};
  bool until_slack{true};
  bool watched{false};
};

[[nodiscard]] CableRunResult run_cables(const Scene& scene, const State& start, const Integrator& method,
                                        const CableRunPlan& plan, Findings& findings);

/// Work recorded for one mechanism.
[[nodiscard]] double recorded_work(const State& state, Mechanism mechanism);

}  // namespace talus::verification::problems
