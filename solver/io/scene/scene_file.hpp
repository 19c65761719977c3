#pragma once

#include <optional>

#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// A fence as described by its file, and the scene built from it.
struct FenceInput {
  scenes::Fence fence;
  scenes::FenceScene made;
};

/// Content of a scene file.
struct SceneFile {
  Scene scene;
  std::optional<FenceInput> fence{};  ///< if the scene is a fence
};

}  // namespace talus
