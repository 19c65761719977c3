#include "solver/app/run_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/file/utf8.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/run/simulate.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Another end. A history that is as long as by default stays so, and so do the files of a fence.
void change_end(SceneFile& file, double end) {
  constexpr double usual_rows = 1000.0;
  RunPlan& plan = file.scene.plan;
  const double factor = end / plan.end;
  const bool usual = plan.interval == std::max(plan.end / usual_rows, plan.step);
  plan.end = end;
  if (!file.fence) {
    if (usual) plan.interval = std::max(end / usual_rows, plan.step);
    return;
  }
  scenes::Fence& fence = file.fence->fence;
  if (fence.options == scenes::FenceOptions{} || fence.history_every != std::max(1L, fence.steps / 1000)) return;
  const auto longer = [&](long every) {
    return std::max(1L, std::lround(std::min(factor, 1e9) * static_cast<double>(every)));
  };
  fence.history_every = longer(fence.history_every);
  fence.print_every = longer(fence.print_every);
  plan.interval = static_cast<double>(fence.history_every) * plan.step;
}

/// A new run, with what the command line changes of its scene.
RunOrder new_order(const RunOptions& options) {
  if (options.scene.empty()) throw InputError{"SCENE is required, or --resume DIR\nhelp: talus run --help"};
  if (!options.until.empty() && options.folder.empty()) {
    throw InputError{"--until: it goes with --out, the folder in which the run is left to be taken on"};
  }
  const fs::path file{options.scene};
  if (const std::string whole = fs::absolute(file).string(); !options.folder.empty() && !is_utf8(whole))
    throw InputError{
        fmt::format("{}: the folder of the scene is not UTF-8; a run to be taken on names it", as_utf8(whole))};
  RunOrder order{.scene = file,
                 .text = read_text(file),
                 .file = read_scene_file(file),
                 .folder = options.folder,
                 .from = {},
                 .name = file,
                 .sheet = options.sheet,
                 .memory = {}};
  if (options.sheet && (!order.file.fence || options.folder.empty())) {
    throw InputError{"--sheet: it goes with a fence (a deck or a scene with [fence]) and with --out"};
  }
  Scene& scene = order.file.scene;
  const UnitSystem& units = scene.model.units;
  if (!options.end.empty()) change_end(order.file, option_quantity("--end", options.end, dimension::time, units));
  bool needs_step = false;
  if (!options.integrator.empty() || options.tolerance != 0.0) {
    const std::string_view method = options.integrator.empty() ? name(scene.integrator) : options.integrator;
    if (const auto known = integrator_choices(); std::ranges::find(known, method) == known.end())
      throw unknown_name("integrator", method, known);
    // The scene's tolerance stays with it, under any method that takes one.
    const bool takes_one = method == automatic_integrator || has_step_control(method);
    const double given = options.tolerance != 0.0 ? options.tolerance : talus::tolerance(scene.integrator);
    const double tolerance = takes_one || options.tolerance != 0.0 ? given : 0.0;
    const IntegratorChoice chosen = choose_integrator(scene.model, method, tolerance);
    // The step of a method that chooses its own is the time between two outputs, and no step for another.
    needs_step = chooses_steps(scene.integrator) && !chooses_steps(chosen.integrator);
    scene.integrator = chosen.integrator;
    scene.integrator_why = chosen.why;
  }
  if (options.step == automatic_step_name || (needs_step && options.step.empty())) {
    scene.plan.step = automatic_step(scene);
    scene.plan.interval = std::max(scene.plan.interval, scene.plan.step);
  } else if (!options.step.empty()) {
    scene.plan.step = option_quantity("--step", options.step, dimension::time, units);
  }
  return order;
}

/// Whether the run of a checkpoint writes a sheet.
bool holds_sheet(const MemoryItems& memory) {
  const auto item = memory.find("sheet");
  if (item == memory.end()) return false;
  const auto* numbers = std::get_if<std::vector<double>>(&item->second);
  return numbers && *numbers == std::vector{1.0};
}

/// A run that stands, as its checkpoint says.
RunOrder resumed_order(const RunOptions& options) {
  const fs::path file = fs::path{options.resume} / checkpoint_name;
  Checkpoint checkpoint = read_checkpoint(file, TALUS_VERSION);
  if (checkpoint.memory.contains("choices.integrator"))
    throw InputError{file.string() + ": it is of a shear cell; `talus cell --resume` takes it on"};
  const bool sheet = holds_sheet(checkpoint.memory);
  for (const auto& [name, given] : {std::pair{"--end", !options.end.empty()},
                                    {"--step", !options.step.empty()},
                                    {"--integrator", !options.integrator.empty()},
                                    {"--tolerance", options.tolerance != 0.0},
                                    {"--frames", options.frames != 0},
                                    {"--sheet", options.sheet && !sheet}}) {
    if (given) throw InputError{fmt::format("{}: a run that is taken on (--resume) keeps what it began with", name)};
  }
  const fs::path scene = options.scene.empty() ? fs::path{checkpoint.scene_file} : fs::path{options.scene};
  RunOrder order{.scene = scene,
                 .text = read_text(scene),
                 .file = {},
                 .folder = options.folder.empty() ? options.resume : options.folder,
                 .from = options.resume,
                 .name = checkpoint.scene_file,
                 .sheet = sheet,
                 .steps = checkpoint.steps,
                 .memory = std::move(checkpoint.memory)};
  if (fnv1a(order.text) != checkpoint.scene_fnv1a) {
    throw InputError{
        fmt::format("{}: scene_fnv1a: found {}, but {} has {}; it must be the scene as it was when the run "
                    "was stopped",
                    file.string(), checkpoint.scene_fnv1a, scene.string(), fnv1a(order.text))};
  }
  order.file = read_scene_file(scene);
  order.file.scene.integrator = make_integrator(checkpoint.integrator, checkpoint.tolerance);
  order.file.scene.plan.step = checkpoint.step;
  order.file.scene.plan.end = checkpoint.end;
  return order;
}

}  // namespace

RunOrder run_order(const RunOptions& options) {
  RunOrder order = options.resume.empty() ? new_order(options) : resumed_order(options);
  check_step_count(order.file.scene.plan);
  return order;
}

long last_step(const RunOptions& options, const RunOrder& order) {
  const Scene& scene = order.file.scene;
  const RunPlan& plan = scene.plan;
  const double start = scene.initial.t;
  const auto steps_to = [&](double time) {
    return step_count({.step = plan.step, .end = time - start, .interval = plan.interval, .ledger = plan.ledger});
  };
  const long all = steps_to(plan.end);
  if (options.until.empty()) return all;
  const UnitSystem& units = scene.model.units;
  const std::string unit = symbol(units, dimension::time);
  const double time = option_quantity("--until", options.until, dimension::time, units);
  const double stands = start + static_cast<double>(order.steps) * plan.step;
  // Not by steps: a time far beyond the end may be more of them than can be counted.
  if (time > plan.end && (time > 2.0 * plan.end || steps_to(time) > all)) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be at most {:.10g} {}, where the run ends",
                                 options.until, plan.end, unit)};
  }
  if (time <= stands || steps_to(time) <= order.steps) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be beyond {:.10g} {}, where the run stands",
                                 options.until, stands, unit)};
  }
  return steps_to(time);
}

}  // namespace talus::app
