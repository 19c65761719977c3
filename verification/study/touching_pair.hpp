#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"

/// Two outlines that overlap, and the energy and forces of a model wherever its bodies stand.
namespace talus::verification::problems {

/// A pair of outlines in a way of contact.
struct TouchingPair {
  const char* name;
  Shape a, b;
  ContactMethod method{ContactMethod::resultant};
  NodeDepth rule{NodeDepth::nearest};
};

/// Bodies "a" and "b" of unit mass and inertia (ground is fixed), contact "touch": a spring of that stiffness alone.
[[nodiscard]] Model pair_model(const TouchingPair& pair, double stiffness);

/// Energy and forces of a model wherever its bodies stand.
class Potential {
 public:
  explicit Potential(const Model& model) : dynamics_{model}, work_{dynamics_.workspace()} {}

  /// Puts the bodies where the state has them and settles its modes; what follows is asked of this state.
  void stand(State& state) {
    dynamics_.update(state, work_);
    dynamics_.update_modes(state, work_);
  }
  /// Stored in contact and cable [F L].
  double energy(const State& state) const {
    const Energies energies = dynamics_.energies(state, work_);
    return energies.contacts + energies.cables;
  }
  /// Along the coordinates: accelerations, as masses and inertias are one.
  std::vector<double> forces(const State& state) {
    Rates rates{state};
    dynamics_.rates(state, work_, rates, false);
    return rates.v;
  }

 private:
  Dynamics dynamics_;
  Workspace work_;
};

/// The way of body "a" of a pair round the corner of "b" and back: its centre on a circle about the corner, its angle
/// to and fro.
struct CornerLoop {
  static constexpr Vec2 corner{0.5, 0.35};
  static constexpr double radius = 0.36;
  double work{};                      ///< of the contact's forces on the body, once round [F L]
  double energy{};                    ///< largest on the way [F L]
  std::vector<double> angle, stored;  ///< at some 200 places [degrees, F L]
};

/// The work by trapezia between `steps` places, 200 at least. `moments`: a fault, the share of the moment that is
/// counted.
[[nodiscard]] CornerLoop round_corner(const Model& model, int steps, double moments = 1.0);

}  // namespace talus::verification::problems
