#include "solver/threads/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace talus {

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex recording;
  std::size_t first = count;  // smallest index whose call failed
  std::exception_ptr failure;
  const auto serve = [&] {
    // Indices are assigned in order: when one fails, all below it have been assigned and run to their end.
    while (!failed) {
      const std::size_t i = next++;
      if (i >= count) return;
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock{recording};
        if (i < first) first = i, failure = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t)
        others.emplace_back(serve);
    } catch (const std::system_error&) {
      // The system cannot start more threads: those already started do the remaining work later.
    }
    serve();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace talus
