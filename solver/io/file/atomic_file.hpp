#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "verification/record/whole_file.hpp"

namespace talus {

using records::remove_remains;

/// As records::write_whole(): the file appears complete or not at all. Errors: IoError
/// "out/history.csv: No space left on device"; the file then has its previous content.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Flushes all data written in the file system of a folder to the disk. Errors: IoError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes the files of a folder whose names satisfy `of`. Files that cannot be removed remain.
void remove_files(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

/// Creates a folder and its parent folders. Errors: IoError with the system's reason.
void make_folder(const std::filesystem::path& folder);

}  // namespace talus
