#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/dynamics/dynamics.hpp"
#include "verification/study/findings/expectations.hpp"

/// Two discs in contact that stick by friction, turned together as one body.
namespace talus::verification::problems::turned_pair {

inline constexpr double radius_a = 1.0, radius_b = 0.5, overlap = 0.0625, distance = radius_a + radius_b - overlap;
inline constexpr double normal_stiffness = 64.0, slip_stiffness = 32.0, first_stretch = 0.0078125;

/// Bodies "a" and "b", contact "touch".
[[nodiscard]] Model model();

/// Sets the pair to an angle, with velocities that advance it by `turn` in a step of unit time.
void set_pair(State& state, double angle, double turn, bool b_spins);

/// Result of a full turn: changes of the stretch and energy, and the largest changes of force on the way.
struct Turn {
  double stretch{};       ///< change at the end
  double force{};         ///< largest change of the force on B along the line of centres, in the frame of the pair
  double drag{};          ///< the same across that line, minus the part explained by the change of stretch
  double energy{};        ///< change of the stored energy at the end
  double stretch_back{};  ///< change of stretch after the turn and the same turn back
};

/// Faults that can be planted in a turn.
struct Faults {
  bool b_stands{};           ///< one disc does not spin
  bool looked_from_world{};  ///< forces are evaluated in directions that do not turn
};

/// Turns the pair through a full circle in steps of unit time, and back without evaluating forces.
template <class System>
Turn turned(long steps, const Faults& faults) {
  const Dynamics dynamics{model()};
  System system{dynamics};
  Workspace work = dynamics.workspace();
  State state = rest_state(dynamics.model());
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(steps);
  set_pair(state, 0.0, turn, !faults.b_stands);
  state.z[0] = first_stretch;
  system.begin(state);
  const auto force_at = [&](double angle) {
    const double frame = faults.looked_from_world ? 0.0 : angle;
    Rates rates{state};
    system.evaluate(state, rates);
    const Vec2 f{rates.v[3], rates.v[4]};
    return Vec2{f.x * std::cos(frame) + f.y * std::sin(frame), f.y * std::cos(frame) - f.x * std::sin(frame)};
  };
  const Vec2 first = force_at(0.0);
  dynamics.update(state, work);
  const double energy = dynamics.energies(state, work).contacts;
  Turn found;
  for (long n = 0; n < steps; ++n) {
    set_pair(state, turn * static_cast<double>(n), turn, !faults.b_stands);
    system.drift(state, 1.0);
    const Vec2 change = force_at(turn * static_cast<double>(n + 1)) - first;
    keep_largest(found.force, change.x);
    keep_largest(found.drag, change.y + slip_stiffness * (state.z[0] - first_stretch));
  }
  found.stretch = state.z[0] - first_stretch;
  dynamics.update(state, work);
  found.energy = dynamics.energies(state, work).contacts - energy;
  for (long n = steps; n > 0; --n) {
    set_pair(state, turn * static_cast<double>(n), -turn, !faults.b_stands);
    system.drift(state, 1.0);
  }
  found.stretch_back = state.z[0] - first_stretch;
  return found;
}

/// Exact stretch added by a full turn in `steps` steps: the centres move along chords, over which the spins roll.
[[nodiscard]] inline double exact_drift(long steps) {
  const double half = std::numbers::pi / static_cast<double>(steps);
  return 2.0 * static_cast<double>(steps) * distance * (std::sin(half) - half * std::cos(half));
}

}  // namespace talus::verification::problems::turned_pair
