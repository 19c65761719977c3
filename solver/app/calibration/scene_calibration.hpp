#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::app {

/// The damping or hysteresis of a contact of a scene that gives its first impact a restitution in (0, 1], by runs of
/// the scene: what `talus calibrate SCENE --json` prints, in SI units. Errors: InputError for an unknown contact, or a
/// restitution that no damping gives. `progress`: as of calibrate().
[[nodiscard]] nlohmann::ordered_json scene_calibration(const Scene& scene, const std::string& contact,
                                                       double restitution, const std::function<void()>& progress);

/// Executes `talus calibrate SCENE --contact NAME`. Returns the exit status. Errors: InputError naming the option.
[[nodiscard]] int calibrate_scene(const CalibrateOptions& options);

}  // namespace talus::app
