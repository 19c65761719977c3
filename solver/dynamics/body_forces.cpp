#include "solver/dynamics/body_forces.hpp"

#include <algorithm>

namespace talus {
namespace {

/// Books a force [F] from outside that acts at world point p of each of several identical bodies, and a moment [F L]
/// beside it.
void book(Rates& out, double copies, Vec2 p, Vec2 force, double moment) {
  out.impulse[0] += copies * force.x;
  out.impulse[1] += copies * force.y;
  out.impulse[2] += copies * (cross(p, force) + moment);
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
                            static_cast<double>(body.copies)};
    (body.mobility == Mobility::free       ? free_
     : body.mobility == Mobility::particle ? particles_
     : pinned                              ? pinned_
                                           : fixed_)
        .push_back(compiled);
  }
}

void BodyForces::place_fixed(Workspace& work) const {
  for (const Compiled& body : fixed_)
    work.poses[body.body] = {body.p_WB, body.R_WB, {}, 0.0};
}

void BodyForces::list_awake(Waking& waking) const {
  waking.bodies.clear();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (waking.awake[free_[i].body]) waking.bodies.push_back(i);
  }
}

void BodyForces::update(const State& state, Workspace& work) const {
  const auto place = [&](const Compiled& body) {
    const double* q = &state.q[body.first];
    const double* v = &state.v[body.first];
    work.poses[body.body] = {{q[0], q[1]}, rotation(q[2]), {v[0], v[1]}, v[2]};
  };
  if (work.waking.whole) {
    for (const Compiled& body : free_)
      place(body);
  } else {
    for (const std::size_t i : work.waking.bodies)
      place(free_[i]);
  }
  for (const Compiled& body : particles_) {
    const double* q = &state.q[body.first];
    const double* v = &state.v[body.first];
    work.poses[body.body] = {{q[0], q[1]}, body.R_WB, {v[0], v[1]}, 0.0};
  }
  for (const Compiled& body : pinned_) {
    const Rotation R_WB = rotation(state.q[body.first]);
    const double w_WB = state.v[body.first];
    const Vec2 from_pin = R_WB * body.p_PinB;
    work.poses[body.body] = {body.p_WPin + from_pin, R_WB, cross(w_WB, from_pin), w_WB};
  }
}

void BodyForces::rates(Workspace& work, Rates& out, bool ledger) const {
  const Waking& waking = work.waking;
  if (waking.bodies.size() < free_.size()) std::fill(out.v.begin(), out.v.end(), 0.0);
  for (const std::size_t i : waking.bodies) {
    const Compiled& body = free_[i];
    const Wrench& wrench = work.wrenches[body.body];
    const Vec2 force = wrench.force + body.load;
    out.v[body.first] = body.inverse_mass * force.x;
    out.v[body.first + 1] = body.inverse_mass * force.y;
    out.v[body.first + 2] = body.inverse_inertia * (wrench.moment + body.moment);
  }
  if (ledger) {
    for (const Compiled& body : free_)
      book(out, body.copies, work.poses[body.body].p_WB, body.load, body.moment);
  }
  for (const Compiled& body : particles_) {
    const Wrench& wrench = work.wrenches[body.body];
    const Vec2 force = wrench.force + body.load;
    out.v[body.first] = body.inverse_mass * force.x;
    out.v[body.first + 1] = body.inverse_mass * force.y;
    // What keeps a particle from turning takes all moments on it, the applied one included.
    if (ledger) book(out, body.copies, work.poses[body.body].p_WB, body.load, -wrench.moment);
  }
  for (const Compiled& body : pinned_)
    pinned_rates(body, work, out, ledger);
  if (!ledger) return;
  for (const Compiled& body : fixed_) {
    const Wrench& wrench = work.wrenches[body.body];
    book(out, body.copies, body.p_WB, -wrench.force, -wrench.moment);
  }
}

/// Moments about the pin, r from the pin to the centre of mass:  I_p alpha = M + r x F.
/// The pin pushes the body with R = m a - F, where a = alpha x r - w^2 r is how the centre of mass must accelerate.
void BodyForces::pinned_rates(const Compiled& body, const Workspace& work, Rates& out, bool ledger) const {
  const Wrench& wrench = work.wrenches[body.body];
  const Pose& pose = work.poses[body.body];
  const Vec2 r = pose.p_WB - body.p_WPin;
  const Vec2 force = wrench.force + body.load;
  const double alpha = body.inverse_inertia * (wrench.moment + body.moment + cross(r, force));
  out.v[body.first] = alpha;
  if (!ledger) return;
  const Vec2 acceleration = cross(alpha, r) - (pose.w_WB * pose.w_WB) * r;
  book(out, body.copies, pose.p_WB, body.load, body.moment);
  book(out, body.copies, body.p_WPin, body.mass * acceleration - force, 0.0);
}

Energies BodyForces::energies(const State& state, const Workspace& work) const {
  Energies sum;
  const auto add = [&](const Compiled& body, double turned) {
    const Pose& pose = work.poses[body.body];
    sum.kinetic += 0.5 * body.copies * body.mass * dot(pose.v_WB, pose.v_WB);
    if (body.inertia > 0.0) sum.kinetic += 0.5 * body.copies * body.inertia * pose.w_WB * pose.w_WB;
    sum.gravity -= body.copies * body.mass * dot(gravity_, pose.p_WB);
    sum.applied -= body.copies * (dot(body.force, pose.p_WB - body.p_WB) + body.moment * turned);
  };
  for (const Compiled& body : free_)
    add(body, state.q[body.first + 2] - body.angle);
  for (const Compiled& body : particles_)
    add(body, 0.0);
  for (const Compiled& body : pinned_)
    add(body, state.q[body.first] - body.angle);
  return sum;
}

Momenta BodyForces::momenta(const Workspace& work) const {
  Momenta sum;
  for (const auto* bodies : {&free_, &particles_, &pinned_}) {
    for (const Compiled& body : *bodies) {
      const Pose& pose = work.poses[body.body];
      sum.linear += body.copies * body.mass * pose.v_WB;
      sum.angular += body.copies * (body.mass * cross(pose.p_WB, pose.v_WB) + body.inertia * pose.w_WB);
    }
  }
  return sum;
}

}  // namespace talus
