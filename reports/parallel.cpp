#include "reports/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace talus::reports {

void in_parallel(const std::vector<std::function<void()>>& tasks, unsigned jobs) {
  std::vector<std::exception_ptr> failures(tasks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      try {
        tasks[i]();
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  const std::size_t count = std::min<std::size_t>(std::max(jobs, 1U), tasks.size());
  for (std::size_t i = 0; i < count; ++i)
    threads.emplace_back(work);
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace talus::reports
