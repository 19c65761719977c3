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
    dynamics_.settle(state, work_);
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

}  // namespace talus::verification::problems
