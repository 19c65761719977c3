#include "verification/record/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <vector>

#include "verification/record/error.hpp"

namespace talus::records {
namespace {

namespace fs = std::filesystem;

/// Marks the name of a temporary file; six letters or digits follow.
constexpr std::string_view ending = ".talus-";
constexpr std::size_t letters = 6;

/// Maximum size of a regular file, and of a pipe or device [bytes]. The largest file that Talus writes is the
/// checkpoint of a cell of 10,000,000 discs, with 380 bytes a disc 3.8 GB. A pipe or device may have no end; reading it
/// must end before the memory of a small machine is exhausted.
constexpr std::size_t largest_file = std::size_t{4} << 30, largest_stream = std::size_t{1} << 30;

FileError file_error(const fs::path& file, int reason) {
  return FileError{fmt::format("{}: {}", file.string(), std::strerror(reason))};
}

/// An open file; the destructor closes it and removes it unless keep() was called.
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
  /// Closes the file; returns 0 or the system's error number.
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

/// Returns 0 or the system's error number.
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
  if (target.number() < 0) throw file_error(file, errno);
  if (const int reason = write_all(target.number(), content)) throw file_error(file, reason);
  if (const int reason = target.close()) throw file_error(file, reason);
}

/// A name that is unique in this process and almost certainly among others.
std::string temporary_name(const fs::path& file) {
  static std::atomic<std::uint32_t> calls{0};
  std::uint64_t number = static_cast<std::uint64_t>(::getpid()) * 65537U + calls++;
  std::string name = fmt::format(".{}{}", file.filename().string(), ending);
  for (std::size_t i = 0; i < letters; ++i) {
    name += "0123456789abcdefghijklmnopqrstuvwxyz"[number % 36U];
    number /= 36U;
  }
  return (file.parent_path() / name).string();
}

/// A new file with default permissions.
Descriptor temporary_file(const fs::path& file, std::string& path) {
  for (;;) {
    path = temporary_name(file);
    const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (number >= 0) return {number, path};
    if (errno != EEXIST) throw file_error(file, errno);
  }
}

}  // namespace

std::string read_whole(const fs::path& file) {
  const Descriptor source{::open(file.c_str(), O_RDONLY | O_CLOEXEC), {}};
  if (source.number() < 0) throw file_error(file, errno);
  struct stat status {};
  if (::fstat(source.number(), &status) != 0) throw file_error(file, errno);
  const bool is_regular = S_ISREG(status.st_mode);
  const std::size_t largest = is_regular ? largest_file : largest_stream;
  const auto demand = [&](bool fits) {
    if (fits) return;
    throw FileError{fmt::format("{}: found more than {} bytes; {} must have at most that many", file.string(), largest,
                                is_regular ? "a file" : "a pipe or device")};
  };
  const auto expected = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  demand(expected <= largest);
  std::string text;
  text.reserve(expected);
  char block[65536];
  for (;;) {
    const ssize_t count = ::read(source.number(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw file_error(file, errno);
    if (count == 0) return text;
    // A file can grow while it is read, and one of /proc has no size.
    demand(text.size() + static_cast<std::size_t>(count) <= largest);
    text.append(block, static_cast<std::size_t>(count));
  }
}

void write_whole(const fs::path& file, std::string_view content, Durability durability) {
  struct stat present {};
  if (::stat(file.c_str(), &present) == 0 && !S_ISREG(present.st_mode) && !S_ISDIR(present.st_mode)) {
    return write_directly(file, content);
  }
  std::string path;
  Descriptor temporary = temporary_file(file, path);
  int reason = write_all(temporary.number(), content);
  if (reason == 0 && durability == Durability::now && ::fsync(temporary.number()) != 0) reason = errno;
  const int closing = temporary.close();
  if (reason == 0) reason = closing;
  if (reason == 0 && ::rename(path.c_str(), file.c_str()) != 0) reason = errno;
  if (reason != 0) throw file_error(file, reason);
  temporary.keep();
}

void sync_folder(const fs::path& folder) {
  const Descriptor opened{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC), {}};
  if (opened.number() < 0 || ::syncfs(opened.number()) != 0) throw file_error(folder, errno);
}

void remove_remains(const fs::path& folder, const std::function<bool(std::string_view)>& of) {
  std::error_code none;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, none}) {
    const std::string file = entry.path().filename().string();
    const std::size_t minimum = ending.size() + letters;
    if (file.size() < minimum + 2 || file.front() != '.') continue;
    const std::string_view target = std::string_view{file}.substr(1, file.size() - minimum - 1);
    if (file.compare(file.size() - minimum, ending.size(), ending) == 0 && of(target)) found.push_back(entry.path());
  }
  for (const fs::path& file : found)
    fs::remove(file, none);
}

}  // namespace talus::records
