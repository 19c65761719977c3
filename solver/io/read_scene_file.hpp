#pragma once

#include <filesystem>
#include <string_view>

#include "solver/io/scene/scene_file.hpp"

namespace talus {

/// Reads a scene from a deck of 1993 (.DAT) or otherwise from a TOML file. Errors: IoError if the file cannot be read;
/// InputError for invalid content, with file, line and field.
[[nodiscard]] SceneFile read_scene_file(const std::filesystem::path& file);

/// The same from the text of the file, for callers that need both: a pipe can be read only once.
[[nodiscard]] SceneFile read_scene_text(std::string_view text, const std::filesystem::path& file);

/// As read_scene_file, but returns only the scene.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);

}  // namespace talus
