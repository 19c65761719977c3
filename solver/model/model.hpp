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

/// When bodies that may sleep are woken.
enum class Sleep {
  off,    ///< they never sleep
  exact,  ///< by the first change of a pull on them that is not zero: the same bits as `off`
  on,     ///< by a change of more than 1e-13 of the pull
};
template <>
struct Names<Sleep> {
  static constexpr std::array<std::string_view, 3> list{"off", "exact", "on"};
};

/// What exists in a scene. Made by ModelBuilder, which checks it; never changed afterwards.
struct Model {
  std::vector<Body> bodies;
  std::vector<Cable> cables;
  std::vector<Contact> contacts;
  std::vector<Hanger> hangers;
  Vec2 gravity;  ///< acceleration of free fall, world [L/T^2]
  Sleep sleep{Sleep::off};
  UnitSystem units{si};  ///< a tag for labels; the solver does not use it
};

/// The body, cable, contact or hanger of that name, if there is one.
[[nodiscard]] std::optional<BodyId> find_body(const Model& model, std::string_view name);
[[nodiscard]] std::optional<CableId> find_cable(const Model& model, std::string_view name);
[[nodiscard]] std::optional<ContactId> find_contact(const Model& model, std::string_view name);
[[nodiscard]] std::optional<HangerId> find_hanger(const Model& model, std::string_view name);

/// Whether the cable's end is at the hanger's point.
[[nodiscard]] bool ends_at(const CableEnd& end, const Hanger& hanger);

/// Inertia of a pinned body about its pin: I + m |p_BPin|^2 [M L^2].
[[nodiscard]] double inertia_about_pin(const Body& body);

/// World position of a pinned body's pin [L].
[[nodiscard]] Vec2 pin(const Body& body);

/// World position of a cable's end in the reference positions of the bodies [L].
[[nodiscard]] Vec3 reference_point(const Model& model, const CableEnd& end);

}  // namespace talus
