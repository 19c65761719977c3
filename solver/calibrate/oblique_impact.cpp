#include "solver/calibrate/oblique_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {
namespace {

/// Local errors of the method, relative to the displacement.
constexpr double tolerance = 1e-10;
/// Number of times in a contact at which it is observed.
constexpr double steps_in_contact = 400.0;
/// Largest error of the tangential restitution that a calibration reaches: restitutions jump by some 1e-5 where the
/// number of steps to an event changes.
constexpr double largest_jump = 1e-4;
/// Largest overlap over the radius of the smaller body, as of runs that are monitored.
constexpr double deepest = 0.5;

struct ObliqueScene {
  Scene scene;
  BodyId second{};
};

/// Body 2 above body 1, which rests, moves right and down; they touch at `lead`.
ObliqueScene scene_of(const ObliqueImpact& impact, double contact_time, double step, double lead,
                      const Integrator& integrator) {
  const Vec2 velocity{impact.slip_speed(), -impact.approach_speed()};
  const auto body = [](const char* name, const RoundBody& of, Vec2 position) {
    return Body{.name = name, .mass = of.mass, .inertia = of.inertia, .shape = Circle{of.radius}, .p_WB = position};
  };
  ModelBuilder builder;
  const BodyId first = impact.first ? builder.add(body("first", *impact.first, {0.0, -impact.first->radius}))
                                    : builder.add({.name = "plane", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const BodyId second =
      builder.add(body("second", impact.second, {-lead * velocity.x, impact.second.radius - lead * velocity.y}));
  builder.add(Contact{.name = "impact", .a = second, .b = first, .law = impact.law, .friction = impact.friction});
  ObliqueScene made{{.title = "oblique impact", .model = builder.build()}, second};
  made.scene.initial = rest_state(made.scene.model);
  set_velocity(made.scene.model, made.scene.initial, second, velocity, 0.0);
  made.scene.integrator = integrator;
  made.scene.plan = {step, lead + 3.0 * contact_time + 4.0 * step, step, false, MonitorRules::off()};
  return made;
}

/// Observes the contact: whether it has ended, and how long it sticks.
class ContactMonitor {
 public:
  ContactMonitor(const Layout& layout, const ObliqueImpact& impact)
      : acts_{std::visit([]<class L>(const L&) -> bool (*)(Mode) { return &L::acts; }, impact.law)},
        law_{impact.friction},
        normal_{layout.contact_slots.front().mode},
        friction_{layout.friction_slots.front()} {}

  void operator()(const Snapshot& seen, const StepInfo&) {
    const State& state = seen.state();
    const bool acts = acts_(state.mode[normal_]), sticks = acts && is_within_limit(seen);
    sticking_ += 0.5 * (state.t - time_) * (static_cast<double>(sticks) + static_cast<double>(has_stuck_));
    has_acted_ = has_acted_ || acts;
    is_over_ = is_over_ || (has_acted_ && !acts);
    time_ = state.t, has_stuck_ = sticks;
  }

  bool is_over() const { return is_over_; }
  double sticking() const { return sticking_; }  ///< [T]

 private:
  /// Modes do not say it: a stretch at the limit of the friction, to which it has just been reduced, is within it.
  bool is_within_limit(const Snapshot& seen) const {
    constexpr double rounding = 1e-9;
    const State& state = seen.state();
    const double limit = at(law_, seen.geometry().gaps[normal_].depth).stretch_limit(seen.forces().instances[normal_]);
    return state.mode[friction_.mode] == CoulombFriction::sticking &&
           std::abs(state.z[friction_.memory]) < (1.0 - rounding) * limit;
  }

  bool (*acts_)(Mode);
  FrictionLaw law_;
  std::size_t normal_;
  Slot friction_;
  bool has_acted_{}, is_over_{}, has_stuck_{};
  double time_{}, sticking_{};
};

/// The rebound with this step; none if the contact does not end.
std::optional<ObliqueRebound> simulated(const ObliqueImpact& impact, double contact_time, double step, double lead,
                                        Integrator integrator) {
  const ObliqueScene made = scene_of(impact, contact_time, step, lead, integrator);
  const Dynamics dynamics{made.scene.model};
  RigidBodySystem system{dynamics, false};
  ContactMonitor monitor{dynamics.layout(), impact};
  State state = made.scene.initial;
  system.begin(state);
  const Observer observer = std::ref(monitor);
  const Outcome outcome = simulate(system, integrator, state, made.scene.plan, {&observer, 1},
                                   [&monitor](const State&) { return monitor.is_over(); });
  if (!outcome || !monitor.is_over()) return {};
  const std::size_t at = dynamics.layout().first[index(made.second)];
  Vec2 velocity{state.v[at], state.v[at + 1]};
  const double spin = -state.v[at + 2];
  double rim = spin * impact.second.radius;
  if (impact.first) {
    velocity = velocity - Vec2{state.v[0], state.v[1]};
    rim -= state.v[2] * impact.first->radius;
  }
  ObliqueRebound found;
  found.restitution = velocity.y / impact.approach_speed();
  found.tangential_restitution = velocity.x / impact.slip_speed();
  found.rotational_restitution = (rim - velocity.x) / impact.slip_speed();
  found.angle = std::atan2(velocity.x, velocity.y);
  found.spin = spin;
  found.sticking = monitor.sticking() / contact_time;
  return found;
}

/// Contact time of the impact [T]. Errors: see rebound().
double contact_time_of(const ObliqueImpact& impact) {
  if (!(impact.angle > 0.0 && impact.angle < 0.5 * std::numbers::pi && impact.speed > 0.0))
    throw InputError{"an oblique impact needs an angle in (0, 90) degrees and a speed > 0"};
  const KnownImpact known = known_impact(impact.law, impact.effective_mass(), impact.approach_speed());
  if (!std::isfinite(known.contact_time))
    throw InputError{"so strong a damping never lets the contact end; choose a smaller one, or the clamped end rule"};
  const double radius = std::min(impact.second.radius, impact.first ? impact.first->radius : impact.second.radius);
  if (const double depth = known.largest_overlap / radius; depth > deepest) {
    throw InputError{
        fmt::format("the largest overlap would be {:.3g} times the radius; it must be at most {}", depth, deepest)};
  }
  return known.contact_time;
}

ObliqueRebound rebound(const ObliqueImpact& impact, double contact_time) {
  // The method's local errors are relative to the largest displacement so far. Positions are rounded to 1e-16 of the
  // radius: the bodies first approach each other by enough that this is less than the errors, if four contact times
  // suffice for it, or else the errors are larger.
  constexpr double resolved = 1e-14;
  const double radius = std::max(impact.second.radius, impact.first ? impact.first->radius : 0.0);
  const double lead = std::min(resolved / tolerance * radius / impact.speed, 4.0 * contact_time);
  const double allowed = std::max(tolerance, resolved * radius / (impact.speed * lead));
  const auto found = simulated(impact, contact_time, contact_time / steps_in_contact, lead,
                               make_integrator("stormer_cowell", allowed));
  if (!found) throw InputError{"the contact does not end within three times the contact time of its normal impact"};
  return *found;
}

/// Values of a parameter: 0 or nothing, then a logarithmic range.
struct Span {
  bool has_zero{};
  double smallest{}, largest{};
};

Span span_of(const ObliqueImpact& impact, std::string_view name, double contact_time) {
  const double m = impact.effective_mass(), n = impact.mobility();
  const KnownImpact known = known_impact(impact.law, m, impact.approach_speed());
  const auto at_unit = [&] { return at(with_parameter(impact.friction, name, 1.0), known.largest_overlap); };
  if (name == "friction") {
    const double stops = std::tan(impact.angle) / (n * (1.0 + known.restitution));
    return {true, 1e-3 * stops, 10.0 * stops};
  }
  if (name == "shear_damping") {
    const CoulombFriction unit = at_unit();
    const double critical = 2.0 * std::sqrt(unit.stiffness * m / n) / unit.damping;
    return {true, 1e-3 * critical, 10.0 * critical};
  }
  const double normal = m * std::pow(std::numbers::pi / contact_time, 2);
  return {false, 1e-3 * normal / at_unit().stiffness, 10.0 * normal / at_unit().stiffness};
}

/// A value of the parameter, and the tangential restitution that it gives.
using Sample = std::pair<double, double>;

/// Samples of the span, in increasing order. They end at a value that the method cannot simulate: a spring that is soft
/// beside its dashpot relaxes without end; friction by Mindlin's law that is too strong to slip at touch has a stretch
/// whose rate is infinite there. Stiffnesses are sampled from the largest one on, other parameters from the smallest.
template <class Function>
std::vector<Sample> samples_of(const Span& span, const Function& restitution) {
  constexpr double values_a_decade = 12.0;
  const int count = static_cast<int>(std::ceil(values_a_decade * std::log10(span.largest / span.smallest)));
  std::vector<double> values;
  if (span.has_zero) values.push_back(0.0);
  for (int i = 0; i <= count; ++i)
    values.push_back(span.smallest * std::pow(span.largest / span.smallest, static_cast<double>(i) / count));
  if (!span.has_zero) std::ranges::reverse(values);
  std::vector<Sample> samples;
  try {
    for (const double value : values)
      samples.emplace_back(value, restitution(value));
  } catch (const InputError&) {
    if (samples.empty()) throw;
  }
  if (!span.has_zero) std::ranges::reverse(samples);
  return samples;
}

/// Inserts the extremes between the samples.
template <class Function>
void add_extremes(std::vector<Sample>& samples, const Function& restitution) {
  constexpr int bits = 26;
  for (const double sign : {1.0, -1.0}) {
    const auto best = std::ranges::min_element(samples, {}, [sign](const Sample& of) { return sign * of.second; });
    if (best == samples.begin() || best + 1 == samples.end()) continue;
    const auto [value, smallest] = boost::math::tools::brent_find_minima(
        [&](double x) { return sign * restitution(x); }, (best - 1)->first, (best + 1)->first, bits);
    samples.insert(value < best->first ? best : best + 1, {value, sign * smallest});
  }
}

}  // namespace

double ObliqueImpact::approach_speed() const { return speed * std::cos(angle); }

double ObliqueImpact::slip_speed() const { return speed * std::sin(angle); }

double ObliqueImpact::effective_mass() const {
  return first ? first->mass * second.mass / (first->mass + second.mass) : second.mass;
}

double ObliqueImpact::mobility() const {
  const auto of = [](const RoundBody& body) { return 1.0 / body.mass + body.radius * body.radius / body.inertia; };
  return effective_mass() * (of(second) + (first ? of(*first) : 0.0));
}

ObliqueRebound rebound(const ObliqueImpact& impact) { return rebound(impact, contact_time_of(impact)); }

ImpactError rebound_error(const ObliqueImpact& impact, const Integrator& integrator) {
  const double time = contact_time_of(impact);
  const ObliqueRebound exact = rebound(impact, time);
  return [=](double step, double phase) {
    const auto found = simulated(impact, time, step, phase * step, integrator);
    if (!found) return std::numeric_limits<double>::infinity();
    return std::max(std::abs(found->restitution - exact.restitution),
                    std::abs(found->tangential_restitution - exact.tangential_restitution));
  };
}

FrictionLaw with_parameter(FrictionLaw friction, std::string_view name, double value) {
  std::visit(
      [&]<class F>(F& law) {
        const auto fields = F::fields();
        const auto field = std::ranges::find(fields, name, &Field<F>::name);
        TALUS_DEMAND(field != fields.end());
        law.*field->member = value;
      },
      friction);
  return friction;
}

TangentialCalibration calibrate_tangential(const ObliqueImpact& impact, std::string_view name, double e_t) {
  const double time = contact_time_of(impact);
  const auto with = [&](double value) {
    ObliqueImpact changed = impact;
    changed.friction = with_parameter(impact.friction, name, value);
    return changed;
  };
  const auto restitution = [&](double value) { return rebound(with(value), time).tangential_restitution; };
  std::vector<Sample> samples = samples_of(span_of(impact, name, time), restitution);
  add_extremes(samples, restitution);
  std::string jump;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const auto [low, at_low] = samples[i];
    const auto [high, at_high] = samples[i + 1];
    if ((at_low - e_t) * (at_high - e_t) > 0.0) continue;
    std::uintmax_t passes = 60;
    const auto excess = [&](double value) { return restitution(value) - e_t; };
    const auto [below, above] =
        at_low == e_t ? Sample{low, low}
                      : boost::math::tools::toms748_solve(excess, low, high, at_low - e_t, at_high - e_t,
                                                          boost::math::tools::eps_tolerance<double>(40), passes);
    const TangentialCalibration found{0.5 * (below + above), rebound(with(0.5 * (below + above)), time)};
    if (std::abs(found.rebound.tangential_restitution - e_t) <= largest_jump) return found;
    if (jump.empty())
      jump = fmt::format(
          ": at {:.6g} (SI) it jumps from {:.6g} to {:.6g}, as friction with a dashpot begins to slip; "
          "choose another restitution or a smaller dashpot",
          found.value, restitution(below), restitution(above));
  }
  const auto [smallest, largest] = std::ranges::minmax_element(samples, {}, &Sample::second);
  if (jump.empty())
    jump = fmt::format("; at this angle it must be {:.6g} to {:.6g}", smallest->second, largest->second);
  throw InputError{fmt::format("a tangential restitution of {} is not reachable by {}{}", e_t, name, jump)};
}

}  // namespace talus
