#include "verification/study/scenes/cable_scenes.hpp"

#include "solver/model/model_builder.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {
namespace {

BodyId add_mass(ModelBuilder& builder, const char* name, double mass, double x) {
  return builder.add(Body{.name = name, .mobility = Mobility::sliding_x, .mass = mass, .p_WB = {x, 0.0}});
}

/// A cable that can yield, or one with a dashpot of `relaxation` times the stiffness.
CableLaw cable_law(double stiffness, double relaxation) {
  if (relaxation > 0.0) return TensionOnly{stiffness, relaxation * stiffness};
  return ElasticPlastic{.stiffness = stiffness};
}

}  // namespace

Scene thrown_mass(const CableLaw& law, double mass, double speed, double gravity) {
  ModelBuilder builder;
  builder.gravity({gravity, 0.0});
  const BodyId body = add_mass(builder, "mass", mass, cable_length);
  builder.add(Cable{.name = "cable", .a = {}, .b = {body, {}}, .rest_length = cable_length, .law = law});
  Scene scene;
  scene.model = builder.build();
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, body, {speed, 0.0}, 0.0);
  return scene;
}

Scene hung_pair(const reference::HungPair& pair, double strength, double relaxation) {
  ModelBuilder builder;
  const BodyId b = add_mass(builder, "b", pair.mass_b, cable_length);
  const BodyId c = add_mass(builder, "c", pair.mass_c, 2.0 * cable_length);
  builder.add(Cable{.name = "one",
                    .a = {},
                    .b = {b, {}},
                    .rest_length = cable_length,
                    .law = cable_law(pair.stiffness_1, relaxation)});
  builder.add(Cable{.name = "two",
                    .a = {b, {}},
                    .b = {c, {}},
                    .rest_length = cable_length,
                    .law = cable_law(pair.stiffness_2, relaxation)});
  builder.add(Hanger{"hanger", b, {}, strength});
  Scene scene;
  scene.model = builder.build();
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, c, {pair.speed, 0.0}, 0.0);
  return scene;
}

Scene parted_pair_scene(const reference::HungPair& pair, const State& at_break, double relaxation) {
  ModelBuilder builder;
  add_mass(builder, "b", pair.mass_b, cable_length);
  const BodyId c = add_mass(builder, "c", pair.mass_c, 2.0 * cable_length);
  const double stiffness = 1.0 / (1.0 / pair.stiffness_1 + 1.0 / pair.stiffness_2);
  builder.add(Cable{.name = "one",
                    .a = {},
                    .b = {c, {}},
                    .rest_length = 2.0 * cable_length,
                    .law = cable_law(stiffness, relaxation)});
  Scene scene;
  scene.model = builder.build();
  scene.initial = rest_state(scene.model);
  scene.initial.t = at_break.t;
  scene.initial.q = at_break.q;
  scene.initial.v = at_break.v;
  return scene;
}

CableRunResult run_cables(const Scene& scene, const State& start, const Integrator& method, const CableRunPlan& plan,
                          Findings& findings) {
  CableRunResult run;
  Scene from = scene;
  from.initial = start;
  from.initial = first_state(from);
  RunLedger ledger{scene.model, from.initial};
  Probe probe{scene.model};
  const Watcher watch = [&](const State& state, const StepInfo&) {
    probe.evaluate(state);
    const std::vector<double>& tensions = probe.forces().tensions;
    run.time.push_back(state.t);
    run.elongation.push_back(probe.elongation(0));
    run.tension.push_back(tensions[0]);
    if (tensions.size() > 1) run.second_tension.push_back(tensions[1]);
  };
  const Layout layout{scene.model};
  bool pulled = false;
  const Until slack = [&](const State& state) {
    const Mode mode = state.mode[layout.cable_slots[0].mode];
    pulled = pulled || mode == ElasticPlastic::taut || mode == ElasticPlastic::yielding;
    return (pulled && mode == ElasticPlastic::slack) || mode == ElasticPlastic::broken;
  };
  run.end = run_scene(from, method, {plan.step, plan.end, 1e9, true}, findings, plan.watched ? watch : Watcher{},
                      plan.until_slack ? slack : Until{})
                .state;
  run.balance_error = ledger(run.end).energy_balance_error;
  run.hanger_broken = !scene.model.hangers.empty() && run.end.mode[layout.first_hanger] != 0;
  return run;
}

double recorded_work(const State& state, Mechanism mechanism) {
  return state.work[static_cast<std::size_t>(mechanism)];
}

}  // namespace talus::verification::problems
