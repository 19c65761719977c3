#include "solver/base/thread_pool.hpp"

#include <atomic>
#include <exception>
#include <limits>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace talus {
namespace {

/// Number of polls before a thread sleeps: waking it takes longer than most waits between the parts of a step. With
/// more threads than processors there is no polling, because a polling thread keeps others from working.
constexpr int looks_alone = 1000;

inline void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until `number` differs from `than`, with `looks` polls before it sleeps; returns the new value.
std::size_t await_other(const std::atomic<std::size_t>& number, std::size_t than, int looks) {
  for (int look = 0; look < looks; ++look) {
    const std::size_t now = number.load(std::memory_order_acquire);
    if (now != than) return now;
    pause();
  }
  number.wait(than, std::memory_order_acquire);
  return number.load(std::memory_order_acquire);
}

}  // namespace

struct ThreadPool::Shared {
  /// Value of `calls` that makes the threads end.
  static constexpr std::size_t no_more = std::numeric_limits<std::size_t>::max();

  /// If the system cannot start all threads, the calling thread does the parts of the missing ones.
  explicit Shared(std::size_t size)
      : looks{size <= std::thread::hardware_concurrency() ? looks_alone : 0}, taken(size), failures(size) {
    try {
      for (std::size_t k = 1; k < size; ++k)
        others.emplace_back([this, k] { serve(k); });
    } catch (const std::system_error&) {
    }
  }
  ~Shared() {
    calls.store(no_more, std::memory_order_release);
    calls.notify_all();
    for (std::thread& other : others)
      other.join();
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  /// Does part k of a call unless a thread has already taken it. A call ends when all its parts are done, and the next
  /// one begins only then: a thread that takes a part sees the work of this call, and a late thread finds no part.
  void do_part(std::size_t k, std::size_t call) noexcept {
    std::size_t before = call - 1;
    if (!taken[k].compare_exchange_strong(before, call, std::memory_order_acq_rel)) return;
    try {
      (*work)(k);
    } catch (...) {
      failures[k] = std::current_exception();
    }
    if (left.fetch_sub(1, std::memory_order_acq_rel) == 1) left.notify_all();
  }
  void serve(std::size_t k) {
    for (std::size_t seen = 0;;) {
      seen = await_other(calls, seen, looks);
      if (seen == no_more) return;
      do_part(k, seen);
    }
  }

  int looks;
  const std::function<void(std::size_t)>* work{};
  std::atomic<std::size_t> calls{};             ///< number of calls so far
  std::vector<std::atomic<std::size_t>> taken;  ///< of each part: the last call in which a thread took it
  std::atomic<std::size_t> left{};              ///< unfinished parts of the current call
  std::vector<std::exception_ptr> failures;
  std::vector<std::thread> others;  ///< last member: the threads use all those above
};

ThreadPool::ThreadPool(std::size_t size) : shared_{std::make_unique<Shared>(size)} {}
ThreadPool::~ThreadPool() = default;

std::size_t ThreadPool::size() const { return shared_->failures.size(); }

void ThreadPool::each(const std::function<void(std::size_t)>& work) {
  Shared& shared = *shared_;
  shared.work = &work;
  shared.left.store(size(), std::memory_order_relaxed);
  const std::size_t call = shared.calls.fetch_add(1, std::memory_order_release) + 1;
  shared.calls.notify_all();
  // Includes the parts of threads that have not begun: if other programs keep the processors busy, a thread may wait
  // for some milliseconds before it runs, about a hundred times as long as the part takes.
  for (std::size_t k = 0; k < size(); ++k)
    shared.do_part(k, call);
  for (std::size_t left = shared.left.load(std::memory_order_acquire); left != 0;)
    left = await_other(shared.left, left, shared.looks);
  for (std::exception_ptr& failure : shared.failures) {
    if (failure != nullptr) {
      const std::exception_ptr thrown = std::exchange(failure, nullptr);
      for (std::exception_ptr& other : shared.failures)
        other = nullptr;
      std::rethrow_exception(thrown);
    }
  }
}

}  // namespace talus
