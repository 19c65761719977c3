#pragma once

#include <boost/test/unit_test.hpp>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus::scenes {

/// A fence's state at the end of a run, and its energy balance.
struct End {
  State state;
  double balance_error{};  ///< balance error of the energy [F L]
  double scale{};          ///< the largest energy [F L]
};

/// Runs a fence from its start to time `end` [T]; it must finish.
inline End run(const FenceScene& made, double end) {
  const Dynamics dynamics{made.scene.model};
  RigidBodySystem system{dynamics};
  Integrator integrator = made.scene.integrator;
  State state = made.scene.initial;
  system.begin(state);
  EnergyLedger ledger{dynamics, state};
  RunPlan plan = made.scene.plan;
  plan.end = end;
  BOOST_TEST_REQUIRE(static_cast<bool>(simulate(system, integrator, state, plan)));
  return {state, ledger.accounts(state).energy_balance_error, ledger.energy_scale()};
}

}  // namespace talus::scenes
