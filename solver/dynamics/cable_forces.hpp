#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "solver/dynamics/workspace.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// All cables of one law.
template <class L>
struct CableArray {
  std::vector<std::size_t> cable;  ///< place of each in Workspace::paths
  std::vector<L> laws;
  std::vector<Slot> slots;
};

/// The cables of a model, compiled: paths, tensions, modes and energies.
class CableForces {
 public:
  CableForces(const Model& model, const Layout& layout);

  std::size_t size() const { return ends_.size(); }
  void update(Workspace& work) const;
  void settle(State& state, const Workspace& work) const;
  /// Adds the tensions to the wrenches of the bodies at the ends; with out, dissipated power and the anchors' impulse
  /// as well.
  void add(const State& state, Workspace& work, Rates* out) const;
  void guards(const State& state, const Workspace& work, std::span<double> out) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Tension of each cable [F] >= 0.
  void tensions(const State& state, const Workspace& work, std::span<double> out) const;
  /// Elongation of one cable [L]; negative while slack.
  double elongation(const Workspace& work, std::size_t cable) const {
    return work.paths[cable].length - rest_lengths_[cable];
  }

  /// An end as compiled: a body's point (`on_body`) or a point of the world.
  struct End {
    bool on_body{};
    BodyId body{};
    Vec3 p;
  };
  struct Ends {
    End a;
    End b;
  };
  const std::vector<Ends>& ends() const { return ends_; }
  /// Tangent of each law instance, in order.
  const std::vector<Tangent>& tangents() const { return tangents_; }

 private:
  CableLaws::Tuple<CableArray> laws_;
  std::vector<Ends> ends_;
  std::vector<double> rest_lengths_;
  std::vector<Tangent> tangents_;
};

/// World position of a cable's end [L].
[[nodiscard]] Vec3 position(const CableForces::End& end, const Workspace& work);

}  // namespace talus
