/// A disc that hits a linear spring without a dashpot leaves the plane with its speed of approach.
#include <cmath>
#include <cstdio>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"

int main() {
  using namespace talus;
  const Scene scene = scenes::bouncing_disc({.speed = 2.0, .contact = LinearSpringDashpot{1e4, 0.0, EndRule::clamped}});
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  State state = scene.initial;
  Integrator method = make_integrator("exact", 0.0);
  const Outcome outcome = simulate(system, method, state, {.step = 1e-3, .end = 0.1});
  const double speed = state.v[1];
  std::printf("leaves at %.15g\n", speed);
  return outcome && std::abs(speed - 2.0) < 1e-12 ? 0 : 1;
}
