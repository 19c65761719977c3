#include <fmt/format.h>

#include <type_traits>

#include "solver/io/scene/scene_parts.hpp"
#include "solver/laws/restitution.hpp"

namespace talus {
namespace {

template <class L>
concept HasEndRule = requires(L law) {
  law.end_rule;
};

/// Whether a law's damping can be found from a wanted restitution.
template <class L>
concept Restituting = std::is_same_v<L, LinearSpringDashpot>;

template <class L>
void read_law(SceneTable& table, SceneContact& read) {
  L law;
  std::vector<std::string> keys = field_names<L>();
  keys.insert(keys.end(), {"between", "method", "nodes", "node_depth", "friction", "shear_stiffness", "shear_damping"});
  if constexpr (HasEndRule<L>) keys.push_back("end_rule");
  if constexpr (Restituting<L>) keys.insert(keys.end(), {"restitution", "restitution_rule"});
  table.allow(keys);
  table.read_fields(law);
  if constexpr (HasEndRule<L>) law.end_rule = table.choice_or("end_rule", law.end_rule);
  if constexpr (Restituting<L>) {
    const auto rule = table.choice_or("restitution_rule", RestitutionRule::effective_mass);
    if (table.has("restitution") == table.has("damping")) {
      table.complain("damping", "give either this or restitution, one of the two");
    }
    if (table.has("restitution")) {
      const double e = table.number("restitution", Range::positive_fraction);
      if (rule == RestitutionRule::eq_21) {
        read.restitution = e;
      } else {
        law.damping_ratio = damping_ratio(e, law.end_rule);
      }
    } else {
      table.refuse("restitution_rule", "the damping is given; leave this out or give restitution instead");
    }
  }
  read.contact.law = law;
}

/// Boundary nodes of both bodies: one number, or one for each.
std::array<int, 2> read_nodes(SceneTable& table) {
  const std::vector<int> counts = table.wholes_or_one("nodes");
  if (counts.size() > 2) table.fail("nodes", fmt::format("found {} numbers; give one, or one a body", counts.size()));
  return {counts.front(), counts.back()};
}

/// The dashpot of friction that sticks. Without `shear_damping` a linear spring and dashpot has the same retardation
/// time c/k along the surfaces as along the normal, as a viscoelastic solid has; other laws have none.
void read_shear_damping(SceneTable& table, Contact& contact) {
  if (!contact.friction) return table.refuse("shear_damping", "without friction it has no use; leave it out");
  contact.friction->follows_normal =
      !table.has("shear_damping") && std::holds_alternative<LinearSpringDashpot>(contact.law);
  contact.friction->damping = table.quantity_or("shear_damping", dimension::damping, 0.0, Range::non_negative);
}

SceneContact read_contact(SceneTable table, const BodyNames& bodies) {
  SceneContact read{table, {}, {}};
  Contact& contact = read.contact;
  contact.name = table.text("name");
  bool has_law = false;
  table.guard([&] {
    const std::string law = table.choice("law", ContactLaws::names());
    has_law = visit_named<ContactLaw>(law, [&](auto wanted) { read_law<decltype(wanted)>(table, read); });
  });
  table.guard([&] {
    const std::vector<std::string> between = table.texts("between", 2);
    table.guard([&] { contact.a = bodies.find(table, "between", between[0]); });
    table.guard([&] { contact.b = bodies.find(table, "between", between[1]); });
  });
  contact.method = table.choice_or("method", contact.method);
  if (contact.method == ContactMethod::nodes) {
    if (table.has("nodes")) table.guard([&] { contact.nodes = read_nodes(table); });
    contact.node_depth = table.choice_or("node_depth", contact.node_depth);
    if (has_law && table.has("restitution") && !read.restitution) {
      table.complain("restitution_rule", "contact by nodes has no single effective mass; it must be \"eq_21\"");
    }
  } else {
    for (const std::string_view key : {"nodes", "node_depth"})
      table.refuse(key, "contact by resultant has no nodes; leave it out");
  }
  contact.friction = read_friction(table, std::visit([](const auto& l) { return l.tangent().stiffness; }, contact.law));
  read_shear_damping(table, contact);
  return read;
}

}  // namespace

std::optional<CoulombFriction> read_friction(SceneTable& table, double normal_stiffness) {
  if (!table.has("friction")) {
    table.refuse("shear_stiffness", "without friction it has no use; leave it out or give friction");
    return {};
  }
  return CoulombFriction{table.number("friction", Range::non_negative),
                         table.quantity_or("shear_stiffness", dimension::stiffness, normal_stiffness, Range::positive)};
}

std::vector<SceneContact> read_contacts(SceneTable& file, const BodyNames& bodies) {
  std::vector<SceneContact> contacts;
  for (SceneTable& table : file.tables("contact"))
    table.source().guard(table.line(), [&] { contacts.push_back(read_contact(std::move(table), bodies)); });
  return contacts;
}

}  // namespace talus
