#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/laws/contact_kernel.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/elastic_plastic.hpp"
#include "solver/laws/friction_kernel.hpp"
#include "solver/laws/hertz.hpp"
#include "solver/laws/hunt_crossley.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/law.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "solver/laws/mindlin.hpp"
#include "solver/laws/tension_only.hpp"

namespace talus {

/// A closed list of law types: parsers, tests, the command line and the report iterate over it.
template <class... Laws>
struct LawList {
  using Variant = std::variant<Laws...>;
  /// The same list with each law L wrapped as Wrap<L>.
  template <template <class> class Wrap>
  using Tuple = std::tuple<Wrap<Laws>...>;

  static std::vector<std::string> names() { return {std::string{Laws::name}...}; }
  /// Calls visit(L{}) for each law type L, in the list's order.
  template <class Visit>
  static void for_each(Visit&& visit) {
    (visit(Laws{}), ...);
  }
};

template <Law... Laws>
using ForceLawList = LawList<Laws...>;
/// Laws of contacts between bodies.
using ContactLaws = ForceLawList<LinearSpringDashpot, LatchingSpring, Hertz, HuntCrossley>;
using ContactLaw = ContactLaws::Variant;
/// Laws of cables.
using CableLaws = ForceLawList<TensionOnly, ElasticPlastic>;
using CableLaw = CableLaws::Variant;
/// Laws of friction of contacts between bodies. Each gives, at an overlap, a spring, dashpot and slider in series
/// (CoulombFriction), and the motion of the stretch of this spring, which is the first double of the law's memory; the
/// second, if there is one, is the stiffness at the last update of the modes [F/L].
///
///   name, memory_size, fields()    as of other laws; a field that is not `friction` and does not begin with `shear_`
///                                  is one of the contact's law: contacts whose law lacks it cannot have this friction
///   stiffness_rule                 the tangential stiffness, as text for lists of fields
///   onset                          stretch at the first evaluation of a contact over the slip since touch
///   at(overlap)                    spring, dashpot and slider at an overlap [L]
///   stiffest()                     the same for step limits
///   stretch_rate(s, u, x)          ds/dt [L/T] at the slip rate u, for the overlap and its rate x
///   stretch_after(s, u, x, h)      stretch [L] after a time h of constant speeds; x: at the middle of this time
///   area_power(s, x)               power that a changing stiffness dissipates [F L/T]
///
/// Optional
///   follow(k, damping)             sets the values of optional fields from the largest stiffness k of the normal law
///                                  [F/L]; `damping`: whether this law has a retardation time and a scene gives no
///                                  `shear_damping`
///
/// Friction of discs also has the functions of HasFrictionKernel (friction_kernel.hpp).
template <class L>
concept IsFrictionLaw = std::equality_comparable<L> && requires(const L law, double x, Kinematics of_normal) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::memory_size } -> std::convertible_to<std::size_t>;
  { L::onset } -> std::convertible_to<double>;
  { L::stiffness_rule } -> std::convertible_to<std::string_view>;
  L::fields();
  { law.at(x) } -> std::same_as<CoulombFriction>;
  { law.stiffest() } -> std::same_as<CoulombFriction>;
  { law.stretch_rate(x, x, of_normal) } -> std::same_as<double>;
  { law.stretch_after(x, x, of_normal, x) } -> std::same_as<double>;
  { law.area_power(x, of_normal) } -> std::same_as<double>;
};
template <class L>
concept FollowsNormal = IsFrictionLaw<L> && requires(L law, double stiffness, bool damping) {
  { law.follow(stiffness, damping) } -> std::same_as<void>;
};
template <IsFrictionLaw... Laws>
using FrictionLawList = LawList<Laws...>;
using FrictionLaws = FrictionLawList<CoulombFriction, Mindlin>;
using FrictionLaw = FrictionLaws::Variant;
/// Number of doubles of a friction law's memory.
inline std::size_t memory_count(const FrictionLaw& law) {
  return std::visit([]<class L>(const L&) { return L::memory_size; }, law);
}
/// Spring, dashpot and slider at an overlap [L].
inline CoulombFriction at(const FrictionLaw& law, double overlap) {
  return std::visit([overlap](const auto& of) { return of.at(overlap); }, law);
}
/// Whether a field of a friction law belongs to this law, not to the contact's law.
constexpr bool is_friction_field(std::string_view name) { return name == "friction" || name.starts_with("shear_"); }
/// Names of these fields.
template <IsFrictionLaw F>
std::vector<std::string_view> friction_fields() {
  std::vector<std::string_view> names;
  for (const auto& field : F::fields())
    if (is_friction_field(field.name)) names.push_back(field.name);
  return names;
}
/// Whether L has all fields that F needs of the contact's law. Such friction acts only between surfaces that touch.
template <class L, IsFrictionLaw F>
constexpr bool fits_contact() {
  constexpr auto needed = F::fields();
  constexpr auto given = L::fields();
  return std::ranges::all_of(needed, [&](const auto& field) {
    return is_friction_field(field.name) ||
           (!ActsAtDistance<L> && std::ranges::find(given, field.name, &Field<L>::name) != given.end());
  });
}
/// Contacts of law L can have the friction F, or none.
template <class L, class F>
concept CanHaveFriction = std::same_as<F, Frictionless> || fits_contact<L, F>();

/// Calls visit(F{}) for each friction law F of a list that contacts of law L can have, in the list's order.
template <class Frictions, class L, class Visit>
void for_each_friction_of(Visit&& visit) {
  Frictions::for_each([&]<class F>(const F& law) {
    if constexpr (CanHaveFriction<L, F>) visit(law);
  });
}
/// Names of these laws; the first is the default.
template <class Frictions, class L>
std::vector<std::string> friction_names_of() {
  std::vector<std::string> names;
  for_each_friction_of<Frictions, L>([&](const auto& law) { names.emplace_back(law.name); });
  return names;
}

/// A contact law that discs can have, too; a shear cell needs the duration and the restitution of their impacts.
template <class L>
concept IsDiscLaw = HasContactKernel<L> && KnowsImpacts<L> && SetsRestitution<L>;
/// Friction that discs can have, too. Their contacts have no tangential dashpot.
template <class L>
concept IsDiscFriction = IsFrictionLaw<L> && HasFrictionKernel<L>;

template <class... Ones, class... Others>
LawList<Ones..., Others...> operator+(LawList<Ones...>, LawList<Others...>);
template <bool is_selected, class L>
using ListIf = std::conditional_t<is_selected, LawList<L>, LawList<>>;
template <class... Laws>
auto disc_laws(LawList<Laws...>) -> decltype((LawList<>{} + ... + ListIf<IsDiscLaw<Laws>, Laws>{}));
template <class... Laws>
auto disc_frictions(LawList<Laws...>) -> decltype((LawList<>{} + ... + ListIf<IsDiscFriction<Laws>, Laws>{}));
/// Laws of contacts between discs: all contact laws that discs can have.
using DiscLaws = decltype(disc_laws(ContactLaws{}));
using DiscLaw = DiscLaws::Variant;
/// Friction of contacts between discs: all friction laws that discs can have.
using DiscFrictions = decltype(disc_frictions(FrictionLaws{}));
using DiscFriction = DiscFrictions::Variant;

}  // namespace talus
