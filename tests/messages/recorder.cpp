/// A library that is loaded before a program (LD_PRELOAD) and records each error of Talus that is thrown: a line with
/// its kind, the program and the message, in a file for each process in the folder TALUS_MESSAGES. Line breaks within a
/// message become \x1f.
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <typeinfo>

namespace {

/// The function of the C++ library; found when the program starts, because that takes memory.
using Throw = void (*)(void*, std::type_info*, void (*)(void*));
const auto next_throw = reinterpret_cast<Throw>(::dlsym(RTLD_NEXT, "__cxa_throw"));

/// Takes no memory: some tests limit it.
void note(std::string_view kind, const char* what) {
  const char* const folder = std::getenv("TALUS_MESSAGES");
  if (folder == nullptr) return;
  static thread_local std::array<char, 1 << 16> line;
  const int printed = std::snprintf(line.data(), line.size(), "%.*s\t%s\t%s\n", static_cast<int>(kind.size()),
                                    kind.data(), program_invocation_short_name, what);
  const std::size_t size = std::min(static_cast<std::size_t>(std::max(printed, 0)), line.size() - 1);
  if (size == 0) return;
  std::replace(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(size - 1), '\n', '\x1f');
  line[size - 1] = '\n';
  std::array<char, 4096> file;
  if (std::snprintf(file.data(), file.size(), "%s/%ld.tsv", folder, static_cast<long>(::getpid())) < 0) return;
  const int to = ::open(file.data(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (to < 0) return;
  // Some tests limit the size of files; a message that does not fit is also provoked by other tests.
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  [[maybe_unused]] const ssize_t written = ::write(to, line.data(), size);
  std::signal(SIGXFSZ, before);
  ::close(to);
}

}  // namespace

/// Replaces the function of the C++ library, which it calls.
extern "C" [[noreturn, gnu::visibility("default")]] void __cxa_throw(void* object, std::type_info* type,
                                                                     void (*destroy)(void*)) {
  const std::string_view name = type->name();
  // Both derive from std::exception alone, so that the thrown object begins with it.
  const auto what = [object] { return static_cast<const std::exception*>(object)->what(); };
  if (name == "N5talus10InputErrorE") note("input", what());
  if (name == "N5talus7IoErrorE" || name == "N5talus11FolderInUseE") note("file", what());
  next_throw(object, type, destroy);
  __builtin_unreachable();
}
