#include "reports/base/file.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>
#include <vector>

#include "reports/base/error.hpp"

namespace talus::reports {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view prefix = ".partial-";

/// Removes the folders left by killed processes.
void remove_abandoned(const fs::path& target) {
  std::error_code ignored;
  std::vector<fs::path> abandoned;
  for (const auto& entry : fs::directory_iterator(target, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    pid_t process = 0;
    const char* const end = name.data() + name.size();
    const auto [rest, failure] = std::from_chars(name.data() + prefix.size(), end, process);
    if (failure != std::errc{} || rest != end || process <= 0) continue;
    if (::kill(process, 0) != 0 && errno == ESRCH) abandoned.push_back(entry.path());
  }
  for (const fs::path& folder : abandoned)
    fs::remove_all(folder, ignored);
}

}  // namespace

StagingFolder::StagingFolder(fs::path target)
    : target_(fs::absolute(target)), folder_(target_ / fmt::format("{}{}", prefix, ::getpid())) {
  std::error_code failure;
  fs::create_directories(target_, failure);
  if (!failure) remove_abandoned(target_);
  if (!failure) fs::remove_all(folder_, failure);
  if (!failure) fs::create_directory(folder_, failure);
  if (failure) throw OutputError(fmt::format("{}: {}", folder_.string(), failure.message()));
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void StagingFolder::publish(const std::string& name) const {
  std::error_code failure;
  const fs::path target = target_ / name;
  // Renaming cannot replace a folder by a folder: the old one is moved away first.
  if (fs::is_directory(target)) fs::rename(target, folder_ / (name + ".old"), failure);
  if (!failure) fs::rename(folder_ / name, target, failure);
  if (failure) throw OutputError(fmt::format("{}: {}", target.string(), failure.message()));
}

}  // namespace talus::reports
