#pragma once

#include <string>

#include "solver/app/scene_request.hpp"
#include "solver/io/scene/scene_file.hpp"
#include "solver/python/script_document.hpp"

namespace talus::python {

/// The file of a scene of bodies. Errors: InputError, also for a shear cell.
[[nodiscard]] SceneFile read_scene_document(const TomlValue& document, const std::string& name);

/// A scene of bodies.
using ScriptScene = ScriptDocument<SceneFile, read_scene_document>;

/// The file of a scene with the changes that these options of `talus run` make. Errors: InputError naming the option.
[[nodiscard]] SceneFile with_method(const ScriptScene& scene, const app::MethodOptions& options);

}  // namespace talus::python
