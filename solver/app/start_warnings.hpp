#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// The warning of a step that is longer than its linear limit. `verdict`: the text of its StepVerdict; `command`: the
/// same run by a method that chooses its steps.
[[nodiscard]] std::string step_warning(std::string_view verdict, std::string_view command);

/// What is unlikely to be meant in the bodies of a scene at its start: overlaps in contacts.
[[nodiscard]] std::vector<std::string> start_warnings(const SceneFile& file, const Dynamics& dynamics);

/// What is unlikely to be meant in the geometry of a fence; nothing of other scenes.
[[nodiscard]] std::vector<std::string> geometry_warnings(const SceneFile& file);

}  // namespace talus::app
