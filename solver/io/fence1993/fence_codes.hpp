#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "solver/dynamics/dynamics.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// What the histories of one element are computed from, at one time.
struct FenceSample {
  const Dynamics& dynamics;
  const State& state;
  const Workspace& work;    ///< of that state, with the loads on its bodies
  const LawForces& forces;  ///< at that state
  const scenes::FenceElement& element;
  const scenes::FenceMember& member;

  Pose pose() const { return work.poses[index(*member.body)]; }
  /// All that acts on the body: contacts, cables, applied loads and weight [F], [F L].
  Wrench load() const;
  const Cable& cable(std::optional<CableId> id) const { return dynamics.model().cables[index(*id)]; }
  const ElasticPlastic& law(std::optional<CableId> id) const { return std::get<ElasticPlastic>(cable(id).law); }
  Path path(std::optional<CableId> id) const { return work.paths[index(*id)]; }
  double tension(std::optional<CableId> id) const { return forces.tensions[index(*id)]; }
  /// Pull of the segment on the element, in the plane of motion [F].
  Vec2 pull(std::optional<CableId> id) const { return tension(id) * path(id).pull_A; }
  /// Plastic stretch of the segment [L].
  double stretch(std::optional<CableId> id) const { return state.z[dynamics.layout().cable_slots[index(*id)].memory]; }
  /// Length of the sum of all pulls of the top cable at the element's joint [F].
  double joint_force() const;
};

/// What an element must have for a quantity to be its own.
enum class Needs {
  body,    ///< it is no fixed end
  column,  ///< it is a column
  moving,  ///< none of its motions is held
  top,     ///< a segment of the top cable goes outwards from it
  bottom,  ///< a segment of the bottom cable goes outwards from it
};

/// One of the 61 quantities that the 1993 program kept for each element and could store as a history.
struct FenceCode {
  int number{};
  std::string_view title;  ///< as its listing prints it
  std::string_view name;   ///< in the headers of the histories; empty if it has none
  Dimension dimension{};
  Needs needs{};
  std::string_view refusal;                      ///< why it has no history; empty if it has one
  double (*value)(const FenceSample&){nullptr};  ///< in the scene's consistent units
};

inline constexpr std::size_t fence_code_count = 61;

/// All of them; code n is the element n - 1 (Mustoe & Huttelmaier 1993, Appendix II.5.2).
[[nodiscard]] const std::array<FenceCode, fence_code_count>& fence_codes();

}  // namespace talus
