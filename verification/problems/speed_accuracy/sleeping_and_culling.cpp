#include <random>

#include "solver/scenes/fence_scene.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/scenes/moved_scene.hpp"
#include "verification/study/scenes/scenes_in_motion.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::sleeping_and_culling {
namespace {

/// A system that computes every gap of every pair, however far apart, at each evaluation.
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
  void update_modes(State& state) {
    dynamics_->update_all(state, work_);
    dynamics_->update_modes(state, work_);
  }
  void update_modes(State& state, const State& before) {
    dynamics_->update_all(state, work_);
    dynamics_->update_modes(state, work_, &before);
  }
  void derivative(const State& state, Rates& out) {
    dynamics_->update_all(state, work_);
    dynamics_->rates(state, work_, out, true, true);
  }
  void evaluate(State& state, Rates& out) {
    update_modes(state);
    dynamics_->rates(state, work_, out, true);
  }

  // For steps between located events.
  GuardBounds guards(const State& state, bool, double, std::vector<double>& out) {
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

/// A system with a fault: modes that do not act yet have infinite guards.
struct ShortSighted : RigidBodySystem {
  GuardBounds guards(const State& state, bool same, double horizon, std::vector<double>& out) {
    const GuardBounds found = RigidBodySystem::guards(state, same, horizon, out);
    for (std::size_t i = 0; found.finite && i < out.size(); ++i)
      out[i] = state.mode[i] == 0 ? std::numeric_limits<double>::infinity() : out[i];
    return found;
  }
};

template <class Method, class System, class Watch>
State stepped(const Scene& scene, const Dynamics& dynamics, Method method, System&& system, double step, long count,
              Watch&& watch) {
  record_use(scene.model);
  record_use(Integrator{method});
  State state = scene.initial;
  system.begin(state);
  method.start(system, state, step);
  for (long n = 0; n < count; ++n) {
    method.step(system, state, step);
    watch(dynamics, state);
  }
  return state;
}

/// Zero for two states with equal coordinates, velocities, memories and losses; otherwise the largest difference of any
/// coordinate or velocity, or NaN if only memories or losses differ.
double change(const State& a, const State& b) {
  const auto [position, velocity] = difference(a, b);
  if (position > 0.0 || velocity > 0.0) return std::max(position, velocity);
  return a.z == b.z && a.work == b.work ? position + velocity : std::nan("");
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
  findings.expect_exact(
      {"state_at_end", fmt::format("{}: state at the end against the run with every pair, largest difference", name)},
      change(visited, all), 0.0, "bodies out of reach exert no force, and neither does a node outside its target");
  StormerCowell located;
  located.tolerance = 1e-8;
  // Only a tenth of the duration, because events between crowded bodies follow each other closely.
  const double interval = 0.1 * step * static_cast<double>(count);
  const State every = stepped(scene, dynamics, located, EveryPair{dynamics}, interval, 1, unwatched);
  const State ahead =
      setup.has("no_time_ahead")
          ? stepped(scene, dynamics, located, ShortSighted{RigidBodySystem{dynamics, true}}, interval, 1, unwatched)
          : stepped(scene, dynamics, located, RigidBodySystem{dynamics, true}, interval, 1, unwatched);
  findings.expect_exact(
      fmt::format("{}, located events: state against the run with every guard, largest difference", name),
      change(ahead, every), 0.0, "bodies that at their speed do not meet within five steps end no mode within one");
  table.rows.push_back(
      cells("pairs within reach, {} | {} | {:.2f} | none", name, dynamics.contacts().candidates(), near));
}

/// Discs thrown together, with a contact for each pair, and a second one without dashpot for every other pair.
Scene thrown_discs() {
  constexpr int side = 4;
  std::mt19937 random{7};
  std::uniform_real_distribution<double> nudge{-0.2, 0.2};
  SceneBuilder builder;
  std::vector<BodyId> discs;
  for (int i = 0; i < side * side; ++i) {
    const Vec2 position{2.6 * (i % side) + nudge(random), 2.6 * (i / side) + nudge(random)};
    discs.push_back(builder.add(
        Body{.name = fmt::format("disc{}", i), .mass = 1.0, .inertia = 0.4, .shape = Circle{1.0}, .p_WB = position}));
    for (int other = 0; other < i; ++other) {
      builder.add_contact(fmt::format("{}-{}", other, i), discs[static_cast<std::size_t>(other)], discs.back(),
                          LinearSpringDashpot{4e3, 3.0, EndRule::clamped});
      if ((i + other) % 2 == 0)
        builder.add_contact(fmt::format("{}-{} again", other, i), discs[static_cast<std::size_t>(other)], discs.back(),
                            LinearSpringDashpot{1e3, 0.0, EndRule::clamped});
    }
  }
  Scene scene = builder.at_rest("Thrown discs");
  for (const BodyId disc : discs) {
    const Vec2 position = scene.model.bodies[index(disc)].p_WB;
    set_velocity(scene.model, scene.initial, disc, {1.5 * (4.0 - position.x), 1.5 * (4.0 - position.y)}, 0.0);
  }
  return scene;
}

/// Checks that runs end bit-identical to runs in which every gap of every pair is computed at each evaluation. Fault
/// `pair_forgotten`.
void check_contacts(Findings& findings, const Setup& setup, Table& table) {
  check_pairs(findings, setup, table, "yard", mixed_pile(), 1.0 / 4096.0, 3000);
  if (setup.coarse) return;
  check_pairs(findings, setup, table, "16 discs", thrown_discs(), 1.0 / 2048.0, 3000);
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.layers = 2;
  fence.options.start = scenes::FenceStart::plain;
  check_pairs(findings, setup, table, "fence of two layers", scenes::fence_scene(fence).scene, 1e-5, 5000);
}

/// Checks that the tensions of cable rows equal those of each law alone throughout a run in which cables slacken and
/// yield (fault `line_of_another`), and that the run without a ledger, in which paths are not computed, ends
/// bit-identical to that with one (fault `paths_of_another`).
void check_rows(Findings& findings, const Setup& setup, Table& table) {
  scenes::Fence fence = rough_fence();
  fence.options.hanger_strength = 0.0;  // unbreakable: cables that continue through broken hangers form no rows
  fence.options.start = scenes::FenceStart::plain;
  const Scene scene = scenes::fence_scene(fence).scene;
  const Dynamics dynamics{scene.model};
  Model other = scene.model;
  if (setup.has("line_of_another") || setup.has("paths_of_another"))
    std::get<ElasticPlastic>(other.cables.front().law).stiffness *= 1.0 + 1e-15;
  const Dynamics by_laws{other};
  const auto unwatched = [](const Dynamics&, const State&) {};
  constexpr long count = 5000;
  const State full_state =
      stepped(scene, by_laws, VelocityVerlet{}, RigidBodySystem{by_laws, true}, 1e-5, count, unwatched);
  Workspace work = dynamics.workspace(), laws = by_laws.workspace();
  LawForces forces;
  Rates rates{scene.initial};
  double largest = 0.0, by_law = 0.0;
  const auto watch = [&](const Dynamics&, const State& state) {
    dynamics.update(state, work);
    dynamics.rates(state, work, rates, false);
    by_laws.update_all(state, laws);
    by_laws.forces(state, laws, forces);
    for (const auto& runs : work.active.cables) {
      for (const talus::CableSpan& run : runs) {
        if (!run.on_linear_branch) by_law += static_cast<double>(run.count) / count;
        for (std::size_t c = run.cable; c < run.cable + run.count; ++c)
          keep_largest(largest, work.paths.tension[c] - forces.tensions[c]);
      }
    }
  };
  const State bare = stepped(scene, dynamics, VelocityVerlet{}, RigidBodySystem{dynamics, false}, 1e-5, count, watch);
  const auto [position, velocity] = difference(bare, full_state);
  findings.count(2 * count);
  findings.expect_exact(
      {"without_ledger", "without ledger: state at the end against the run with ledger, largest difference"},
      worst_of({position, velocity}), 0.0,
      "the force on a body is the same sum, whether the paths are computed or not");
  findings.expect_exact(
      {"row_tensions",
       "tensions of rows of cables against those of the individual laws, largest difference over a run"},
      largest, 0.0, "the same operations on the same numbers, several at a time", "lb");
  table.rows.push_back(cells("cables evaluated by their laws, fence that yields | {} | {:.2f} | none",
                             scene.model.cables.size(), by_law));
}

constexpr long steps = 25000;

enum class Sag { as_tight, fraction_of_span };

/// Table 2's fence with another number of columns; spacing and end segments are unchanged.
scenes::FenceScene long_fence(int columns, Sag sag, Sleep sleep) {
  scenes::Fence fence = published_fence("table_2.DAT");
  const double ratio = 1.0 + (columns - fence.columns) * fence.spacing / fence.span;
  fence.sag *= sag == Sag::as_tight ? ratio * ratio : ratio;
  fence.span *= ratio;
  fence.columns = columns;
  fence.options.sleep = sleep;
  return scenes::fence_scene(fence);
}

struct LongRun {
  State state;
  double pull{};   ///< largest tension of a cable [lb]
  double awake{};  ///< columns, mean over the steps
  double horizontal_tension{};
  Series columns;  ///< awake, against time
};

LongRun run_long(const scenes::FenceScene& made, Findings& findings) {
  const Scene& scene = made.scene;
  Probe probe{scene.model};
  LongRun found{{}, 0.0, 0.0, made.horizontal_tension, {.label = "", .style = Style::lines}};
  const std::size_t sleeper = Layout{scene.model}.first_sleeper;
  const auto columns = static_cast<double>(scene.model.bodies.size() - 2);  // without ground and rock
  const Watcher watch = [&](const State& state, const StepInfo& info) {
    const auto first = state.mode.begin() + static_cast<std::ptrdiff_t>(sleeper);
    const double awake =
        sleeper == state.mode.size() ? columns : static_cast<double>(std::count(first, state.mode.end(), Mode{1}));
    found.awake += awake / steps;
    if (!info.due) return;
    found.columns.add(1e3 * state.t, awake);
    probe.evaluate(state);
    const std::vector<double>& tensions = probe.forces().tensions;
    found.pull = std::max(found.pull, *std::max_element(tensions.begin(), tensions.end()));
  };
  const double step = scene.plan.step;
  const RunEnd end = run_scene(scene, scene.integrator, {step, step * steps, 100.0 * step, false}, findings, watch);
  found.state = end.state;
  if (!end.finished) found.pull = std::nan("");
  return found;
}

void check_sleep(Findings& findings, const Setup& setup, Table& table) {
  const auto with = [&](Sleep sleep) { return run_long(long_fence(101, Sag::fraction_of_span, sleep), findings); };
  const LongRun off = with(Sleep::off), exact = with(setup.has("default_for_exact") ? Sleep::on : Sleep::exact);
  findings.expect_exact(
      {"exact_sleep", "101 columns, sleep exact: state at 0.05 s against the run without sleep, largest difference"},
      change(exact.state, off.state), 0.0,
      "sleeping bodies are in equilibrium at rest, and no force on them has changed by a bit");
  if (setup.coarse) return;
  const LongRun on = with(Sleep::on);
  const char* why =
      "a column stays asleep while the force on it changes by less than 1e-13 of a tension of 65 600 lb: 6.6e-9 lb "
      "during a thousandth of a second, in which the motion of the next column doubles many times, on 14.9 slug cause "
      "4.4e-13 ft/s at the border, 8e-14 of the rock's 5.5 ft/s, and less in the middle; the round-off of 25 000 steps "
      "is of the same size";
  findings.expect({"default_sleep", "101 columns, sleep by default: speed of the rock against the run without sleep"},
                  on.state.v[0], off.state.v[0], Tolerance::model(2e-13, why).relative(), "ft/s");
  findings.expect_model("101 columns, sleep by default: largest difference of any coordinate or velocity",
                        change(on.state, off.state), 0.0, 2.2e-11,
                        "6.6e-9 lb during the whole 0.05 s on 14.9 slug: a column at the border that sleeps although "
                        "it would have moved if awake");
  table.rows.push_back({"sleep exact, 101 columns", "51", fmt::format("{:.1f}", exact.awake), "none"});
  table.rows.push_back(cells("sleep by default, 101 columns | 51 | {:.1f} | {:.1e} of the speed", on.awake,
                             std::abs(on.state.v[0] / off.state.v[0] - 1.0)));
}

/// A rock that falls on the middle column from above: the columns beside it are pulled downwards alone.
void check_fall(Findings& findings, const Setup& setup) {
  const auto with = [&](Sleep sleep) {
    scenes::Fence fence = published_fence("table_2.DAT");
    // A disc on the side of a rectangle: nothing moves along x.
    fence.options = scenes::current_options();
    fence.options.integrator = "velocity_verlet", fence.options.tolerance = 0.0;
    fence.column.outline = scenes::ElementOutline::rectangle;
    fence.options.sleep = sleep;
    scenes::FenceElement& rock = fence.rocks[0];
    rock.position = {fence.column.position.x, fence.column.position.y + fence.column.b + rock.b + 0.01};
    rock.velocity = {0.0, -65.0}, rock.spin = 0.0;
    return run_long(scenes::fence_scene(fence), findings);
  };
  const LongRun off = with(Sleep::off), exact = with(setup.has("default_for_exact") ? Sleep::on : Sleep::exact);
  findings.expect_exact(
      {"falling_rock",
       "rock that falls on a column, sleep exact: state against the run without sleep, largest difference"},
      change(exact.state, off.state), 0.0,
      "the next column wakes as soon as the pull on it changes by a bit, in whatever direction");
  const LongRun on = with(Sleep::on);
  findings.expect_model(
      "rock that falls on a column, sleep by default: largest difference of any coordinate or velocity",
      change(on.state, off.state), 0.0, 2.2e-11, "as for 101 columns: 6.6e-9 lb during the whole 0.05 s on 14.9 slug");
  double woken = 0.0;
  for (const double awake : exact.columns.y)
    woken = std::max(woken, awake);
  findings.expect_between("columns awake after a rock fell on the middle one", woken, 2.0, 7.0,
                          "the middle column pulls the others, one after the other; half of thirteen are modelled");
}

void check_length(Findings& findings, const Setup& setup, Table& table) {
  const auto with = [&](int columns, Sag sag) {
    return run_long(long_fence(columns, sag, setup.has("never_asleep") ? Sleep::off : Sleep::on), findings);
  };
  Figure figure{.name = "awake",
                .title = "Columns awake",
                .caption = "Half of each fence is modelled: 51 and 501 columns.",
                .x = {.label = "time", .unit = "ms"},
                .y = {.label = "columns awake", .min = 0.0}};
  for (const Sag sag : {Sag::as_tight, Sag::fraction_of_span}) {
    const LongRun tenth = with(101, sag), whole = with(1001, sag);
    const bool tight = sag == Sag::as_tight;
    const double ratio = whole.awake / tenth.awake;
    if (tight) {
      findings.expect_between({"awake_columns", "columns awake in 0.05 s, equal tightness: 1,001 columns over 101"},
                              ratio, 0.9, 1.1,
                              "nothing near the impact depends on the length of the fence except the tensions, which "
                              "differ by 0.7 %, and the slopes of the cables");
    } else {
      findings.expect_between(
          {"wide_fences", "columns awake in 0.05 s, sag a fixed fraction of the span: 1,001 columns over 101"}, ratio,
          1.0, std::sqrt(whole.horizontal_tension / tenth.horizontal_tension),
          "motion spreads along a cable at a speed proportional to the root of its tension, and takes time to do so");
    }
    const char* what = tight ? "equal tightness" : "fixed sag fraction";
    for (const auto& [columns, found] : {std::pair{51, &tenth}, std::pair{501, &whole}}) {
      table.rows.push_back(
          cells("sleep by default, {} columns, {} | {} | {:.1f} | ", 2 * columns - 1, what, columns, found->awake));
      figure.series.push_back(found->columns);
      figure.series.back().label = fmt::format("{} columns, {}", 2 * columns - 1, what);
    }
    if (setup.coarse) return;
  }
  findings.figure(figure);
}

/// Checks that a moment on the columns, which at first changes no cable force, wakes all of them at once: they turn at
/// the rate M t/I in any mode of sleep, with the same bits.
void check_turning(Findings& findings, const Setup& setup) {
  constexpr double moment = 200.0, step = 2e-6;  // [lb ft], [s]
  constexpr long count = 100;
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.rocks[0].position.x += 1.0;  // it touches nothing
  fence.column.moment = setup.has("moment_left_out") ? 0.0 : moment;
  const auto& [a, b, density] = std::tie(fence.column.a, fence.column.b, fence.column.density);
  const double inertia = 2.0 * std::numbers::pi * a * a * b * density * (3.0 * a * a + 4.0 * b * b) / 12.0;
  const double time = count * step;
  double spin = 0.0, bits = 0.0, columns = 0.0, tension = 0.0;
  std::optional<State> without_sleep;
  for (const Sleep sleep : {Sleep::off, Sleep::exact, Sleep::on}) {
    fence.options.sleep = sleep;
    const scenes::FenceScene made = scenes::fence_scene(fence);
    const Model& model = made.scene.model;
    const State state = run_steps(made.scene, VelocityVerlet{}, step, count, findings).state;
    for (std::size_t body = 0; body < model.bodies.size(); ++body) {
      if (model.bodies[body].name.find("column") == std::string::npos) continue;
      columns += 1.0;
      keep_worst(spin, pose(model, state, static_cast<BodyId>(body)).w_WB * inertia / (moment * time) - 1.0);
    }
    if (!without_sleep) without_sleep = state;
    for (std::size_t i = 0; i < state.v.size(); ++i)
      keep_worst(bits, worst_of({state.q[i] - without_sleep->q[i], state.v[i] - without_sleep->v[i]}));
    tension = made.horizontal_tension;
  }
  const double restoring = 2.0 * tension * fence.y_top * fence.y_top / (fence.spacing * inertia);
  findings.expect_truncation(
      {"turned_columns", "sleeping columns with a moment: spin after 100 steps over M t/I, largest relative error"},
      spin, 0.0, restoring * time * time / 6.0, 1.0,
      "the pull of two segments at the joint turns a column back by at most w^2 = 2 T y^2/(l I) times its angle, if "
      "its neighbours stood still");
  findings.expect_exact("sleeping columns with a moment: state against the run without sleep, largest difference", bits,
                        0.0, "all columns are awake from the first step");
  findings.expect_exact("sleeping columns with a moment: columns compared", columns, 21.0,
                        "seven of thirteen in a half model, with three modes of sleep");
}

/// Checks that columns which move at the start are awake: the central one flies freely, since its neighbours move as
/// it does, with the same bits in any mode of sleep.
void check_thrown(Findings& findings, const Setup& setup) {
  constexpr double speed = 3.0, step = 2e-6;  // [ft/s], [s]
  constexpr long count = 100;
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.rocks[0].position.x += 1.0;  // it touches nothing
  if (!setup.has("columns_not_thrown")) fence.column.velocity = {speed, 0.0};
  double bits = 0.0, path = 0.0, compared = 0.0;
  std::optional<State> without_sleep;
  for (const Sleep sleep : {Sleep::off, Sleep::exact, Sleep::on}) {
    fence.options.sleep = sleep;
    const Scene scene = scenes::fence_scene(fence).scene;
    const State state = run_steps(scene, VelocityVerlet{}, step, count, findings).state;
    const BodyId column = *find_body(scene.model, "column1");
    const double moved = pose(scene.model, state, column).p_WB.x - scene.model.bodies[index(column)].p_WB.x;
    keep_worst(path, moved / (speed * count * step) - 1.0);
    compared += static_cast<double>(state.v.size());
    if (!without_sleep) without_sleep = state;
    for (std::size_t i = 0; i < state.v.size(); ++i)
      keep_worst(bits, worst_of({state.q[i] - without_sleep->q[i], state.v[i] - without_sleep->v[i]}));
  }
  findings.expect_round_off(
      {"thrown_columns", "columns with a velocity at the start: path of the central one over v t, deviation from 1"},
      path, 0.0, 1e-11,
      "cables between bodies that move alike stay in balance, and the anchor is seven spacings away; a hundred steps "
      "of a position of some ft, each rounded by 2e-16 of it, along 6e-4 ft");
  findings.expect_exact("columns with a velocity at the start: state against the run without sleep, largest difference",
                        bits, 0.0, "all columns are awake from the first step");
  findings.expect_exact("columns with a velocity at the start: velocities compared", compared, 72.0,
                        "three of each of seven columns and of a rock, with three modes of sleep");
}

/// Moves one column at a time and checks that the guards of its cables, at any position in the row, equal those
/// computed without omissions.
void check_guards(Findings& findings, const Setup& setup) {
  const scenes::FenceScene made = long_fence(41, Sag::fraction_of_span, Sleep::off);
  const Model& model = made.scene.model;
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics, true};
  EveryPair all{dynamics};
  std::vector<double> guards, every;
  double missing = 0.0, compared = 0.0;
  for (std::size_t body = 0; body < model.bodies.size(); ++body) {
    if (model.bodies[body].name.find("column") == std::string::npos) continue;
    State state = rest_state(model);
    set_velocity(model, state, static_cast<BodyId>(body), {0.0, setup.has("columns_at_rest") ? 0.0 : 100.0}, 0.0);
    system.update_modes(state), system.update_modes(state);  // the second uses the linear branches set by the first
    (void)system.guards(state, true, 0.1, guards);
    (void)all.guards(state, true, 0.1, every);
    for (std::size_t c = 0; c < model.cables.size(); ++c) {
      const talus::Cable& cable = model.cables[c];
      if (cable.name.find("top") == std::string::npos) continue;
      if (cable.a.body != static_cast<BodyId>(body) && cable.b.body != static_cast<BodyId>(body)) continue;
      const std::size_t slot = dynamics.layout().cable_slots[c].mode;
      compared += 1.0, missing += guards[slot] == every[slot] && std::isfinite(guards[slot]) ? 0.0 : 1.0;
    }
  }
  findings.expect_exact(
      {"guards_ahead", "guards ahead: cables at a moving column without the guard of their law, of 41"}, missing, 0.0,
      "a column that moves by 10 ft within the horizon takes its cables off the linear branches of their laws");
  // Rough discs that approach: friction cannot begin before the normal force.
  SceneBuilder builder;
  const BodyId a = builder.add_free("a", 1.0, 1.0, Circle{1.0});
  const BodyId b = builder.add_free("b", 1.0, 1.0, Circle{1.0}, {2.25, 0.0});
  builder.add_contact("ab", a, b, LinearSpringDashpot{1.0, 0.0, EndRule::clamped},
                      CoulombFriction{.coefficient = 0.5, .stiffness = 1.0});
  const Model pair = builder.build();
  const Dynamics discs{pair};
  State state = rest_state(pair);
  set_velocity(pair, state, b, {-1.0, 0.0}, 0.0);
  RigidBodySystem approach{discs, true};
  approach.update_modes(state);
  (void)approach.guards(state, true, 1.0, guards);
  findings.expect_exact("guards ahead: guard of the normal law of approaching rough discs",
                        guards[discs.layout().contact_slots[0].mode], 0.25, "the gap");
  findings.expect_true("guards ahead: no guard for the friction of discs without contact",
                       std::isinf(guards[discs.layout().friction_slots[0].mode]),
                       "friction begins with the normal force");
  findings.expect_exact("guards ahead: cables compared", compared, 41.0,
                        "21 columns with two cables each, but one at the central column");
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "visited",
              .caption =
                  "Number of objects that a step could evaluate, and number that it evaluates (mean over the steps). "
                  "Without sleep a fence evaluates all its columns; half of a fence is modelled.",
              .columns = {"what", "in the scene", "evaluated", "change of the result"}};
  if (setup.needs("sleep exact") || setup.needs("sleep by default")) check_sleep(findings, setup, table);
  check_fall(findings, setup);
  if (setup.needs("with a moment")) check_turning(findings, setup);
  if (setup.needs("with a velocity")) check_thrown(findings, setup);
  if (setup.needs("columns awake")) check_length(findings, setup, table);
  if (setup.needs("with every pair") || setup.needs("with every guard")) check_contacts(findings, setup, table);
  if (setup.needs("tensions of rows") || setup.needs("without ledger")) check_rows(findings, setup, table);
  if (setup.needs("guards ahead")) check_guards(findings, setup);
  findings.table(table);
}

}  // namespace

Case definition() {
  return {
      .id = "sleeping_and_culling",
      .title = "Sleeping bodies and culled contacts: results unchanged",
      .family = "speed and accuracy",
      .requirements = {{"E10", {"state_at_end"}}},
      .main_checks = {"exact_sleep", "default_sleep", "awake_columns", "wide_fences",
                      "yard: state at the end against the run with every pair, largest difference",
                      "16 discs: state at the end against the run with every pair, largest difference",
                      "fence of two layers: state at the end against the run with every pair, largest difference",
                      "yard, located events: state against the run with every guard, largest difference",
                      "16 discs, located events: state against the run with every guard, largest difference",
                      "fence of two layers, located events: state against the run with every guard, largest difference",
                      "row_tensions", "without_ledger"},
      .source = "Verlet 1967 and Baraff 1992 for the contact search",
      .faults = {{"default_for_exact", "the default threshold where `exact` is required", "exact_sleep"},
                 {"never_asleep", "a fence that never sleeps", "awake_columns"},
                 {"moment_left_out", "columns without their moment", "turned_columns"},
                 {"columns_not_thrown", "columns without their velocity", "thrown_columns"},
                 {"pair_forgotten", "one pair of the yard never found",
                  "yard: state at the end against the run with every pair, largest difference"},
                 {"no_time_ahead", "located events without the guards of inactive modes",
                  "yard, located events: state against the run with every guard, largest difference"},
                 {"columns_at_rest", "columns at rest, whose cables stay on their linear branches", "guards_ahead"},
                 {"line_of_another", "the law of one cable stiffer by 1e-15", "row_tensions"},
                 {"paths_of_another", "the run with ledger for a fence with one cable stiffer by 1e-15",
                  "without_ledger"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::sleeping_and_culling
