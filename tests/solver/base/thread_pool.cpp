#include "solver/base/thread_pool.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <ctime>
#include <fstream>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(thread_pool_tests)

using talus::ThreadPool;

namespace {

/// Limits the address space to the amount in use, during its lifetime: then no thread can be started, because no stack
/// can be allocated.
class NoRoom {
 public:
  NoRoom() {
    ::getrlimit(RLIMIT_AS, &before_);
    std::ifstream in{"/proc/self/statm"};
    rlim_t pages{};
    in >> pages;
    const rlimit now{pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + 1'000'000, before_.rlim_max};
    ::setrlimit(RLIMIT_AS, &now);
  }
  NoRoom(const NoRoom&) = delete;
  NoRoom& operator=(const NoRoom&) = delete;
  ~NoRoom() { ::setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

std::atomic<bool> is_paused{false}, may_continue{false};

/// Handler of a signal: its thread pauses, 10 s at most.
void pause_thread(int) {
  is_paused = true;
  const timespec interval{0, 1'000'000};
  for (int i = 0; i < 10'000 && !may_continue; ++i)
    ::nanosleep(&interval, nullptr);
}

}  // namespace

/// Must be the first test: later ones reuse the stacks of earlier threads.
BOOST_AUTO_TEST_CASE(threads_that_cannot_be_started_are_done_without) {
  std::set<std::thread::id> ids;
  std::vector<int> done(4);
  const auto made = [] {
    const NoRoom no_room;
    return std::make_unique<ThreadPool>(4);
  };
  const std::unique_ptr<ThreadPool> pool = made();
  for (int call = 0; call < 100; ++call) {
    pool->each([&](std::size_t k) {
      ++done[k];
      ids.insert(std::this_thread::get_id());  // by this thread alone
    });
  }
  BOOST_TEST(done == std::vector<int>(4, 100), boost::test_tools::per_element());
  BOOST_TEST(ids.size() == 1u);
}

BOOST_AUTO_TEST_CASE(each_part_is_done_once_and_before_the_next_work_begins) {
  for (const std::size_t size : {1U, 2U, 3U, 7U}) {
    ThreadPool pool{size};
    std::vector<long> done(size);
    bool together = true;
    for (long call = 1; call <= 2000; ++call) {
      pool.each([&](std::size_t k) { ++done[k]; });
      together = together && std::accumulate(done.begin(), done.end(), 0L) == call * static_cast<long>(size);
    }
    BOOST_TEST(together);
    BOOST_TEST(done == std::vector<long>(size, 2000), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(what_a_part_throws_reaches_the_caller_and_the_team_goes_on) {
  ThreadPool pool{3};
  for (const std::size_t thrower : {0U, 2U}) {
    std::string caught;
    try {
      pool.each([&](std::size_t k) {
        if (k >= thrower) throw std::runtime_error{"part " + std::to_string(k)};
      });
    } catch (const std::runtime_error& error) {
      caught = error.what();
    }
    BOOST_TEST(caught == "part " + std::to_string(thrower));
    int done = 0;
    pool.each([&](std::size_t k) {
      if (k == 1) ++done;
    });
    BOOST_TEST(done == 1);
  }
}

// If other programs keep the processors busy, a thread of the pool may not run for some milliseconds.
BOOST_AUTO_TEST_CASE(the_calling_thread_does_the_part_of_a_thread_that_has_not_begun) {
  ThreadPool pool{2};
  std::atomic<pthread_t> other{};
  pool.each([&](std::size_t k) {
    if (k == 1) other = ::pthread_self();
    while (other == pthread_t{})  // so that the calling thread does not take both parts
      std::this_thread::yield();
  });
  std::signal(SIGUSR1, pause_thread);
  BOOST_REQUIRE(::pthread_kill(other, SIGUSR1) == 0);
  while (!is_paused)
    std::this_thread::yield();
  std::vector<std::thread::id> by(2);
  pool.each([&](std::size_t k) { by[k] = std::this_thread::get_id(); });
  may_continue = true;
  std::signal(SIGUSR1, SIG_DFL);
  for (const std::thread::id id : by)
    BOOST_TEST((id == std::this_thread::get_id()));
}

BOOST_AUTO_TEST_SUITE_END()
