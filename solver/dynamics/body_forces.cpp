#include "solver/dynamics/body_forces.hpp"

#include <algorithm>

#include "solver/dynamics/spans.hpp"

namespace talus {
namespace {

/// Adds a force [F] from outside that acts at world point p of each of several identical bodies, and a moment [F L], to
/// the rates of the impulse.
void accumulate(Rates& out, double multiplicity, Vec2 p, Vec2 force, double moment) {
  out.impulse[0] += multiplicity * force.x;
  out.impulse[1] += multiplicity * force.y;
  out.impulse[2] += multiplicity * (cross(p, force) + moment);
}

}  // namespace

BodyForces::BodyForces(const Model& model, const Layout& layout) : gravity_{model.gravity} {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const bool pinned = body.mobility == Mobility::pinned;
    const double inertia = pinned ? inertia_about_pin(body) : body.inertia;
    const Compiled compiled{i,
                            layout.first[i],
                            body.mass,
                            body.inertia,
                            1.0 / body.mass,
                            1.0 / inertia,
                            body.mass * model.gravity + body.force,
                            body.moment,
                            body.force,
                            body.p_WB,
                            body.angle,
                            rotation(body.angle),
                            pin(body),
                            -body.p_BPin,
                            static_cast<double>(body.multiplicity),
                            has_x(body.mobility)};
    array(body.mobility).push_back(compiled);
  }
  for (const Compiled& body : free_)
    weigh(body, body.first + 2);
  for (const Compiled& body : particles_)
    weigh(body, none);
  for (const Compiled& body : pinned_)
    weigh(body, body.first);
  for (const Compiled& body : sliding_)
    weigh(body, none);
  for (const Compiled& body : guided_)
    weigh(body, body.first + 1);
  only_free_ = particles_.empty() && pinned_.empty() && sliding_.empty() && guided_.empty();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    append(free_runs_, run_of(i));
    const Compiled& body = free_[i];
    constants_.inverse_mass.push_back(body.inverse_mass);
    constants_.inverse_inertia.push_back(body.inverse_inertia);
    constants_.load_x.push_back(body.load.x), constants_.load_y.push_back(body.load.y);
    constants_.moment.push_back(body.moment);
    constants_.multiplicity.push_back(body.multiplicity);
  }
}

std::vector<BodyForces::Compiled>& BodyForces::array(Mobility mobility) {
  switch (mobility) {
    case Mobility::free:
      return free_;
    case Mobility::particle:
      return particles_;
    case Mobility::pinned:
      return pinned_;
    case Mobility::sliding_x:
    case Mobility::sliding_y:
      return sliding_;
    case Mobility::guided_x:
    case Mobility::guided_y:
      return guided_;
    case Mobility::fixed:
      break;
  }
  return fixed_;
}

void BodyForces::set_fixed_poses(Workspace& work) const {
  for (const Compiled& body : fixed_)
    work.poses.set(body.body, {body.p_WB, body.R_WB, {}, 0.0});
}

void BodyForces::list_awake(ActiveSet& active) const {
  active.bodies.clear();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (active.awake[free_[i].body]) append(active.bodies, run_of(i));
  }
}

void BodyForces::set_velocities(const State& state, Workspace& work) const {
  for (const BodySpan& span : evaluated_spans(work))
    set_body_velocities(span, &state.v[free_[span.index].first], work.poses);
}

void BodyForces::set_poses(const State& state, Workspace& work) const {
  for (const BodySpan& span : evaluated_spans(work))
    set_body_poses(span, &state.q[free_[span.index].first], work.poses);
  if (only_free_) return;
  for (const Compiled& body : particles_) {
    const double* q = &state.q[body.first];
    const double* v = &state.v[body.first];
    work.poses.set(body.body, {{q[0], q[1]}, body.R_WB, {v[0], v[1]}, 0.0});
  }
  for (const Compiled& body : pinned_) {
    const Rotation R_WB = rotation(state.q[body.first]);
    const double w_WB = state.v[body.first];
    const Vec2 from_pin = R_WB * body.p_PinB;
    work.poses.set(body.body, {body.p_WPin + from_pin, R_WB, cross(w_WB, from_pin), w_WB});
  }
  for (const Compiled& body : sliding_) {
    const double q = state.q[body.first], v = state.v[body.first];
    work.poses.set(body.body, {body.along_x ? Vec2{q, body.p_WB.y} : Vec2{body.p_WB.x, q}, body.R_WB,
                               body.along_x ? Vec2{v, 0.0} : Vec2{0.0, v}, 0.0});
  }
  for (const Compiled& body : guided_) {
    const Rotation R_WB = rotation(state.q[body.first + 1]);
    const double q = state.q[body.first], v = state.v[body.first], w_WB = state.v[body.first + 1];
    const Vec2 r = R_WB * body.p_PinB;
    const Vec2 turning = cross(w_WB, r);
    work.poses.set(body.body, {body.along_x ? Vec2{q, body.p_WPin.y + r.y} : Vec2{body.p_WPin.x + r.x, q}, R_WB,
                               body.along_x ? Vec2{v, turning.y} : Vec2{turning.x, v}, w_WB});
  }
}

void BodyForces::rates(Workspace& work, Rates& out, bool ledger) const {
  // Behind the last awake body, rates that were zero remain zero.
  const std::size_t moving = work.active.moving;
  if (work.active.any_asleep) std::fill_n(out.v.begin(), std::min(std::max(out.moving, moving), out.v.size()), 0.0);
  out.moving = moving;
  for (const BodySpan& span : work.active.bodies) {
    accelerate_bodies(span, constants_, work.wrenches, &out.v[free_[span.index].first]);
  }
  if (ledger) {
    for (const BodySpan& span : free_runs_)
      add_impulses(span, constants_, work.poses, out.impulse);
  } else if (only_free_) {
    return;
  }
  for (const Compiled& body : particles_) {
    const Wrench wrench = work.wrenches[body.body];
    const Vec2 force = wrench.force + body.load;
    out.v[body.first] = body.inverse_mass * force.x;
    out.v[body.first + 1] = body.inverse_mass * force.y;
    // The support that prevents a particle from turning takes all moments on it, including the applied one.
    if (ledger) accumulate(out, body.multiplicity, work.poses[body.body].p_WB, body.load, -wrench.moment);
  }
  for (const Compiled& body : pinned_)
    pinned_rates(body, work, out, ledger);
  for (const Compiled& body : sliding_)
    sliding_rates(body, work, out, ledger);
  for (const Compiled& body : guided_)
    guided_rates(body, work, out, ledger);
  if (!ledger) return;
  for (const Compiled& body : fixed_) {
    const Wrench wrench = work.wrenches[body.body];
    accumulate(out, body.multiplicity, body.p_WB, -wrench.force, -wrench.moment);
  }
}

/// Moments about the pin, r from the pin to the centre of mass:  I_p alpha = M + r x F.
/// The pin exerts R = m a - F, where a = alpha x r - w^2 r is the acceleration of the centre of mass.
void BodyForces::pinned_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const {
  const Wrench wrench = work.wrenches[body.body];
  const Pose pose = work.poses[body.body];
  const Vec2 r = pose.p_WB - body.p_WPin;
  const Vec2 force = wrench.force + body.load;
  const double alpha = body.inverse_inertia * (wrench.moment + body.moment + cross(r, force));
  out.v[body.first] = alpha;
  if (!ledger) return;
  const Vec2 acceleration = cross(alpha, r) - (pose.w_WB * pose.w_WB) * r;
  accumulate(out, body.multiplicity, pose.p_WB, body.load, body.moment);
  accumulate(out, body.multiplicity, body.p_WPin, body.mass * acceleration - force, 0.0);
}

/// Along the guide m a = F; the guide takes the rest of the force and all moments.
void BodyForces::sliding_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const {
  const Wrench wrench = work.wrenches[body.body];
  const Vec2 force = wrench.force + body.load;
  out.v[body.first] = body.inverse_mass * (body.along_x ? force.x : force.y);
  if (!ledger) return;
  const Vec2 reaction = body.along_x ? Vec2{0.0, -force.y} : Vec2{-force.x, 0.0};
  accumulate(out, body.multiplicity, work.poses[body.body].p_WB, body.load + reaction, -wrench.moment);
}

/// Along the guide m a = F. Across it the centre of mass is at r(theta) from the pin; with c = r . n for the unit n
/// across, dc/dtheta = g and d2c/dtheta2 = -c, so that T = m c'^2/2 + I w^2/2 gives
///   (I + m g^2) alpha = M + g F_n + m g c w^2.
/// The guide exerts on the pin R = m (g alpha - c w^2) - F_n.
void BodyForces::guided_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const {
  const Wrench wrench = work.wrenches[body.body];
  const Pose pose = work.poses[body.body];
  const Vec2 r = pose.R_WB * body.p_PinB;
  const Vec2 force = wrench.force + body.load;
  const double across = body.along_x ? force.y : force.x;
  const double c = body.along_x ? r.y : r.x;
  const double g = body.along_x ? r.x : -r.y;
  const double square = pose.w_WB * pose.w_WB;
  const double alpha =
      (wrench.moment + body.moment + g * (across + body.mass * c * square)) / (body.inertia + body.mass * g * g);
  out.v[body.first] = body.inverse_mass * (body.along_x ? force.x : force.y);
  out.v[body.first + 1] = alpha;
  if (!ledger) return;
  const double reaction = body.mass * (g * alpha - c * square) - across;
  accumulate(out, body.multiplicity, pose.p_WB, body.load, body.moment);
  accumulate(out, body.multiplicity, pose.p_WB - r, body.along_x ? Vec2{0.0, reaction} : Vec2{reaction, 0.0}, 0.0);
}

void BodyForces::weigh(const Compiled& body, std::size_t angle) {
  append(weighed_, {weights_.mass.size(), body.body, 1});
  weights_.kinetic.push_back(0.5 * body.multiplicity * body.mass);
  weights_.turning.push_back(0.5 * body.multiplicity * body.inertia);
  weights_.weight.push_back(body.multiplicity * body.mass);
  weights_.multiplicity.push_back(body.multiplicity);
  weights_.mass.push_back(body.mass), weights_.inertia.push_back(body.inertia);
  weights_.force_x.push_back(body.force.x), weights_.force_y.push_back(body.force.y);
  weights_.moment.push_back(angle == none ? 0.0 : body.moment);
  weights_.reference_x.push_back(body.p_WB.x), weights_.reference_y.push_back(body.p_WB.y);
  weights_.angle.push_back(body.angle);
  weights_.angle_coordinate.push_back(angle == none ? 0 : angle);
  any_applied_ = any_applied_ || body.force != Vec2{} || body.moment != 0.0;
}

Energies BodyForces::energies(const State& state, const Workspace& work) const {
  const Poses& poses = work.poses;
  Energies sum;
  for (const BodySpan& span : weighed_) {
    add_energies(span, weights_, gravity_, poses, sum);
    if (any_applied_) add_applied(span, weights_, state.q.data(), poses, sum.applied);
  }
  return sum;
}

Momenta BodyForces::momenta(const Workspace& work) const {
  Momenta sum;
  for (const BodySpan& span : weighed_)
    add_momenta(span, weights_, work.poses, sum);
  return sum;
}

}  // namespace talus
