#include "solver/python/python_signals.hpp"

#include <atomic>
#include <stdexcept>

namespace talus::python {
namespace {

std::atomic<int> running{0};
std::atomic<bool> is_ending{false};

}  // namespace

Unlocked::Counted::Counted() { ++running; }
Unlocked::Counted::~Counted() { --running; }

void end_computations() {
  is_ending = true;
  const pybind11::gil_scoped_release unlocked;
  while (running > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
}

PythonSignals::PythonSignals()
    : is_main_{pybind11::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>() ==
               PyThread_get_thread_ident()} {}

bool PythonSignals::pending() {
  if (is_ending) return true;
  if (!is_main_ || std::this_thread::get_id() != caller_) return false;
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
  if (is_ending) throw std::runtime_error{"the interpreter ends"};
}

}  // namespace talus::python
