#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace talus {

/// Threads that work together, again and again: this one and others that wait meanwhile.
class ThreadPool {
 public:
  /// size >= 1: with this thread. Threads that the system cannot start are done without.
  explicit ThreadPool(std::size_t size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls work(k) for 0 <= k < size, at once as far as the system lets the threads run, and returns when all calls
  /// have ended. A call must not wait for another: the calling thread makes those that no thread has begun. Errors: what
  /// work(k) throws, that of the smallest k.
  void each(const std::function<void(std::size_t)>& work);
  std::size_t size() const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

/// Some of a number of things that follow each other.
struct IndexRange {
  std::size_t number{};  ///< which part it is
  std::size_t begin{}, end{};
};

/// Calls work(part) for `count` things in as many even parts as the team has threads, as ThreadPool::each; without a team, for
/// all of them in the calling thread.
template <class Work>
void in_ranges(ThreadPool* pool, std::size_t count, Work&& work) {
  if (pool == nullptr) return work(IndexRange{0, 0, count});
  pool->each([&](std::size_t k) { work(IndexRange{k, count * k / pool->size(), count * (k + 1) / pool->size()}); });
}

}  // namespace talus
