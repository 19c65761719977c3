#pragma once

#include "solver/base/dimension.hpp"
#include "solver/scenes/fence.hpp"
#include "solver/scenes/scene.hpp"

/// The same scene in other units.
namespace talus::verification::problems {

/// Scale factors of the units: every quantity is multiplied by mass^i length^j time^k of its dimension.
struct UnitScale {
  double mass{1.0};
  double length{1.0};
  double time{1.0};

  [[nodiscard]] double of(Dimension dimension) const;
  [[nodiscard]] UnitScale inverse() const { return {1.0 / mass, 1.0 / length, 1.0 / time}; }
};

/// The model with every number scaled, by the dimensions that the solver's tables of fields declare.
[[nodiscard]] Model scaled(Model model, const UnitScale& scale);
/// The state with every number scaled.
[[nodiscard]] State scaled(const Model& model, State state, const UnitScale& scale);
/// The fence with every number scaled.
[[nodiscard]] scenes::Fence scaled(scenes::Fence fence, const UnitScale& scale);

/// Number of differing values of two states of one model, including modes.
[[nodiscard]] int differing_numbers(const State& one, const State& other);
/// Number of differing values of two models, over bodies, cables, contacts, hangers and gravity.
[[nodiscard]] int differing_numbers(const Model& one, const Model& other);

}  // namespace talus::verification::problems
