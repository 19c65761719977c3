#include "solver/dynamics/springs.hpp"

#include <algorithm>
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

/// Slopes of a contact law while it acts with this effective mass [M].
Tangent tangent_of(const ContactLaw& law, double effective_mass) {
  return std::visit([effective_mass](const auto& of) { return tangent(of, effective_mass); }, law);
}

/// c/k of a contact law with this effective mass [T]; 0 for laws that have none.
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

/// Makes springs of a scene from a workspace, which must have the gaps of the required ones.
class SpringMaker {
 public:
  SpringMaker(const Dynamics& dynamics, const Workspace& work) : dynamics_{dynamics}, work_{work} {}

  /// Spring of law instance i of contact c.
  Spring contact(std::size_t c, std::size_t i) const {
    const Gap& gap = work_.gaps[i];
    const InstancePair pair = dynamics_.contacts().pairs()[i];
    Spring spring = empty(gap.depth);
    add_gradient(dynamics_, work_, pair.a, gap.p_WC, gap.n_AB, spring.gradient);
    add_gradient(dynamics_, work_, pair.b, gap.p_WC, -gap.n_AB, spring.gradient);
    spring.effective_mass = effective_mass(spring.gradient, dynamics_.inertias());
    const Tangent slopes = tangent_of(dynamics_.model().contacts[c].law, finite_mass(spring));
    spring.stiffness = slopes.stiffness, spring.damping = slopes.damping;
    return spring;
  }
  Spring cable(std::size_t c) const {
    const CableForces& cables = dynamics_.cables();
    Spring spring = empty(cables.elongation(work_, c));
    spring.stiffness = cables.tangents()[c].stiffness, spring.damping = cables.tangents()[c].damping;
    const CableForces::Ends ends = cables.ends()[c];
    const Joint& a = cables.joints()[ends.a];
    const Joint& b = cables.joints()[ends.b];
    const Vec2 pull = work_.paths.pull(c);
    if (a.on_body) add_gradient(dynamics_, work_, a.body, work_.joints.p_WP(ends.a), -pull, spring.gradient);
    if (b.on_body) add_gradient(dynamics_, work_, b.body, work_.joints.p_WP(ends.b), pull, spring.gradient);
    spring.effective_mass = effective_mass(spring.gradient, dynamics_.inertias());
    return spring;
  }
  /// Spring of the friction of law instance i of contact c, which has friction; `normal`: the spring of the instance.
  Spring friction(std::size_t c, std::size_t i, const Spring& normal) const {
    const Contact& contact = dynamics_.model().contacts[c];
    const Gap& gap = work_.gaps[i];
    const InstancePair pair = dynamics_.contacts().pairs()[i];
    const Vec2 across{-gap.n_AB.y, gap.n_AB.x};
    Spring spring = empty(0.0);
    const CoulombFriction friction = std::visit([](const auto& law) { return law.stiffest(); }, *contact.friction);
    spring.stiffness = friction.stiffness;
    spring.damping = friction.dashpot(retardation_time(contact.law, finite_mass(normal)));
    // Bodies that are apart will touch at their surfaces, not in the middle between them.
    const Vec2 to_surface = std::max(0.0, -0.5 * gap.depth) * gap.n_AB;
    add_gradient(dynamics_, work_, pair.b, gap.p_WC + to_surface, across, spring.gradient);
    add_gradient(dynamics_, work_, pair.a, gap.p_WC - to_surface, -across, spring.gradient);
    spring.effective_mass = effective_mass(spring.gradient, dynamics_.inertias());
    return spring;
  }

 private:
  Spring empty(double deformation) const {
    return {.deformation = deformation, .gradient = std::vector<double>(dynamics_.inertias().size())};
  }
  static double finite_mass(const Spring& spring) {
    return std::isfinite(spring.effective_mass) ? spring.effective_mass : 0.0;
  }

  const Dynamics& dynamics_;
  const Workspace& work_;
};

/// True if a law exerts a force in a mode.
template <class Law>
bool exerts(const Law& law, Mode mode) {
  return std::visit([mode]<class L>(const L&) { return L::acts(mode); }, law);
}

/// Makes the springs that `wanted` selects, in the order of springs(). `wanted` receives a function of a state: whether
/// the spring acts in it.
template <class Wanted>
std::vector<Spring> make_springs(const Dynamics& dynamics, const Workspace& work, const Wanted& wanted) {
  const Model& model = dynamics.model();
  const Layout& layout = dynamics.layout();
  const SpringMaker make{dynamics, work};
  std::vector<Spring> found;
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const std::size_t first = layout.contact_slots[c].mode;
    for (std::size_t i = first; i < first + layout.contact_instances[c]; ++i) {
      if (wanted([&](const State& state) { return exerts(model.contacts[c].law, state.mode[i]); }))
        found.push_back(make.contact(c, i));
    }
  }
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    if (wanted([&](const State& state) { return exerts(model.cables[c].law, state.mode[layout.cable_slots[c].mode]); }))
      found.push_back(make.cable(c));
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    if (!model.contacts[c].friction) continue;
    const std::size_t first = layout.contact_slots[c].mode, friction = layout.friction_slots[c].mode;
    for (std::size_t i = 0; i < layout.contact_instances[c]; ++i) {
      if (wanted([&](const State& state) { return state.mode[friction + i] == CoulombFriction::sticking; }))
        found.push_back(make.friction(c, first + i, make.contact(c, first + i)));
    }
  }
  return found;
}

}  // namespace

std::vector<Spring> springs(const Dynamics& dynamics, const State& state) {
  Workspace work = dynamics.workspace();
  dynamics.update_all(state, work);
  return make_springs(dynamics, work, [](const auto&) { return true; });
}

std::vector<Spring> acting_springs(const Dynamics& dynamics, const State& state, const Workspace& work) {
  return make_springs(dynamics, work, [&state](const auto& acts) { return acts(state); });
}

}  // namespace talus
