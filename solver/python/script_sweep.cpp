#include "solver/python/script_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/python/python_signals.hpp"
#include "solver/threads/parallel_for.hpp"

namespace talus::python {
namespace {

std::variant<ScriptScene, ScriptCell> base_of(TomlValue document, const std::string& name) {
  if (describes_cell(document)) return ScriptCell{std::move(document), name};
  return ScriptScene{std::move(document), name};
}

}  // namespace

PlannedSweep plan_sweep(const std::string& file) {
  app::SweepFile described = app::read_sweep(read_text(file), file);
  const std::string name = described.base.string();
  TomlValue document = of_scene(name, [&] { return parse_toml(script_text(name, described.base_location()), name); });
  try {
    std::vector<app::SweptRun> runs = app::swept_runs(described).runs;
    app::SweepBase{document, name}.check_axes(described, runs.front());
    return {base_of(std::move(document), name), std::move(runs), std::move(described.outputs), described.limits};
  } catch (const SceneInputError&) {
    throw;
  } catch (const InputError& error) {
    throw SceneInputError{error.what(), file};
  }
}

ScriptSweep sweep_document(const TomlValue& document, const std::string& name, const std::vector<FieldValues>& runs,
                           const SweepArguments& arguments) {
  for (auto output = arguments.outputs.begin(); output != arguments.outputs.end(); ++output)
    if (std::find(arguments.outputs.begin(), output, *output) != output)
      throw InputError{fmt::format("outputs: found '{}' twice; remove one", *output)};
  app::SweepBase base{document, name};
  base.choose(arguments.outputs);
  // Nearly always all runs change the same fields.
  const FieldValues* checked = nullptr;
  for (const FieldValues& fields : runs) {
    constexpr auto name_of = &FieldValues::value_type::first;
    if (checked != nullptr && std::ranges::equal(*checked, fields, {}, name_of, name_of)) continue;
    app::check_fields(document, {{}, fields});
    checked = &fields;
  }
  ScriptSweep sweep;
  for (const app::SweepOutput& output : base.outputs())
    sweep.outputs.push_back(output.name);
  sweep.is_fence = base.is_fence();
  sweep.results.resize(runs.size());
  PythonSignals signals;
  std::atomic<bool> is_interrupted{false};
  const auto interrupted = [&] { return is_interrupted.load(); };
  {
    const Unlocked unlocked;
    const unsigned threads =
        arguments.threads > 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency());
    std::future<void> all = std::async(std::launch::async, [&] {
      parallel_for(runs.size(), threads, [&](std::size_t i) {
        if (!interrupted()) sweep.results[i] = base.result({{}, runs[i]}, arguments.limits, interrupted);
      });
    });
    // This thread sees signals, also when it would have no run left.
    while (all.wait_for(std::chrono::milliseconds{20}) != std::future_status::ready)
      if (signals.pending()) is_interrupted = true;
    all.get();
  }
  signals.rethrow();
  return sweep;
}

}  // namespace talus::python
