#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace talus {

/// Threads that work together, again and again: this one and others that wait meanwhile.
class Team {
 public:
  /// size >= 1: with this thread. Threads that the system cannot start are done without.
  explicit Team(std::size_t size);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

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
struct Part {
  std::size_t number{};  ///< which part it is
  std::size_t begin{}, end{};
};

/// Calls work(part) for `count` things in as many even parts as the team has threads, as Team::each; without a team, for
/// all of them in the calling thread.
template <class Work>
void in_parts(Team* team, std::size_t count, Work&& work) {
  if (team == nullptr) return work(Part{0, 0, count});
  team->each([&](std::size_t k) { work(Part{k, count * k / team->size(), count * (k + 1) / team->size()}); });
}

}  // namespace talus
