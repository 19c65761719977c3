#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "solver/scenes/fence_scene.hpp"

/// The deck sample2.DAT of the 1993 manual, run by the solver up to the printed states.
namespace talus::verification::problems {

inline constexpr std::array<long, 2> printed_steps{60, 120};

/// x, y, theta, vx, vy, omega of an element as the listing prints them: velocities at that time, coordinates half a
/// step later [ft, rad, s].
using ElementState = std::array<double, 6>;

/// A change of the deck or of the options of the historical fence.
struct Sample2Change {
  std::function<void(scenes::Fence&)> records{};    ///< of the deck and its options
  std::function<void(scenes::FenceScene&)> made{};  ///< of the scene made from them
};

struct Sample2Run {
  scenes::Fence fence;
  scenes::FenceScene made;
  std::string listing;                            ///< complete, with both states
  std::vector<std::vector<ElementState>> states;  ///< of each printed step, of each element
  long evaluations{};
};

/// Reads the deck and runs its first 120 steps.
[[nodiscard]] Sample2Run run_sample2(const Sample2Change& change = {});

}  // namespace talus::verification::problems
