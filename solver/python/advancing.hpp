#pragma once

#include <atomic>
#include <stdexcept>

namespace talus::python {

/// Errors: std::runtime_error if a run advances.
inline void demand_idle(bool is_advancing) {
  if (is_advancing)
    throw std::runtime_error{"the run is advancing: another thread, or a handler of a signal, cannot use it"};
}

/// A run advances during the lifetime of the object. Errors: std::runtime_error if it does already.
class Advancing {
 public:
  explicit Advancing(std::atomic<bool>& flag) : flag_{flag} { demand_idle(flag.exchange(true)); }
  Advancing(const Advancing&) = delete;
  Advancing& operator=(const Advancing&) = delete;
  ~Advancing() { flag_ = false; }

 private:
  std::atomic<bool>& flag_;
};

}  // namespace talus::python
