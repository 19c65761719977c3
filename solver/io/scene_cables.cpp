#include <fmt/format.h>

#include "solver/io/scene_parts.hpp"

namespace talus {
namespace {

CableEnd read_end(SceneTable table, const Model& bodies) {
  table.allow({"body", "point"});
  CableEnd end;
  if (table.has("body")) end.body = body_named(table, "body", bodies, table.text("body"));
  const std::vector<double> p = table.quantities("point", dimension::length, 2, 3);
  end.p = {p[0], p[1], p.size() == 3 ? p[2] : 0.0};
  return end;
}

SceneCable read_cable(SceneTable table, const Model& bodies) {
  SceneCable read{table, {}};
  Cable& cable = read.cable;
  cable.name = table.text("name");
  const std::string law = table.choice("law", CableLaws::names());
  visit_named<CableLaw>(law, [&](auto wanted) {
    std::vector<std::string> keys = field_names<decltype(wanted)>();
    keys.insert(keys.end(), {"from", "to", "rest_length", "slack"});
    if constexpr (requires { wanted.table; }) keys.emplace_back("table");
    table.allow(keys);
    table.read_fields(wanted);
    if constexpr (requires { wanted.table; }) {
      if (table.has("table")) {
        for (const auto& [stretch, force] : table.pairs("table", dimension::length, dimension::force))
          wanted.table.push_back({stretch, force});
      }
    }
    cable.law = wanted;
  });
  cable.a = read_end(table.table("from"), bodies);
  cable.b = read_end(table.table("to"), bodies);
  const double distance = norm(reference_point(bodies, cable.b) - reference_point(bodies, cable.a));
  cable.rest_length = table.quantity_or("rest_length", dimension::length, distance, Range::non_negative) +
                      table.quantity_or("slack", dimension::length, 0.0);
  return read;
}

SceneHanger read_hanger(SceneTable table, const Model& bodies) {
  SceneHanger read{table, {}};
  read.hanger.name = table.text("name");
  table.allow({"body", "point", "strength"});
  read.hanger.body = body_named(table, "body", bodies, table.text("body"));
  const std::vector<double> p = table.quantities("point", dimension::length, 2, 3);
  read.hanger.p = {p[0], p[1], p.size() == 3 ? p[2] : 0.0};
  read.hanger.strength = table.quantity("strength", dimension::force, Range::positive);
  return read;
}

}  // namespace

std::vector<SceneHanger> read_hangers(SceneTable& file, const Model& bodies) {
  std::vector<SceneHanger> hangers;
  for (const SceneTable& table : file.tables("hanger"))
    hangers.push_back(read_hanger(table, bodies));
  return hangers;
}

std::vector<SceneCable> read_cables(SceneTable& file, const Model& bodies) {
  std::vector<SceneCable> cables;
  for (const SceneTable& table : file.tables("cable"))
    cables.push_back(read_cable(table, bodies));
  return cables;
}

}  // namespace talus
