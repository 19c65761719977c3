#include "solver/run/run_state.hpp"

#include <variant>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/state/state_archive.hpp"

namespace talus {

void RunState::serialize(Archive& archive) {
  archive.number("start", start);
  archive.count("step", step);
  archive.count("evaluations", evaluations);
  archive.scope("state", [&] { talus::serialize(archive, state); });
  archive.scope(name(integrator),
                [&] { std::visit([&](auto& method) { method.serialize(archive, state); }, integrator); });
}

RunState initial_run_state(const Integrator& integrator, const State& state) {
  return {.integrator = integrator, .state = state, .start = state.t};
}

State synchronized(const RunState& run_state, RigidBodySystem& system, const RunPlan& plan) {
  State state = std::visit([&](const auto& method) { return synchronized(method, system, run_state.state, plan.step); },
                           run_state.integrator);
  system.update_modes(state);
  return state;
}

}  // namespace talus
