#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/scene/scene_table.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// The keys of a contact of law L that choose and describe its friction, by a law of the list. Contacts of discs have
/// no tangential dashpot.
template <class Frictions, class L>
std::vector<std::string> friction_keys(bool has_dashpot) {
  std::vector<std::string> keys;
  for_each_friction_of<Frictions, L>([&]<class F>(const F&) {
    for (const std::string_view field : friction_fields<F>())
      if (std::ranges::find(keys, field) == keys.end() && (has_dashpot || field != "shear_damping"))
        keys.emplace_back(field);
  });
  if (friction_names_of<Frictions, L>().size() > 1) keys.emplace_back("shear_law");
  return keys;
}

/// Reports the fields of other friction laws that contacts of law L can have, with the field to give instead: one that
/// F requires, as far as `friction` has no value for it.
template <class Frictions, class L, IsFrictionLaw F>
void refuse_other_friction(SceneTable& table, const F& friction) {
  const std::vector<std::string_view> own = friction_fields<F>();
  for_each_friction_of<Frictions, L>([&]<class Other>(const Other&) {
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

/// Reads the friction of a contact of law L, if it is given, by a law of the list. `normal_stiffness` [F/L] and
/// `normal_damping` are those of FollowsNormal, `has_dashpot` that of friction_keys().
template <class Frictions, class L>
std::optional<typename Frictions::Variant> read_friction(SceneTable& table, double normal_stiffness,
                                                         bool normal_damping, bool has_dashpot) {
  const std::vector<std::string> names = friction_names_of<Frictions, L>();
  if (!table.has("friction")) {
    for (const std::string& key : friction_keys<Frictions, L>(has_dashpot))
      if (key != "friction") table.refuse(key, "it requires friction; give friction, or remove it");
    return {};
  }
  const std::string name = table.has("shear_law") && names.size() > 1 ? table.choice("shear_law", names) : names[0];
  std::optional<typename Frictions::Variant> read;
  for_each_friction_of<Frictions, L>([&]<class F>(F friction) {
    if (F::name != name) return;
    if constexpr (FollowsNormal<F>) friction.follow(normal_stiffness, normal_damping);
    refuse_other_friction<Frictions, L>(table, friction);
    table.read_fields(friction);
    read = friction;
  });
  return read;
}

}  // namespace talus
