#include "solver/io/file/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

namespace talus {
namespace {

/// The holder of the lock by the kernel's list, " (process 4321)"; empty if it is not listed, for example because it
/// runs on another machine.
std::string holder(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return {};
  const std::string locked = fmt::format("{:02x}:{:02x}:{}", major(status.st_dev), minor(status.st_dev), status.st_ino);
  std::ifstream list{"/proc/locks"};
  for (std::string line; std::getline(list, line);) {
    std::istringstream fields{line};
    std::string number, kind, form, mode, process, file;
    fields >> number >> kind >> form >> mode >> process >> file;
    if (kind == "FLOCK" && file == locked && process != "0") return fmt::format(" (process {})", process);
  }
  return {};
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)} {
  if (descriptor_ < 0) throw IoError{fmt::format("{}: {}", folder.string(), std::strerror(errno))};
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  const std::string process = holder(descriptor_);
  ::close(descriptor_);
  throw FolderInUse{
      fmt::format("{}: another run{} is writing into it; each run needs a separate folder", folder.string(), process)};
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace talus
