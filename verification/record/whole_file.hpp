#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace talus::records {

/// The content of a file. FileError if it cannot be read.
[[nodiscard]] std::string read_whole(const std::filesystem::path& file);

/// Writes a file so that it appears whole or not at all: to a temporary file in the same folder, which is brought to
/// the disk and then renamed to `file`. A target that exists and is not a regular file (a pipe, a terminal) is written
/// directly. FileError "out/history.csv: No space left on device"; a former content of `file` is then still there.
/// Threads may write different files at the same time. With Durability::later sync_folder() brings the file to the
/// disk, together with others.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Brings to the disk all that was written in the file system of a folder. FileError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes the temporary files that write_whole() left in a folder when its program was killed, of target files for
/// whose names `of` holds. Files that cannot be removed stay.
void remove_remains(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

}  // namespace talus::records
