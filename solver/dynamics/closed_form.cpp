#include "solver/dynamics/closed_form.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <variant>

#include "solver/dynamics/dynamics.hpp"
#include "solver/integrate/linear_segment.hpp"

namespace talus {
namespace {

bool has_linear_parts(const ContactLaw& law) {
  return std::visit([]<class L>(const L&) { return HasLinearPart<L>; }, law);
}

std::string_view name(const ContactLaw& law) {
  return std::visit([]<class L>(const L&) { return L::name; }, law);
}

/// True if two bodies can only move along the same line.
bool share_a_line(const Body& a, const Body& b) {
  const auto moves_only = [](const Body& body, Mobility along) {
    return body.mobility == along || body.mobility == Mobility::fixed;
  };
  if (moves_only(a, Mobility::sliding_x) && moves_only(b, Mobility::sliding_x)) return a.p_WB.y == b.p_WB.y;
  if (moves_only(a, Mobility::sliding_y) && moves_only(b, Mobility::sliding_y)) return a.p_WB.x == b.p_WB.x;
  return false;
}

bool normal_turns(const Body& a, const Body& b) {
  if (std::holds_alternative<HalfPlane>(a.shape)) return normal_turns(b, a);
  const bool round = std::holds_alternative<Circle>(a.shape);
  if (std::holds_alternative<HalfPlane>(b.shape)) return turns(b.mobility) || (turns(a.mobility) && !round);
  return !(round && std::holds_alternative<Circle>(b.shape) && share_a_line(a, b));
}

}  // namespace

std::optional<std::string> obstacle_to_closed_form(const Model& model) {
  for (const Body& body : model.bodies) {
    if (has_pin(body.mobility)) return fmt::format("body '{}' turns about a pin", body.name);
  }
  if (!model.cables.empty()) return fmt::format("cable '{}' may turn", model.cables.front().name);
  for (const Contact& contact : model.contacts) {
    if (!has_linear_parts(contact.law))
      return fmt::format("contact '{}': the law {} is not linear", contact.name, name(contact.law));
    if (contact.friction) return fmt::format("contact '{}' has friction", contact.name);
    if (contact.method == ContactMethod::nodes) return fmt::format("contact '{}' acts at nodes", contact.name);
    if (normal_turns(model.bodies[index(contact.a)], model.bodies[index(contact.b)]))
      return fmt::format("contact '{}': its normal turns with the motion", contact.name);
  }
  return std::nullopt;
}

void Dynamics::linear_segment(const State& state, const Workspace& work, LinearSegment& out) const {
  out.terms.clear();
  for (const ContactForces::LinearContact& contact : contacts_.linear_contacts(state, work)) {
    // F = k n.(d_A - d_B) + c n.(v_A - v_B) pushes B along n and A against it.
    struct Side {
      BodyId body;
      double sign;
      double weight;
    };
    const Side sides[] = {{contact.a, 1.0, contact.symmetry_weight_a}, {contact.b, -1.0, contact.symmetry_weight_b}};
    const auto along = [&](std::size_t i) {
      const Axis axis = layout_.coordinates[i].axis;
      return axis == Axis::x ? contact.n_AB.x : axis == Axis::y ? contact.n_AB.y : 0.0;
    };
    for (const Side& pushed : sides) {
      for (const Side& moved : sides) {
        for (std::size_t i = layout_.first[index(pushed.body)]; i < layout_.first[index(pushed.body) + 1]; ++i) {
          for (std::size_t j = layout_.first[index(moved.body)]; j < layout_.first[index(moved.body) + 1]; ++j) {
            const double each = pushed.sign * moved.sign * pushed.weight * along(i) * along(j) / inertias_[i];
            if (each != 0.0)
              out.terms.push_back({i, j, each * contact.slopes.stiffness, each * contact.slopes.damping});
          }
        }
      }
    }
  }
}

}  // namespace talus
