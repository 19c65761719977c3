#pragma once

#include <string>

#include "solver/base/vec.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// Degrees of freedom of a body. Each value names the generalised coordinates; a body has no others.
enum class Mobility {
  free,       ///< x, y of the centre of mass, and the angle
  particle,   ///< x, y; its orientation never changes
  pinned,     ///< the angle; the body turns about its pin, a point that is fixed in the body and in the world
  fixed,      ///< none: an obstacle
  sliding_x,  ///< x; neither y nor the orientation ever change
  sliding_y,  ///< y; neither x nor the orientation ever change
  guided_x,   ///< x of the centre of mass, and the angle; the pin stays at its height
  guided_y,   ///< y of the centre of mass, and the angle; the pin stays at its x
};
template <>
struct Names<Mobility> {
  static constexpr std::array<std::string_view, 8> list{"free",      "particle",  "pinned",   "fixed",
                                                        "sliding_x", "sliding_y", "guided_x", "guided_y"};
};

/// Coordinates that a mobility has, and whether it needs a pin.
constexpr bool has_x(Mobility m) {
  return m == Mobility::free || m == Mobility::particle || m == Mobility::sliding_x || m == Mobility::guided_x;
}
constexpr bool has_y(Mobility m) {
  return m == Mobility::free || m == Mobility::particle || m == Mobility::sliding_y || m == Mobility::guided_y;
}
constexpr bool has_pin(Mobility m) {
  return m == Mobility::pinned || m == Mobility::guided_x || m == Mobility::guided_y;
}
constexpr bool turns(Mobility m) { return m == Mobility::free || has_pin(m); }

/// A planar rigid body B. Its frame has its origin at the centre of mass.
struct Body {
  std::string name{};  ///< unique in the model
  Mobility mobility{Mobility::free};
  double mass{};     ///< [M] > 0 unless fixed
  double inertia{};  ///< about the centre of mass [M L^2] > 0 if it turns
  Shape shape{};
  Vec2 p_WB{};          ///< reference position of the centre of mass, world [L]
  double angle{};       ///< reference orientation [rad], counter-clockwise > 0
  Vec2 p_BPin{};        ///< pin of a pinned or guided body, body coordinates [L]
  Vec2 force{};         ///< constant applied force at the centre of mass, world [F]
  double moment{};      ///< constant applied moment [F L], counter-clockwise > 0
  bool sleeps{};        ///< may sleep: it is not computed while in equilibrium at its reference position
  int multiplicity{1};  ///< number of identical bodies that this one represents, by symmetry of the scene

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
