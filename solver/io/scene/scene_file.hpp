#pragma once

#include <optional>

#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// A fence as its file describes it, and what was made of it.
struct FenceInput {
  scenes::Fence fence;
  scenes::FenceScene made;
};

/// What a scene's file holds.
struct SceneFile {
  Scene scene;
  std::optional<FenceInput> fence{};  ///< if the scene is a fence
};

}  // namespace talus
