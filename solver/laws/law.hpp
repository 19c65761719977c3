#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/laws/hertz_impact.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A force law along one line: a small value type that computes a force from kinematics, memory and mode. It is
/// independent of bodies, time steps and other laws, has no mutable state, and is smooth within a mode. The list below
/// is its interface. A law with a hook of one of these names but another signature does not compile
/// (HooksAreWellFormed).
///
/// Required of every law
///   name                          name in scenes
///   modes                         names of its modes; mode 0 is "not acting", mode 1 a compressed contact or a taut
///                                 cable
///   memory_size                   number of doubles of memory, if it does not depend on the parameters
///   dissipation, release          mechanisms of the work of its dissipative force, and of the energy that resets
///                                 release
///   fields()                      its parameters with dimension, range and meaning
///   acts(mode)                    static: whether it exerts a force in the mode
///   law(x, memory, mode)          the force [F]; deterministic to the last bit
///   stored_energy(x, memory, mode)  [F L]; within a mode its derivative by the deformation is the elastic force
///   guard(x, memory, mode)        positive while the mode lasts; all ends of a mode have the same unit
///   reset(x, memory, mode)        the next mode and the energy released [F L]; sets the memory at the mode's start
///   tangent()                     stiffness [F/L] and damping [F T/L] of the stiffest branch while it acts
///
/// Optional, of every law
///   orders()                      pairs of parameters of which one must not be smaller than the other
///   memory_count()                number of doubles of memory, replaces memory_size if it depends on the parameters
///   track(x, memory, mode)        updates memory that follows the motion within a mode, such as a maximum; with
///   memory_follows(mode)          static: whether there is such memory in the mode
///   linear_part(memory, mode)     slopes [F/L, F T/L] in a mode; only if in every mode the force is linear in
///                                 deformation and rate
///   linear_branch(memory, mode)    linear branch of the law in a mode, if the force does not depend on the rate; only
///                                 laws with at most one double of memory. Chains of cables are then evaluated without
///                                 calling the law
///
/// Optional, of cables
///   natural_elongation(memory)    elongation at which the cable becomes slack [L]; 0 with memory 0
///   yields(mode)                  static: whether the cable yields in the mode, so that natural_elongation grows; with
///   largest_yield()               the largest tension in such a mode [F]
///   is_broken(mode)               static: whether the force stays zero permanently
///
/// Optional, of contacts
///   reach()                       largest gap at which the law acts [L] >= 0. Without this hook it acts only between
///                                 surfaces that touch
///   start_contact(memory, m_eff)  sets memory when the bodies touch, before the first reset, from the effective mass
///                                 along the normal [M]; only called if memory_count() > 0; with
///   tangent(m_eff)                tangent() of a contact of that effective mass
///   retardation_time(memory)      c/k of a spring and dashpot [T]; the default for sticking friction
///   contact_time(m_eff, v)        duration of an impact of that effective mass at the speed of approach v [T];
///                                 infinite if it does not end; with
///   restitution(m_eff, v)         the ratio of the speeds after and before the impact, and
///   largest_overlap(m_eff, v)     its largest overlap [L]
///   restitution_field             static: the parameter that sets the restitution; with
///   set_restitution(e, m_eff, v)  sets that parameter, for impacts of that effective mass and speed, e in (0, 1]
///   set_every_restitution(e, v)   sets it for every effective mass; requires the two hooks above
///   restitution_varies()          whether the restitution depends on the speed, so that v must be known to set it; by
///                                 default it does not
///
/// Optional, of contacts between discs: one of the two
///   is_clamped()                  the law is one-sided: without memory, and in mode 1 the force is k overlap + c rate.
///                                 It acts while the surfaces overlap (false) or while this force is positive (true).
///                                 k and c are the slopes linear_part({}, 1), or depend on the overlap:
///   secant(overlap, k, c)         sets k [F/L] and c [F T/L] at an overlap > 0, for numbers and packs of numbers; with
///   secant_energy_ratio()         ratio of the stored energy to k overlap^2/2
///   needs_rate(), force(..), dissipated_power(..) or hysteresis_loss(..)
///                                 the law is its own contact kernel (laws/contact_kernel.hpp)
///
/// Optional parameters, which readers and writers of files recognise by name
///   end_rule (EndRule), dashpot (HertzDashpot), damping (double) [F T/L], damping_ratio (double),
///   table (std::vector<YieldPoint>)
template <class L>
concept HasLawParts = std::equality_comparable<L> &&
    requires(const L law, Kinematics x, std::span<const double> memory, std::span<double> writable, Mode mode) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::modes[0] } -> std::convertible_to<std::string_view>;
  { L::memory_size } -> std::convertible_to<std::size_t>;
  { L::dissipation } -> std::convertible_to<Mechanism>;
  { L::release } -> std::convertible_to<Mechanism>;
  L::fields();
  { L::acts(mode) } -> std::same_as<bool>;
  { law(x, memory, mode) } -> std::same_as<LawForce>;
  { law.stored_energy(x, memory, mode) } -> std::same_as<double>;
  { law.guard(x, memory, mode) } -> std::same_as<double>;
  { law.reset(x, writable, mode) } -> std::same_as<Reset>;
  { law.tangent() } -> std::same_as<Tangent>;
};

/// Concepts of the optional hooks, in the order of the list above.
template <class L>
concept HasOrders = requires(const L law) {
  { law.*L::orders()[0].larger } -> std::convertible_to<double>;
  { law.*L::orders()[0].smaller } -> std::convertible_to<double>;
  { L::orders()[0].why } -> std::convertible_to<std::string_view>;
};
template <class L>
concept CountsMemory = requires(const L law) {
  { law.memory_count() } -> std::same_as<std::size_t>;
};
template <class L>
concept Tracks = requires(const L law, Kinematics x, std::span<double> memory, Mode mode) {
  { law.track(x, memory, mode) } -> std::same_as<void>;
  { L::memory_follows(mode) } -> std::same_as<bool>;
};
template <class L>
concept HasLinearPart = requires(const L law, std::span<const double> memory, Mode mode) {
  { law.linear_part(memory, mode) } -> std::same_as<Tangent>;
};
template <class L>
concept HasLinearBranch = L::memory_size <= 1 && requires(const L law, std::span<const double> memory, Mode mode) {
  { law.linear_branch(memory, mode) } -> std::same_as<LinearBranch>;
};
template <class L>
concept HasNaturalElongation = requires(const L law, std::span<const double> memory) {
  { law.natural_elongation(memory) } -> std::same_as<double>;
};
template <class L>
concept Yields = HasNaturalElongation<L> && requires(const L law, Mode mode) {
  { L::yields(mode) } -> std::same_as<bool>;
  { law.largest_yield() } -> std::same_as<double>;
};
template <class L>
concept Breaks = requires(Mode mode) {
  { L::is_broken(mode) } -> std::same_as<bool>;
};
template <class L>
concept ActsAtDistance = requires(const L law) {
  { law.reach() } -> std::same_as<double>;
};
template <class L>
concept StartsByMass = requires(const L law, std::span<double> memory, double effective_mass) {
  { law.start_contact(memory, effective_mass) } -> std::same_as<void>;
  { law.tangent(effective_mass) } -> std::same_as<Tangent>;
};
template <class L>
concept HasRetardationTime = requires(const L law, std::span<const double> memory) {
  { law.retardation_time(memory) } -> std::same_as<double>;
};
template <class L>
concept KnowsImpacts = requires(const L law, double effective_mass, double speed) {
  { law.contact_time(effective_mass, speed) } -> std::same_as<double>;
  { law.restitution(effective_mass, speed) } -> std::same_as<double>;
  { law.largest_overlap(effective_mass, speed) } -> std::same_as<double>;
};
template <class L>
concept SetsRestitution = requires(L law, double e, double effective_mass, double speed) {
  { L::restitution_field } -> std::convertible_to<RestitutionField>;
  { law.set_restitution(e, effective_mass, speed) } -> std::same_as<void>;
};
/// The parameter that sets the restitution, with its unit and range.
template <SetsRestitution L>
constexpr Field<L> restitution_parameter() {
  const auto fields = L::fields();
  return *std::ranges::find(fields, L::restitution_field.name, &Field<L>::name);
}
template <class L>
concept SetsEveryRestitution = SetsRestitution<L> && requires(L law, double e, double speed) {
  { law.set_every_restitution(e, speed) } -> std::same_as<void>;
};
template <class L>
concept VariesRestitution = SetsRestitution<L> && requires(const L law) {
  { law.restitution_varies() } -> std::same_as<bool>;
};
template <class L>
concept HasSecant = requires(const L law, double x, double& y) {
  { law.secant(x, y, y) } -> std::same_as<void>;
  { law.secant_energy_ratio() } -> std::same_as<double>;
};
template <class L>
concept OneSided = L::memory_size == 0 && (HasLinearPart<L> || HasSecant<L>)&&requires(const L law) {
  { law.is_clamped() } -> std::same_as<bool>;
};
/// Parts of a contact kernel: dissipated power for laws without memory, hysteresis loss for laws with memory.
template <class K>
concept HasDissipatedPower = requires(const K kernel, double x, double& y) {
  { kernel.dissipated_power(x, x, x, x, y, y) } -> std::same_as<void>;
};
template <class K>
concept HasHysteresisLoss = requires(const K kernel, double x) {
  { kernel.hysteresis_loss(x) } -> std::same_as<double>;
};
template <class K>
concept ContactKernel = requires(const K kernel, double x, double& y) {
  requires(HasDissipatedPower<K> != HasHysteresisLoss<K>);
  { kernel.needs_rate() } -> std::same_as<bool>;
  { kernel.force(x, x, y, y) } -> std::same_as<void>;
};
/// A law that implements its contact kernel itself.
template <class L>
concept IsKernel = ContactKernel<L> && L::memory_size == (HasHysteresisLoss<L> ? 1 : 0);
template <class L>
concept HasEndRule = requires(L law) {
  { law.end_rule } -> std::same_as<EndRule&>;
};
template <class L>
concept HasHertzDashpot = requires(L law) {
  { law.dashpot } -> std::same_as<HertzDashpot&>;
};
/// Laws with the radius of curvature of their contact, `radius`.
template <class L>
concept HasContactRadius = requires(L law) {
  { law.radius } -> std::same_as<double&>;
};
template <class L>
concept HasDamping = requires(L law) {
  { law.damping } -> std::same_as<double&>;
};
template <class L>
concept HasDampingRatio = requires(L law) {
  { law.damping_ratio } -> std::same_as<double&>;
};
template <class L>
concept HasYieldTable = requires(L law) {
  { law.yield } -> std::same_as<double&>;
  { law.table } -> std::same_as<std::vector<YieldPoint>&>;
};

// clang-format off
/// The optional hooks, each with the concept that checks its signature and those of the hooks it requires.
#define TALUS_LAW_HOOKS(HOOK)                         \
  HOOK(orders, HasOrders)                             \
  HOOK(memory_count, CountsMemory)                    \
  HOOK(track, Tracks)                                 \
  HOOK(memory_follows, Tracks)                        \
  HOOK(linear_part, HasLinearPart)                    \
  HOOK(linear_branch, HasLinearBranch)                  \
  HOOK(natural_elongation, HasNaturalElongation)      \
  HOOK(yields, Yields)                                \
  HOOK(largest_yield, Yields)                         \
  HOOK(is_broken, Breaks)                             \
  HOOK(reach, ActsAtDistance)                         \
  HOOK(start_contact, StartsByMass)                   \
  HOOK(retardation_time, HasRetardationTime)          \
  HOOK(contact_time, KnowsImpacts)                    \
  HOOK(restitution, KnowsImpacts)                     \
  HOOK(largest_overlap, KnowsImpacts)                 \
  HOOK(restitution_field, SetsRestitution)            \
  HOOK(set_restitution, SetsRestitution)              \
  HOOK(set_every_restitution, SetsEveryRestitution)   \
  HOOK(restitution_varies, VariesRestitution)         \
  HOOK(is_clamped, OneSided)                          \
  HOOK(secant, HasSecant)                             \
  HOOK(secant_energy_ratio, HasSecant)                \
  HOOK(needs_rate, IsKernel)                          \
  HOOK(force, IsKernel)                               \
  HOOK(dissipated_power, IsKernel)                    \
  HOOK(hysteresis_loss, IsKernel)                     \
  HOOK(end_rule, HasEndRule)                          \
  HOOK(dashpot, HasHertzDashpot)                      \
  HOOK(damping, HasDamping)                           \
  HOOK(damping_ratio, HasDampingRatio)                \
  HOOK(table, HasYieldTable)

/// One concept per hook: the law has the hook with the right signature, or has no member of that name. Private members
/// and members of another kind are detected too: in a class that inherits the name from two bases it is ambiguous.
namespace hook {

template <class L, class Other>
struct Beside : L, Other {};

#define TALUS_HOOK(NAME, IS)                              \
  struct Other_##NAME { int NAME; };                      \
  template <class L>                                      \
  concept NAME = IS<L> || requires { &Beside<L, Other_##NAME>::NAME; };
TALUS_LAW_HOOKS(TALUS_HOOK)
#undef TALUS_HOOK

}  // namespace hook

#define TALUS_AND_HOOK(NAME, IS) && hook::NAME<L>
template <class L>
concept HooksAreWellFormed = true TALUS_LAW_HOOKS(TALUS_AND_HOOK);
#undef TALUS_AND_HOOK
#undef TALUS_LAW_HOOKS
// clang-format on

template <class L>
concept Law = HasLawParts<L> && HooksAreWellFormed<L>;

/// Number of doubles of a law's memory.
template <Law L>
constexpr std::size_t memory_count(const L& law) {
  if constexpr (CountsMemory<L>) return law.memory_count();
  return L::memory_size;
}

/// Whether part of the law's memory follows the motion in a mode.
template <Law L>
constexpr bool memory_follows([[maybe_unused]] Mode mode) {
  if constexpr (Tracks<L>) return L::memory_follows(mode);
  return false;
}

/// Whether the law's force stays zero permanently in a mode.
template <Law L>
constexpr bool is_broken([[maybe_unused]] Mode mode) {
  if constexpr (Breaks<L>) return L::is_broken(mode);
  return false;
}

/// Largest gap at which a contact law acts [L]; 0 for laws that act only between touching surfaces.
template <Law L>
constexpr double reach([[maybe_unused]] const L& law) {
  if constexpr (ActsAtDistance<L>) return law.reach();
  return 0.0;
}

/// Elongation at which a cable becomes slack [L].
template <Law L>
constexpr double natural_elongation([[maybe_unused]] const L& law, [[maybe_unused]] std::span<const double> memory) {
  if constexpr (HasNaturalElongation<L>) return law.natural_elongation(memory);
  return 0.0;
}

/// Whether the restitution of a law's impacts depends on their speed.
template <Law L>
constexpr bool restitution_varies([[maybe_unused]] const L& law) {
  if constexpr (VariesRestitution<L>) return law.restitution_varies();
  return false;
}

/// Stiffest branch of a law at a contact of this effective mass [M].
template <Law L>
constexpr Tangent tangent(const L& law, [[maybe_unused]] double effective_mass) {
  if constexpr (StartsByMass<L>) return law.tangent(effective_mass);
  return law.tangent();
}

}  // namespace talus
