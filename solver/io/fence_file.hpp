#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/scenes/fence.hpp"

namespace talus {

/// File formats of a fence.
enum class FenceFormat {
  deck,  ///< input file of the 1993 program: .DAT
  toml,  ///< scene file with a table [fence]: .toml
};

/// Format given by a file's extension, in upper or lower case. Errors: InputError naming the known ones.
[[nodiscard]] FenceFormat fence_format(const std::filesystem::path& file);

/// Whether a file's extension is that of a deck.
[[nodiscard]] bool is_deck(const std::filesystem::path& file);

/// Reads a fence in the format of the file's extension. Errors: IoError; InputError, also for a scene file without a
/// table [fence].
[[nodiscard]] scenes::Fence read_fence(const std::filesystem::path& file);

/// A fence as text of the given format. Errors: InputError if the format cannot represent the fence.
[[nodiscard]] std::string fence_text(const scenes::Fence& fence, FenceFormat format);

}  // namespace talus
