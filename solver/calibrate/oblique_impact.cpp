#include "solver/calibrate/oblique_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/laws/parameter.hpp"
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

/// A rebound, or why there is none.
using Simulated = std::variant<ObliqueRebound, std::string>;

/// The rebound with this step.
Simulated simulated(const ObliqueImpact& impact, double contact_time, double step, double lead, Integrator integrator) {
  const ObliqueScene made = scene_of(impact, contact_time, step, lead, integrator);
  const Dynamics dynamics{made.scene.model};
  RigidBodySystem system{dynamics, false};
  ContactMonitor monitor{dynamics.layout(), impact};
  State state = made.scene.initial;
  system.begin(state);
  const Observer observer = std::ref(monitor);
  const Outcome outcome = simulate(system, integrator, state, made.scene.plan, {&observer, 1},
                                   [&monitor](const State&) { return monitor.is_over(); });
  if (!outcome) return outcome.message;
  if (!monitor.is_over())
    return std::string{"the contact does not end within three times the contact time of its normal impact"};
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

Simulated located(const ObliqueImpact& impact, double contact_time) {
  // The method's local errors are relative to the largest displacement so far. Positions are rounded to 1e-16 of the
  // radius: the bodies first approach each other by enough that this is less than the errors, if four contact times
  // suffice for it, or else the errors are larger.
  constexpr double resolved = 1e-14;
  const double radius = std::max(impact.second.radius, impact.first ? impact.first->radius : 0.0);
  const double lead = std::min(resolved / tolerance * radius / impact.speed, 4.0 * contact_time);
  const double allowed = std::max(tolerance, resolved * radius / (impact.speed * lead));
  return simulated(impact, contact_time, contact_time / steps_in_contact, lead,
                   make_integrator("stormer_cowell", allowed));
}

ObliqueRebound rebound(const ObliqueImpact& impact, double contact_time) {
  const Simulated found = located(impact, contact_time);
  if (const auto* reason = std::get_if<std::string>(&found))
    throw InputError{fmt::format("the impact cannot be simulated; choose a smaller friction or dashpot: {}", *reason)};
  return std::get<ObliqueRebound>(found);
}

/// Values of a parameter: 0 or nothing, then a logarithmic range.
struct Span {
  bool has_zero{};
  double smallest{}, largest{};
};

Span span_of(const ObliqueImpact& impact, std::string_view name, double contact_time) {
  const double m = impact.effective_mass(), n = impact.mobility();
  const KnownImpact known = known_impact(impact.law, m, impact.approach_speed());
  const auto at_unit = [&] {
    FrictionLaw unit = impact.friction;
    set_parameter(unit, name, 1.0);
    return at(unit, known.largest_overlap);
  };
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

/// Finds a parameter of the friction by its tangential restitution.
class TangentialSearch {
 public:
  TangentialSearch(const ObliqueImpact& impact, std::string_view name, double wanted)
      : impact_{impact}, name_{name}, wanted_{wanted}, contact_time_{contact_time_of(impact)} {}

  /// Errors: InputError with the reason, if no value gives the restitution.
  TangentialCalibration result() {
    const std::optional<TangentialCalibration> last = sample();
    const std::size_t count = samples_.size();
    add_near_extremes();
    if (last && samples_.size() == count) return *last;
    if (const auto found = first_root()) return *found;
    for (const double sign : {1.0, -1.0}) {
      const auto best = std::ranges::min_element(samples_, {}, [sign](const Sample& of) { return sign * of.second; });
      if (best != samples_.begin() && best + 1 != samples_.end()) add_extreme(best, sign);
    }
    if (const auto found = first_root()) return *found;
    throw InputError{refusal()};
  }

 private:
  using Samples = std::vector<Sample>;

  /// Samples the span. The samples end at a value that the method cannot simulate: a spring that is soft beside its
  /// dashpot relaxes without end; friction by Mindlin's law that is too strong to slip at touch has a stretch whose
  /// rate is infinite there. Stiffnesses are sampled from the largest one on, other parameters from the smallest up to
  /// the first root, which is returned: impacts with a strong dashpot take long. Errors: InputError if not even the
  /// first value can be simulated.
  std::optional<TangentialCalibration> sample() {
    constexpr double values_a_decade = 12.0;
    const Span span = span_of(impact_, name_, contact_time_);
    const int count = static_cast<int>(std::ceil(values_a_decade * std::log10(span.largest / span.smallest)));
    std::vector<double> values;
    if (span.has_zero) values.push_back(0.0);
    for (int i = 0; i <= count; ++i)
      values.push_back(span.smallest * std::pow(span.largest / span.smallest, static_cast<double>(i) / count));
    if (!span.has_zero) std::ranges::reverse(values);
    samples_ = {{values.front(), restitution(values.front())}};
    for (const double value : std::span{values}.subspan(1)) {
      const Simulated found = located(with(value), contact_time_);
      if (!std::holds_alternative<ObliqueRebound>(found)) break;
      samples_.emplace_back(value, std::get<ObliqueRebound>(found).tangential_restitution);
      if (!span.has_zero) continue;
      if (const auto root = root_between(*(samples_.end() - 2), samples_.back())) return root;
    }
    if (!span.has_zero) std::ranges::reverse(samples_);
    return {};
  }

  /// Inserts the extremes between samples that may reach the restitution where the samples do not. An extreme exceeds
  /// the sample next to it by less than this one exceeds its neighbours.
  void add_near_extremes() {
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
      const double value = samples_[i].second, sign = value > wanted_ ? 1.0 : -1.0;
      const double before = sign * (samples_[i - 1].second - value), after = sign * (samples_[i + 1].second - value);
      if (std::min(before, after) < 0.0 || std::abs(value - wanted_) > std::max(before, after)) continue;
      add_extreme(samples_.begin() + static_cast<Samples::difference_type>(i), sign);
      ++i;
    }
  }

  /// Inserts the extreme beside the sample `best`: a minimum for sign 1, a maximum for -1.
  void add_extreme(Samples::const_iterator best, double sign) {
    // The restitution at an extreme differs by the square of the error of its value.
    constexpr int bits = 14;
    const auto [value, smallest] = boost::math::tools::brent_find_minima(
        [&](double x) { return sign * restitution(x); }, (best - 1)->first, (best + 1)->first, bits);
    samples_.insert(value < best->first ? best : best + 1, {value, sign * smallest});
  }

  /// The smallest value between samples that gives the restitution; none if there is none, or only jumps past it.
  std::optional<TangentialCalibration> first_root() const {
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
      if (const auto root = root_between(samples_[i], samples_[i + 1])) return root;
    return {};
  }

  std::optional<TangentialCalibration> root_between(const Sample& low, const Sample& high) const {
    if (!is_between(low, high)) return {};
    const auto [below, above] = bracket(low, high);
    const double value = 0.5 * (below + above);
    const TangentialCalibration found{value, rebound(with(value), contact_time_)};
    if (std::abs(found.rebound.tangential_restitution - wanted_) <= largest_jump) return found;
    return {};
  }

  /// Why no value gives the restitution: the first jump past it, or the reachable ones.
  std::string refusal() const {
    const std::string what = fmt::format("a tangential restitution of {} is not reachable by {}", wanted_, name_);
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
      if (!is_between(samples_[i], samples_[i + 1])) continue;
      const auto [below, above] = bracket(samples_[i], samples_[i + 1]);
      return fmt::format(
          "{}: at {:.6g} (SI) it jumps from {:.6g} to {:.6g}, as friction with a dashpot begins to slip; choose "
          "another restitution or a smaller dashpot",
          what, 0.5 * (below + above), restitution(below), restitution(above));
    }
    const auto [smallest, largest] = std::ranges::minmax_element(samples_, {}, &Sample::second);
    return fmt::format("{}; at this angle it must be {:.6g} to {:.6g}", what, smallest->second, largest->second);
  }

  ObliqueImpact with(double value) const {
    ObliqueImpact changed = impact_;
    set_parameter(changed.friction, name_, value);
    return changed;
  }
  double restitution(double value) const { return rebound(with(value), contact_time_).tangential_restitution; }
  bool is_between(const Sample& low, const Sample& high) const {
    return (low.second - wanted_) * (high.second - wanted_) <= 0.0;
  }
  /// Neighbouring values whose restitutions lie on both sides of the wanted one.
  std::pair<double, double> bracket(const Sample& low, const Sample& high) const {
    if (low.second == wanted_) return {low.first, low.first};
    std::uintmax_t passes = 60;
    return boost::math::tools::toms748_solve([&](double value) { return restitution(value) - wanted_; }, low.first,
                                             high.first, low.second - wanted_, high.second - wanted_,
                                             boost::math::tools::eps_tolerance<double>(40), passes);
  }

  const ObliqueImpact& impact_;
  std::string_view name_;
  double wanted_;
  double contact_time_;
  Samples samples_;  ///< in increasing order of the values
};

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
  demand_closed_form(scene_of(impact, time, time, time, integrator).scene.model, integrator);
  const ObliqueRebound exact = rebound(impact, time);
  return [=](double step, double phase) {
    const Simulated simulation = simulated(impact, time, step, phase * step, integrator);
    const auto* found = std::get_if<ObliqueRebound>(&simulation);
    if (found == nullptr) return std::numeric_limits<double>::infinity();
    return std::max(std::abs(found->restitution - exact.restitution),
                    std::abs(found->tangential_restitution - exact.tangential_restitution));
  };
}

TangentialCalibration calibrate_tangential(const ObliqueImpact& impact, std::string_view name, double e_t) {
  return TangentialSearch{impact, name, e_t}.result();
}

}  // namespace talus
