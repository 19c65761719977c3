#include "verification/problems/normal_contact/falling_disc.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/scenes/bouncing_disc.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {

std::string name_of(const Fall& fall) {
  return fmt::format("xi = {:g}, {}", fall.xi, fall.rule == EndRule::attractive ? "attractive" : "clamped");
}

reference::DampedBounce exact_fall(const Fall& fall, double gap, double speed) {
  return {fall.frequency, fall.xi, gravity, gap, speed, same(fall.rule)};
}

Scene falling_disc(const Fall& fall, double gap, double speed, const Setup& setup) {
  const double xi = setup.has("dashpot_halved") ? 0.5 * fall.xi : fall.xi;
  const EndRule other = fall.rule == EndRule::attractive ? EndRule::clamped : EndRule::attractive;
  return scenes::bouncing_disc({.radius = 1.0,
                                .gap = gap,
                                .speed = speed,
                                .gravity = setup.has("weight_halved") ? 0.5 * gravity : gravity,
                                .contact = dashpot_of(xi, fall.frequency * fall.frequency, 1.0,
                                                      setup.has("other_end_rule") ? other : fall.rule)});
}

double contact_time(const Fall& fall) {
  const reference::Impact impact{fall.frequency * fall.frequency, 2.0 * fall.xi * fall.frequency, 1.0, 1.0};
  return reference::impact_events(impact, same(fall.rule)).contact_time;
}

std::vector<double> apexes(const Scene& scene, double step, int bounces, Findings& findings) {
  std::vector<double> found;
  bool acted = false;
  const double weight = -scene.model.gravity.y;
  const Until done = [&](const State& state) {
    const bool acts = state.mode[0] == UnilateralSpring::acting;
    if (acted && !acts) found.push_back(state.q[1] - 1.0 + 0.5 * state.v[1] * state.v[1] / weight);
    acted = acts;
    return static_cast<int>(found.size()) == bounces;
  };
  if (!run_scene(scene, VelocityVerlet{}, {step, 20.0, 20.0, false}, findings, {}, done).finished) found.clear();
  found.resize(static_cast<std::size_t>(bounces), NAN);
  return found;
}

}  // namespace talus::verification::problems
