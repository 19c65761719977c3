#pragma once

#include "solver/base/dimension.hpp"
#include "solver/scenes/fence.hpp"
#include "solver/scenes/scene.hpp"

/// The same scene in other units.
namespace talus::verification::problems {

/// What one new unit is worth: every quantity is multiplied by mass^i length^j time^k of its dimension.
struct UnitScale {
  double mass{1.0};
  double length{1.0};
  double time{1.0};

  [[nodiscard]] double of(Dimension dimension) const;
  [[nodiscard]] UnitScale inverse() const { return {1.0 / mass, 1.0 / length, 1.0 / time}; }
};

/// Every number of the model, by the dimensions that the solver's own tables of fields declare.
[[nodiscard]] Model scaled(Model model, const UnitScale& scale);
/// Every number of a state of the model.
[[nodiscard]] State scaled(const Model& model, State state, const UnitScale& scale);
/// Every number of a fence.
[[nodiscard]] scenes::Fence scaled(scenes::Fence fence, const UnitScale& scale);

/// How many numbers of two states of one model differ, modes included.
[[nodiscard]] int differing_numbers(const State& one, const State& other);
/// How many numbers of two models differ: of bodies, cables, contacts, hangers, gravity.
[[nodiscard]] int differing_numbers(const Model& one, const Model& other);

}  // namespace talus::verification::problems
