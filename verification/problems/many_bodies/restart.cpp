#include <unistd.h>
#include <filesystem>

#include "solver/io/file/atomic_file.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/study/scenes/moved_scene.hpp"
#include "verification/study/scenes/scaled_scene.hpp"
#include "verification/study/scenes/scenes_in_motion.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::restart {
namespace {

struct Half {
  State end;
  long evaluations{};
};

/// How a run is interrupted.
enum class Interrupted { never, by_checkpoint, from_state_alone };

std::string rounded_digits(const std::string& text) {
  // Truncates a number with a decimal point to eight digits after the point.
  std::string out;
  int behind = -1;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    if (c == '.') behind = 0;
    if (behind >= 0 && digit && ++behind > 8) continue;
    if (!digit && c != '.') behind = -1;
    out += c;
  }
  return out;
}

/// Saves the run to a file, and restores it from there into a new run.
RunState through_file(RunState& run_state, const Scene& scene, const Integrator& method, const Setup& setup) {
  namespace fs = std::filesystem;
  Archive saving;
  run_state.serialize(saving);
  const Checkpoint kept{.scene_file = "scene",
                        .scene_fnv1a = fnv1a("scene"),
                        .integrator = std::string{name(method)},
                        .tolerance = tolerance(method),
                        .step = 1.0,
                        .end = 1.0,
                        .steps = run_state.step,
                        .memory = saving.items()};
  std::string text = checkpoint_text(kept, "case");
  if (setup.has("few_digits")) {
    const auto from = text.find("\"memory\""), last = text.rfind("\"fnv1a\"");
    text = text.substr(0, from) + rounded_digits(text.substr(from, last - from));
    text += fmt::format("\"fnv1a\": \"{}\"\n}}\n", fnv1a(text));
  }
  const fs::path file = fs::temp_directory_path() / fmt::format("talus_restart_{}.json", ::getpid());
  write_whole(file, text);
  const Checkpoint read = read_checkpoint(file, "case");
  fs::remove(file);
  RunState other = initial_run_state(method, scene.initial);
  Archive restoring{read.memory};
  other.serialize(restoring);
  if (setup.has("stretch_forgotten")) std::fill(other.state.z.begin(), other.state.z.end(), 0.0);
  return other;
}

Half run_in_halves(const Scene& scene, const Integrator& method, double step, long steps, Interrupted how,
                   const Setup& setup, Findings& findings) {
  record_use(scene.model);
  record_use(method);
  const Dynamics first{scene.model}, second{scene.model};
  RigidBodySystem system{first}, other_system{second};
  RunState run_state = initial_run_state(method, scene.initial);
  const auto plan = [&](long count) {
    const double end = step * static_cast<double>(count);
    return RunPlan{step, end, end, true};
  };
  const auto ended = [&](RunState& run, RigidBodySystem& on) {
    const bool good = static_cast<bool>(simulate(on, run, plan(steps)));
    Half half{synchronized(run, on, plan(steps)), run.evaluations};
    if (!good) half.end.q[0] = std::nan("");
    findings.count(run.evaluations);
    return half;
  };
  if (how == Interrupted::never) return ended(run_state, system);
  (void)simulate(system, run_state, plan(steps / 2));
  if (how == Interrupted::by_checkpoint && !setup.has("method_restarts")) {
    RunState other = through_file(run_state, scene, method, setup);
    return ended(other, other_system);
  }
  RunState other = initial_run_state(method, synchronized(run_state, system, plan(steps)));
  other.start = 0.0;
  Integrator fresh = method;
  std::visit([&](auto& m) { m.start(other_system, other.state, step); }, fresh);
  other.integrator = fresh;
  other.step = run_state.step;
  return ended(other, other_system);
}

struct Named {
  std::string name;
  Integrator method;
};

std::vector<Named> methods() {
  std::vector<Named> all;
  for (const std::string& name : integrator_names()) {
    const bool controlled = needs_tolerance(name);
    all.push_back({controlled ? name + ", tolerance 1e-6" : name, make_integrator(name, controlled ? 1e-6 : 0.0)});
  }
  all.push_back({"odeint_dopri5, tolerance 1e-6", make_integrator("odeint_dopri5", 1e-6)});
  return all;
}

void check_restart(Findings& findings, const Setup& setup, const std::string& scene_name, const Scene& scene,
                   const Named& method, double step, long steps, Table& table) {
  const Half whole = run_in_halves(scene, method.method, step, steps, Interrupted::never, setup, findings);
  const Half halves = run_in_halves(scene, method.method, step, steps, Interrupted::by_checkpoint, setup, findings);
  const auto claim = findings.in(fmt::format("integrator.{}", name(method.method))), group = findings.in(scene_name);
  findings.expect_exact(
      {"restarts", fmt::format("values that differ after a restart, {}, {}", scene_name, method.name)},
      differing_numbers(whole.end, halves.end), 0.0,
      "the file contains everything that a step depends on, with all digits");
  if (setup.coarse) return;
  const Half again = run_in_halves(scene, method.method, step, steps, Interrupted::from_state_alone, setup, findings);
  const Difference change = difference(whole.end, again.end);
  table.rows.push_back(cells("{} | {} | {} | {} | {:.1e}", scene_name, method.name, whole.evaluations,
                             halves.evaluations, change.position));
}

/// Two discs on the ground, one above the other, sliding along one line; both contacts are compressed.
Scene two_pressed_discs() {
  SceneBuilder builder{si};
  const Body disc{.mobility = Mobility::sliding_y, .mass = 1.0, .shape = Circle{0.5}};
  Body lower = disc, upper = disc;
  lower.name = "lower", lower.p_WB = {0.0, 0.499};
  upper.name = "upper", upper.mass = 2.0, upper.p_WB = {0.0, 1.497};
  const BodyId a = builder.add(lower), b = builder.add(upper);
  const BodyId ground = builder.add_fixed("ground", HalfPlane{});
  builder.add_contact("below", a, ground, LinearSpringDashpot{1e4, 20.0});
  builder.add_contact("between", a, b, LinearSpringDashpot{2e4, 10.0});
  Scene scene = builder.at_rest("Two discs");
  set_velocity(scene.model, scene.initial, b, {0.0, -0.3}, 0.0);
  return scene;
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "again",
              .caption =
                  "Force evaluations of the uninterrupted run and of the resumed one, and the largest change of a "
                  "coordinate at the end when the method restarts from the state alone, as from a printed listing.",
              .columns = {"scene", "method", "uninterrupted", "resumed", "restarted"}};
  const Scene yard = mixed_pile();
  const double step = 1e-3;
  const long steps = std::lround(0.8 / step);

  for (const Named& method : methods()) {
    if (setup.coarse && method.name != "velocity_verlet") continue;
    check_restart(findings, setup, "yard", yard, method, step, steps, table);
  }
  if (setup.coarse) return;
  const scenes::FenceScene fence = scenes::fence_scene(rough_fence());
  for (const char* name : {"velocity_verlet", "lagged_central_difference"})
    check_restart(findings, setup, "fence", fence.scene, {name, make_integrator(name)}, 2e-5, 3000, table);
  // During a contact, within a segment of the exact method.
  const Scene pressed = scenes::bouncing_disc({.contact = LinearSpringDashpot{1e4, 20.0}});
  check_restart(findings, setup, "pressed disc", pressed, {"exact", make_integrator("exact")}, step, 30, table);
  // Two discs on each other on the ground, whose motions are coupled.
  check_restart(findings, setup, "two pressed discs", two_pressed_discs(), {"exact", make_integrator("exact")}, step,
                30, table);
  bool same_cost = true;
  for (const auto& row : table.rows)
    same_cost = same_cost && row[2] == row[3];
  findings.expect_true("equal numbers of force evaluations, resumed and uninterrupted runs", same_cost,
                       "a resumed run repeats no evaluation");
  findings.table(table);
}

}  // namespace

Case definition() {
  return {.id = "restart",
          .title = "Restart: interrupted and resumed runs",
          .requirements = {{"F5", {"restarts"}},
                           {"law.linear_spring_dashpot", {"yard", "fence"}},
                           {"law.tension_only", {"yard"}},
                           {"law.elastic_plastic, Eq. 18", {"yard", "fence"}}},
          .main_checks = {"values that differ after a restart, yard, velocity_verlet",
                          "values that differ after a restart, yard, odeint_abm8",
                          "values that differ after a restart, fence, lagged_central_difference"},
          .source = "IEEE 754; Steele & White 1990",
          .faults = {{"few_digits", "numbers written with eight decimal digits",
                      "values that differ after a restart, yard, velocity_verlet"},
                     {"stretch_forgotten", "memory of friction and cables omitted",
                      "values that differ after a restart, yard, velocity_verlet"},
                     {"method_restarts", "memory of the integration method omitted",
                      "values that differ after a restart, yard, velocity_verlet"}},
          .run = run};
}

}  // namespace talus::verification::problems::restart
