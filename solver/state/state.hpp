#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// Mechanisms by which mechanical energy leaves or enters the bodies and springs of a scene.
enum class Mechanism : std::size_t {
  contact_damping,  ///< dashpots of contacts, and hysteresis of latching springs: dissipated > 0
  contact_release,  ///< spring energy of a contact that stops acting before its surfaces part: dissipated > 0
  cable_damping,    ///< dashpots of cables: dissipated > 0
  cable_release,    ///< spring energy of a cable whose dashpot ends its force before it is slack: dissipated > 0
  cable_yield,      ///< plastic work of yielding cables: dissipated > 0
  cable_break,      ///< energy stored in a cable when it broke: dissipated > 0
  hanger_break,     ///< energy that cables lost when a hanger between them broke: dissipated > 0
  friction,         ///< sliders of contacts, and the energy of their springs when a contact opens: dissipated > 0
};
template <>
struct Names<Mechanism> {
  static constexpr std::array<std::string_view, 8> list{"contact_damping", "contact_release", "cable_damping",
                                                        "cable_release",   "cable_yield",     "cable_break",
                                                        "hanger_break",    "friction"};
};
inline constexpr std::size_t mechanism_count = Names<Mechanism>::list.size();

/// Impulse on the moving bodies from outside: x and y components [M L/T], and moment about the world's origin
/// [M L^2/T], counter-clockwise > 0.
template <class Scalar>
using Impulse = std::array<Scalar, 3>;

template <class Scalar>
struct RatesOf;

/// All quantities that change during a run, as numbers of type Scalar. The model's Layout assigns them to bodies and
/// laws.
template <class Scalar>
struct StateOf {
  using Number = Scalar;
  using Rates = RatesOf<Scalar>;

  Scalar t{};                                  ///< time [T]
  std::vector<Scalar> q;                       ///< generalised coordinates [L or rad]
  std::vector<Scalar> v;                       ///< their rates [1/T of q]
  std::vector<Scalar> z;                       ///< memory of the history-dependent laws; see each law
  std::vector<Mode> mode;                      ///< one for each law instance
  std::array<Scalar, mechanism_count> work{};  ///< energy dissipated so far by each mechanism [F L]
  Impulse<Scalar> impulse{};                   ///< impulse received so far from supports and gravity

  friend bool operator==(const StateOf&, const StateOf&) = default;
};

/// to = from, for two states of one scene, whose arrays have the same sizes: without the checks and calls of a vector's
/// assignment.
template <class Scalar>
void copy_numbers(const StateOf<Scalar>& from, StateOf<Scalar>& to) {
  to.t = from.t;
  std::copy(from.q.begin(), from.q.end(), to.q.begin());
  std::copy(from.v.begin(), from.v.end(), to.v.begin());
  std::copy(from.z.begin(), from.z.end(), to.z.begin());
  std::copy(from.mode.begin(), from.mode.end(), to.mode.begin());
  to.work = from.work, to.impulse = from.impulse;
}

/// Rates of change of a state in its present modes; dq/dt is v itself.
template <class Scalar>
struct RatesOf {
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  std::vector<Scalar> v;    ///< accelerations
  std::size_t moving{all};  ///< coordinates from here on belong to sleeping bodies and have zero rates
  std::vector<Scalar> z;    ///< memory rates
  bool accounts{true};      ///< whether the next two are computed; else they are zero
  std::array<Scalar, mechanism_count> work{};  ///< powers dissipated [F L/T]
  Impulse<Scalar> impulse{};                   ///< forces and moment from outside

  explicit RatesOf(const StateOf<Scalar>& like) : v(like.v.size()), z(like.z.size()) {}
  RatesOf() = default;
};

/// Scenes are computed in double; other number types serve one-body systems that measure the rounding errors of the
/// integrators.
using State = StateOf<double>;
using Rates = RatesOf<double>;

}  // namespace talus
