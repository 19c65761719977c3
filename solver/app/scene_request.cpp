#include "solver/app/scene_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/app/outputs/impact_output.hpp"
#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/run/simulate.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

/// Changes the end of the run. A history with the default number of rows keeps that number; likewise a fence's files.
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

/// Changes the step of the run. The history has at most one row a step.
void change_step(SceneFile& file, double step) {
  RunPlan& plan = file.scene.plan;
  plan.step = step;
  if (!file.fence) plan.interval = std::max(plan.interval, step);
}

/// Whether the interrupted run of a checkpoint was started with --sheet.
bool holds_sheet(const ArchiveItems& memory) {
  const auto item = memory.find("sheet");
  if (item == memory.end()) return false;
  const auto* numbers = std::get_if<std::vector<double>>(&item->second);
  return numbers && *numbers == std::vector{1.0};
}

/// Whether the interrupted run of a checkpoint was started with --impacts: it then has a part for this output.
bool holds_impacts(const ArchiveItems& memory) {
  const std::string part = fmt::format("outputs.{}.", ImpactOutput::name);
  const auto item = memory.lower_bound(part);
  return item != memory.end() && item->first.starts_with(part);
}

}  // namespace

GivenOptions SceneOptions::kept() const {
  return {{"--end", !end.empty()},
          {"--step", !step.empty()},
          {"--integrator", !integrator.empty()},
          {"--tolerance", tolerance != 0.0},
          {"--frames", frames != 0}};
}

void apply_options(const MethodOptions& options, SceneFile& file) {
  Scene& scene = file.scene;
  const UnitSystem& units = scene.model.units;
  if (!options.end.empty()) change_end(file, option_quantity("--end", options.end, dimension::time, units));
  bool needs_step = false;
  if (!options.integrator.empty() || options.tolerance != 0.0) {
    const std::string_view method = options.integrator.empty() ? name(scene.integrator) : options.integrator;
    if (const auto known = integrator_choices(); std::ranges::find(known, method) == known.end())
      throw unknown_name("integrator", method, known);
    // The scene's tolerance is kept for any method that accepts one.
    const bool takes_one = method == automatic_integrator || has_step_control(method);
    const double given = options.tolerance != 0.0 ? options.tolerance : talus::tolerance(scene.integrator);
    const double tolerance = takes_one || options.tolerance != 0.0 ? given : 0.0;
    const IntegratorChoice chosen = choose_integrator(scene.model, method, tolerance);
    // The step of a method with step control is its output interval; other methods cannot use it as their step.
    needs_step = chooses_steps(scene.integrator) && !chooses_steps(chosen.integrator);
    scene.integrator = chosen.integrator;
    scene.integrator_reason = chosen.why;
  }
  if (options.step == automatic_step_name || (needs_step && options.step.empty())) {
    change_step(file, automatic_step(scene));
  } else if (!options.step.empty()) {
    change_step(file, option_quantity("--step", options.step, dimension::time, units));
  }
}

SceneRequest scene_request(const SceneOptions& options) {
  if (options.resume.empty() && !options.until.empty() && options.folder.empty())
    throw InputError{"--until: it requires --out, the folder in which the run is saved"};
  SceneRequest request{.run = run_request("run", options, options.kept()),
                       .file = {},
                       .sheet = options.sheet,
                       .impacts = options.impacts};
  request.file = read_scene_text(request.run.text, request.run.scene);
  Scene& scene = request.file.scene;
  if (!request.run.resumes()) {
    if (options.sheet && (!request.file.fence || options.folder.empty()))
      throw InputError{"--sheet: it requires a fence (a deck or a scene with [fence]) and --out"};
    if (options.impacts && options.folder.empty())
      throw InputError{"--impacts: it requires --out, the folder in which impacts.csv is written"};
    apply_options(options, request.file);
  } else {
    const Checkpoint& saved = request.run.saved;
    request.sheet = holds_sheet(saved.memory);
    if (options.sheet && !request.sheet) throw kept_option("--sheet");
    request.impacts = holds_impacts(saved.memory);
    if (options.impacts && !request.impacts) throw kept_option("--impacts");
    try {
      scene.integrator = make_integrator(saved.integrator, saved.tolerance);
      change_end(request.file, saved.end);
      change_step(request.file, saved.step);
      check_step_count(scene.plan);
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: {}", (request.run.from / checkpoint_name).string(), error.what())};
    }
  }
  check_step_count(scene.plan);
  return request;
}

long last_step(const SceneOptions& options, const SceneRequest& request) {
  const Scene& scene = request.file.scene;
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
  const double reached = start + static_cast<double>(request.run.saved.steps) * plan.step;
  // Compares times first: the number of steps to a time far beyond the end may overflow.
  if (time > plan.end && (time > 2.0 * plan.end || steps_to(time) > all)) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be at most {:.10g} {}, where the run ends",
                                 options.until, plan.end, unit)};
  }
  if (time <= reached || steps_to(time) <= request.run.saved.steps) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be beyond {:.10g} {}, the current time of the run",
                                 options.until, reached, unit)};
  }
  return steps_to(time);
}

}  // namespace talus::app
