#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace talus {

/// Writes a file so that it appears whole or not at all: to a temporary file in the same folder, brought to the disk,
/// then renamed over `file`. With Durability::later what was written is brought to the disk by sync_folder(), together
/// with other files. A target that exists and is not a regular file (a pipe, a terminal) is written to
/// directly. Errors: IoError "out/history.csv: No space left on device"; what stood under the name before is then still
/// there.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Brings to the disk all that was written in a folder's file system. Errors: IoError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes the files of a folder for whose names `of` holds. What cannot be removed stays.
void remove_files(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

/// Removes what write_whole() left in a folder when its program was killed, of files for whose names
/// `of` holds.
void remove_remains(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

/// Makes a folder and those above it. Errors: IoError with the system's reason.
void make_folder(const std::filesystem::path& folder);

}  // namespace talus
