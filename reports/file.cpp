#include "reports/file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "reports/error.hpp"

namespace talus::reports {
namespace fs = std::filesystem;

Workshop::Workshop(fs::path target)
    : target_(fs::absolute(target)), folder_(target_ / fmt::format(".partial-{}", getpid())) {
  std::error_code failure;
  fs::create_directories(target_, failure);
  if (!failure) fs::remove_all(folder_, failure);
  if (!failure) fs::create_directory(folder_, failure);
  if (failure) throw OutputError(fmt::format("{}: {}", folder_.string(), failure.message()));
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Workshop::publish(const std::string& name) const {
  std::error_code failure;
  const fs::path target = target_ / name;
  // A folder cannot replace a folder by renaming: the old one steps aside first.
  if (fs::is_directory(target)) fs::rename(target, folder_ / (name + ".old"), failure);
  if (!failure) fs::rename(folder_ / name, target, failure);
  if (failure) throw OutputError(fmt::format("{}: {}", target.string(), failure.message()));
}

}  // namespace talus::reports
