#include "verification/problems/program/recorded/recorded_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solver/cell/cell_run.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/packing.hpp"
#include "solver/granular/stress.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/run/history.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/scenes/pendulum.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "solver/stability/run_monitor.hpp"
#include "verification/check/case_file.hpp"
#include "verification/study/runs/fingerprint.hpp"
#include "verification/study/runs/scene_run.hpp"
#include "verification/study/scenes/scenes_in_motion.hpp"
#include "verification/study/scenes/varied_scenes.hpp"

namespace talus::verification::problems {
namespace {

using Take = std::function<void(const RunResult&)>;

template <class Object, class... More>
ArchiveItems saved(Object& object, More&... more) {
  Archive saving;
  if constexpr (requires { object.serialize(saving, more...); }) {
    object.serialize(saving, more...);
  } else {
    serialize(saving, object);
  }
  return saving.items();
}

/// 1 if an object, restored from the saved items of another, differs from these items; otherwise 0.
template <class Object, class... More>
int differs_restored(const ArchiveItems& items, Object& object, More&... more) {
  Archive loading{items};
  object.serialize(loading, more...);
  return fingerprint(items) == fingerprint(saved(object, more...)) && loading.left_over().empty() ? 0 : 1;
}

// --- Bodies -------------------------------------------------------------------------------------

/// The springs and dashpots that act in a state, and the longest step there.
ArchiveItems linear_parts(const Dynamics& dynamics, const State& state) {
  const Snapshot seen{dynamics, state};
  LinearSegment piece;
  dynamics.linearization(state, seen.geometry(), piece);
  std::vector<double> terms;
  for (const LinearSegment::Term& term : piece.terms)
    terms.insert(terms.end(),
                 {static_cast<double>(term.row), static_cast<double>(term.column), term.stiffness, term.damping});
  for (const LinearSegment::MemoryTerm& term : piece.memory)
    terms.insert(terms.end(), {static_cast<double>(term.row), static_cast<double>(term.column), term.slope});
  for (const LinearSegment::MemoryPull& term : piece.pulls)
    terms.insert(terms.end(), {static_cast<double>(term.row), static_cast<double>(term.column), term.pull});
  return {{"terms", terms},
          {"lengths", dynamics.lengths()},
          {"longest_step", std::vector{dynamics.longest_step(seen.geometry())}}};
}

/// Final state of the same run without observers and without the energy ledger.
ArchiveItems unseen(const Scene& scene, Findings& findings) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  RunState run_state = initial_run_state(scene.integrator, scene.initial);
  RunPlan plan = scene.plan;
  plan.ledger = false;
  const Outcome outcome = simulate(system, run_state, plan);
  findings.count(system.evaluations());
  ArchiveItems items = saved(run_state);
  items["outcome"] = std::vector{static_cast<double>(outcome.kind), outcome.time};
  return items;
}

void run_bodies(const std::string& group, const std::string& name, const SceneFile& file, Findings& findings,
                const Take& take) {
  const Scene& scene = file.scene;
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, scene.plan.ledger};
  RunState run_state = initial_run_state(scene.integrator, scene.initial);
  const State first = first_state(scene);
  Recorder recorder{dynamics, first, scene.plan.ledger};
  std::optional<scenes::FenceMonitor> watch;
  if (file.fence) watch.emplace(file.fence->fence, file.fence->made, dynamics);
  RunMonitor limits{scene, dynamics, first};
  const std::vector<Observer> observers{[&](const Snapshot& seen, const StepInfo& info) {
    recorder(seen, info);
    limits.check(seen, info.step);
    if (watch) (*watch)(seen, info);
  }};
  const Outcome outcome = simulate(system, run_state, scene.plan, observers);
  findings.count(system.evaluations());
  RunResult run{group, name, {}, 0};
  const ArchiveItems end = saved(run_state);
  run.parts["end"] = end;
  run.parts["end"]["outcome"] = std::vector{static_cast<double>(outcome.kind), outcome.time};
  run.parts["history"] = saved(recorder);
  run.parts["limits"] = saved(limits);
  run.parts["unseen"] = unseen(scene, findings);
  if (watch) run.parts["fence"] = saved(*watch);
  if (outcome) {
    run.parts["linear"] = linear_parts(dynamics, synchronized(run_state, system, scene.plan));
    RunMonitor other_limits{scene, dynamics, first};
    run.not_restored += differs_restored(run.parts["limits"], other_limits);
    RunState other = initial_run_state(scene.integrator, scene.initial);
    run.not_restored += differs_restored(end, other);
    Recorder again{dynamics, first, scene.plan.ledger};
    run.not_restored += differs_restored(run.parts["history"], again);
    if (watch) {
      scenes::FenceMonitor other_watch{file.fence->fence, file.fence->made, dynamics};
      run.not_restored += differs_restored(run.parts["fence"], other_watch);
    }
  }
  take(run);
}

void run_as_written(Findings& findings, const Take& take) {
  for (const VariedScene& varied : varied_scenes())
    run_bodies("scenes", varied.name, {read_scene(varied.text, varied.name), {}}, findings, take);
  for (const char* name :
       {"cable_pendulum", "damped_disc", "pendulum", "pivoted_cylinder", "rolling_disc", "sliding_block", "two_cable"})
    run_bodies("scenes", fmt::format("{}.toml", name), read_scene_file(case_file(fmt::format("{}.toml", name))),
               findings, take);
  std::vector<VariedScene> fences = varied_fences();
  for (const VariedScene& even : even_fences())
    fences.push_back(even);
  for (const VariedScene& varied : fences)
    run_bodies("fences", varied.name, read_scene_file(varied.text, varied.name), findings, take);
  // Decks of 1993, with steps of fixed length.
  for (const char* name :
       {"table_2", "appendix_one_layer", "appendix_two_layers", "appendix_top_cable_only", "appendix_nine_rocks"}) {
    SceneFile file = read_scene_file(case_file("fence") / fmt::format("{}.DAT", name));
    file.scene.plan.end = std::min(file.scene.plan.end, 6000.0 * file.scene.plan.step);
    file.scene.plan.interval = 20.0 * file.scene.plan.step;
    run_bodies("fences", fmt::format("{}.DAT", name), file, findings, take);
  }
}

/// Runs scenes in which every kind of force acts, with every integrator.
void run_methods(Findings& findings, const Setup& setup, const Take& take) {
  struct Run {
    std::string name;
    Scene scene;
    double step, end;
  };
  Scene yard = mixed_pile();
  if (setup.has("gravity_one_ulp")) yard.model.gravity.y = std::nextafter(yard.model.gravity.y, 0.0);
  const LinearSpringDashpot law{1e5, 300.0, EndRule::clamped};
  const scenes::FenceScene fence = scenes::fence_scene(rough_fence());
  std::vector<Run> runs{{"yard", yard, 1e-3, 0.6}};
  if (!setup.coarse) {
    runs.push_back({"free group", free_group(), 1e-3, 1.0});
    runs.push_back({"two cables", scenes::two_cable({.contact = law}), 1e-4, 0.5});
    runs.push_back({"cable pendulum", scenes::cable_pendulum({.amplitude = 1.0}), 1e-3, 1.0});
    runs.push_back({"column by nodes",
                    scenes::pivoted_cylinder({.rock_radius = 1.5, .contact = law, .method = ContactMethod::nodes}),
                    1e-4, 0.4});
    runs.push_back({"Hertzian column", scenes::pivoted_cylinder({.contact = Hertz{1e6, 1.5, 100.0}}), 1e-4, 0.4});
    runs.push_back({"latching disc",
                    scenes::bouncing_disc({.gap = 0.1, .gravity = 9.81, .contact = LatchingSpring{1e4, 2e4, 0.5}}),
                    1e-3, 2.0});
    runs.push_back({"bouncing disc", scenes::bouncing_disc({.gap = 0.5, .gravity = 9.81, .contact = law}), 1e-3, 2.0});
    runs.push_back({"rough fence", fence.scene, 2e-5, 0.03});
  }
  for (Run& run : runs) {
    for (const std::string& name : integrator_names()) {
      if (setup.coarse && name != "velocity_verlet") continue;
      if (needs_closed_form(name) != (run.name == "bouncing disc" && name == "exact")) continue;
      run.scene.integrator = make_integrator(name, needs_tolerance(name) ? 1e-8 : 0.0);
      run.scene.plan = {.step = run.step, .end = run.end, .interval = 10.0 * run.step, .ledger = true};
      run_bodies("integrators", fmt::format("{}, {}", run.name, name), {run.scene, {}}, findings, take);
    }
  }
}

// --- Discs --------------------------------------------------------------------------------------

struct NamedLaw {
  const char* name;
  DiscLaw law;
};

/// All laws with their options.
std::vector<NamedLaw> laws(double stiffness, double damping) {
  return {{"latching", LatchingSpring{stiffness, stiffness / 0.49, 0.0}},
          {"latching, growing", LatchingSpring{stiffness, 1.2 * stiffness, 5.0}},
          {"dashpot, clamped", LinearSpringDashpot{stiffness, damping}},
          {"dashpot, attractive", LinearSpringDashpot{stiffness, damping, EndRule::attractive}}};
}

void run_cell(const ShearCell& cell, CellPlan plan, const std::string& name, Findings& findings, const Take& take) {
  CellRun cell_run{cell, plan};
  while (!cell_run.finished() && cell_run.failure().empty())
    cell_run.advance();
  findings.count(cell_run.evaluations());
  RunResult run{"cells", name, {}, 0};
  run.parts["end"] = saved(cell_run);
  std::vector<double> means, intervals;
  for (std::size_t k = 0; k < static_cast<std::size_t>(CellQuantity::count); ++k) {
    const auto quantity = static_cast<CellQuantity>(k);
    const Estimate mean = cell_run.mean(quantity);
    means.insert(means.end(), {mean.value, mean.error, cell_run.drift(quantity)});
    for (std::size_t i = 0; i < cell_run.intervals(); ++i)
      intervals.push_back(cell_run.interval_mean(i, quantity));
  }
  const Estimate ratio = cell_run.ratio(CellQuantity::top_shear, CellQuantity::top_normal);
  means.insert(means.end(), {ratio.value, ratio.error});
  std::vector<double> layers;
  for (const CellProfile::Layer& layer : cell_run.profile().layers())
    for (const Estimate& one : {Estimate{layer.y, 0.0}, layer.velocity, layer.temperature, layer.spin, layer.fraction})
      layers.insert(layers.end(), {one.value, one.error});
  const CellRun::Ledger ledger = cell_run.ledger();
  std::vector<double> energies{ledger.kinetic,    ledger.potential,     ledger.stored,       ledger.input,
                               ledger.dissipated, ledger.friction_work, ledger.spurious_gain};
  std::vector<double> contacts;
  for (const CellRun::ActingContact& contact : cell_run.acting_contacts())
    contacts.insert(contacts.end(),
                    {static_cast<double>(contact.a), static_cast<double>(contact.b), contact.depth, contact.force,
                     contact.friction, contact.stored, contact.multiple ? 1.0 : 0.0, contact.sliding ? 1.0 : 0.0});
  const FilledCell& start = cell_run.start();
  run.parts["summary"] = {
      {"means", means},
      {"intervals", intervals},
      {"layers", layers},
      {"energies", energies},
      {"contacts", contacts},
      {"limits", std::vector{cell_run.largest_overlap(), cell_run.largest_fraction(),
                             static_cast<double>(cell_run.jumped()), static_cast<double>(cell_run.evaluations()),
                             depth(cell, cell_run.discs()), sixfold_order(cell, start, cell_run.discs())}}};
  CellRun other{cell, plan};
  run.not_restored += differs_restored(run.parts["end"], other);
  take(run);
}

void run_cells(Findings& findings, const Take& take) {
  for (const auto& [law_name, law] : laws(1.7e4, 0.02)) {
    for (const bool rubs : {false, true}) {
      ShearCell cell = ice_cell(8e3, 5e3);
      cell.law = law;
      if (rubs) cell.friction = CoulombFriction{0.5, 1.4e4};
      const double step = cell.contact_time() / 20.0;
      const std::string name = fmt::format("{}, {}", law_name, rubs ? "rough" : "smooth");
      CellPlan plan{.step = step, .every = 400.0 * step, .end = 1900.0 * step};
      for (const std::string& method : disc_method_names()) {
        plan.integrator = method;
        if (validation_errors(cell, plan).empty()) run_cell(cell, plan, name + ", " + method, findings, take);
      }
      plan.integrator = "velocity_verlet", plan.images = Images::virtual_discs;
      run_cell(cell, plan, name + ", virtual discs", findings, take);
      // Few, hard discs, which are in free flight most of the time.
      cell.rows = 2, cell.columns = 4;
      plan.images = Images::nearest, plan.jump = true, plan.end = 40000.0 * step, plan.every = 0.25 * plan.end;
      run_cell(cell, plan, name + ", few discs", findings, take);
    }
  }
}

std::vector<double> numbers(const Virial& sums) { return {sums.xx, sums.xy, sums.yx, sums.yy}; }

ArchiveItems items_of(const Packing& packing) {
  return {{"radius", packing.shapes.radius},
          {"inverse_mass", packing.shapes.inverse_mass},
          {"x", packing.discs.x},
          {"y", packing.discs.y},
          {"vx", packing.discs.vx},
          {"vy", packing.discs.vy},
          {"box", std::vector{packing.width, packing.height, packing.box.width, closest(packing)}}};
}

/// Runs the flow of the discs of one packing in one engine.
template <class System>
void run_flow(System system, const Packing& packing, const std::string& name, Findings& findings, const Take& take) {
  constexpr double step = 0.15;
  Discs discs = packing.discs;
  if constexpr (requires { system.keep_work(); }) system.keep_work();
  System other = system;
  system.begin(discs);
  for (int n = 0; n < 600; ++n)
    system.kick(discs, step), system.drift(discs, step);
  system.kick(discs, step);
  findings.count(system.evaluations());
  const ContactSums contacts = contact_sums(system, discs);
  std::vector<double> on_walls;
  for (std::size_t wall = 1; wall <= packing.shapes.walls.size(); ++wall)
    on_walls.insert(on_walls.end(), {system.wall_force(wall).x, system.wall_force(wall).y});
  const MeanFlow flow = mean_flow(packing.shapes, discs, packing.box.shear_rate);
  RunResult run{"packings", name, {}, 0};
  run.parts["discs"] = saved(discs);
  run.parts["contacts"] = saved(system, discs);
  run.not_restored = differs_restored(run.parts["contacts"], other, discs);
  run.parts["summary"] = {
      {"virial", numbers(contacts.virial)},
      {"kinetic", numbers(kinetic_virial(packing.shapes, discs, flow))},
      {"flow", std::vector{flow.speed, flow.shear_rate, temperature(packing.shapes, discs, flow)}},
      {"walls", on_walls},
      {"sums", std::vector{contacts.stored, contacts.largest_depth, static_cast<double>(contacts.contacts),
                           static_cast<double>(system.builds())}}};
  take(run);
}

template <class Law, class Friction>
void run_both(const Law& law, const Friction& friction, const Packing& packing, const std::string& name,
              Findings& findings, const Take& take) {
  run_flow(DiscSystem{packing.shapes, packing.box, law, 0.3, friction}, packing, name + ", plain", findings, take);
  run_flow(FastDiscSystem{packing.shapes, packing.box, law, 0.3, friction}, packing, name + ", fast", findings, take);
}

void run_packings(Findings& findings, const Take& take) {
  struct Named {
    const char* name;
    Packing packing;
  };
  PackingPlan plan{.discs = 90, .diameter = 1.0, .mass = 1.0, .solid_fraction = 0.45, .seed = 7};
  std::vector<Named> packings{{"scattered", scatter(plan)}};
  plan.spread = 0.2, plan.solid_fraction = 0.8;
  packings.push_back({"grown", grow(plan)});
  plan.aspect = 1.6, plan.walls = true, plan.solid_fraction = 0.7;
  packings.push_back({"grown between walls", grow(plan)});
  for (Named& one : packings) {
    const std::string name = one.name;
    Packing& packing = one.packing;
    take({"packings", name, {{"discs", items_of(packing)}}, 0});
    agitate(packing, 2e-3, 5);
    if (packing.shapes.walls.empty()) packing.box.shear_rate = 0.01;
    for (const auto& [law_name, law] : laws(0.5, 0.1)) {
      const std::string of = fmt::format("{}, {}", name, law_name);
      std::visit(
          [&](const auto& the_law) {
            run_both(the_law, Frictionless{}, packing, of + ", smooth", findings, take);
            run_both(the_law, CoulombFriction{0.5, 0.35}, packing, of + ", rough", findings, take);
          },
          law);
    }
  }
}

}  // namespace

void run_all(Findings& findings, const Setup& setup, const Take& take) {
  run_methods(findings, setup, take);
  if (setup.coarse) return;
  run_as_written(findings, take);
  run_cells(findings, take);
  run_packings(findings, take);
}

}  // namespace talus::verification::problems
