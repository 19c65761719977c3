#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "solver/base/units.hpp"
#include "solver/model/body.hpp"
#include "solver/model/cable.hpp"
#include "solver/model/contact.hpp"
#include "solver/model/hanger.hpp"

namespace talus {

/// Change of a cable force that wakes a sleeping body.
enum class Sleep {
  off,    ///< bodies never sleep
  exact,  ///< any change of a force that is not zero: bit-identical to `off`
  on,     ///< a change of more than 1e-13 of the force
};
template <>
struct Names<Sleep> {
  static constexpr std::array<std::string_view, 3> list{"off", "exact", "on"};
};

/// Bodies, cables, contacts and hangers of a scene. Built and checked by ModelBuilder; never changed afterwards.
struct Model {
  std::vector<Body> bodies;
  std::vector<Cable> cables;
  std::vector<Contact> contacts;
  std::vector<Hanger> hangers;
  Vec2 gravity;  ///< acceleration of free fall, world [L/T^2]
  Sleep sleep{Sleep::off};
  UnitSystem units{si};  ///< a tag for labels; the solver does not use it
};

/// Finds the body, cable or contact of this name, if there is one.
[[nodiscard]] std::optional<BodyId> find_body(const Model& model, std::string_view name);
[[nodiscard]] std::optional<CableId> find_cable(const Model& model, std::string_view name);
[[nodiscard]] std::optional<ContactId> find_contact(const Model& model, std::string_view name);

/// True if the end of the cable is at the point of the hanger.
[[nodiscard]] bool ends_at(const CableEnd& end, const Hanger& hanger);

/// Inertia of a pinned body about its pin: I + m |p_BPin|^2 [M L^2].
[[nodiscard]] double inertia_about_pin(const Body& body);

/// World position of a pinned body's pin [L].
[[nodiscard]] Vec2 pin(const Body& body);

/// World position of a cable's end in the reference positions of the bodies [L].
[[nodiscard]] Vec3 reference_point(const Model& model, const CableEnd& end);

}  // namespace talus
