#pragma once

#include <array>
#include <optional>
#include <string>

#include "solver/base/ids.hpp"
#include "solver/geometry/node_depth.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// How the overlap of two outlines becomes forces.
enum class ContactMethod {
  resultant,  ///< from the exact gap of the two shapes, independent of any discretisation: one force for a pair; a
              ///< rectangle that lies flat on a half-plane or another rectangle rests on both ends of its side
  nodes,      ///< the law acts at each boundary node of one body inside the other, both ways (FENCE 1993): the answer
              ///< depends on the number of nodes and does not converge with it
};
template <>
struct Names<ContactMethod> {
  static constexpr std::array<std::string_view, 2> list{"resultant", "nodes"};
};

/// Two bodies that may touch, and the law by which they do.
struct Contact {
  std::string name{};  ///< unique in the model
  BodyId a{};
  BodyId b{};
  ContactLaw law{};
  ContactMethod method{ContactMethod::resultant};
  std::array<int, 2> nodes{12, 12};  ///< boundary nodes of a and b when method is `nodes`: of a circle or superquadric
  NodeDepth node_depth{NodeDepth::nearest};   ///< of nodes in a superquadric when method is `nodes`
  std::optional<CoulombFriction> friction{};  ///< none: the contact is smooth, and keeps no memory for it
  int multiplicity{1};  ///< number of identical contacts that this one stands for, by symmetry of the scene
};

}  // namespace talus
