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
    table.allow(keys);
    table.read_fields(wanted);
    cable.law = wanted;
  });
  cable.a = read_end(table.table("from"), bodies);
  cable.b = read_end(table.table("to"), bodies);
  const double distance = norm(reference_point(bodies, cable.b) - reference_point(bodies, cable.a));
  cable.rest_length = table.quantity_or("rest_length", dimension::length, distance, Range::non_negative) +
                      table.quantity_or("slack", dimension::length, 0.0);
  return read;
}

}  // namespace

std::vector<SceneCable> read_cables(SceneTable& file, const Model& bodies) {
  std::vector<SceneCable> cables;
  for (const SceneTable& table : file.tables("cable"))
    cables.push_back(read_cable(table, bodies));
  return cables;
}

}  // namespace talus
