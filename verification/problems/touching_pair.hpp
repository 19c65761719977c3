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

  /// Modes are settled here and kept for the neighbourhood. Accelerations are forces: masses are one.
  State settled(State state) {
    dynamics_.update(state, work_);
    dynamics_.settle(state, work_);
    return state;
  }
  double energy(const State& state) {
    dynamics_.update(state, work_);
    const Energies energies = dynamics_.energies(state, work_);
    return energies.contacts + energies.cables;
  }
  std::vector<double> forces(const State& state) {
    Rates rates{state};
    dynamics_.update(state, work_);
    dynamics_.rates(state, work_, rates, false);
    return rates.v;
  }
  bool same_modes(const State& state) { return settled(state).mode == state.mode; }

 private:
  Dynamics dynamics_;
  Workspace work_;
};

}  // namespace talus::verification::problems
