#include "verification/study/program/compared_folders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace talus::verification::problems {

std::set<std::string> files_of(const TemporaryFolder& folder, const std::string& out) {
  std::set<std::string> files;
  const std::filesystem::path whole = folder.path() / out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{whole})
    if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(whole).string());
  return files;
}

double different_files(const TemporaryFolder& folder, const std::string& one, const std::string& other,
                       const std::set<std::string>& allowed) {
  std::set<std::string> files = files_of(folder, one), others = files_of(folder, other);
  for (const std::string& file : allowed)
    files.erase(file), others.erase(file);
  if (others != files) return 1.0;
  return static_cast<double>(std::ranges::count_if(files, [&](const std::string& file) {
    return folder.read(fmt::format("{}/{}", one, file)) != folder.read(fmt::format("{}/{}", other, file));
  }));
}

}  // namespace talus::verification::problems
