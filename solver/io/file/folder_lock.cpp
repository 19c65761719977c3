#include "solver/io/file/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "solver/base/error.hpp"

namespace talus {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)} {
  if (descriptor_ < 0) throw IoError{fmt::format("{}: {}", folder.string(), std::strerror(errno))};
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw IoError{fmt::format("{}: another run is writing into it; each run needs a separate folder", folder.string())};
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace talus
