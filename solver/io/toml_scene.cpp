#include "solver/io/toml_scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/io/scene_parts.hpp"
#include "solver/io/toml_fence.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {
namespace {

/// The parts of a scene as written, and what they stand in.
struct Parts {
  Vec2 gravity;
  std::vector<SceneBody> bodies;
  std::vector<SceneContact> contacts;
  std::vector<SceneCable> cables;
  std::vector<SceneHanger> hangers;
};

/// The model of the parts; what a builder refuses gets the line of the table concerned.
Model built(const Parts& parts, const SceneTable& file) {
  ModelBuilder builder{file.units()};
  builder.gravity(parts.gravity);
  for (const SceneBody& read : parts.bodies)
    read.table.placed([&] { return builder.add(read.body); });
  for (const SceneContact& read : parts.contacts)
    read.table.placed([&] { return builder.add(read.contact); });
  for (const SceneCable& read : parts.cables)
    read.table.placed([&] { return builder.add(read.cable); });
  for (const SceneHanger& read : parts.hangers)
    read.table.placed([&] { return builder.add(read.hanger); });
  return file.placed([&] { return builder.build(); });
}

/// Reduced mass of two bodies taken as particles; a fixed one as infinitely heavy [M].
double particle_mass(const Model& model, const Contact& contact) {
  const Body& a = model.bodies[index(contact.a)];
  const Body& b = model.bodies[index(contact.b)];
  if (a.mobility == Mobility::fixed) return b.mass;
  if (b.mobility == Mobility::fixed) return a.mass;
  return effective_mass(ContactSide{a.mass, {}, 0.0, false}, ContactSide{b.mass, {}, 0.0, false});
}

/// Damping by Eq. 21, where a contact requires it.
void set_damping(std::vector<SceneContact>& contacts, const Model& undamped) {
  for (SceneContact& read : contacts) {
    if (!read.restitution) continue;
    auto& law = std::get<LinearSpringDashpot>(read.contact.law);
    const double mass = particle_mass(undamped, read.contact);
    read.table.placed(
        [&] { law.damping = damping(damping_ratio(*read.restitution, EndRule::attractive), law.stiffness, mass); });
  }
}

Parts read_parts(SceneTable& file) {
  Parts parts;
  parts.gravity = file.vector_or("gravity", dimension::acceleration, {});
  parts.bodies = read_bodies(file);
  const Model bodies = built(parts, file);
  parts.contacts = read_contacts(file, bodies);
  parts.cables = read_cables(file, bodies);
  parts.hangers = read_hangers(file, bodies);
  set_damping(parts.contacts, built(parts, file));
  return parts;
}

void read_run(SceneTable table, Scene& scene) {
  table.allow({"integrator", "tolerance", "step", "end", "interval", "ledger", "watch"});
  const std::string integrator = table.choice("integrator", integrator_choices());
  const double tolerance = table.has("tolerance") ? table.number("tolerance", Range::positive) : 0.0;
  const IntegratorChoice chosen = table.placed([&] { return choose_integrator(scene.model, integrator, tolerance); });
  scene.integrator = chosen.integrator;
  scene.integrator_why = chosen.why;
  scene.plan.step = table.quantity("step", dimension::time, Range::positive);
  scene.plan.end = table.quantity("end", dimension::time, Range::positive);
  scene.plan.interval = table.quantity_or("interval", dimension::time, scene.plan.step, Range::positive);
  table.placed([&] { check_step_count(scene.plan); });
  if (table.has("watch")) scene.plan.watch = read_watch(table.table("watch"));
  if (table.has("ledger")) scene.plan.ledger = table.choice("ledger", {"on", "off"}) == "on";
}

State start_state(const Parts& parts, const Model& model) {
  State state = rest_state(model);
  for (std::size_t i = 0; i < parts.bodies.size(); ++i) {
    const SceneBody& read = parts.bodies[i];
    read.table.placed([&] { set_velocity(model, state, static_cast<BodyId>(i), read.velocity, read.spin); });
  }
  return state;
}

}  // namespace

WatchRules read_watch(SceneTable table) {
  WatchRules rules;
  for (const WatchRules::Choice& choice : WatchRules::choices())
    rules.*choice.member = table.choice_or(choice.name, rules.*choice.member);
  table.allow({});
  return rules;
}

SceneFile read_scene_file(std::string_view text, std::string_view name) {
  const TomlValue document = parse_toml(text, name);
  SceneSource source{std::string{name}, si};
  SceneTable file{source, document, ""};
  if (file.has("fence")) {
    const scenes::Fence fence = read_fence(file, source);
    const scenes::FenceScene made = file.table("fence").placed([&] { return scenes::fence_scene(fence); });
    return {made.scene, FenceInput{fence, made}};
  }
  file.refuse("cell", "a shear cell is run by `talus cell`");
  file.allow({"title", "units", "gravity", "body", "contact", "cable", "hanger", "run"});
  source.units = unit_system(file.choice("units", {std::string{si.name}, std::string{us.name}}));
  Scene scene;
  scene.title = file.text("title");
  const Parts parts = read_parts(file);
  scene.model = built(parts, file);
  scene.initial = start_state(parts, scene.model);
  read_run(file.table("run"), scene);
  return {std::move(scene)};
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
