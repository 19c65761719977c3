#include <fmt/format.h>

#include "solver/io/scene/scene_parts.hpp"

namespace talus {
namespace {

Shape read_shape(SceneTable table) {
  Shape shape;
  const std::string kind = table.choice("kind", shape_names());
  visit_named<Shape>(kind, [&](auto wanted) {
    std::vector<std::string> keys = field_names<decltype(wanted)>();
    if constexpr (requires { wanted.points; }) keys.emplace_back("points");
    table.allow(keys);
    table.read_fields(wanted);
    if constexpr (requires { wanted.points; }) {
      table.guard([&] {
        for (const auto& [x, y] : table.pairs("points", dimension::length, dimension::length))
          wanted.points.push_back({x, y});
      });
    }
    shape = wanted;
  });
  return shape;
}

/// Reason why a body of this mobility has no such quantity; empty if it has.
std::string_view refusal_reason(std::string_view key, Mobility mobility) {
  const bool fixed = mobility == Mobility::fixed;
  const bool turns = talus::turns(mobility);
  if (key == "mass" || key == "force") return fixed ? "a fixed body has none; leave it out" : "";
  if (key == "inertia" || key == "moment" || key == "spin") return turns ? "" : "this body cannot turn; leave it out";
  if (key == "pin") return has_pin(mobility) ? "" : "only a pinned or guided body has a pin; leave it out";
  if (key == "velocity" && mobility == Mobility::pinned) return "a pinned body only turns; give its spin instead";
  return key == "velocity" && fixed ? "a fixed body has none; leave it out" : "";
}

SceneBody read_body(SceneTable table) {
  std::vector<std::string> keys = field_names<Body>();
  keys.insert(keys.end(), {"mobility", "shape", "position", "pin", "velocity", "spin", "force"});
  table.allow(keys);
  SceneBody read{table, {}, {}, 0.0};
  Body& body = read.body;
  body.name = table.text("name");
  static_cast<void>(table.choice("mobility", names_of<Mobility>()));
  body.mobility = table.choice_or("mobility", Mobility::free);
  for (const std::string_view key : {"mass", "inertia", "moment", "pin", "velocity", "spin", "force"}) {
    if (const std::string_view why = refusal_reason(key, body.mobility); !why.empty()) table.refuse(key, why);
  }
  for (const auto& field : Body::fields()) {
    if (refusal_reason(field.name, body.mobility).empty()) table.read_field(body, field);
  }
  if (table.has("shape")) table.guard([&] { body.shape = read_shape(table.table("shape")); });
  body.p_WB = table.vector("position", dimension::length);
  if (has_pin(body.mobility)) body.p_BPin = table.vector("pin", dimension::length);
  body.force = table.vector_or("force", dimension::force, {});
  read.velocity = table.vector_or("velocity", dimension::velocity, {});
  read.spin = table.quantity_or("spin", dimension::angular_velocity, 0.0);
  return read;
}

}  // namespace

std::vector<SceneBody> read_bodies(SceneTable& file) {
  std::vector<SceneBody> bodies;
  for (const SceneTable& table : file.tables("body")) {
    // Contacts may refer to a body that cannot be read, so its name is kept.
    SceneBody body{table, {.name = table.written("name")}, {}, 0.0};
    table.source().guard(table.line(), [&] { body = read_body(table); });
    bodies.push_back(std::move(body));
  }
  return bodies;
}

BodyNames::BodyNames(const std::vector<SceneBody>& bodies) {
  for (const SceneBody& read : bodies) {
    const std::string& name = read.body.name;
    if (!ids_.emplace(name, static_cast<BodyId>(names_.size())).second && !name.empty()) {
      differ_ = false;
      read.table.source().guard(read.table.line(), [&] {
        read.table.placed([&] { throw InputError{fmt::format("body '{}' exists already; names must differ", name)}; });
      });
    }
    names_.push_back(name);
  }
}

BodyId BodyNames::find(const SceneTable& table, std::string_view key, const std::string& name) const {
  if (const auto found = ids_.find(name); found != ids_.end()) return found->second;
  const std::string message = unknown_name("body", name, names_).what();
  if (!differ_ || table.source().has_nameless("body")) throw SceneSource::Collected{message};
  table.fail(key, message);
}

}  // namespace talus
