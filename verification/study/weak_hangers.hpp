#pragma once

#include <vector>

#include "solver/run/failure_log.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/state/state.hpp"

/// The fence of Table 2 with hangers that may break, run as it would be today: one resultant a contact, clamped, and
/// velocity Verlet.
namespace talus::verification::problems {

/// Where the energy is at one time [lb ft].
struct EnergySample {
  double time{};     ///< [s]
  double rock{};     ///< kinetic, of the rock
  double fence{};    ///< kinetic, of the columns
  double held{};     ///< stored in cables and contacts, and of weights since the start
  double lost{};     ///< by contacts and cables
  double hangers{};  ///< lost by hangers that broke
};

struct WeakFenceRun {
  scenes::FenceScene made;
  State end;
  std::vector<Failure> failures;
  double closure{};              ///< of the energy ledger at the end [lb ft]
  double scale{};                ///< largest energy of the run [lb ft]
  double hanger_loss{};          ///< [lb ft]
  double largest_joint_force{};  ///< at the central column's hanger while it holds [lb]
  std::vector<EnergySample> history;
  long evaluations{};
};

/// Fence of table_2.DAT: 600 lb, yc 0, bottom cable with .5 ft slack.
[[nodiscard]] scenes::Fence weak_fence(double hanger_strength);

/// Runs it to `end` [s] in steps of `step` [s]; a sample of the energies every `every` steps, if > 0.
[[nodiscard]] WeakFenceRun run_weak_fence(const scenes::Fence& fence, double step, double end, long every = 0);

}  // namespace talus::verification::problems
