#include "solver/dynamics/springs.hpp"

namespace talus {
namespace {

/// Adds the derivative of (direction . position of the body's point at p_WP) to the gradient.
void add_gradient(const Dynamics& dynamics, const Workspace& work, BodyId body, Vec2 p_WP, Vec2 direction,
                  std::vector<double>& gradient) {
  const Layout& layout = dynamics.layout();
  const Body& moved = dynamics.model().bodies[index(body)];
  Vec2 center = moved.mobility == Mobility::pinned ? pin(moved) : work.poses[index(body)].p_WB;
  // A guided body turns about the point level with its pin, across the guide from its centre of mass.
  const Vec2 pin_now = world_point(work.poses[index(body)], moved.p_BPin);
  if (moved.mobility == Mobility::guided_x) center.x = pin_now.x;
  if (moved.mobility == Mobility::guided_y) center.y = pin_now.y;
  for (std::size_t i = layout.first[index(body)]; i < layout.first[index(body) + 1]; ++i) {
    const Axis axis = layout.coordinates[i].axis;
    gradient[i] += axis == Axis::x   ? direction.x
                   : axis == Axis::y ? direction.y
                                     : dot(cross(1.0, p_WP - center), direction);
  }
}

double effective_mass(const std::vector<double>& gradient, const std::vector<double>& inertias) {
  double mobility = 0.0;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    mobility += gradient[i] * gradient[i] / inertias[i];
  return 1.0 / mobility;
}

}  // namespace

std::vector<Spring> springs(const Dynamics& dynamics, const State& state) {
  Workspace work = dynamics.workspace();
  dynamics.update_all(state, work);
  std::vector<Spring> found;
  const ContactForces& contacts = dynamics.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Gap& gap = work.gaps[i];
    Spring spring{contacts.tangents()[i].stiffness, contacts.tangents()[i].damping, gap.depth, 0.0,
                  std::vector<double>(state.q.size())};
    add_gradient(dynamics, work, contacts.pairs()[i].a, gap.p_WC, gap.n_AB, spring.gradient);
    add_gradient(dynamics, work, contacts.pairs()[i].b, gap.p_WC, -gap.n_AB, spring.gradient);
    found.push_back(std::move(spring));
  }
  const CableForces& cables = dynamics.cables();
  for (std::size_t c = 0; c < cables.size(); ++c) {
    Spring spring{cables.tangents()[c].stiffness, cables.tangents()[c].damping, cables.elongation(work, c), 0.0,
                  std::vector<double>(state.q.size())};
    const CableForces::Ends ends = cables.ends()[c];
    const Joint& a = cables.joints()[ends.a];
    const Joint& b = cables.joints()[ends.b];
    const Vec2 pull = work.paths.pull(c);
    if (a.on_body) add_gradient(dynamics, work, a.body, work.joints.p_WP(ends.a), -pull, spring.gradient);
    if (b.on_body) add_gradient(dynamics, work, b.body, work.joints.p_WP(ends.b), pull, spring.gradient);
    found.push_back(std::move(spring));
  }
  for (std::size_t c = 0, i = 0; c < dynamics.model().contacts.size(); ++c) {
    const std::optional<CoulombFriction>& friction = dynamics.model().contacts[c].friction;
    const std::size_t last = i + dynamics.layout().contact_instances[c];
    for (; i < last; ++i) {
      if (!friction) continue;
      const Vec2 across{-work.gaps[i].n_AB.y, work.gaps[i].n_AB.x};
      Spring spring{friction->stiffness, 0.0, 0.0, 0.0, std::vector<double>(state.q.size())};
      add_gradient(dynamics, work, contacts.pairs()[i].b, work.gaps[i].p_WC, across, spring.gradient);
      add_gradient(dynamics, work, contacts.pairs()[i].a, work.gaps[i].p_WC, -across, spring.gradient);
      found.push_back(std::move(spring));
    }
  }
  for (Spring& spring : found)
    spring.effective_mass = effective_mass(spring.gradient, dynamics.inertias());
  return found;
}

}  // namespace talus
