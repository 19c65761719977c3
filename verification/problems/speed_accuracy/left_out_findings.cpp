#include "verification/problems/speed_accuracy/left_out_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/study/fence_table.hpp"
#include "verification/study/lively_scenes.hpp"
#include "verification/study/moved_scene.hpp"

namespace talus::verification::problems {
namespace {

/// A system that works out every gap of every pair, however far apart, at each evaluation.
class EveryPair {
 public:
  explicit EveryPair(const Dynamics& dynamics)
      : dynamics_{&dynamics}, work_{dynamics.workspace()}, rates_{rest_state(dynamics.model())} {}

  void drift(State& state, double h) {
    if (!dynamics_->follows_motion()) return drift_coordinates(state, h);
    drift_coordinates(state, 0.5 * h);
    dynamics_->update_all(state, work_);
    dynamics_->memory_rates(state, work_, rates_);
    for (std::size_t i = 0; i < state.z.size(); ++i)
      state.z[i] += h * rates_.z[i];
    drift_coordinates(state, 0.5 * h);
  }
  void begin(State& state) {
    dynamics_->update_all(state, work_);
    dynamics_->begin(state, work_);
  }
  void settle(State& state) {
    dynamics_->update_all(state, work_);
    dynamics_->settle(state, work_);
  }
  void settle(State& state, const State& before) {
    dynamics_->update_all(state, work_);
    dynamics_->settle(state, work_, &before);
  }
  void derivative(const State& state, Rates& out) {
    dynamics_->update_all(state, work_);
    dynamics_->rates(state, work_, out, true, true);
  }
  void evaluate(State& state, Rates& out) {
    settle(state);
    dynamics_->rates(state, work_, out, true);
  }

  // For steps between located events.
  Prospect guards(const State& state, bool, double, std::vector<double>& out) {
    dynamics_->update_all(state, work_);
    out.resize(state.mode.size());
    return {dynamics_->guards(state, work_, out), dynamics_->longest_step(work_)};
  }
  void guards_of(const State& state, std::span<const std::size_t>, std::span<double> out) {
    dynamics_->update_all(state, work_);
    dynamics_->guards(state, work_, out);
  }
  bool follows(const State& state) const { return dynamics_->follows(state); }
  std::vector<double> lengths() const { return dynamics_->lengths(); }
  bool moves_memory() const { return dynamics_->follows_motion(); }
  void wake_all(State& state) const { dynamics_->wake_all(state); }

 private:
  const Dynamics* dynamics_;
  Workspace work_;
  Rates rates_;
};

/// Looks out for nothing that does not act yet.
struct ShortSighted : RigidBodySystem {
  Prospect guards(const State& state, bool same, double ahead, std::vector<double>& out) {
    const Prospect found = RigidBodySystem::guards(state, same, ahead, out);
    for (std::size_t i = 0; found.finite && i < out.size(); ++i)
      out[i] = state.mode[i] == 0 ? std::numeric_limits<double>::infinity() : out[i];
    return found;
  }
};

template <class Method, class System, class Watch>
State stepped(const Scene& scene, const Dynamics& dynamics, Method method, System&& system, double step, long count,
              Watch&& watch) {
  State state = scene.initial;
  system.begin(state);
  method.start(system, state, step);
  for (long n = 0; n < count; ++n) {
    method.step(system, state, step);
    watch(dynamics, state);
  }
  return state;
}

void check_pairs(Findings& findings, const Setup& setup, Table& table, const char* name, const Scene& scene,
                 double step, long count) {
  const Dynamics dynamics{scene.model};
  Model less = scene.model;
  if (setup.has("pair_forgotten")) less.contacts.front().law = LinearSpringDashpot{1e-9, 0.0, EndRule::clamped};
  const Dynamics searched{less};
  Workspace work = searched.workspace();
  double near = 0.0;
  const auto watch = [&](const Dynamics& by, const State& state) {
    by.update(state, work);
    near += static_cast<double>(std::count(work.near.begin(), work.near.end(), char{1})) / static_cast<double>(count);
  };
  const auto unwatched = [](const Dynamics&, const State&) {};
  const State visited = stepped(scene, searched, VelocityVerlet{}, RigidBodySystem{searched, true}, step, count, watch);
  const State all = stepped(scene, dynamics, VelocityVerlet{}, EveryPair{dynamics}, step, count, unwatched);
  findings.count(2 * count);
  findings.expect(fmt::format("{}: state at the end from that with every pair, largest difference", name),
                  change(visited, all), 0.0,
                  Tolerance::exact("bodies out of reach push nothing, and a node outside its target neither"));
  StormerCowell located;
  located.tolerance = 1e-8;
  // As far as a tenth of the way: between crowded bodies events follow each other closely.
  const double interval = 0.1 * step * static_cast<double>(count);
  const State every = stepped(scene, dynamics, located, EveryPair{dynamics}, interval, 1, unwatched);
  const State ahead =
      setup.has("no_time_ahead")
          ? stepped(scene, dynamics, located, ShortSighted{RigidBodySystem{dynamics, true}}, interval, 1, unwatched)
          : stepped(scene, dynamics, located, RigidBodySystem{dynamics, true}, interval, 1, unwatched);
  findings.expect(fmt::format("{}, located events: state from that with every guard, largest difference", name),
                  change(ahead, every), 0.0,
                  Tolerance::exact("bodies that at their speed do not meet in five steps end no mode in one"));
  table.rows.push_back({fmt::format("pairs within reach, {}", name),
                        fmt::format("{}", dynamics.contacts().candidates()), fmt::format("{:.2f}", near), "none"});
}

/// Discs thrown together, each paired with each.
Scene thrown_discs() {
  constexpr int side = 4;
  std::mt19937 random{7};
  std::uniform_real_distribution<double> nudge{-0.2, 0.2};
  ModelBuilder builder;
  std::vector<BodyId> discs;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 place{2.6 * (i % side) + nudge(random), 2.6 * (i / side) + nudge(random)};
    discs.push_back(builder.add(
        Body{.name = fmt::format("disc{}", i), .mass = 1.0, .inertia = 0.4, .shape = Circle{1.0}, .p_WB = place}));
    for (int other = 0; other < i; ++other) {
      builder.add(Contact{.name = fmt::format("{}-{}", other, i),
                          .a = discs[static_cast<std::size_t>(other)],
                          .b = discs.back(),
                          .law = LinearSpringDashpot{4e3, 3.0, EndRule::clamped}});
    }
  }
  Scene scene{.title = "Thrown discs", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  for (const BodyId disc : discs) {
    const Vec2 place = scene.model.bodies[index(disc)].p_WB;
    set_velocity(scene.model, scene.initial, disc, {1.5 * (4.0 - place.x), 1.5 * (4.0 - place.y)}, 0.0);
  }
  return scene;
}

}  // namespace

double change(const State& a, const State& b) {
  const auto [place, velocity] = difference(a, b);
  if (place > 0.0 || velocity > 0.0) return std::max(place, velocity);
  return a.z == b.z && a.work == b.work ? place + velocity : std::nan("");
}

void check_contacts(Findings& findings, const Setup& setup, Table& table) {
  check_pairs(findings, setup, table, "yard", crowded_yard(), 1.0 / 4096.0, 3000);
  if (setup.coarse) return;
  check_pairs(findings, setup, table, "16 discs", thrown_discs(), 1.0 / 2048.0, 3000);
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.layers = 2;
  fence.options.start = scenes::FenceStart::plain;
  check_pairs(findings, setup, table, "fence of two layers", scenes::fence_scene(fence).scene, 1e-5, 5000);
}

void check_rows(Findings& findings, const Setup& setup, Table& table) {
  scenes::Fence fence = rough_fence();
  fence.options.hanger_strength = 0.0;  // where cables go on through broken hangers there are no rows
  fence.options.start = scenes::FenceStart::plain;
  const Scene scene = scenes::fence_scene(fence).scene;
  const Dynamics dynamics{scene.model};
  Model other = scene.model;
  if (setup.has("line_of_another") || setup.has("paths_of_another"))
    std::get<ElasticPlastic>(other.cables.front().law).stiffness *= 1.0 + 1e-15;
  const Dynamics asked{other};
  const auto unwatched = [](const Dynamics&, const State&) {};
  constexpr long count = 5000;
  const State told = stepped(scene, asked, VelocityVerlet{}, RigidBodySystem{asked, true}, 1e-5, count, unwatched);
  Workspace work = dynamics.workspace(), laws = asked.workspace();
  LawForces forces;
  Rates rates{scene.initial};
  double largest = 0.0, by_law = 0.0;
  const auto watch = [&](const Dynamics&, const State& state) {
    dynamics.update(state, work);
    dynamics.rates(state, work, rates, false);
    asked.update_all(state, laws);
    asked.forces(state, laws, forces);
    for (const auto& runs : work.waking.cables) {
      for (const CableRun& run : runs) {
        if (!run.quiet) by_law += static_cast<double>(run.count) / count;
        for (std::size_t c = run.cable; c < run.cable + run.count; ++c)
          largest = std::max(largest, std::abs(work.paths.tension[c] - forces.tensions[c]));
      }
    }
  };
  const State bare = stepped(scene, dynamics, VelocityVerlet{}, RigidBodySystem{dynamics, false}, 1e-5, count, watch);
  const auto [place, velocity] = difference(bare, told);
  findings.count(2 * count);
  findings.expect("without ledger, paths not told: state at the end from that with, largest difference",
                  std::max(place, velocity), 0.0,
                  Tolerance::exact("what pulls on bodies is the same sum, whether the paths are kept or not"));
  findings.expect("tensions of rows of cables from those of the laws, one by one, largest difference over a run",
                  largest, 0.0, Tolerance::exact("the same operations on the same numbers, several at a time"), "lb");
  table.rows.push_back({"cables asked by their laws, fence that yields", fmt::format("{}", scene.model.cables.size()),
                        fmt::format("{:.2f}", by_law), "none"});
}

}  // namespace talus::verification::problems
