#include "solver/run/run_state.hpp"

#include <variant>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/state/state_memory.hpp"

namespace talus {

void RunState::remember(Memory& memory) {
  memory.number("start", start);
  memory.count("step", step);
  memory.count("evaluations", evaluations);
  memory.part("state", [&] { talus::remember(memory, state); });
  memory.part(name(integrator), [&] { std::visit([&](auto& method) { method.remember(memory, state); }, integrator); });
}

RunState initial_run_state(const Integrator& integrator, const State& state) {
  return {.integrator = integrator, .state = state, .start = state.t};
}

State synchronized(const RunState& run_state, RigidBodySystem& system, const RunPlan& plan) {
  State state = std::visit([&](const auto& method) { return synchronized(method, system, run_state.state, plan.step); },
                           run_state.integrator);
  system.settle(state);
  return state;
}

}  // namespace talus
