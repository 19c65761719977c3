#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "solver/dynamics/workspace.hpp"
#include "solver/geometry/shape.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Geometry of one contact instance between body A (the first shape) and body B (the second).
template <class ShapeA, class ShapeB>
struct PointContact {
  BodyId a{};
  BodyId b{};
  ShapeA shape_a;
  ShapeB shape_b;
};

/// All contact instances of one law, in one array for each kind of geometry, with the slots of their modes and memory.
/// `slot` also is the place of the instance in Workspace::gaps (contacts have the first mode slots).
template <class L>
struct ContactArrays {
  template <class ShapeA, class ShapeB>
  struct Array {
    std::vector<PointContact<ShapeA, ShapeB>> geometry;
    std::vector<L> laws;
    std::vector<Slot> slots;
  };

  std::tuple<Array<Ball, Circle>, Array<Ball, Rectangle>, Array<Ball, HalfPlane>, Array<Rectangle, HalfPlane>,
             Array<Rectangle, Rectangle>>
      arrays;
};

/// The contacts of a model, compiled: gaps, forces, modes and energies of all law instances.
class ContactForces {
 public:
  ContactForces(const Model& model, const Layout& layout);

  /// Number of law instances: the length of Workspace::gaps and Workspace::rates.
  std::size_t size() const { return pairs_.size(); }
  void update(Workspace& work) const;
  void settle(State& state, const Workspace& work) const;
  /// Adds the forces to the wrenches of both bodies; with out, the dissipated power as well.
  void add(const State& state, Workspace& work, Rates* out) const;
  void guards(const State& state, const Workspace& work, std::span<double> out) const;
  double stored_energy(const State& state, const Workspace& work) const;
  /// Normal force of each instance [F], > 0 pushing apart.
  void forces(const State& state, const Workspace& work, std::span<double> out) const;
  /// Tangent of each law instance, in order.
  const std::vector<Tangent>& tangents() const { return tangents_; }
  /// The two bodies of each instance, in the order of its gap's normal.
  struct Pair {
    BodyId a{};
    BodyId b{};
  };
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  ContactLaws::Tuple<ContactArrays> laws_;
  std::vector<Pair> pairs_;
  std::vector<Tangent> tangents_;
};

}  // namespace talus
