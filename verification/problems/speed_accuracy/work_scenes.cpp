#include "verification/problems/speed_accuracy/work_scenes.hpp"

#include <memory>

#include "solver/stability/step_advice.hpp"
#include "verification/problems/speed_accuracy/exact_motions.hpp"
#include "verification/problems/speed_accuracy/fence_exit.hpp"
#include "verification/study/impacts/disc_bounce.hpp"
#include "verification/study/impacts/pivoted_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double round_off = 0.5 * std::numeric_limits<double>::epsilon();
constexpr int impact_phases = static_cast<int>(fewest_phases);

WorkScene of_motion(const ExactMotion& motion, double frequency) {
  WorkScene made{.name = motion.name,
                 .quantities = {"position and velocity"},
                 .scenes = {motion.scene},
                 .duration = motion.duration,
                 .spans = compared_times,
                 .runs = 1,
                 .frequency = frequency,
                 .floor = round_off,
                 .measure = {}};
  made.measure = [motion](const Integrator& integrator, long steps, int, Findings& findings) {
    const WorkPoint point = run_motion(motion, integrator, steps, findings);
    return WorkRun{{point.error}, point.evaluations};
  };
  return made;
}

/// Impacts whose exit speed is compared, at 64 phases of the touch within a step. Each phase has a different step, so
/// that the phase of the end of the contact differs, too.
struct ImpactScenes {
  std::string name;
  std::function<Scene(double gap)> scene_at;
  std::size_t coordinate{};
  double approach{};      ///< speed [L/T]
  double exit{};          ///< exact velocity of the coordinate after the impact [L/T]
  double contact_time{};  ///< [T]
  double frequency{};
  double floor{};
};

WorkScene of_impact(const ImpactScenes& impact, const Setup& setup) {
  WorkScene made{.name = impact.name,
                 .quantities = {"exit speed"},
                 .scenes = {},
                 .duration = std::numbers::e * impact.contact_time,
                 .spans = 4,
                 .runs = impact_phases,
                 .frequency = impact.frequency,
                 .floor = impact.floor,
                 .measure = {}};
  for (const double phase : even_phases(fewest_phases))
    made.scenes.push_back(
        impact.scene_at(impact.approach * impact.contact_time * phase / static_cast<double>(made.spans)));
  const bool commensurate = setup.has("commensurate");
  made.measure = [impact, commensurate](const Integrator& integrator, long steps, int run, Findings& findings) {
    constexpr long spans = 4;
    const auto phase = static_cast<std::size_t>(run);
    const double contact_steps = static_cast<double>(spans * steps) / std::numbers::e;
    const double step = commensurate ? impact.contact_time / std::ceil(contact_steps)
                                     : offset_step(impact.contact_time, contact_steps, phase);
    const Scene scene = impact.scene_at(impact.approach * step * even_phases(fewest_phases)[phase]);
    const RunEnd end = run_steps(scene, integrator, step, spans * steps, findings);
    return WorkRun{{std::abs(end.state.v[impact.coordinate] / impact.exit - 1.0)},
                   static_cast<double>(end.evaluations)};
  };
  return made;
}

/// A disc of mass, stiffness and speed 1 on a wall.
WorkScene wall_impact(const char* name, double xi, const Setup& setup) {
  Bounce disc;
  disc.xi = xi;
  disc.law = LinearSpringDashpot{1.0, 2.0 * xi, EndRule::clamped};
  const auto exact = reference::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, reference::EndRule::clamped);
  return of_impact({.name = name,
                    .scene_at = [disc](double gap) { return disc_at(disc, gap); },
                    .coordinate = 1,
                    .approach = 1.0,
                    .exit = exact.restitution,
                    .contact_time = exact.contact_time,
                    .frequency = 1.0,
                    .floor = round_off},
                   setup);
}

/// The rock on the pinned column of the 1993 report's problem 2; the contact may be attractive, as Eq. 21 assumes.
WorkScene column_impact(const Setup& setup) {
  const PivotedRun run{.rule = EndRule::attractive};
  const reference::PivotedCylinder problem{};
  const auto exact = reference::soft_impact(problem, contact_of(run));
  return of_impact({.name = "pinned column",
                    .scene_at =
                        [run](double gap) {
                          PivotedRun from = run;
                          from.gap = gap;
                          return scene_of(from, {});
                        },
                    .coordinate = 1,
                    .approach = problem.approach_speed,
                    .exit = exact.at_end.rock_vx,
                    .contact_time = exact.at_end.t,
                    .frequency = frequency_of(run),
                    .floor = 1e-12},
                   setup);
}

WorkScene fence_scene_of_table_2() {
  constexpr double end = 0.2;
  constexpr long spans = 500;
  const auto hit = std::make_shared<FenceHit>(fence_hit());
  Findings uncounted;
  const FenceExit best = run_fence(*hit, make_integrator("stormer_cowell", 1e-13), {end, spans}, uncounted);
  const Dynamics dynamics{hit->scene.model};
  WorkScene made{.name = "fence",
                 .quantities = {"exit speed", "largest tension"},
                 .scenes = {hit->scene},
                 .duration = end,
                 .spans = spans,
                 .runs = 1,
                 .frequency = advise_step(dynamics, hit->scene.initial).highest_frequency(),
                 .floor = 1e-11,
                 .measure = {}};
  made.measure = [hit, best](const Integrator& integrator, long steps, int, Findings& findings) {
    const FenceExit found = run_fence(*hit, integrator, {end, spans, steps}, findings);
    return WorkRun{{std::abs(found.speed / best.speed - 1.0), std::abs(found.tension / best.tension - 1.0)},
                   found.evaluations};
  };
  return made;
}

}  // namespace

std::vector<WorkScene> work_scenes(const Setup& setup, bool fence) {
  const bool full = setup.tier == Tier::full && !setup.coarse;
  std::vector<ExactMotion> motions = exact_motions();
  if (setup.has("other_amplitude")) motions.front().scene.initial.q[0] += 1e-3;
  const double swing = std::sqrt(9.81);
  std::vector<WorkScene> all;
  all.push_back(of_motion(motions[0], swing));
  all.push_back(of_motion(motions[1], swing));
  all.push_back(of_motion(motions[2], std::sqrt(8.0)));  // sqrt(2 k/m): limit at large displacement
  all.push_back(of_motion(motions[3], 100.0));
  const double budgets[] = {1.7e5, 1.7e5, 8.5e4, 2.4e5};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].budget = budgets[i];
  all.back().runs = full ? 16 : 8;
  all.push_back(wall_impact("wall, undamped", 0.0, setup));
  all.push_back(wall_impact("wall, damped", 0.2, setup));
  all.push_back(column_impact(setup));
  for (std::size_t i = all.size() - 3; i < all.size(); ++i)
    all[i].budget = 7e4;
  if (fence) {
    all.push_back(fence_scene_of_table_2());
    all.back().runs = full ? 8 : 2;
    all.back().budget = 4e4;
  }
  for (WorkScene& scene : all) {
    scene.tolerance_ratio = full || scene.runs == 1 ? std::sqrt(0.1) : 0.1;
    if (full) scene.budget *= scene.name == "fence" ? 50.0 : scene.runs == 1 ? 8.0 : 10.0;
  }
  return all;
}

}  // namespace talus::verification::problems
