#pragma once

#include <string>
#include <vector>

#include "solver/app/capacity/capacity_file.hpp"
#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/base/vec.hpp"
#include "solver/io/scene/scene_file.hpp"

namespace talus::app {

/// The runs of a fence with other rocks in place of the base's. A rock of another mass has the density and the
/// proportions of the base's; it starts at least as far from the fence, in the same direction, with the same angle.
class RockRuns {
 public:
  /// `base`: a scene that is right. Errors: InputError for a base that is no fence, has no rock or several, or whose
  /// rock does not move along x; if the file sets a field wrongly; and if it has positions along the fence and the base
  /// is a half model or has no such position.
  RockRuns(const TomlValue& base, const std::string& name, const CapacityFile& file);

  /// The rock of the base.
  const Rock& own() const { return own_; }
  /// Translational and rotational kinetic energy of a rock at its start [J].
  [[nodiscard]] double start_energy(const Rock& rock) const;
  /// Units of the base.
  const UnitSystem& units() const { return base_.scene.model.units; }
  /// Whether all of the fence is modelled, and not one half.
  bool is_full() const { return base_.fence->fence.options.symmetry == scenes::FenceSymmetry::full; }
  /// The run of one rock with small changes, which `numbers` in [-1, 1) choose: speed, height, angle, spin, position.
  [[nodiscard]] SweptRun run(const Rock& rock, const std::array<double, 5>& numbers) const;

 private:
  /// Height of the base's rock's centre, at this distance from its place, above the ground [m].
  double height_at(Vec2 shift) const;

  TomlValue document_;  ///< the base with the fields that the file sets
  SceneFile base_;
  bool gives_mass_{};                ///< the base gives its rock's mass, not the density
  bool sets_spin_{}, sets_along_{};  ///< the file asks for spins or positions other than the base's
  std::vector<std::pair<std::string, TomlValue>> fields_;
  RockChanges changes_;
  Rock own_;
};

/// Numbers in [-1, 1) that follow from a seed and what they are for.
[[nodiscard]] std::array<double, 5> random_numbers(std::int64_t seed, const std::vector<std::uint32_t>& purpose);

}  // namespace talus::app
