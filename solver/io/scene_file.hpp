#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

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

/// Reads a scene from a deck of 1993 (.DAT) or else from a TOML file. Errors: IoError if the file cannot be read;
/// InputError for everything in it that is wrong, with file, line and field.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& file);

/// The scene alone.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

}  // namespace talus
