#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace talus {

/// A pool of threads for repeated parallel calls: the calling thread and others, which wait between calls.
class ThreadPool {
 public:
  /// size >= 1, including the calling thread, which also does the parts of threads that the system cannot start.
  explicit ThreadPool(std::size_t size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls work(k) for 0 <= k < size(), in parallel as far as the system schedules the threads, and returns when all
  /// calls have ended. A call must not wait for another one: the calling thread makes those that no thread has begun.
  /// Errors: the exception of work(k); if there are several, that of the smallest k.
  void each(const std::function<void(std::size_t)>& work);
  std::size_t size() const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

/// A contiguous range [begin, end) of items.
struct IndexRange {
  std::size_t number{};  ///< index of the range among those of one call
  std::size_t begin{}, end{};
};

/// Divides `count` items evenly into as many ranges as the pool has threads and calls work(range) for each, as
/// ThreadPool::each; without a pool, calls it once for all items, in the calling thread.
template <class Work>
void in_ranges(ThreadPool* pool, std::size_t count, Work&& work) {
  if (pool == nullptr) return work(IndexRange{0, 0, count});
  pool->each([&](std::size_t k) { work(IndexRange{k, count * k / pool->size(), count * (k + 1) / pool->size()}); });
}

}  // namespace talus
