#pragma once

#include <concepts>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "solver/laws/elastic_plastic.hpp"
#include "solver/laws/hertz.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "solver/laws/tension_only.hpp"

namespace talus {

/// A law of force along one line. What it is: a small value that turns kinematics, memory and mode into a force.
/// It sees no body, no time step and no other law, remembers nothing itself, and is smooth inside a mode.
///   name, modes, memory_size  its name in scenes, the names of its modes (mode 0 is "not acting"), doubles of memory
///   dissipation, release      where the work of its dissipative force and the energy its resets release are booked
///   fields()                  its parameters with dimension and range
///   law(x, memory, mode)      the force; calling it twice gives the same bits
///   stored_energy             what it holds; in a mode, d(stored)/d(extent) is the elastic force
///   guard                     positive while the mode lasts
///   tangent()                 the stiffest linear piece while it acts
///   reset                     the mode that follows, and the memory it starts with
///   track (only if needed)    brings memory that follows the motion inside a mode, such as a largest stretch, up to
///   date
///   memory_count() (only if it depends on the parameters)   doubles of memory in place of memory_size
///   start_contact(memory, m_eff) (of contact laws, only if needed)   sets memory when the bodies touch, by the
///   effective mass along the normal; called before the first reset of a contact, if there is any memory
///   tangent(m_eff) (with it)  the tangent of a contact of that effective mass
///   retardation_time(memory) (only of a linear spring and dashpot)   c/k of the present contact [T]
///   linear_part (only if in every mode the force is linear in extent and rate)  its slopes in a mode with that memory
///   linear_piece (only if it has one)  the straight line that it is in a mode, so that rows of springs at rest in
///   their modes are worked out without asking each
template <class L>
concept Law = std::equality_comparable<L> &&
    requires(const L law, Kinematics x, std::span<const double> memory, std::span<double> writable, Mode mode) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::modes[0] } -> std::convertible_to<std::string_view>;
  { L::memory_size } -> std::convertible_to<std::size_t>;
  { L::dissipation } -> std::convertible_to<Mechanism>;
  { L::release } -> std::convertible_to<Mechanism>;
  L::fields();
  { law(x, memory, mode) } -> std::same_as<LawForce>;
  { law.stored_energy(x, memory, mode) } -> std::same_as<double>;
  { law.guard(x, memory, mode) } -> std::same_as<double>;
  { law.reset(x, writable, mode) } -> std::same_as<Reset>;
  { law.tangent() } -> std::same_as<Tangent>;
};

/// Doubles of memory that an instance of a law has.
template <Law L>
constexpr std::size_t memory_count(const L& law) {
  if constexpr (requires { law.memory_count(); }) return law.memory_count();
  return L::memory_size;
}

/// Whether the memory of a contact law starts with the effective mass of the contact.
template <class L>
concept StartsByMass = requires(const L law, std::span<double> memory) {
  law.start_contact(memory, 1.0);
};

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

using ContactLaws = LawList<LinearSpringDashpot, LatchingSpring, Hertz>;
using ContactLaw = ContactLaws::Variant;
using CableLaws = LawList<TensionOnly, ElasticPlastic>;
using CableLaw = CableLaws::Variant;

}  // namespace talus
