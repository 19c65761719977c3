#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/stability/contact_range.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {

/// Maximum number of coordinates for which frequencies are evaluated: this many take 2 s; the time grows with the cube.
inline constexpr std::size_t maximum_checked_coordinates = 1000;

/// What is found in a scene before it is run.
struct SceneCheck {
  std::optional<StepAdvice> advice;  ///< empty for scenes of more coordinates than that
  /// Contacts whose effective mass can differ by more than 1 % from that in the position of the start, on the side of
  /// shorter contacts: first the one whose step is farthest beyond its limit, then the shortest contacts.
  std::vector<ContactRange> lighter;
  std::optional<StepLimit> limit;                                    ///< of the scene's method, if it is known
  double shortest_contact{std::numeric_limits<double>::infinity()};  ///< over all positions [T]; infinite without any
  std::vector<std::string> warnings;
  bool is_unusable{};  ///< `talus check` ends with exit status 7
};

/// Checks a scene. The Dynamics is that of the scene; `command`: the command of the same run by a method that chooses
/// its steps, for a warning.
[[nodiscard]] SceneCheck check_scene(const SceneFile& file, const Dynamics& dynamics, const std::string& command);

}  // namespace talus::app
