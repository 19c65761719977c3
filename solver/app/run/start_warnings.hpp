#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// The warning for a step beyond its linear limit. `verdict`: the text of its StepVerdict; `command`: the command for
/// the same run by a method with step control.
[[nodiscard]] std::string step_warning(std::string_view verdict, std::string_view command);

/// Warnings about overlaps of contacts at a scene's start, and about moments of inertia that no mass within the outline
/// has, which are probably not intended.
[[nodiscard]] std::vector<std::string> start_warnings(const SceneFile& file, const Dynamics& dynamics);

/// Warning about bodies that overlap at a scene's start without a contact between them; none if its watch switches this
/// check off. A run gets the same warning from its monitor.
[[nodiscard]] std::vector<std::string> missing_contact_warnings(const Scene& scene, const Dynamics& dynamics);

/// Warnings about geometry of a fence that is probably not intended; none for other scenes.
[[nodiscard]] std::vector<std::string> geometry_warnings(const SceneFile& file);

}  // namespace talus::app
