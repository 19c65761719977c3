#include "solver/io/file/atomic_file.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "solver/base/error.hpp"
#include "verification/record/error.hpp"

namespace talus {

namespace fs = std::filesystem;

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

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError{fmt::format("{}: {}", folder.string(), error.message())};
}

}  // namespace talus
