#pragma once

#include <functional>
#include <span>
#include <vector>

#include "solver/dynamics/cable_arrays.hpp"
#include "solver/dynamics/spans.hpp"
#include "solver/dynamics/workspace.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A point at which cables end: of a body, or of the world. Cables that end at the same point share it.
struct Joint {
  bool on_body{};
  BodyId body{};
  Vec2 p;          ///< in body coordinates, or in the world [L]
  double along{};  ///< position along the fence, z [L]
  friend bool operator==(const Joint&, const Joint&) = default;
};

/// The cables of a model, compiled: joints, paths, tensions, modes and energies.
class CableForces {
 public:
  CableForces(const Model& model, const Layout& layout);

  /// Joints of a cable.
  struct Ends {
    std::size_t a{};
    std::size_t b{};
  };

  std::size_t size() const { return ends_.size(); }
  const std::vector<Joint>& joints() const { return joints_; }
  const std::vector<Ends>& ends() const { return ends_; }
  /// Tangent of each law instance, in order.
  const std::vector<Tangent>& tangents() const { return tangents_; }

  /// Sets the joints that are points of the world: called once, when the workspace is made.
  void set_anchors(Workspace& work) const;
  /// Updates the topology to the broken hangers of the state. True if it changed.
  bool update_topology(const State& state, HangerTopology& topology) const;
  /// Lists the joints and cables to compute: all, or those with an end on a body that does not sleep, and those that
  /// continue through broken hangers.
  void list_awake(ActiveSet& active, const HangerTopology& topology) const;
  /// For rates alone, after the poses: writes the cable forces on bodies to their wrenches and those at joints, without
  /// computing paths and independent of velocities. False if the forces require paths.
  bool pull_rows(const State& state, Workspace& work) const;
  /// Computes joints and paths and, for rows on their linear branches, the forces.
  void update(const State& state, Workspace& work) const;
  /// Hangers on which the cable force reaches the strength; only those with the largest ratio of force to strength.
  std::vector<HangerId> overloaded(const State& state, const Workspace& work) const;
  /// True if a cable has broken in a chain that had tension when it was last evaluated.
  bool any_chain_broken(const State& state, const Workspace& work) const;
  /// Bodies at both ends of the cables of a hanger.
  std::vector<BodyId> joined_bodies(HangerId hanger) const;
  void update_modes(State& state, const Workspace& work) const;
  /// Sums the tensions at the joints and writes the sums to the wrenches of the bodies, as their first part. With
  /// `out`, computes also the dissipated power and the impulse of the anchors.
  void load(const State& state, Workspace& work, Rates* out) const;
  /// True if some memory is changed by update_modes() alone: that of cables that yield.
  bool follows(const State& state) const;
  /// Cheap sufficient test that all guards() are infinite.
  bool none_ends(const Workspace& work, double horizon) const;
  /// Computes the guards, except for rows that remain on their linear branches for the time `horizon` [T] at their
  /// present rates. True if any were computed.
  bool guards(const State& state, const Workspace& work, double horizon, std::span<double> out) const;
  /// A cable in tension that runs straight between its own two joints.
  struct TautCable {
    std::size_t index{};
    Tangent slopes;              ///< of its tension
    double symmetry_weight_a{};  ///< force on the body at end A for each unit of tension
    double symmetry_weight_b{};
  };
  void for_each_taut(const State& state, const Workspace& work,
                     const std::function<void(const TautCable&)>& visit) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Lists the sleeping bodies on which a cable force differs from that at rest, by more than the `fraction` of
  /// its tension.
  void list_woken(const State& state, const Workspace& work, double fraction, std::vector<BodyId>& woken) const;
  /// Stores the present cable forces as those at rest.
  void keep_rest(const State& state, const Workspace& work);
  /// Tension of each cable [F] >= 0.
  void tensions(const State& state, const Workspace& work, std::span<double> out) const;
  /// Elongation of one cable [L]; negative while slack.
  double elongation(const Workspace& work, std::size_t cable) const {
    return work.paths.length[cable] - constants_.rest_length[cable];
  }

 private:
  /// A hanger, compiled.
  struct HangerJoint {
    std::size_t joint{};
    double strength{};
    std::vector<std::size_t> cables;  ///< one or two that end at its joint
  };

  std::size_t joint(const CableEnd& end);
  void find_row(CableSpan& span, const std::vector<std::size_t>& ends_at) const;
  /// Computes the linear branches of rows whose modes or memories have changed.
  void keep_lines(const State& state, Workspace& work) const;
  void evaluate_paths(const CableSpan& span, Workspace& work) const;
  void sum_pulls(const State& state, Workspace& work, Rates* out) const;
  void sum_pulls(const CableSpan& span, Workspace& work) const;
  /// Magnitude of the resultant cable force on a hanger [F].
  double pull_on(const HangerJoint& holder, const State& state, const Workspace& work) const;
  Chain chain_from(std::size_t cable, const HangerTopology& topology, std::vector<char>& used) const;
  void extend(Chain& chain, const HangerTopology& topology, std::vector<char>& used) const;
  void straighten(Chain& chain, const State& state, Workspace& work) const;
  Kinematics kinematics(const Workspace& work, std::size_t cable) const {
    return {elongation(work, cable), work.paths.length_rate[cable]};
  }

  CableLaws::Tuple<CableArray> laws_;
  std::vector<Joint> joints_;
  std::vector<std::size_t> anchors_;  ///< the joints that are on no body
  std::vector<Ends> ends_;
  CableConstants constants_;
  std::vector<CableIndex> indices_;
  std::vector<HangerJoint> hanger_joints_;
  std::size_t first_hanger_{};    ///< mode slot of the first hanger
  std::vector<Vec2> rest_pulls_;  ///< tension times direction, of each cable at rest
  std::vector<Tangent> tangents_;
};

}  // namespace talus
