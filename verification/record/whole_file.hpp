#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace talus::records {

/// The content of a file, pipe or device. FileError if it cannot be read, or has more than 4 GiB (a pipe or device: 1
/// GiB).
[[nodiscard]] std::string read_whole(const std::filesystem::path& file);

/// Writes a file atomically: to a temporary file in the same folder, which is flushed to disk and then renamed to
/// `file`. An existing target that is not a regular file (a pipe, a terminal) is written directly. FileError
/// "out/history.csv: No space left on device"; the previous content of `file` is then unchanged. Threads may write
/// different files at the same time. With Durability::later, sync_folder() flushes the file to disk, together with
/// others.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Flushes to disk everything written in the file system of a folder. FileError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes temporary files that write_whole() left in a folder when its process was killed, if `of` is true for the
/// name of their target file. Files that cannot be removed are ignored.
void remove_remains(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

}  // namespace talus::records
