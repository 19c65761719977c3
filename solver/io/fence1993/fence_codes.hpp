#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "solver/dynamics/dynamics.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// The data of one element at one time from which its history values are computed.
struct FenceSample {
  const Dynamics& dynamics;
  const State& state;
  const Workspace& work;    ///< evaluated at that state, with the loads on its bodies
  const LawForces& forces;  ///< at that state
  const scenes::FenceElement& element;
  const scenes::FenceMember& member;

  Pose pose() const { return work.poses[index(*member.body)]; }
  /// Total load on the body: contacts, cables, applied loads and weight [F], [F L].
  Wrench load() const;
  const Cable& cable(std::optional<CableId> id) const { return dynamics.model().cables[index(*id)]; }
  const ElasticPlastic& law(std::optional<CableId> id) const { return std::get<ElasticPlastic>(cable(id).law); }
  Path path(std::optional<CableId> id) const { return work.paths[index(*id)]; }
  double tension(std::optional<CableId> id) const { return forces.tensions[index(*id)]; }
  /// Pull of the segment on the element, in the plane of motion [F].
  Vec2 pull(std::optional<CableId> id) const { return tension(id) * path(id).pull_A; }
  /// Plastic stretch of the segment [L].
  double stretch(std::optional<CableId> id) const { return state.z[dynamics.layout().cable_slots[index(*id)].memory]; }
  /// Magnitude of the sum of all pulls of the top cable at the element's joint [F].
  double joint_force() const;
};

/// Condition that an element must satisfy to have a quantity.
enum class Needs {
  body,    ///< it is not a fixed end of a cable
  column,  ///< it is a column
  moving,  ///< none of its motions is fixed
  top,     ///< a segment of the top cable leads outwards from it
  bottom,  ///< a segment of the bottom cable leads outwards from it
};

/// One of the 61 quantities that the 1993 program had for each element and could store as a history.
struct FenceCode {
  int number{};
  std::string_view title;  ///< as printed in its listing
  std::string_view name;   ///< in the headers of history files; empty if it has no history
  Dimension dimension{};
  Needs needs{};
  std::string_view refusal;                      ///< why it has no history; empty if it has one
  double (*value)(const FenceSample&){nullptr};  ///< in the scene's consistent units
};

inline constexpr std::size_t fence_code_count = 61;

/// All codes; code n has the index n - 1 (Mustoe & Huttelmaier 1993, Appendix II.5.2).
[[nodiscard]] const std::array<FenceCode, fence_code_count>& fence_codes();

}  // namespace talus
