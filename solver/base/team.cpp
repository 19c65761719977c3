#include "solver/base/team.hpp"

#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace talus {
namespace {

/// Looks before a thread sleeps: waking it takes longer than most waits between the parts of a step. Of more threads
/// than processors who looks keeps others from their work.
constexpr int looks_alone = 1000;

inline void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until the number is another; returns it.
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

struct Team::Shared {
  explicit Shared(std::size_t size)
      : looks{size <= std::thread::hardware_concurrency() ? looks_alone : 0}, failures(size) {
    for (std::size_t k = 1; k < size; ++k)
      others.emplace_back([this, k] { serve(k); });
  }
  ~Shared() {
    work = nullptr;
    call();
    for (std::thread& other : others)
      other.join();
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  void call() {
    calls.fetch_add(1, std::memory_order_release);
    calls.notify_all();
  }
  void do_part(std::size_t k) noexcept {
    try {
      (*work)(k);
    } catch (...) {
      failures[k] = std::current_exception();
    }
  }
  void serve(std::size_t k) {
    for (std::size_t seen = 0;;) {
      seen = await_other(calls, seen, looks);
      if (work == nullptr) return;
      do_part(k);
      if (left.fetch_sub(1, std::memory_order_acq_rel) == 1) left.notify_all();
    }
  }

  int looks;
  const std::function<void(std::size_t)>* work{};
  std::atomic<std::size_t> calls{};  ///< to the others so far
  std::atomic<std::size_t> left{};   ///< of them who are at work
  std::vector<std::exception_ptr> failures;
  std::vector<std::thread> others;  ///< last: they use all that stands above
};

Team::Team(std::size_t size) : shared_{std::make_unique<Shared>(size)} {}
Team::~Team() = default;

std::size_t Team::size() const { return shared_->failures.size(); }

void Team::each(const std::function<void(std::size_t)>& work) {
  Shared& shared = *shared_;
  shared.work = &work;
  shared.left.store(shared.others.size(), std::memory_order_relaxed);
  shared.call();
  shared.do_part(0);
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
