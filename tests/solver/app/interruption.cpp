#include "solver/app/interruption.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <csignal>
#include <thread>

BOOST_AUTO_TEST_SUITE(interruption_tests)

namespace {

using talus::app::Interruption;

/// Status, as of waitpid, of a process that receives a signal twice at once and, `later`, once more; 0 if it survives
/// and has recorded the signal.
int status_after(int signal, bool later) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(signal, SIG_DFL);  // not ignored, as SIGHUP under nohup
    const Interruption interruption;
    std::raise(signal);
    std::raise(signal);
    if (later) {
      std::this_thread::sleep_for(std::chrono::milliseconds{300});
      std::raise(signal);
    }
    ::_exit(interruption.signal() == signal ? 0 : 1);
  }
  BOOST_REQUIRE(child > 0);
  int status = 0;
  BOOST_REQUIRE(::waitpid(child, &status, 0) == child);
  return status;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_signal_that_comes_twice_at_once_is_one_and_a_later_one_ends_the_program) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    BOOST_TEST(status_after(signal, false) == 0);
    const int status = status_after(signal, true);
    BOOST_TEST((WIFSIGNALED(status) && WTERMSIG(status) == signal));
  }
}

BOOST_AUTO_TEST_SUITE_END()
