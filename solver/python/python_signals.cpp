#include "solver/python/python_signals.hpp"

#include <pybind11/pybind11.h>

namespace talus::python {

bool PythonSignals::pending() {
  if (std::this_thread::get_id() != caller_) return false;
  if (raised_) return true;
  const Clock::time_point now = Clock::now();
  if (now < next_) return false;
  next_ = now + std::chrono::milliseconds{50};
  const pybind11::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return false;
  raised_ = std::make_exception_ptr(pybind11::error_already_set{});
  return true;
}

void PythonSignals::rethrow() const {
  if (raised_) std::rethrow_exception(raised_);
}

}  // namespace talus::python
