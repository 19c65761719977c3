#pragma once

#include <span>
#include <tuple>
#include <vector>

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
  double along{};  ///< place along the fence, z [L]
  friend bool operator==(const Joint&, const Joint&) = default;
};

/// All cables of one law.
template <class L>
struct CableArray {
  std::vector<std::size_t> cable;  ///< place of each in Workspace::paths
  std::vector<L> laws;
  std::vector<Slot> slots;
};

/// The cables of a model, compiled: joints, paths, tensions, modes and energies.
class CableForces {
 public:
  CableForces(const Model& model, const Layout& layout);

  /// Joints of a cable, and how much of its tension each takes: a cable that stands for several pulls several times
  /// at a body that stands for itself alone.
  struct Ends {
    std::size_t a{};
    std::size_t b{};
    double share_a{1.0};
    double share_b{1.0};
  };

  std::size_t size() const { return ends_.size(); }
  const std::vector<Joint>& joints() const { return joints_; }
  const std::vector<Ends>& ends() const { return ends_; }
  /// Tangent of each law instance, in order.
  const std::vector<Tangent>& tangents() const { return tangents_; }

  /// Lists the joints and cables to work out: all, or those of which an end is on a body that is awake or held.
  void list_awake(Waking& waking) const;
  void update(Workspace& work) const;
  void settle(State& state, const Workspace& work) const;
  /// Sums the tensions at the joints and adds them to the wrenches of the bodies; with out, dissipated power and the
  /// anchors' impulse as well.
  void add(const State& state, Workspace& work, Rates* out) const;
  void guards(const State& state, const Workspace& work, std::span<double> out) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Lists the sleeping bodies on which a cable pulls otherwise than at rest, by more than `share` of its tension.
  void list_woken(const State& state, const Workspace& work, double share, std::vector<BodyId>& woken) const;
  /// Keeps the present pulls as those at rest.
  void keep_rest(const State& state, const Workspace& work);
  /// Tension of each cable [F] >= 0.
  void tensions(const State& state, const Workspace& work, std::span<double> out) const;
  /// Elongation of one cable [L]; negative while slack.
  double elongation(const Workspace& work, std::size_t cable) const {
    return work.paths[cable].length - rest_lengths_[cable];
  }

 private:
  std::size_t joint(const CableEnd& end);
  Kinematics kinematics(const Workspace& work, std::size_t cable) const {
    return {elongation(work, cable), work.paths[cable].length_rate};
  }

  CableLaws::Tuple<CableArray> laws_;
  std::vector<Joint> joints_;
  std::vector<Ends> ends_;
  std::vector<double> across_squared_;
  std::vector<double> rest_lengths_;
  std::vector<double> copies_;
  std::vector<Vec2> rest_pulls_;  ///< tension times direction, of each cable at rest
  std::vector<Tangent> tangents_;
};

}  // namespace talus
