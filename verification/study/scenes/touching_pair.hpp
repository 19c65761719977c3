#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"

/// Pairs of overlapping outlines, and the energy and forces of a model in any state of its bodies.
namespace talus::verification::problems {

/// A pair of outlines with a contact method.
struct TouchingPair {
  const char* name;
  Shape a, b;
  ContactMethod method{ContactMethod::resultant};
  NodeDepth rule{NodeDepth::nearest};
};

/// Bodies "a" and "b" of unit mass and inertia (ground is fixed), contact "touch": a spring with `stiffness`, no
/// dashpot.
[[nodiscard]] Model pair_model(const TouchingPair& pair, double stiffness);

/// Energy and forces of a model in any state of its bodies.
class Potential {
 public:
  explicit Potential(const Model& model) : dynamics_{model}, work_{dynamics_.workspace()} {}

  /// Evaluates the state and updates its modes; the functions below refer to this state.
  void evaluate(State& state) {
    dynamics_.update(state, work_);
    dynamics_.update_modes(state, work_);
  }
  /// Stored energy of contact and cable [F L].
  double energy(const State& state) const {
    const Energies energies = dynamics_.energies(state, work_);
    return energies.contacts + energies.cables;
  }
  /// Forces along the coordinates: equal to the accelerations, because masses and inertias are one.
  std::vector<double> forces(const State& state) {
    Rates rates{state};
    dynamics_.rates(state, work_, rates, false);
    return rates.v;
  }

 private:
  Dynamics dynamics_;
  Workspace work_;
};

/// Path of body "a" of a pair around the corner of "b" and back: its centre moves on a circle about the corner, its
/// angle back and forth.
struct CornerLoop {
  static constexpr Vec2 corner{0.5, 0.35};
  static constexpr double radius = 0.36;
  double work{};                      ///< work of the contact forces on the body in one loop [F L]
  double energy{};                    ///< largest on the path [F L]
  std::vector<double> angle, stored;  ///< at about 200 positions [degrees, F L]
};

/// Work by the trapezoidal rule over `steps` positions, at least 200. `moments`: a fault, the fraction of the moment
/// that is included.
[[nodiscard]] CornerLoop round_corner(const Model& model, int steps, double moments = 1.0);

}  // namespace talus::verification::problems
