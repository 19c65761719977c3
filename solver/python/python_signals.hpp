#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <thread>

namespace talus::python {

/// A computation without the interpreter's lock, during the lifetime of the object. The interpreter ends only when no
/// such computation runs: taking the lock later would end the process.
class Unlocked {
 public:
  Unlocked() = default;
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  /// Counts the computations, until each has the lock again.
  struct Counted {
    Counted();
    ~Counted();
  };
  Counted counted_;
  pybind11::gil_scoped_release released_;  ///< destroyed first
};

/// Asks all computations to stop and waits for them; called when the interpreter ends.
void end_computations();

/// What ends a computation early: a Python signal handler that raises, as Ctrl-C does, or the end of the interpreter.
/// Constructed by the thread that calls the computation, with the interpreter's lock.
class PythonSignals {
 public:
  PythonSignals();

  /// Whether there is such a reason; without the lock, and cheap enough for every step. Python handles signals in its
  /// main thread; signals are looked for every 50 ms.
  bool pending();
  /// Throws the exception of the handler, with the lock. Errors: std::runtime_error if the interpreter ends.
  void rethrow() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::thread::id caller_{std::this_thread::get_id()};
  bool is_main_{};
  Clock::time_point next_{Clock::now()};
  std::exception_ptr raised_;
};

}  // namespace talus::python
