#include "solver/io/file/atomic_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "solver/base/error.hpp"
#include "verification/record/error.hpp"

namespace talus {

namespace fs = std::filesystem;

namespace {

/// `above`: the folder in which it would be; empty if it is not known.
IoError not_created(const fs::path& folder, const fs::path& above, std::string_view reason) {
  return IoError{fmt::format("{}: it cannot be created{} ({}); it must be a writable folder, or a new one",
                             folder.string(), above.empty() ? "" : fmt::format(" in '{}'", above.string()), reason)};
}

}  // namespace

void write_whole(const fs::path& file, std::string_view content, Durability durability) {
  try {
    const bool now = durability == Durability::now;
    records::write_whole(file, content, now ? records::Durability::now : records::Durability::later);
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  }
}

void sync_folder(const fs::path& folder) {
  try {
    records::sync_folder(folder);
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  }
}

void remove_files(const fs::path& folder, const std::function<bool(std::string_view)>& of) {
  std::error_code none;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, none})
    if (of(entry.path().filename().string())) found.push_back(entry.path());
  for (const fs::path& file : found)
    fs::remove(file, none);
}

bool is_inside_folder(const fs::path& name) {
  return name.has_filename() && name.is_relative() && std::ranges::find(name, fs::path{".."}) == name.end();
}

void demand_writable_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error);
  // The folder itself, or the nearest one above it.
  fs::path found = whole;
  while (!error && found.has_relative_path() && fs::status(found, error).type() == fs::file_type::not_found) {
    error.clear();
    found = found.parent_path();
  }
  if (error) throw not_created(folder, {}, error.message());
  const bool is_there = found == whole;
  if (!fs::is_directory(found)) {
    if (is_there) throw IoError{fmt::format("{}: found a file; it must be a folder, or a new one", folder.string())};
    throw IoError{fmt::format("{}: found the file '{}' above it; only a folder can contain a folder", folder.string(),
                              found.string())};
  }
  if (::access(found.c_str(), W_OK | X_OK) == 0) return;
  const char* const reason = std::strerror(errno);
  if (!is_there) throw not_created(folder, found, reason);
  throw IoError{
      fmt::format("{}: found a folder that cannot be written ({}); it must be a writable folder, or a new one",
                  folder.string(), reason)};
}

void make_folder(const fs::path& folder) {
  demand_writable_folder(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw not_created(folder, {}, error.message());
}

void demand_folder_with(const fs::path& folder, std::string_view file, std::string_view meaning) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  const auto refuse = [&](std::string_view found) {
    throw IoError{fmt::format("{}: found {}; it must be {}", folder.string(), found, meaning)};
  };
  if (status.type() == fs::file_type::not_found) refuse("no folder of this name");
  if (error) refuse(fmt::format("a folder that cannot be read ({})", error.message()));
  if (!fs::is_directory(status)) refuse("a file");
  const bool is_there = fs::exists(folder / file, error);
  if (error) refuse(fmt::format("a folder that cannot be read ({})", error.message()));
  if (!is_there) refuse(fmt::format("a folder without {}", file));
}

}  // namespace talus
