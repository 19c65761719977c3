#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/scenes/fence.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// One element in the numbering of 1993: 1 is the ground, followed by the rocks and then, for each layer, its columns
/// from the centre outwards and the fixed end of the top cable.
struct FenceMember {
  std::optional<BodyId> body{};      ///< none for a fixed end
  int layer{};                       ///< 1 or 2 for columns and fixed ends, else 0
  Vec2 position{};                   ///< at the start [L]
  double angle{};                    ///< at the start [rad]
  double mass{};                     ///< of one element, as printed in the listing [M]
  double inertia{};                  ///< about its centroid [M L^2]
  std::optional<CableId> top{};      ///< segment of the top cable from the element outwards
  std::optional<CableId> bottom{};   ///< segment of the bottom cable from the element outwards
  std::optional<HangerId> hanger{};  ///< its top joint, if that can break
};

/// Stiffness and dashpot of a fence contact, computed from its allowed overlap (Mustoe & Huttelmaier 1993, section 3.5,
/// Appendix I Eq. 9, and Eq. 21).
struct FenceContactLaw {
  double stiffness{};  ///< k_n [F/L]
  double damping{};    ///< c [F T/L]
};

/// A fence as a scene, with the values that its listing prints.
struct FenceScene {
  Scene scene;
  std::vector<FenceMember> members;  ///< element n is members[n - 1]
  double critical_step{};       ///< of the 1993 rule: T/100, T = 2 pi sqrt(m/(2 k)) of the central column's segment [T]
  double horizontal_tension{};  ///< H of the static shape, first layer [F]
  FenceContactLaw rock_column;  ///< of the first rock
  FenceContactLaw column_column;
  FenceContactLaw rock_ground;  ///< of the first rock
};

/// Static shape of the top cable: heights of the columns of a layer above the central column(s), and tensions (Mustoe &
/// Huttelmaier 1993, section 2.4). The columns' weights are point loads; the slope of segment i is (load inside segment
/// i)/H.
struct StaticShape {
  std::vector<double> distances;  ///< horizontal length of each segment from the centre outwards [L]
  std::vector<double> heights;    ///< of each column, followed by the fixed end [L]
  std::vector<double> tensions;   ///< of each segment [F]
  double horizontal_tension{};    ///< H [F]
};
[[nodiscard]] StaticShape static_shape(const Fence& fence);

/// Number of columns in one half of a layer; the centre counts once.
[[nodiscard]] int columns_of_half(const Fence& fence);

/// Number of elements in the numbering of 1993.
[[nodiscard]] int element_count(const Fence& fence);

/// An error in a fence, which readers of files report at the line of the field.
struct FenceFault {
  std::size_t element{};  ///< number of the element concerned; 0: the fence itself
  std::string field;      ///< name of the member of Fence or FenceElement
  std::string message;    ///< what was found and what is allowed
};

/// A fence that cannot be built. Its message is that of the fault, after "fence: FIELD: ".
class FenceError : public InputError {
 public:
  explicit FenceError(FenceFault fault);
  const FenceFault& fault() const { return fault_; }

 private:
  FenceFault fault_;
};

/// The scene of a fence. Errors: FenceError, or another InputError for invalid or inconsistent numbers.
[[nodiscard]] FenceScene fence_scene(const Fence& fence);

}  // namespace talus::scenes
