#pragma once

#include <array>
#include <optional>
#include <string>

#include "solver/base/ids.hpp"
#include "solver/geometry/node_depth.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// Method that computes forces from the overlap of two outlines.
enum class ContactMethod {
  resultant,  ///< one force for a pair, from the exact gap of the two shapes, independent of any discretisation;
              ///< a rectangle that lies flat on a half-plane or another rectangle rests on both ends of its side
  nodes,      ///< the law acts at each boundary node of either body that is inside the other (FENCE 1993): results
              ///< depend on the number of nodes and do not converge with it
};
template <>
struct Names<ContactMethod> {
  static constexpr std::array<std::string_view, 2> list{"resultant", "nodes"};
};

/// Two bodies that may touch, and the contact law between them.
struct Contact {
  std::string name{};  ///< unique in the model
  BodyId a{};
  BodyId b{};
  ContactLaw law{};
  ContactMethod method{ContactMethod::resultant};
  std::array<int, 2> nodes{12, 12};  ///< number of boundary nodes of a circle or superquadric a or b, with `nodes`
  NodeDepth node_depth{NodeDepth::nearest};  ///< depth rule for nodes in a superquadric, with `nodes`
  std::optional<FrictionLaw> friction{};     ///< none: a frictionless contact, without memory for friction
  int multiplicity{1};  ///< number of identical contacts that this one represents, by symmetry of the scene
};

}  // namespace talus
