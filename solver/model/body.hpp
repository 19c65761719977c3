#pragma once

#include <string>

#include "solver/base/vec.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// How a body may move. Each way names its generalised coordinates; a body carries no others.
enum class Mobility {
  free,      ///< x, y of the centre of mass, and the angle
  particle,  ///< x, y; its orientation never changes
  pinned,    ///< the angle; the body turns about a fixed point of itself
  fixed,     ///< none: an obstacle
};
template <>
struct Names<Mobility> {
  static constexpr std::array<std::string_view, 4> list{"free", "particle", "pinned", "fixed"};
};

/// A planar rigid body B. Its frame has its origin at the centre of mass.
struct Body {
  std::string name{};  ///< unique in the model
  Mobility mobility{Mobility::free};
  double mass{};     ///< [M] > 0 unless fixed
  double inertia{};  ///< about the centre of mass [M L^2] > 0 if free or pinned
  Shape shape{};
  Vec2 p_WB{};      ///< reference position of the centre of mass, world [L]
  double angle{};   ///< reference orientation [rad], counter-clockwise > 0
  Vec2 p_BPin{};    ///< of a pinned body: the pin in body coordinates [L]
  Vec2 force{};     ///< constant applied force at the centre of mass, world [F]
  double moment{};  ///< constant applied moment [F L], counter-clockwise > 0
  bool sleeps{};    ///< may sleep: while it is in balance at its reference position nothing is worked out of it
  int copies{1};    ///< number of identical bodies that this one stands for, by symmetry of the scene

  static constexpr std::array<Field<Body>, 4> fields() {
    return {
        {{"mass", dimension::mass, &Body::mass, Range::positive, "mass"},
         {"inertia", dimension::inertia, &Body::inertia, Range::positive, "moment of inertia about the centre of mass"},
         {"angle", dimension::angle, &Body::angle, Range::any, "orientation, counter-clockwise positive"},
         {"moment", dimension::moment, &Body::moment, Range::any,
          "constant applied moment, counter-clockwise positive"}}};
  }
};

}  // namespace talus
