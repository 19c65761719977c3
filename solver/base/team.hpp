#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace talus {

/// Threads that work together, again and again: this one and others that wait meanwhile.
class Team {
 public:
  /// size >= 1: with this thread.
  explicit Team(std::size_t size);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls work(k) for 0 <= k < size, each by another thread, and waits until all are done. Errors: what work(k)
  /// throws, that of the smallest k.
  void each(const std::function<void(std::size_t)>& work);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace talus
