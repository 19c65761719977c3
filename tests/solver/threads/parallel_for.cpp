#include "solver/threads/parallel_for.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(parallel_for_tests)

using talus::parallel_for;

namespace {

/// Waits up to ten seconds until `count` others have arrived as well.
bool met(std::atomic<int>& arrived, int count) {
  ++arrived;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{10};
  while (arrived < count && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
  return arrived >= count;
}

/// Error message that the loop throws; `started` counts the calls.
std::string thrown(std::size_t count, unsigned threads, std::size_t first_bad, std::atomic<int>& started) {
  try {
    parallel_for(count, threads, [&](std::size_t i) {
      ++started;
      // Among the failing calls, later ones fail sooner.
      if (i >= first_bad) {
        std::this_thread::sleep_for(std::chrono::microseconds{i == first_bad ? 300 : 0});
        throw std::runtime_error{std::to_string(i)};
      }
    });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_is_called_once) {
  for (const std::size_t count : {0U, 1U, 2U, 5U, 1000U}) {
    for (const unsigned threads : {0U, 1U, 2U, 7U}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, threads, [&](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& of_one : calls)
        BOOST_REQUIRE(of_one == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(one_thread_is_the_callers_and_goes_in_order) {
  const std::thread::id here = std::this_thread::get_id();
  std::vector<std::size_t> order;
  parallel_for(100, 1, [&](std::size_t i) {
    BOOST_REQUIRE(std::this_thread::get_id() == here);
    order.push_back(i);
  });
  BOOST_TEST_REQUIRE(order.size() == 100U);
  for (std::size_t i = 0; i < 100; ++i)
    BOOST_REQUIRE(order[i] == i);
}

// Three tasks that wait for each other end only with three threads.
BOOST_AUTO_TEST_CASE(threads_work_at_the_same_time) {
  std::atomic<int> arrived{0}, together{0};
  parallel_for(3, 3, [&](std::size_t) { together += met(arrived, 3) ? 1 : 0; });
  BOOST_TEST(together == 3);
}

BOOST_AUTO_TEST_CASE(the_error_of_the_smallest_is_thrown) {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    for (int attempt = 0; attempt < 50; ++attempt) {
      std::atomic<int> started{0};
      BOOST_REQUIRE(thrown(200, threads, 5, started) == "5");
      BOOST_REQUIRE(started >= 6);
      BOOST_REQUIRE(started <= 5 + static_cast<int>(threads));
    }
  }
  std::atomic<int> started{0};
  BOOST_TEST(thrown(4, 2, 9, started) == "nothing");
  BOOST_TEST(started == 4);
}

BOOST_AUTO_TEST_SUITE_END()
