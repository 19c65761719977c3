#pragma once

#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/laws/contact_kernel.hpp"
#include "solver/laws/elastic_plastic.hpp"
#include "solver/laws/hertz.hpp"
#include "solver/laws/hunt_crossley.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/law.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "solver/laws/tension_only.hpp"

namespace talus {

/// A closed list of law types: parsers, tests, the command line and the report iterate over it.
template <Law... Laws>
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

/// Laws of contacts between bodies.
using ContactLaws = LawList<LinearSpringDashpot, LatchingSpring, Hertz, HuntCrossley>;
using ContactLaw = ContactLaws::Variant;
/// Laws of cables.
using CableLaws = LawList<TensionOnly, ElasticPlastic>;
using CableLaw = CableLaws::Variant;
/// A contact law that discs can have, too; a shear cell needs the duration and the restitution of their impacts.
template <class L>
concept IsDiscLaw = HasContactKernel<L> && KnowsImpacts<L> && SetsRestitution<L>;
/// Laws of contacts between discs: all contact laws that discs can have.
template <Law... Ones, Law... Others>
LawList<Ones..., Others...> operator+(LawList<Ones...>, LawList<Others...>);
template <Law... Laws>
auto disc_laws(LawList<Laws...>)
    -> decltype((LawList<>{} + ... + std::conditional_t<IsDiscLaw<Laws>, LawList<Laws>, LawList<>>{}));
using DiscLaws = decltype(disc_laws(ContactLaws{}));
using DiscLaw = DiscLaws::Variant;

}  // namespace talus
