#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "verification/record/whole_file.hpp"

namespace talus {

using records::remove_remains;

/// As records::write_whole(): the file appears whole or not at all. Errors: IoError
/// "out/history.csv: No space left on device"; a former content of the file is then still there.
enum class Durability { now, later };
void write_whole(const std::filesystem::path& file, std::string_view content, Durability durability = Durability::now);

/// Brings to the disk all that was written in the file system of a folder. Errors: IoError with the system's reason.
void sync_folder(const std::filesystem::path& folder);

/// Removes the files of a folder for whose names `of` holds. What cannot be removed stays.
void remove_files(const std::filesystem::path& folder, const std::function<bool(std::string_view)>& of);

/// Makes a folder and those above it. Errors: IoError with the system's reason.
void make_folder(const std::filesystem::path& folder);

}  // namespace talus
