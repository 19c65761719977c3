#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <limits>
#include <memory>
#include <span>

#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/python/advancing.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/python/python_values.hpp"

/// What scripts do with runs that are advanced: ScriptSimulation, ScriptCellRun.
namespace talus::python {

/// Advances a run by this many steps or intervals, without the interpreter's lock, unless one of the signals raises.
/// Returns whether some are left.
template <class Run>
bool advance(Run& run, long count, PythonSignals& signals) {
  bool continues = false;
  {
    // Before the lock is free for another thread, to which the run would seem idle.
    const Advancing advancing = run.begin();
    const Unlocked unlocked;
    continues = run.advance(advancing, count, [&] { return signals.pending(); });
  }
  signals.rethrow();
  return continues;
}

/// The same; Ctrl-C raises KeyboardInterrupt. Errors: InputError naming the argument.
template <class Run>
bool advance(Run& run, long count, const char* argument) {
  if (count < 0) throw InputError{fmt::format("{}: found {}; it must be >= 0", argument, count)};
  PythonSignals signals;
  return advance(run, count, signals);
}

/// Advances the run `self` to its end, and calls back after each `every` steps or intervals and at the end; a callback
/// that returns something false but None stops it.
template <class Run>
void run_to_end(const pybind11::object& self, const pybind11::object& callback, long every) {
  if (every < 1) throw InputError{fmt::format("every: found {}; it must be >= 1", every)};
  auto& run = pybind11::cast<Run&>(self);
  if (callback.is_none()) return static_cast<void>(advance(run, std::numeric_limits<long>::max(), "every"));
  // One for all steps: it takes longer than a step.
  PythonSignals signals;
  while (!run.has_ended()) {
    advance(run, every, signals);
    const pybind11::object answer = callback(self);
    if (answer.is_none()) continue;
    const int is_true = PyObject_IsTrue(answer.ptr());
    if (is_true < 0) throw pybind11::error_already_set{};
    if (is_true == 0) return;
  }
}

/// A property that is a view of numbers that a run holds.
template <class Run, class Numbers>
pybind11::cpp_function viewed(Numbers numbers) {
  return pybind11::cpp_function{[numbers](const pybind11::object& self) {
    const auto& run = pybind11::cast<const Run&>(self);
    static_cast<void>(run.idle());
    return view(std::span<const double>{numbers(run)}, self);
  }};
}

/// A run between two steps, as a dict that pickles.
template <class Run>
pybind11::dict saved_run(Run& run) {
  Archive archive;
  run.serialize(archive);
  return to_python(archive);
}
/// Continues `run`, made of the same arguments, where the saved one was. Errors: InputError.
template <class Run>
std::unique_ptr<Run> restored_run(std::unique_ptr<Run> run, const pybind11::dict& saved) {
  const ArchiveItems items = to_items(saved);
  Archive archive{items};
  run->serialize(archive);
  if (!archive.left_over().empty()) throw InputError{"the saved run is of another version of Talus"};
  return run;
}

}  // namespace talus::python
