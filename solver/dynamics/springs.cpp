#include "solver/dynamics/springs.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

#include "solver/dynamics/point_gradient.hpp"

namespace talus {
namespace {

/// Adds the derivative of (direction . position of the body's point at p_WP) to the gradient.
void add_gradient(const Dynamics& dynamics, const Workspace& work, BodyId body, Vec2 p_WP, Vec2 direction,
                  std::vector<double>& gradient) {
  for_each_gradient(dynamics, work, body, p_WP, direction,
                    [&gradient](std::size_t i, double derivative) { gradient[i] += derivative; });
}

/// The law of a contact while it acts with this effective mass [M].
Tangent tangent_of(const ContactLaw& law, double effective_mass) {
  return std::visit([effective_mass](const auto& of) { return tangent(of, effective_mass); }, law);
}

/// c/k of a contact law of this effective mass [T]; 0 of laws that have none.
double retardation_time(const ContactLaw& law, double effective_mass) {
  return std::visit(
      [effective_mass]<class L>(const L& of) {
        if constexpr (HasRetardationTime<L>) {
          const Tangent slopes = tangent(of, effective_mass);
          return slopes.damping / slopes.stiffness;
        }
        return 0.0;
      },
      law);
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
  for (std::size_t c = 0, i = 0; c < dynamics.model().contacts.size(); ++c) {
    const std::size_t last = i + dynamics.layout().contact_instances[c];
    for (; i < last; ++i) {
      const Gap& gap = work.gaps[i];
      Spring spring{.extent = gap.depth, .gradient = std::vector<double>(state.q.size())};
      add_gradient(dynamics, work, contacts.pairs()[i].a, gap.p_WC, gap.n_AB, spring.gradient);
      add_gradient(dynamics, work, contacts.pairs()[i].b, gap.p_WC, -gap.n_AB, spring.gradient);
      const double mass = effective_mass(spring.gradient, dynamics.inertias());
      const Tangent slopes = tangent_of(dynamics.model().contacts[c].law, std::isfinite(mass) ? mass : 0.0);
      spring.stiffness = slopes.stiffness, spring.damping = slopes.damping;
      found.push_back(std::move(spring));
    }
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
      const double normal_mass = effective_mass(found[i].gradient, dynamics.inertias());
      const double time =
          retardation_time(dynamics.model().contacts[c].law, std::isfinite(normal_mass) ? normal_mass : 0.0);
      Spring spring{friction->stiffness, friction->dashpot(time), 0.0, 0.0, std::vector<double>(state.q.size())};
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
