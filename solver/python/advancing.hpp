#pragma once

#include <atomic>
#include <stdexcept>

namespace talus::python {

/// A run advances during the lifetime of the object.
class Advancing {
 public:
  explicit Advancing(std::atomic<bool>& flag) : flag_{flag} { flag_ = true; }
  Advancing(const Advancing&) = delete;
  Advancing& operator=(const Advancing&) = delete;
  ~Advancing() { flag_ = false; }

 private:
  std::atomic<bool>& flag_;
};

/// Errors: std::runtime_error while a run advances.
inline void demand_idle(const std::atomic<bool>& is_advancing) {
  if (is_advancing)
    throw std::runtime_error{"the run is advancing: another thread, or a handler of a signal, cannot use it"};
}

}  // namespace talus::python
