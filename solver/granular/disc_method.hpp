#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/granular/discs.hpp"
#include "solver/integrate/integrator_list.hpp"

namespace talus {

/// Interface that every disc system offers to a method; declared only. DiscSystem, FastDiscSystem and others define it.
struct AnyDiscSystem {
  void drift(Discs& discs, double h);
  void kick(Discs& discs, double h);
  Discs drifted(const Discs& discs, double h) const;
  void update_modes(Discs& discs);
  void evaluate(Discs& discs, DiscRates& out);
};

/// An integrator that also steps discs: any state type, fixed step, and one force evaluation per step, because contact
/// memory is stored outside the state and is updated by each evaluation.
template <class I>
concept StepsDiscs = requires {
  requires(I::step_control == StepControl::fixed && I::evaluations == 1);
  requires IntegratorFor<typename Rebound<I, Discs>::type, AnyDiscSystem, Discs>;
};

/// Selects from a list of integrators those that step discs, as methods over discs:
/// DiscMethodsOf<std::variant<I...>>::type.
template <class List, class... Found>
struct DiscMethodsOf;
template <class... Found>
struct DiscMethodsOf<std::variant<>, Found...> {
  using type = std::variant<Found...>;
};
template <class I, class... Others, class... Found>
struct DiscMethodsOf<std::variant<I, Others...>, Found...> : DiscMethodsOf<std::variant<Others...>, Found...> {};
template <StepsDiscs I, class... Others, class... Found>
struct DiscMethodsOf<std::variant<I, Others...>, Found...>
    : DiscMethodsOf<std::variant<Others...>, Found..., typename Rebound<I, Discs>::type> {};

/// Any of the methods that step discs.
using DiscMethod = DiscMethodsOf<Integrator::List>::type;

/// Names of all disc methods, in the list's order.
[[nodiscard]] std::vector<std::string> disc_method_names();

/// The method of that name. Errors: InputError for an unknown name.
[[nodiscard]] DiscMethod make_disc_method(std::string_view name);

/// The traits that a method declares.
[[nodiscard]] const IntegratorTraits& traits(const DiscMethod& method);

/// Restitution of an impact with a latching spring as integrated by a method, if the exact one is e. The impact is a
/// quarter of an oscillation at w1 and one at w2 = w1/e, which gives e exp(c pi (w1 + w2) h), c the method's
/// amplitude_growth_rate. loading_angle: w1 h [rad] >= 0.
[[nodiscard]] double stepped_restitution(const DiscMethod& method, double restitution, double loading_angle);

}  // namespace talus
