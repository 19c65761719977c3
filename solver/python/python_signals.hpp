#pragma once

#include <chrono>
#include <exception>
#include <thread>

namespace talus::python {

/// Ctrl-C during a computation that holds no lock of the interpreter: the thread that called it looks for signals every
/// 50 ms.
class PythonSignals {
 public:
  /// Whether Python has a signal whose handler raised an exception (KeyboardInterrupt). Cheap enough for every step; of
  /// other threads always false.
  bool pending();
  /// Throws that exception in the thread that has found it, with the interpreter's lock.
  void rethrow() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::thread::id caller_{std::this_thread::get_id()};
  Clock::time_point next_{Clock::now()};
  std::exception_ptr raised_;
};

}  // namespace talus::python
