#pragma once

#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/dynamics/lanes.hpp"
#include "solver/geometry/node_depth.hpp"
#include "solver/geometry/shape.hpp"
#include "solver/model/layout.hpp"
#include "solver/model/model.hpp"

namespace talus {

/// Law instances of one contact that share a kind of geometry: shape A of one body against shape B of another.
struct ContactGroup {
  std::size_t candidate{};  ///< the pair of bodies in the contact search
  BodyId a{};
  BodyId b{};
  std::size_t first{};  ///< its first instance in the array
  std::size_t last{};   ///< one past its last instance
  double symmetry_weight_a{
      1.0};  ///< force on A for each unit of the law's force: above 1 where a contact that represents several
  double symmetry_weight_b{1.0};          ///< acts on a body that represents only itself; the same for B
  double multiplicity{1.0};               ///< number of identical contacts that this one represents
  std::optional<FrictionLaw> friction{};  ///< none: no tangential force is computed
  Slot first_friction{};                  ///< friction slot of its instance `first`; those of the others follow
};

/// All contact instances of one law, in one array for each kind of geometry, with the slots of their modes and memory.
/// The mode slot of an instance is also its index in Workspace::gaps (contacts have the first mode slots).
template <class L>
struct ContactArrays {
  template <class A, class B>
  struct Array {
    using ShapeA = A;
    using ShapeB = B;
    std::vector<ContactGroup> groups;
    std::vector<ShapeA> shapes_a;
    std::vector<ShapeB> shapes_b;
    Row node_x, node_y;  ///< centres of the shapes A, if their depths are computed side by side [L]
    Row radius;          ///< radii of the shapes A, over a half-plane or a circle [L]
    std::vector<L> laws;
    std::vector<Slot> slots;
  };

  std::tuple<Array<Ball, Circle>, Array<Ball, Rectangle>, Array<Ball, Superquadric>, Array<Ball, SideFaces>,
             Array<Ball, CentroidRays>, Array<Ball, Smoother>, Array<Ball, HalfPlane>, Array<Ball, Terrain>,
             Array<Superquadric, HalfPlane>, Array<RectangleEnd, Rectangle>, Array<Superquadric, Superquadric>,
             Array<Rectangle, Superquadric>>
      arrays;
  unsigned used{};  ///< one bit for each array: set if it has an instance
};

/// The two bodies of a law instance, in the order of its gap's normal.
struct InstancePair {
  BodyId a{};
  BodyId b{};
};

/// Index of an array among those of its law.
template <class Array, class... Arrays>
constexpr unsigned index_of(const std::tuple<Arrays...>&) {
  unsigned index = 0;
  static_cast<void>(((std::is_same_v<Array, Arrays> || (++index, false)) || ...));
  return index;
}

/// Fills the arrays of one law from the model, contact by contact.
template <class L>
class ContactCompiler {
 public:
  ContactCompiler(const Model& model, ContactArrays<L>& arrays, std::vector<InstancePair>& pairs)
      : model_{model}, arrays_{arrays}, pairs_{pairs} {}

  void add(std::size_t candidate, const Contact& contact, const L& law, Slot first, Slot friction) {
    const Shape& a = model_.bodies[index(contact.a)].shape;
    const Shape& b = model_.bodies[index(contact.b)].shape;
    candidate_ = candidate;
    contact_ = &contact;
    law_ = law;
    next_ = first;
    next_friction_ = friction;
    if (contact.method == ContactMethod::resultant) return add_resultant(contact.a, a, contact.b, b);
    add_nodes(contact.a, a, contact.nodes[0], contact.b, b);
    add_nodes(contact.b, b, contact.nodes[1], contact.a, a);
  }

 private:
  template <class ShapeA, class ShapeB>
  void add(BodyId id_a, const ShapeA& a, BodyId id_b, const ShapeB& b) {
    using Array = typename ContactArrays<L>::template Array<ShapeA, ShapeB>;
    auto& array = std::get<Array>(arrays_.arrays);
    arrays_.used |= 1U << index_of<Array>(arrays_.arrays);
    if (array.groups.empty() || array.groups.back().candidate != candidate_ || array.groups.back().a != id_a)
      array.groups.push_back(group(id_a, id_b, array.laws.size()));
    array.shapes_a.push_back(a);
    array.shapes_b.push_back(b);
    constexpr bool by_radius =
        std::is_same_v<ShapeA, Ball> && (std::is_same_v<ShapeB, HalfPlane> || std::is_same_v<ShapeB, Circle>);
    if constexpr (BoxedRule<ShapeB> || by_radius)
      array.node_x.push_back(a.center_A.x), array.node_y.push_back(a.center_A.y);
    if constexpr (by_radius) array.radius.push_back(a.radius);
    array.laws.push_back(law_);
    array.slots.push_back(next_);
    array.groups.back().last = array.laws.size();
    pairs_[next_.mode] = {id_a, id_b};
    next_ = {next_.mode + 1, next_.memory + memory_count(law_)};
    next_friction_ = {next_friction_.mode + 1,
                      next_friction_.memory + (contact_->friction ? memory_count(*contact_->friction) : 0)};
  }

  ContactGroup group(BodyId a, BodyId b, std::size_t first) const {
    const double multiplicity = contact_->multiplicity;
    return {candidate_,
            a,
            b,
            first,
            first,
            multiplicity / model_.bodies[index(a)].multiplicity,
            multiplicity / model_.bodies[index(b)].multiplicity,
            multiplicity,
            contact_->friction,
            next_friction_};
  }

  void add_nodes(BodyId id_a, const Shape& a, int count, BodyId id_b, const Shape& b) {
    std::optional<Superquadric> target;
    if (const auto* outline = std::get_if<Superquadric>(&b)) target = *outline;
    if (const auto* circle = std::get_if<Circle>(&b)) target = Superquadric{circle->radius, circle->radius, 2.0};
    for (const Vec2 node : boundary_nodes(a, count)) {
      if (contact_->node_depth == NodeDepth::smoother && target) {
        add(id_a, Ball{node, 0.0}, id_b, smoother(a, node, *target));
      } else {
        add_ball({node, 0.0}, id_a, id_b, b);
      }
    }
  }

  /// Data of a node for the rule `smoother`; a corner has infinite curvature.
  static Smoother smoother(const Shape& a, Vec2 node, const Superquadric& target) {
    if (const auto* circle = std::get_if<Circle>(&a))
      return {target, (1.0 / circle->radius) * node, 1.0 / circle->radius};
    if (const auto* outline = std::get_if<Superquadric>(&a))
      return {target, outward_normal(*outline, node), curvature(*outline, node)};
    return {target, {}, std::numeric_limits<double>::infinity()};
  }

  void add_ball(const Ball& ball, BodyId id_a, BodyId id_b, const Shape& b) {
    const bool node = contact_->method == ContactMethod::nodes;
    std::visit(
        [&]<class Target>(const Target& target) {
          if constexpr (std::is_same_v<Target, NoShape>) {
            TALUS_DEMAND(false);
          } else if constexpr (std::is_same_v<Target, Superquadric>) {
            if (node && contact_->node_depth == NodeDepth::side_face) return add(id_a, ball, id_b, SideFaces{target});
            if (node && contact_->node_depth == NodeDepth::centroid_ray)
              return add(id_a, ball, id_b, CentroidRays{target});
            add(id_a, ball, id_b, target);
          } else {
            add(id_a, ball, id_b, target);
          }
        },
        b);
  }

  void add_resultant(BodyId id_a, const Shape& a, BodyId id_b, const Shape& b) {
    if (const auto* circle = std::get_if<Circle>(&a)) return add_ball({{}, circle->radius}, id_a, id_b, b);
    if (const auto* circle = std::get_if<Circle>(&b)) return add_ball({{}, circle->radius}, id_b, id_a, a);
    if (std::holds_alternative<HalfPlane>(a)) return add_resultant(id_b, b, id_a, a);
    if (const auto* outline = std::get_if<Superquadric>(&a)) {
      if (std::holds_alternative<Rectangle>(b)) return add_resultant(id_b, b, id_a, a);
      if (const auto* other = std::get_if<Superquadric>(&b)) return add(id_a, *outline, id_b, *other);
      return add(id_a, *outline, id_b, std::get<HalfPlane>(b));
    }
    const auto& box = std::get<Rectangle>(a);
    if (const auto* plane = std::get_if<HalfPlane>(&b)) {
      for (const Vec2 corner : boundary_nodes(a, 4))
        add(id_a, Ball{corner, 0.0}, id_b, *plane);
      return;
    }
    if (const auto* outline = std::get_if<Superquadric>(&b)) return add(id_a, box, id_b, *outline);
    for (const int end : {0, 1})
      add(id_a, RectangleEnd{box, end}, id_b, std::get<Rectangle>(b));
  }

  const Model& model_;
  ContactArrays<L>& arrays_;
  std::vector<InstancePair>& pairs_;
  std::size_t candidate_{};
  const Contact* contact_{};
  L law_{};
  Slot next_;
  Slot next_friction_;
};

}  // namespace talus
