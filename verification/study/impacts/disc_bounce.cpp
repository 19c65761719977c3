#include "verification/study/impacts/disc_bounce.hpp"

#include <algorithm>
#include <cmath>

#include "solver/scenes/bouncing_disc.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/runs/phases.hpp"

namespace talus::verification::problems {

const char* word_for(EndRule rule) { return rule == EndRule::attractive ? "attractive" : "clamped"; }

Bounce bounce(double e, EndRule rule, const Setup& setup) {
  Bounce b{e, rule, reference::damping_ratio(e, same(rule)), {}, {}};
  b.law = dashpot_of(b.xi, 1.0, 1.0, rule);
  b.exact = reference::impact_events({1.0, b.law.damping, 1.0, 1.0}, same(rule));
  if (setup.has("eq_21_halved")) b.law.damping *= 0.5;
  if (setup.has("never_pulls")) b.law.end_rule = EndRule::clamped;
  if (setup.has("eq_21_under_clamping")) b.law.damping = reference::eq_21_damping(e, 1.0, 1.0);
  return b;
}

Scene disc_at(const Bounce& b, double gap) {
  return scenes::bouncing_disc({.radius = 8.0, .gap = gap, .speed = 1.0, .contact = b.law});
}

FollowedImpact impact_at_phase(const SceneAtGap& scene_at, const Integrator& integrator, double contact_time,
                               double step, double phase, Findings& findings) {
  const double gap = phase * step;
  Scene scene = scene_at(gap);
  scene.integrator = integrator;
  scene.plan = {step, gap + 3.0 * contact_time + 4.0 * step, contact_time, false};
  FollowedImpact found = follow_impact(scene, findings);
  found.end_time -= gap;
  return found;
}

ImpactErrors impact_errors(const SceneAtGap& scene_at, const reference::ImpactEvents& exact, double steps,
                           const Integrator& integrator, Findings& findings, bool commensurate) {
  ImpactErrors found;
  for (const auto& [i, step, phase] : offset_phases(exact.contact_time, steps, fewest_phases, commensurate)) {
    const FollowedImpact impact = impact_at_phase(scene_at, integrator, exact.contact_time, step, phase, findings);
    found.restitution.add(impact.restitution() / exact.restitution - 1.0);
    found.contact_time.add(impact.end_time / exact.contact_time - 1.0);
    found.largest_depth.add(impact.largest_depth / exact.largest_depth - 1.0);
    found.identity.add(
        impact.restitution() / exact.restitution / std::pow(impact.largest_depth / exact.largest_depth, 2) - 1.0);
    found.pull.add(impact.minimum_deceleration - exact.force_at_end);
    found.mean_restitution += impact.restitution() / static_cast<double>(fewest_phases);
    found.minimum_deceleration = std::min(found.minimum_deceleration, impact.minimum_deceleration);
  }
  return found;
}

double reduced_step(const reference::ImpactEvents& exact, double steps) {
  return exact.frequency * exact.contact_time / (steps + 0.5);
}

double predicted_restitution_error(const Bounce& b, double steps) {
  const double first = b.xi == 0.0 ? 0.0 : leapfrog_impact_error(b.xi, same(b.rule)).restitution;
  return std::hypot(first * reduced_step(b.exact, steps), second_order_constant / std::pow(steps + 0.5, 2));
}

Tolerance near_prediction(EndRule rule) {
  return (rule == EndRule::attractive
              ? Tolerance::model(uneven_end,
                                 "predicted from the half-step lag and the force jumps; the next power of the step is "
                                 "4 % of it, the end's jump at 64 uneven phases leaves 6 %")
              : Tolerance::model(next_power,
                                 "predicted from the half-step lag and the force jump; the next power of the step is "
                                 "4 % of it"))
      .relative();
}

}  // namespace talus::verification::problems
