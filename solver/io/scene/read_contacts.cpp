#include <fmt/format.h>

#include <algorithm>
#include <variant>

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
  if (both || (neither && L::restitution_field.is_required))
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

/// Names of the fields of a friction law that are not fields of the contact's law.
template <IsFrictionLaw F>
std::vector<std::string_view> friction_fields() {
  std::vector<std::string_view> names;
  for (const auto& field : F::fields())
    if (is_friction_field(field.name)) names.push_back(field.name);
  return names;
}

template <class L>
void read_law(SceneTable& table, SceneContact& read) {
  L law;
  std::vector<std::string> keys = field_names<L>();
  keys.insert(keys.end(), {"between", "method", "nodes", "node_depth"});
  for_each_friction_of<L>([&]<class F>(const F&) {
    for (const std::string_view field : friction_fields<F>())
      if (std::ranges::find(keys, field) == keys.end()) keys.emplace_back(field);
  });
  if (friction_names_of<L>().size() > 1) keys.emplace_back("shear_law");
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

/// Reports the fields of other friction laws that contacts of law L can have, with the field to give instead: one that
/// F requires, as far as `friction` has no value for it.
template <class L, IsFrictionLaw F>
void refuse_other_friction(SceneTable& table, const F& friction) {
  const std::vector<std::string_view> own = friction_fields<F>();
  for_each_friction_of<L>([&]<class Other>(const Other&) {
    const std::vector<std::string_view> others = friction_fields<Other>();
    std::string instead = "this law, or remove it";
    for (const auto& field : F::fields()) {
      const bool required = is_friction_field(field.name) && !contains(field.range, friction.*field.member);
      if (required && std::ranges::find(others, field.name) == others.end())
        instead = fmt::format("{} instead", field.name);
    }
    for (const std::string_view field : others) {
      if (std::ranges::find(own, field) == own.end())
        table.refuse(field, fmt::format("it belongs to shear_law = \"{}\"; give {}", Other::name, instead));
    }
  });
}

/// Reads the friction of a contact of law L. Without `shear_damping`, linear friction of a law with a retardation time
/// c/k has the same retardation time tangentially as along the normal, like a viscoelastic solid; other laws have no
/// tangential dashpot.
template <class L>
std::optional<FrictionLaw> read_friction_of(SceneTable& table, const L& law) {
  const std::vector<std::string> names = friction_names_of<L>();
  if (!table.has("friction")) {
    const auto refuse = [&](std::string_view key) {
      table.refuse(key, "it requires friction; give friction, or remove it");
    };
    if (names.size() > 1) refuse("shear_law");
    for_each_friction_of<L>([&]<class F>(const F&) {
      for (const std::string_view field : friction_fields<F>())
        refuse(field);
    });
    return {};
  }
  const std::string name = table.has("shear_law") && names.size() > 1 ? table.choice("shear_law", names) : names[0];
  std::optional<FrictionLaw> read;
  for_each_friction_of<L>([&]<class F>(F friction) {
    if (F::name != name) return;
    if constexpr (FollowsNormal<F>)
      friction.follow(law.tangent().stiffness, HasRetardationTime<L> && !table.has("shear_damping"));
    refuse_other_friction<L>(table, friction);
    table.read_fields(friction);
    read = friction;
  });
  return read;
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
  contact.friction = std::visit([&](const auto& law) { return read_friction_of(table, law); }, contact.law);
  return read;
}

}  // namespace

std::optional<CoulombFriction> read_friction(SceneTable& table, double normal_stiffness) {
  if (!table.has("friction")) {
    table.refuse("shear_stiffness", "it requires friction; give friction, or remove it");
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
