#include "solver/io/file/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "solver/base/error.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// Of the temporary file of another: what mkstemp() puts six letters or digits in place of.
constexpr std::string_view ending = ".talus-", any_ending = ".talus-XXXXXX";

IoError io_error(const fs::path& file, int reason) {
  return IoError{fmt::format("{}: {}", file.string(), std::strerror(reason))};
}

/// An open file that is closed, and removed if it was never kept, at the end of its life.
class Descriptor {
 public:
  Descriptor(int number, std::string path_to_remove) : number_{number}, path_{std::move(path_to_remove)} {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  int number() const { return number_; }
  /// Closes the file; 0 or the system's reason.
  int close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0 ? 0 : errno;
  }
  void keep() { path_.clear(); }

 private:
  int number_;
  std::string path_;
};

/// 0 or the system's reason.
int write_all(int number, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(number, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

void write_directly(const fs::path& file, std::string_view content) {
  Descriptor target{::open(file.c_str(), O_WRONLY | O_CLOEXEC), {}};
  if (target.number() < 0) throw io_error(file, errno);
  if (const int reason = write_all(target.number(), content)) throw io_error(file, reason);
  if (const int reason = target.close()) throw io_error(file, reason);
}

/// The permissions that a file made in the usual way would have.
mode_t usual_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

void write_whole(const fs::path& file, std::string_view content, Durability durability) {
  struct stat present {};
  if (::stat(file.c_str(), &present) == 0 && !S_ISREG(present.st_mode) && !S_ISDIR(present.st_mode)) {
    return write_directly(file, content);
  }
  std::string path = (file.parent_path() / ("." + file.filename().string() + std::string{any_ending})).string();
  const int number = ::mkstemp(path.data());
  if (number < 0) throw io_error(file, errno);
  Descriptor temporary{number, path};
  int reason = write_all(number, content);
  if (reason == 0 && ::fchmod(number, usual_permissions()) != 0) reason = errno;
  if (reason == 0 && durability == Durability::now && ::fsync(number) != 0) reason = errno;
  const int closing = temporary.close();
  if (reason == 0) reason = closing;
  if (reason == 0 && ::rename(path.c_str(), file.c_str()) != 0) reason = errno;
  if (reason != 0) throw io_error(file, reason);
  temporary.keep();
}

void sync_folder(const fs::path& folder) {
  Descriptor opened{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC), {}};
  if (opened.number() < 0 || ::syncfs(opened.number()) != 0) throw io_error(folder, errno);
}

void remove_files(const fs::path& folder, const std::function<bool(std::string_view)>& of) {
  std::error_code none;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, none})
    if (of(entry.path().filename().string())) found.push_back(entry.path());
  for (const fs::path& file : found)
    fs::remove(file, none);
}

void remove_remains(const fs::path& folder, const std::function<bool(std::string_view)>& of) {
  remove_files(folder, [&](std::string_view file) {
    if (file.size() < any_ending.size() + 2 || file.front() != '.') return false;
    const std::size_t end = file.size() - any_ending.size();
    return file.substr(end).starts_with(ending) && of(file.substr(1, end - 1));
  });
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError{fmt::format("{}: {}", folder.string(), error.message())};
}

}  // namespace talus
