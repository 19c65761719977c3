#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/scenes/fence.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// One element by the numbering of 1993: 1 the ground, then the rocks, then for each layer its columns from the centre
/// outwards and the fixed end of the top cable.
struct FenceMember {
  std::optional<BodyId> body{};      ///< none for a fixed end
  int layer{};                       ///< 1 or 2 for columns and fixed ends, else 0
  Vec2 position{};                   ///< at the start [L]
  double angle{};                    ///< at the start [rad]
  double mass{};                     ///< of one element, as the listing prints it [M]
  double inertia{};                  ///< about its centroid [M L^2]
  std::optional<CableId> top{};      ///< segment of the top cable from it outwards
  std::optional<CableId> bottom{};   ///< segment of the bottom cable from it outwards
  std::optional<HangerId> hanger{};  ///< its top joint, if that can break
};

/// Stiffness and dashpot that a contact of a fence gets from the overlap it may reach (Mustoe & Huttelmaier 1993,
/// section 3.5, Appendix I Eq. 9, and Eq. 21).
struct FenceContactLaw {
  double stiffness{};  ///< k_n [F/L]
  double damping{};    ///< c [F T/L]
};

/// A fence as a scene, and what its listing says of it.
struct FenceScene {
  Scene scene;
  std::vector<FenceMember> members;  ///< element n is members[n - 1]
  double critical_step{};       ///< of the 1993 rule: T/100, T = 2 pi sqrt(m/(2 k)) of the central column's segment [T]
  double horizontal_tension{};  ///< H of the static shape, first layer [F]
  FenceContactLaw rock_column;  ///< of the first rock
  FenceContactLaw column_column;
  FenceContactLaw rock_ground;  ///< of the first rock
};

/// The columns of a layer by the static shape of the top cable: heights above the central column(s) and tensions
/// (Mustoe & Huttelmaier 1993, section 2.4; point loads, the weights of the columns; slope of segment i = load inside
/// it / H).
struct StaticShape {
  std::vector<double> distances;  ///< horizontal length of each segment from the centre outwards [L]
  std::vector<double> heights;    ///< of each column, and last of the fixed end [L]
  std::vector<double> tensions;   ///< of each segment [F]
  double horizontal_tension{};    ///< H [F]
};
[[nodiscard]] StaticShape static_shape(const Fence& fence);

/// Number of elements of one layer without its fixed end: the columns of one half, the central ones counted once.
[[nodiscard]] int columns_of_half(const Fence& fence);

/// Number of elements by the numbering of 1993.
[[nodiscard]] int element_count(const Fence& fence);

/// The scene of a fence. Errors: InputError for what the fence's numbers do not allow.
[[nodiscard]] FenceScene fence_scene(const Fence& fence);

}  // namespace talus::scenes
