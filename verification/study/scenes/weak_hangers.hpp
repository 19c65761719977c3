#pragma once

#include <vector>

#include "solver/run/failure_log.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/state/state.hpp"

/// The fence of Table 2 with hangers that may break, run with present options: one resultant per contact, clamped, and
/// velocity Verlet.
namespace talus::verification::problems {

/// Distribution of the energy at one time [lb ft].
struct EnergySample {
  double time{};     ///< [s]
  double rock{};     ///< kinetic energy of the rock
  double fence{};    ///< kinetic energy of the columns
  double held{};     ///< stored in cables and contacts, and potential energy of weights relative to the start
  double lost{};     ///< dissipated by contacts and cables
  double hangers{};  ///< lost by broken hangers
};

struct WeakFenceRun {
  scenes::FenceScene made;
  State end;
  std::vector<Failure> failures;
  double balance_error{};        ///< energy balance error at the end [lb ft]
  double scale{};                ///< largest energy of the run [lb ft]
  double hanger_loss{};          ///< [lb ft]
  double largest_joint_force{};  ///< at the central column's hanger while it is intact [lb]
  std::vector<EnergySample> history;
  long evaluations{};
};

/// Fence of table_2.DAT: 600 lb, yc 0, bottom cable with 0.5 ft slack.
[[nodiscard]] scenes::Fence weak_fence(double hanger_strength);

/// Runs the fence to `end` [s] with steps of `step` [s]; samples the energies every `every` steps, if > 0.
[[nodiscard]] WeakFenceRun run_weak_fence(const scenes::Fence& fence, double step, double end, long every = 0);

}  // namespace talus::verification::problems
