#include "solver/python/script_sweep.hpp"

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/threads/parallel_for.hpp"

namespace talus::python {

PlannedSweep plan_sweep(const std::string& file) {
  app::SweepFile described = app::read_sweep(read_text(file), file);
  try {
    return {read_script_scene(described.base.string()), app::swept_runs(described).runs, std::move(described.outputs),
            described.limits};
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.starts_with(described.base.string())) throw;
    throw InputError{fmt::format("{}: {}", file, message)};
  }
}

ScriptSweep sweep_scene(const ScriptScene& scene, const std::vector<FieldValues>& runs,
                        const SweepArguments& arguments) {
  const app::SweepBase base{scene.document(), scene.name(), arguments.outputs};
  ScriptSweep sweep;
  for (const app::SweepOutput& output : base.outputs()) {
    sweep.outputs.push_back(output.name);
    sweep.units.push_back(symbol(base.units(), output.dimension));
  }
  sweep.is_fence = base.is_fence();
  sweep.results.resize(runs.size());
  PythonSignals signals;
  std::atomic<bool> is_interrupted{false};
  const auto interrupted = [&] {
    if (signals.pending()) is_interrupted = true;
    return is_interrupted.load();
  };
  {
    const pybind11::gil_scoped_release unlocked;
    const unsigned threads =
        arguments.threads > 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency());
    parallel_for(runs.size(), threads, [&](std::size_t i) {
      if (!interrupted()) sweep.results[i] = base.result({{}, runs[i]}, arguments.limits, interrupted);
    });
  }
  signals.rethrow();
  return sweep;
}

}  // namespace talus::python
