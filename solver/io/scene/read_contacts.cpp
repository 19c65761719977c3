#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "solver/io/scene/read_friction.hpp"
#include "solver/io/scene/scene_parts.hpp"

namespace talus {
namespace {

/// Reads the restitution, which replaces the parameter of the law that sets it.
template <class L>
void read_restitution(SceneTable& table, L& law, SceneContact& read) {
  const std::string_view field = L::restitution_field.name;
  auto rule = RestitutionRule::effective_mass;
  if constexpr (HasEndRule<L>) rule = table.choice_or("restitution_rule", rule);
  const bool both = table.has("restitution") && table.has(field);
  const bool neither = !table.has("restitution") && !table.has(field);
  const bool misspelt = table.is_misspelt("restitution") || table.is_misspelt(field);
  if (both || (neither && L::restitution_field.is_required && !misspelt))
    table.report(field, "give either this or restitution, one of the two");
  if (!table.has("restitution")) {
    const std::string why = neither ? "it needs restitution"
                                    : fmt::format("the {} is given; leave this out or give restitution instead", field);
    for (const std::string_view key : {"restitution_rule", "restitution_speed"})
      table.refuse(key, why);
    return;
  }
  const double e = table.number("restitution", Range::positive_fraction);
  // A restitution that is the same at every speed may be given with one, too.
  double speed = 0.0;
  if (restitution_varies(law) || table.has("restitution_speed"))
    speed = table.quantity("restitution_speed", dimension::velocity, Range::positive);
  if (rule == RestitutionRule::eq_21) {
    read.restitution = e, read.restitution_speed = speed;
  } else {
    table.placed([&] { law.set_every_restitution(e, speed); });
  }
}

/// Whether the law's memory depends on the effective mass at which a contact begins.
bool starts_by_mass(const ContactLaw& law) {
  return std::visit(
      []<class L>(const L& of) {
        if constexpr (StartsByMass<L>) return memory_count(of) > 0;
        return false;
      },
      law);
}

template <class L>
void read_law(SceneTable& table, SceneContact& read) {
  L law;
  std::vector<std::string> keys = field_names<L>();
  keys.insert(keys.end(), {"between", "method", "nodes", "node_depth"});
  const std::vector<std::string> friction = friction_keys<FrictionLaws, L>(true);
  keys.insert(keys.end(), friction.begin(), friction.end());
  if constexpr (HasEndRule<L>) keys.push_back("end_rule");
  if constexpr (HasHertzDashpot<L>) keys.push_back("dashpot");
  if constexpr (SetsEveryRestitution<L>) keys.push_back("restitution");
  if constexpr (SetsEveryRestitution<L> && HasEndRule<L>) keys.push_back("restitution_rule");
  if constexpr (SetsEveryRestitution<L> && VariesRestitution<L>) keys.push_back("restitution_speed");
  table.allow(keys);
  table.read_fields(law);
  if constexpr (HasEndRule<L>) law.end_rule = table.choice_or("end_rule", law.end_rule);
  if constexpr (HasHertzDashpot<L>) law.dashpot = table.choice_or("dashpot", law.dashpot);
  if constexpr (SetsEveryRestitution<L>) read_restitution(table, law, read);
  read.contact.law = law;
}

/// Numbers of boundary nodes of the two bodies, from one number for both or one for each.
std::array<int, 2> read_nodes(SceneTable& table) {
  const std::vector<int> counts = table.wholes_or_one("nodes");
  if (counts.size() > 2) table.fail("nodes", fmt::format("found {} numbers; give one, or one per body", counts.size()));
  return {counts.front(), counts.back()};
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
    if (has_law && starts_by_mass(contact.law)) {
      table.report("restitution_rule", "contact by nodes has no single effective mass; it must be \"eq_21\"");
    }
  } else {
    for (const std::string_view key : {"nodes", "node_depth"})
      table.refuse(key, "contact by resultant has no nodes; leave it out");
  }
  contact.friction = std::visit(
      [&]<class L>(const L& law) {
        return read_friction<FrictionLaws, L>(table, law.tangent().stiffness,
                                              HasRetardationTime<L> && !table.has("shear_damping"), true);
      },
      contact.law);
  return read;
}

}  // namespace

std::vector<SceneContact> read_contacts(SceneTable& file, const BodyNames& bodies) {
  std::vector<SceneContact> contacts;
  for (SceneTable& table : file.tables("contact"))
    table.source().guard(table.line(), [&] { contacts.push_back(read_contact(std::move(table), bodies)); });
  return contacts;
}

}  // namespace talus
