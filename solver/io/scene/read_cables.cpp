#include <fmt/format.h>

#include "solver/io/scene/scene_parts.hpp"

namespace talus {
namespace {

CableEnd read_end(SceneTable table, const BodyNames& bodies) {
  table.allow({"body", "point"});
  CableEnd end;
  if (table.has("body")) table.guard([&] { end.body = bodies.find(table, "body", table.text("body")); });
  const std::vector<double> p = table.quantities("point", dimension::length, 2, 3);
  end.p = {p[0], p[1], p.size() == 3 ? p[2] : 0.0};
  return end;
}

SceneCable read_cable(SceneTable table, const BodyNames& bodies) {
  SceneCable read{table, {}, {}, 0.0};
  Cable& cable = read.cable;
  cable.name = table.text("name");
  table.guard([&] {
    const std::string law = table.choice("law", CableLaws::names());
    visit_named<CableLaw>(law, [&](auto wanted) {
      std::vector<std::string> keys = field_names<decltype(wanted)>();
      keys.insert(keys.end(), {"from", "to", "rest_length", "slack"});
      if constexpr (HasYieldTable<decltype(wanted)>) keys.emplace_back("table");
      table.allow(keys);
      table.read_fields(wanted);
      if constexpr (HasYieldTable<decltype(wanted)>) {
        if (table.has("table")) {
          for (const auto& [stretch, force] : table.pairs("table", dimension::length, dimension::force))
            wanted.table.push_back({stretch, force});
        }
      }
      cable.law = wanted;
    });
  });
  table.guard([&] { cable.a = read_end(table.table("from"), bodies); });
  table.guard([&] { cable.b = read_end(table.table("to"), bodies); });
  if (table.has("rest_length"))
    read.rest_length = table.quantity("rest_length", dimension::length, Range::non_negative);
  read.slack = table.quantity_or("slack", dimension::length, 0.0);
  return read;
}

SceneHanger read_hanger(SceneTable table, const BodyNames& bodies) {
  SceneHanger read{table, {}};
  read.hanger.name = table.text("name");
  table.allow({"body", "point", "strength"});
  table.guard([&] { read.hanger.body = bodies.find(table, "body", table.text("body")); });
  const std::vector<double> p = table.quantities("point", dimension::length, 2, 3);
  read.hanger.p = {p[0], p[1], p.size() == 3 ? p[2] : 0.0};
  read.hanger.strength = table.quantity("strength", dimension::force, Range::positive);
  return read;
}

}  // namespace

std::vector<SceneHanger> read_hangers(SceneTable& file, const BodyNames& bodies) {
  std::vector<SceneHanger> hangers;
  for (SceneTable& table : file.tables("hanger"))
    table.source().guard(table.line(), [&] { hangers.push_back(read_hanger(std::move(table), bodies)); });
  return hangers;
}

std::vector<SceneCable> read_cables(SceneTable& file, const BodyNames& bodies) {
  std::vector<SceneCable> cables;
  for (SceneTable& table : file.tables("cable"))
    table.source().guard(table.line(), [&] { cables.push_back(read_cable(std::move(table), bodies)); });
  return cables;
}

}  // namespace talus
