/// A library that is loaded before a program (LD_PRELOAD) and records each error of Talus that is thrown: a line with
/// its kind, the program and the message, in a file for each process in the folder TALUS_MESSAGES. Line breaks within a
/// message become \x1f.
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <typeinfo>

namespace {

void note(std::string_view kind, const char* what) {
  const char* const folder = std::getenv("TALUS_MESSAGES");
  if (folder == nullptr) return;
  std::string line = std::string{kind} + '\t' + program_invocation_short_name + '\t' + what;
  for (char& letter : line)
    letter = letter == '\n' ? '\x1f' : letter;
  line += '\n';
  const std::string file = std::string{folder} + '/' + std::to_string(::getpid()) + ".tsv";
  const int to = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (to < 0) return;
  // Some tests limit the size of files; a message that does not fit is also provoked by other tests.
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  [[maybe_unused]] const ssize_t written = ::write(to, line.data(), line.size());
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
  if (name == "N5talus7IoErrorE") note("file", what());
  using Throw = void (*)(void*, std::type_info*, void (*)(void*));
  const auto next = reinterpret_cast<Throw>(::dlsym(RTLD_NEXT, "__cxa_throw"));
  next(object, type, destroy);
  __builtin_unreachable();
}
