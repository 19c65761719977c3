#include "solver/calibrate/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/dynamics/springs.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/stability/run_monitor.hpp"

namespace talus {
namespace {

/// When an impact is over.
enum class ImpactEnd {
  force,    ///< the law no longer acts
  parting,  ///< the surfaces have parted, as in ImpactLog; between a clamped force's end and this weights change speeds
};

/// Observes the first impact of a contact: the speed of its gap before the law acts, and after the impact.
class ImpactMonitor {
 public:
  ImpactMonitor(const Dynamics& dynamics, ContactId contact, ImpactEnd end)
      : dynamics_{&dynamics}, contact_{contact}, end_{end}, work_{dynamics.workspace()} {}

  void operator()(const State& seen, const StepInfo&) {
    if (stage_ == Stage::after) return;
    State state = seen;
    dynamics_->update_all(state, work_);
    dynamics_->update_modes(state, work_);
    const std::size_t first = dynamics_->layout().contact_slots[index(contact_)].mode;
    const std::size_t last = first + dynamics_->layout().contact_instances[index(contact_)];
    dynamics_->forces(state, work_, forces_);
    bool acts = false, is_open = true;
    std::size_t deepest = first;
    for (std::size_t i = first; i < last; ++i) {
      acts = acts || forces_.instances[i] != 0.0;
      is_open = is_open && state.mode[i] == 0;
      if (work_.gaps[i].depth > work_.gaps[deepest].depth) deepest = i;
    }
    if (stage_ == Stage::before && !acts) {
      approach_ = work_.rates[deepest];
      start_ = state.t;
      return;
    }
    if (acts) {
      if (stage_ == Stage::before && approach_ == 0.0) approach_ = work_.rates[deepest];
      stage_ = Stage::during;
      const double force = forces_.contacts[index(contact_)];
      impact_.largest_force = std::max(impact_.largest_force, force);
      impact_.minimum_force = std::min(impact_.minimum_force, force);
      impact_.largest_overlap = std::max(impact_.largest_overlap, work_.gaps[deepest].depth);
      return;
    }
    if (stage_ == Stage::during) impact_.contact_time = state.t - start_;
    stage_ = Stage::released;
    if (end_ == ImpactEnd::parting && !is_open) return;
    stage_ = Stage::after;
    impact_.restitution = -work_.rates[deepest] / approach_;
    impact_.approach_speed = approach_;
  }

  bool over() const { return stage_ == Stage::after; }
  bool has_started() const { return stage_ != Stage::before; }
  bool approached() const { return approach_ > 0.0; }
  const Impact& impact() const { return impact_; }

 private:
  enum class Stage { before, during, released, after };

  const Dynamics* dynamics_;
  ContactId contact_;
  ImpactEnd end_;
  Workspace work_;
  LawForces forces_;
  Stage stage_{Stage::before};
  double approach_{};
  double start_{};
  Impact impact_;
};

/// A value of the dissipation parameter for the restitution e to begin a search with: the one with which the spring of
/// the initial state has the damping ratio of the attractive rule.
double first_dissipation(const Scene& scene, ContactId contact, double e) {
  const Dynamics dynamics{scene.model};
  const std::size_t first = dynamics.layout().contact_slots[index(contact)].mode;
  const Spring spring = springs(dynamics, scene.initial)[first];
  const double wanted =
      2.0 * std::sqrt(spring.stiffness * spring.effective_mass) * damping_ratio(e, EndRule::attractive);
  const Scene with_one = with_dissipation(scene, contact, 1.0);
  const double of_one =
      std::visit([](const auto& law) { return law.tangent().damping; }, with_one.model.contacts[index(contact)].law);
  return wanted / of_one;
}

/// The first impact of a contact, or why there is none to report.
struct Followed {
  std::optional<Impact> impact;
  std::string why_not;
  bool stays{};  ///< the bodies met and did not part
};
Followed follow_impact(const Scene& scene, ContactId contact, ImpactEnd end,
                       const std::function<void()>& progress = {}) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  ImpactMonitor watch{dynamics, contact, end};
  State state = scene.initial;
  system.begin(state);
  // Monitored like a run: an impact in which bodies slip through or overlap too far gives no restitution.
  std::optional<RunMonitor> monitor;
  long step = 0;
  if (scene.plan.watch.tunnelling != CheckAction::off) monitor.emplace(scene, dynamics, state);
  Integrator integrator = scene.integrator;
  const Observer observer = std::ref(watch);
  const Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1}, [&](const Snapshot& seen) {
    if (monitor) monitor->check(seen, ++step);
    if (progress) progress();
    return watch.over() || (monitor && !monitor->violation().empty());
  });
  if (!outcome) return {{}, outcome.message, false};
  if (monitor && !monitor->violation().empty()) return {{}, monitor->violation(), false};
  if (!watch.has_started())
    return {{}, fmt::format("its bodies do not meet before the scene's end at t = {}", scene.plan.end), false};
  if (!watch.approached()) return {{}, "its bodies do not approach each other; they touch at the start", false};
  if (!watch.over())
    return {{}, fmt::format("its bodies do not part before the scene's end at t = {}", scene.plan.end), true};
  return {watch.impact(), {}, false};
}

/// Scene of a particle of the effective mass that approaches a fixed plane. Errors: InputError if the contact never
/// ends.
Scene impact_scene(const ContactLaw& law, double effective_mass, double speed, double step, double phase,
                   const Integrator& integrator) {
  const KnownImpact known = known_impact(law, effective_mass, speed);
  const double ending = known.contact_time;
  if (!std::isfinite(ending)) {
    throw InputError{"so strong a damping never lets the contact end under the attractive end rule"};
  }
  // Large enough that no overlap is comparable with the size of the circle.
  const double radius = 1e3 * known.largest_overlap;
  ModelBuilder builder;
  const BodyId ball = builder.add({.name = "ball",
                                   .mobility = Mobility::particle,
                                   .mass = effective_mass,
                                   .inertia = 0.0,
                                   .shape = Circle{radius},
                                   .p_WB = {0.0, radius + phase * speed * step}});
  const BodyId plane = builder.add({.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  builder.add(Contact{.name = "impact", .a = ball, .b = plane, .law = law});
  Scene scene{.title = "impact", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, ball, {0.0, -speed}, 0.0);
  scene.integrator = integrator;
  // Coarse steps prolong the contact; three times its duration plus a few steps is enough for all steps of practical
  // use.
  scene.plan = {step, 3.0 * ending + 4.0 * step, step, false, MonitorRules::off()};
  return scene;
}

Impact impact_of(const Scene& scene, ContactId contact, ImpactEnd end) {
  const Followed followed = follow_impact(scene, contact, end);
  if (followed.impact) return *followed.impact;
  throw InputError{fmt::format("contact '{}': {}", scene.model.contacts[index(contact)].name, followed.why_not)};
}

/// Number of phases over which the restitution of an advised step is averaged.
constexpr int phase_count = 64;

}  // namespace

KnownImpact known_impact(const ContactLaw& law, double effective_mass, double speed) {
  return std::visit(
      [&]<class L>(const L& of) -> KnownImpact {
        if constexpr (KnowsImpacts<L>)
          return {of.contact_time(effective_mass, speed), of.restitution(effective_mass, speed),
                  of.largest_overlap(effective_mass, speed)};
        throw InputError{fmt::format("the law '{}' has no impact in closed form", L::name)};
      },
      law);
}

ContactLaw with_dissipation(ContactLaw contact_law, double value) {
  std::visit(
      [&]<class L>(L& law) {
        if constexpr (SetsEveryRestitution<L>) {
          law.*restitution_parameter<L>().member = value;
          if constexpr (HasDampingRatio<L>) law.damping_ratio = 0.0;
        } else {
          throw InputError{fmt::format("the law '{}' has no damping", L::name)};
        }
      },
      contact_law);
  return contact_law;
}

Scene with_dissipation(Scene scene, ContactId contact, double value) {
  Contact& changed = scene.model.contacts[index(contact)];
  try {
    changed.law = with_dissipation(changed.law, value);
  } catch (const InputError& error) {
    throw InputError{fmt::format("contact '{}': {}", changed.name, error.what())};
  }
  return scene;
}

Impact simulate_impact(const Scene& scene, ContactId contact) { return impact_of(scene, contact, ImpactEnd::parting); }

Impact simulate_impact(const ContactLaw& law, double effective_mass, double speed, double step, double phase,
                       const Integrator& integrator) {
  return impact_of(impact_scene(law, effective_mass, speed, step, phase, integrator), ContactId{0}, ImpactEnd::force);
}

ImpactError restitution_error(const ContactLaw& law, double effective_mass, double speed,
                              const Integrator& integrator) {
  const KnownImpact known = known_impact(law, effective_mass, speed);
  demand_closed_form(impact_scene(law, effective_mass, speed, known.contact_time, 0.5, integrator).model, integrator);
  const double exact = known.restitution;
  return [=](double step, double phase) {
    const Followed followed = follow_impact(impact_scene(law, effective_mass, speed, step, phase, integrator),
                                            ContactId{0}, ImpactEnd::force);
    // A step so long that the contact does not end, or the run diverges, is rejected.
    return followed.impact ? std::abs(followed.impact->restitution - exact) : std::numeric_limits<double>::infinity();
  };
}

ImpactStep advise_impact_step(const ContactLaw& law, double effective_mass, double speed, double bound,
                              const Integrator& integrator) {
  const StepOfImpact accurate = accurate_step(restitution_error(law, effective_mass, speed, integrator),
                                              known_impact(law, effective_mass, speed).contact_time, bound,
                                              std::numeric_limits<double>::infinity());
  ImpactStep found{accurate.step, 0.0, accurate.largest_error};
  for (int i = 0; i < phase_count; ++i) {
    const double phase = (i + 0.5) / phase_count;
    const Impact impact = simulate_impact(law, effective_mass, speed, found.step, phase, integrator);
    found.restitution += impact.restitution / phase_count;
  }
  return found;
}

Calibration calibrate(const Scene& scene, ContactId contact, double e, double tolerance,
                      const std::function<void()>& progress) {
  if (!(e > 0.0 && e <= 1.0)) throw InputError{fmt::format("restitution is {}; it must be in (0, 1]", e)};
  Calibration found;
  const std::string& name = scene.model.contacts[index(contact)].name;
  const auto excess = [&](double value) {
    ++found.runs;
    const Followed followed =
        follow_impact(with_dissipation(scene, contact, value), contact, ImpactEnd::parting, progress);
    if (followed.impact) {
      const double now = followed.impact->restitution - e;
      if (found.runs == 1 || std::abs(now) < std::abs(found.impact.restitution - e))
        found.dissipation = value, found.impact = *followed.impact;
      return now;
    }
    // So much damping that a weight keeps the bodies together: no rebound.
    if (followed.stays && value > 0.0) return -e;
    throw InputError{fmt::format("contact '{}': {}", name, followed.why_not)};
  };
  const double undamped = excess(0.0);
  if (std::abs(undamped) <= tolerance) return found;
  if (undamped < 0.0) {
    throw InputError{
        fmt::format("contact '{}': restitution {} is not reachable; without any damping the scene gives {:.6g}", name,
                    e, undamped + e)};
  }
  double low = 0.0, high = first_dissipation(scene, contact, e);
  double at_low = undamped, at_high = excess(high);
  for (int doubling = 0; at_high > 0.0; ++doubling) {
    if (doubling == 20) {
      throw InputError{
          fmt::format("contact '{}': restitution {} is not reached with a damping parameter of {:.6g}", name, e, high)};
    }
    low = high, at_low = at_high;
    high *= 2.0, at_high = excess(high);
  }
  // The simulated e jumps slightly when the end of the contact moves from one step to the next: the search stops at the
  // required tolerance in e, or when the bracket is as narrow as floating-point numbers allow.
  std::uintmax_t maximum = 100;
  const auto until_tolerance = [&](double value) {
    const double now = excess(value);
    return std::abs(now) <= tolerance ? 0.0 : now;
  };
  if (at_high != 0.0) {
    boost::math::tools::toms748_solve(until_tolerance, low, high, at_low, at_high,
                                      boost::math::tools::eps_tolerance<double>(50), maximum);
  }
  return found;
}

}  // namespace talus
