#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "verification/record/whole_file.hpp"

namespace talus {

using records::remove_remains;

/// As records::write_whole(): the file appears complete or not at all. Errors: IoError
/// "out/history.csv: No space left on device"; the file then has its previous content.
/// Durability is a separate type: an argument of records::Durability would make calls find records::write_whole(), too.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Flushes all data written in the file system of a folder to the disk. Errors: IoError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes the files of a folder whose names satisfy `of`. Files that cannot be removed remain.
void remove_files(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

/// Checks that files can be written into a folder, or that it can be created with its parent folders; creates nothing.
/// Errors: IoError that gives the folder, what was found in its place or above it, and what it must be.
void demand_writable_folder(const std::filesystem::path& folder);

/// Creates a folder and its parent folders. Errors: as demand_writable_folder().
void make_folder(const std::filesystem::path& folder);

/// Whether a path by which a file names another one remains in the folder of that file: relative, without "..".
[[nodiscard]] bool is_inside_folder(const std::filesystem::path& name);

/// Checks that a folder contains a file. `meaning`: such a folder, for the message. Errors: IoError
/// "out: found a folder without plot.json; it must be `meaning`", or what else was found.
void demand_folder_with(const std::filesystem::path& folder, std::string_view file, std::string_view meaning);

}  // namespace talus
