#include "solver/app/outputs/output_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/app/outputs/geometry_output.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "solver/io/fence1993/out_listing.hpp"
#include "solver/io/output/fence_history.hpp"
#include "solver/io/output/write_geometry.hpp"
#include "solver/run/history.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

namespace talus::app {
namespace {

/// Bytes of a number and its comma in a CSV file: a changing number (17 digits), and zero.
constexpr double full = 19.0, zero = 2.0;
/// Bytes of summary.json and plot.json for each column of the history, and of final_state.json for each body.
constexpr double bytes_of_column = 255.0 + 165.0, bytes_of_body = 250.0;

/// Number of records of a run: one at the start, one every `every` steps, and one at the last step.
long records(long steps, long every) { return steps / every + (steps % every == 0 ? 1 : 2); }

/// Result of the first steps of a run.
struct Pilot {
  std::vector<double> row;  ///< of the history, after these steps
  State state;
};

Pilot pilot(const Scene& scene, const Dynamics& dynamics) {
  constexpr double steps = 16.0;
  RigidBodySystem system{dynamics, scene.plan.ledger};
  Integrator integrator = scene.integrator;
  Pilot made{{}, scene.initial};
  RunPlan plan = scene.plan;
  plan.end = std::min(plan.end, scene.initial.t + steps * plan.step);
  Recorder recorder{dynamics, scene.initial, plan.ledger};
  const Observer observers[] = {std::ref(recorder)};
  static_cast<void>(simulate(system, integrator, made.state, plan, observers));
  made.row = recorder.row();
  return made;
}

/// Mean bytes of a row's time; it is not `full`, because some times are round numbers.
double bytes_of_time(const Scene& scene, long every) {
  constexpr int samples = 16;
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double time = scene.initial.t + static_cast<double>(every * (7 * i + 1)) * scene.plan.step;
    sum += static_cast<double>(fmt::formatted_size("{},", time));
  }
  return sum / samples;
}

/// Mean bytes of a column's number that is zero after the first steps: a fraction of `full` if it may change later.
double bytes_of_zero(const SceneFile& file, std::string_view name) {
  const Model& model = file.scene.model;
  const auto ends = [&](std::initializer_list<std::string_view> parts) {
    return std::ranges::any_of(parts, [&](std::string_view part) { return name.ends_with(part); });
  };
  const auto partly = [](double fraction) { return zero + fraction * (full - zero); };
  if (name.starts_with("balance_error.")) return partly(0.8);
  if (name.starts_with("dissipated.")) {
    const bool contacts = name.starts_with("dissipated.contact_damping") && !model.contacts.empty();
    const bool friction = name.starts_with("dissipated.friction") &&
                          std::ranges::any_of(model.contacts, [](const Contact& c) { return c.friction.has_value(); });
    return contacts || friction ? partly(0.7) : zero;
  }
  if (name.starts_with("energy.")) return name == "energy.contacts" && !model.contacts.empty() ? partly(0.3) : zero;
  if (ends({".x", ".y", ".vx", ".vy", ".angle", ".spin"})) return partly(file.fence ? 1.0 : 0.3);
  if (ends({".tension"})) return partly(0.5);
  // A body touches only few others at a time.
  if (ends({".force"})) return partly(0.3 / std::max<double>(1.0, static_cast<double>(model.contacts.size()) / 4.0));
  return full;
}

/// Bytes of the additional files of a fence's run.
double fence_bytes(const FenceInput& input, const RunPlan& plan, const Dynamics& dynamics, long steps) {
  const FenceHistory history{input.fence, input.made, dynamics};
  const OutListing listing{input.fence, input.made, plan};
  const auto members = static_cast<double>(input.made.members.size());
  const auto columns = input.fence.requests_histories() ? static_cast<double>(history.history().columns.size()) : 0.0;
  const auto states = static_cast<double>(steps / input.fence.print_every);
  const auto rows = static_cast<double>(records(steps, input.fence.history_every));
  constexpr double listing_line = 71.0, listing_head = 95.0;
  constexpr double csv = 17.0, json = 22.0;  // some histories are zero for a while
  return static_cast<double>(listing.text().size()) + states * (members * listing_line + listing_head) +
         rows * columns * (csv + json);
}

}  // namespace

OutputSize expected_output(const SceneFile& file, const Dynamics& dynamics, const std::filesystem::path& scene_file) {
  const Scene& scene = file.scene;
  RunPlan plan = scene.plan;
  plan.end -= scene.initial.t;
  const long steps = step_count(plan);
  const long every = std::max(1L, std::lround(std::min(plan.interval / plan.step, 1e15)));
  const std::vector<Column> columns = history_columns(scene.model, plan.ledger);
  OutputSize size{.rows = records(steps, every),
                  .columns = columns.size(),
                  .states = records(steps, steps_between_states(file, 0)),
                  .bytes = 0.0};
  const Pilot seen = pilot(scene, dynamics);
  double row = bytes_of_time(scene, every);
  for (std::size_t i = 1; i < columns.size(); ++i)
    row += seen.row[i] != 0.0 ? full : bytes_of_zero(file, columns[i].name);
  const auto states = static_cast<double>(size.states);
  const std::string state = GeometryText{dynamics}.text(Snapshot{dynamics, seen.state}).value_or("");
  const double index_line = 76.0 + 2.0 * static_cast<double>(scene_file.stem().string().size());
  size.bytes = static_cast<double>(size.rows) * row + states * (static_cast<double>(state.size()) + index_line) +
               static_cast<double>(size.columns) * bytes_of_column +
               static_cast<double>(scene.model.bodies.size()) * bytes_of_body;
  if (file.fence) size.bytes += fence_bytes(*file.fence, scene.plan, dynamics, steps);
  return size;
}

OutputSize expected_output(const CellScene& scene, CellRun& run) {
  // Enough steps for discs to move and some to touch.
  constexpr double pilot_steps = 1e7;
  constexpr long maximum_samples = 16;
  const long last =
      std::min(run.last_step(), 1 + static_cast<long>(pilot_steps / static_cast<double>(1 + run.cell().free_discs())));
  // Averaged over several states, because the number of contacts fluctuates.
  double of_state = 0.0;
  int samples = 0;
  while (run.steps() < last && run.failure().empty()) {
    run.advance();
    if (scene.pictures && (samples + 1) * last <= maximum_samples * run.steps())
      of_state += static_cast<double>(cell_state_vtp(run).size()), ++samples;
  }
  const auto outputs = static_cast<long>(scene.plan.outputs());
  OutputSize size{.rows = outputs,
                  .columns = cell_history(scene, run).columns.size(),
                  .states = scene.pictures ? outputs : 0,
                  .bytes = 0.0};
  constexpr double number = 17.8, index_line = 70.0;
  constexpr double of_summary = 4900.0, of_plot = 5650.0, of_layer = 125.0;
  const double layers = 2.0 * run.cell().rows + 4.0;
  size.bytes = static_cast<double>(size.rows) * static_cast<double>(size.columns) * number + of_summary + of_plot +
               layers * of_layer + static_cast<double>(cell_restart_text(run.cell(), run.discs(), run.steps()).size());
  if (scene.pictures) {
    if (samples == 0) of_state = static_cast<double>(cell_state_vtp(run).size()), samples = 1;
    size.bytes += static_cast<double>(size.states) * (of_state / samples + index_line) +
                  static_cast<double>(cell_picture_text(run.cell(), run.discs()).size());
  }
  return size;
}

std::string output_size_text(const OutputSize& size) {
  const std::string states = size.states > 0 ? fmt::format(", {} states of the geometry", size.states) : "";
  const auto [scale, unit] = size.bytes < 1e6   ? std::pair{1e3, "kB"}
                             : size.bytes < 1e9 ? std::pair{1e6, "MB"}
                                                : std::pair{1e9, "GB"};
  return fmt::format("{} history rows x {} columns{}, about {:.3g} {}", size.rows, size.columns, states,
                     size.bytes / scale, unit);
}

}  // namespace talus::app
