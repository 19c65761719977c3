#include "solver/io/scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "solver/io/file/shown_title.hpp"
#include "solver/io/scene/read_fence.hpp"
#include "solver/io/scene/scene_parts.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/model/resultant.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus {
namespace {

/// Gravity and the parts of a scene as written.
struct Parts {
  Vec2 gravity;
  std::vector<SceneBody> bodies;
  std::vector<SceneContact> contacts;
  std::vector<SceneCable> cables;
  std::vector<SceneHanger> hangers;
};

/// The table [run] as written.
struct SceneRun {
  explicit SceneRun(SceneTable of) : table{std::move(of)} {}

  SceneTable table;
  std::string integrator{automatic_integrator};
  double tolerance{};                ///< 0: not given
  double end{};                      ///< [T]
  std::optional<double> step{};      ///< [T]
  bool automatic_step{};             ///< step = "auto"
  std::optional<double> interval{};  ///< [T]
  bool ledger{true};
  MonitorRules watch;
};

/// Default number of rows of a run's history.
constexpr double usual_rows = 1000.0;

Parts read_parts(SceneTable& file) {
  Parts parts;
  parts.gravity = file.vector_or("gravity", dimension::acceleration, {});
  parts.bodies = read_bodies(file);
  const BodyNames names{parts.bodies};
  parts.contacts = read_contacts(file, names);
  parts.cables = read_cables(file, names);
  parts.hangers = read_hangers(file, names);
  return parts;
}

[[noreturn]] void fail_without_step(const SceneTable& table, const Integrator& method) {
  table.fail("step", fmt::format("it is missing; {} has a fixed step: give it, or \"auto\"", name(method)));
}

/// Relative difference of two times that are meant to be equal, but have different units.
constexpr double round_off = 1e-12;

SceneRun read_run(SceneTable table) {
  SceneRun run{std::move(table)};
  run.table.allow({"integrator", "tolerance", "step", "end", "interval", "ledger", "watch"});
  bool has_method = true;
  if (run.table.has("integrator")) {
    has_method = false;
    run.table.guard([&] {
      run.integrator = run.table.choice("integrator", integrator_choices());
      has_method = true;
    });
  }
  if (run.table.has("tolerance")) run.tolerance = run.table.number("tolerance", Range::positive);
  run.end = run.table.quantity("end", dimension::time, Range::positive);
  run.automatic_step = run.table.written("step") == automatic_step_name;
  if (!run.automatic_step && run.table.has("step"))
    run.step = run.table.quantity("step", dimension::time, Range::positive);
  if (run.table.has("interval")) run.interval = run.table.quantity("interval", dimension::time, Range::positive);
  if (run.step && run.interval && *run.interval < (1.0 - round_off) * *run.step)
    run.table.report(
        "interval", fmt::format("found \"{}\"; it must be at least the step, \"{}\": the history has at most one row a "
                                "step",
                                run.table.written("interval"), run.table.written("step")));
  run.ledger = run.table.on_or_off("ledger", run.ledger);
  if (run.table.has("watch")) run.table.guard([&] { run.watch = read_watch(run.table, "watch"); });
  // A named method is known without the model; an automatic one is chosen for the model in set_run().
  if (has_method && run.integrator != automatic_integrator) {
    run.table.guard([&] {
      const bool usual = run.tolerance == 0.0 && needs_tolerance(run.integrator);
      const Integrator method =
          run.table.placed([&] { return make_integrator(run.integrator, usual ? usual_tolerance : run.tolerance); });
      if (!chooses_steps(method) && !run.automatic_step && !run.step) fail_without_step(run.table, method);
    });
  }
  return run;
}

/// Reduced mass of two bodies treated as particles, with infinite mass for a fixed body [M].
double particle_mass(const Model& model, const Contact& contact) {
  const Body& a = model.bodies[index(contact.a)];
  const Body& b = model.bodies[index(contact.b)];
  if (a.mobility == Mobility::fixed) return b.mass;
  if (b.mobility == Mobility::fixed) return a.mass;
  return effective_mass(ContactSide{a.mass, {}, 0.0, false}, ContactSide{b.mass, {}, 0.0, false});
}

/// Checks that a single resultant can represent the contact (see objection_to_resultant). Errors: InputError.
void check_resultant(const Contact& contact, const Model& model) {
  if (contact.method != ContactMethod::resultant) return;
  const auto& bodies = model.bodies;
  const std::string refusal_reason = resultant_error(bodies[index(contact.a)].shape, bodies[index(contact.b)].shape);
  if (!refusal_reason.empty()) throw InputError{fmt::format("contact '{}': {}", contact.name, refusal_reason)};
}

/// The contact as part of the model, with damping by Eq. 21 if it requires that.
Contact between(const SceneContact& read, const Model& bodies) {
  Contact contact = read.contact;
  check_resultant(contact, bodies);
  if (!read.restitution) return contact;
  // Eq. 21 holds for the attractive end rule.
  const double mass = particle_mass(bodies, contact);
  std::visit(
      [&]<class L>(L& law) {
        if constexpr (SetsRestitution<L> && HasEndRule<L>) {
          const EndRule rule = std::exchange(law.end_rule, EndRule::attractive);
          law.set_restitution(*read.restitution, mass, read.restitution_speed);
          law.end_rule = rule;
        } else if constexpr (SetsRestitution<L>) {
          law.set_restitution(*read.restitution, mass, read.restitution_speed);
        }
      },
      contact.law);
  return contact;
}

Cable with_length(const SceneCable& read, const Model& bodies) {
  Cable cable = read.cable;
  const double distance = norm(reference_point(bodies, cable.b) - reference_point(bodies, cable.a));
  cable.rest_length = read.rest_length.value_or(distance) + read.slack;
  return cable;
}

/// The model built from the parts; errors of the builder get the line of the table concerned.
Model built(const Parts& parts, const SceneTable& file) {
  ModelBuilder builder{file.units()};
  builder.gravity(parts.gravity);
  const auto add = [&](const SceneTable& table, const auto& part_of) {
    table.source().guard(table.line(), [&] { table.placed([&] { return builder.add(part_of()); }); });
  };
  for (const SceneBody& read : parts.bodies)
    add(read.table, [&] { return read.body; });
  // Contacts and cables refer to bodies, so that all bodies must have been added.
  if (builder.model().bodies.size() != parts.bodies.size()) file.source().check();
  for (const SceneContact& read : parts.contacts)
    add(read.table, [&] { return between(read, builder.model()); });
  for (const SceneCable& read : parts.cables)
    add(read.table, [&] { return with_length(read, builder.model()); });
  file.source().check();
  file.source().collect();
  for (const SceneHanger& read : parts.hangers)
    add(read.table, [&] { return read.hanger; });
  file.source().check();
  return file.placed([&] { return builder.build(); });
}

/// Sets integrator and plan of a scene that has its model and initial state.
void set_run(const SceneRun& run, Scene& scene) {
  const SceneTable& table = run.table;
  const IntegratorChoice chosen =
      table.placed([&] { return choose_integrator(scene.model, run.integrator, run.tolerance); });
  scene.integrator = chosen.integrator;
  scene.integrator_reason = chosen.why;
  scene.plan.end = run.end;
  scene.plan.ledger = run.ledger;
  scene.plan.watch = run.watch;
  if (run.automatic_step) {
    scene.plan.step = table.placed([&] { return automatic_step(scene); });
  } else if (run.step) {
    scene.plan.step = *run.step;
  } else if (chooses_steps(scene.integrator)) {
    scene.plan.step = output_step(scene);
  } else {
    fail_without_step(table, scene.integrator);
  }
  // A step that is chosen here is at most the required time between rows.
  if (run.interval && !run.step) scene.plan.step = std::min(scene.plan.step, *run.interval);
  scene.plan.interval = run.interval.value_or(std::max(run.end / usual_rows, scene.plan.step));
  table.placed([&] { check_step_count(scene.plan); });
}

State start_state(const Parts& parts, const Model& model) {
  State state = rest_state(model);
  const Layout layout{model};
  for (std::size_t i = 0; i < parts.bodies.size(); ++i) {
    const SceneBody& read = parts.bodies[i];
    read.table.placed([&] { set_velocity(model, layout, state, static_cast<BodyId>(i), read.velocity, read.spin); });
  }
  return state;
}

}  // namespace

MonitorRules read_watch(SceneTable& owner, std::string_view key, const MonitorRules& absent) {
  MonitorRules rules = absent;
  if (owner.is_text(key)) {
    static_cast<void>(owner.choice(key, {"off"}));
    return MonitorRules::off();
  }
  SceneTable table = owner.table(key);
  for (const MonitorRules::Choice& choice : MonitorRules::choices())
    rules.*choice.member = table.choice_or(choice.name, rules.*choice.member);
  table.allow({});
  return rules;
}

namespace {

SceneFile read_fence_scene(SceneTable& file, SceneSource& source) {
  const scenes::Fence fence = read_fence(file, source);
  SceneTable table = file.table("fence");
  const scenes::FenceScene made = fence_scene(table, fence);
  for (const Contact& contact : made.scene.model.contacts)
    table.placed([&] { check_resultant(contact, made.scene.model); });
  return {made.scene, FenceInput{fence, made}};
}

SceneFile read_bodies_scene(SceneTable& file, SceneSource& source) {
  file.refuse("cell", "a shear cell is run by `talus cell`");
  file.allow({"title", "units", "gravity", "body", "contact", "cable", "hanger", "run"});
  source.guard(file.line(), [&] { source.units = unit_system(file.choice("units", unit_system_names())); });
  Scene scene;
  source.guard(file.line(), [&] { scene.title = file.title(); });
  const Parts parts = read_parts(file);
  std::optional<SceneRun> run;
  source.guard(file.line(), [&] { run.emplace(read_run(file.table("run"))); });
  source.check();
  source.collect();
  scene.model = built(parts, file);
  scene.initial = start_state(parts, scene.model);
  set_run(*run, scene);
  return {std::move(scene)};
}

}  // namespace

SceneFile read_scene_file(std::string_view text, std::string_view name) {
  return read_scene_file(parse_toml(text, name), name);
}

SceneFile read_scene_file(const TomlValue& document, std::string_view name) {
  SceneSource source{std::string{name}, si};
  SceneTable file{source, document, ""};
  source.collect();
  try {
    SceneFile read = file.has("fence") ? read_fence_scene(file, source) : read_bodies_scene(file, source);
    read.scene.title = shown_title(read.scene.title, name);
    return read;
  } catch (const SceneSource::Collected&) {
    source.check();
    throw;
  }
}

Scene read_scene(std::string_view text, std::string_view name) { return read_scene_file(text, name).scene; }

void check_step_count(const RunPlan& plan) {
  if (!std::isfinite(plan.step) || !std::isfinite(plan.end)) throw InputError{"run: step and end must be finite"};
  if (plan.step > plan.end) {
    throw InputError{fmt::format("run: the step, {:.6g}, is longer than the whole run, {:.6g}", plan.step, plan.end)};
  }
  const double steps = plan.end / plan.step;
  if (steps <= 1e12) return;
  throw InputError{fmt::format("run: the end is {:.3g} steps away; it must be at most 1e12", steps)};
}

}  // namespace talus
