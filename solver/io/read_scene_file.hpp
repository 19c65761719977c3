#pragma once

#include <filesystem>

#include "solver/io/scene/scene_file.hpp"

namespace talus {

/// Reads a scene from a deck of 1993 (.DAT) or else from a TOML file. Errors: IoError if the file cannot be read;
/// InputError for everything in it that is wrong, with file, line and field.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& file);

/// The scene alone.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

}  // namespace talus
