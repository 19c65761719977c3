/// talus: the solver's command line.

#include <cxxabi.h>
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

#include "solver/app/command.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/version/version.hpp"

namespace {

/// Occupies the descriptors of closed standard streams; otherwise a file opened later would get one of them, and
/// receive the printed output. Reading from and writing to these streams still fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// Whether the program ends for lack of memory: by an exception that initialisation before main() has thrown, or
/// because not even that could be allocated, as the reserve of the C++ library did not fit either.
bool is_without_memory() {
  // glibc requests this much from the system before an allocation fails.
  constexpr std::size_t reserve = 1 << 20;
  if (const std::type_info* const thrown = abi::__cxa_current_exception_type())
    return *thrown == typeid(std::bad_alloc);
  // Volatile: a compiler may leave out an allocation that is not used, and take it for successful.
  void* const volatile block = std::malloc(reserve);
  return block == nullptr;
}

[[noreturn]] void end_without_memory() {
  if (is_without_memory()) {
    constexpr char message[] = "talus: out of memory\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message, sizeof message - 1);
    std::_Exit(talus::app::io_failed);
  }
  std::abort();
}

/// Before all other initialisation, which takes memory.
[[gnu::constructor(101)]] void prepare_for_little_memory() { std::set_terminate(end_without_memory); }

}  // namespace

int main(int count, char** arguments) {
  occupy_closed_streams();
  // Exceeding a file size limit then is a write error with a message and clean-up, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  return talus::app::run_command_line(talus::version_text("talus"), count, arguments);
}
