#include "solver/io/json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/io/json_number.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

Json vector(Vec2 value) { return Json::array({json_number(value.x), json_number(value.y)}); }

Json outcome(const Outcome& outcome) {
  constexpr std::array kinds{"finished", "stopped", "diverged"};
  Json json{{"kind", kinds.at(static_cast<std::size_t>(outcome.kind))}, {"time", json_number(outcome.time)}};
  if (!outcome) json["words"] = outcome.words;
  return json;
}

Json units(const UnitSystem& system) {
  Json json{{"system", system.name}};
  for (const auto& [name, dimension] :
       {std::pair{"length", dimension::length}, std::pair{"time", dimension::time}, std::pair{"mass", dimension::mass},
        std::pair{"force", dimension::force}, std::pair{"energy", dimension::energy},
        std::pair{"momentum", dimension::momentum}, std::pair{"angular_momentum", dimension::angular_momentum}}) {
    json[name] = symbol(system, dimension);
  }
  return json;
}

Json ledger(const RunRecord& record) {
  if (!record.plan.ledger) return "off";
  const Accounts& accounts = record.accounts;
  const Energies& e = accounts.energies;
  Json lost = Json::object();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    lost[std::string{mechanism_names[i]}] = json_number(accounts.lost[i]);
  return {{"energy",
           {{"kinetic", json_number(e.kinetic)},
            {"gravity", json_number(e.gravity)},
            {"applied", json_number(e.applied)},
            {"contacts", json_number(e.contacts)},
            {"cables", json_number(e.cables)},
            {"total", json_number(e.total())}}},
          {"lost", lost},
          {"energy_closure", json_number(accounts.energy_closure)},
          {"largest_energy_closure", json_number(record.largest_energy_closure)},
          {"energy_scale", json_number(record.energy_scale)},
          {"momentum", vector(accounts.momenta.linear)},
          {"momentum_closure", vector(accounts.momentum_closure)},
          {"angular_momentum", json_number(accounts.momenta.angular)},
          {"angular_momentum_closure", json_number(accounts.angular_momentum_closure)}};
}

Json extremes(const RunRecord& record) {
  Json json = Json::array();
  for (const ExtremeRecord& item : record.extremes) {
    json.push_back({{"name", item.column.name},
                    {"unit", symbol(record.units, item.column.dimension)},
                    {"least", json_number(item.extreme.least)},
                    {"least_time", json_number(item.extreme.least_time)},
                    {"largest", json_number(item.extreme.largest)},
                    {"largest_time", json_number(item.extreme.largest_time)}});
  }
  return json;
}

Json failures(const RunRecord& record) {
  Json json = Json::array();
  for (const Failure& failure : record.failures)
    json.push_back({{"time", json_number(failure.time)}, {"part", failure.part}, {"what", failure.what}});
  return json;
}

Json parts(const std::vector<PartState>& states) {
  Json json = Json::array();
  for (const PartState& state : states)
    json.push_back({{"name", state.name}, {"mode", state.mode}, {"plastic_stretch", json_number(state.stretch)}});
  return json;
}

Json bodies(const RunRecord& record) {
  Json json = Json::array();
  for (const BodyState& body : record.bodies) {
    json.push_back({{"name", body.name},
                    {"position", vector(body.p)},
                    {"angle", json_number(body.angle)},
                    {"velocity", vector(body.v)},
                    {"spin", json_number(body.spin)}});
  }
  return json;
}

}  // namespace

std::string summary_json(const RunRecord& record, const std::string& resume) {
  Json json{{"schema", 1},
            {"title", record.title},
            {"units", units(record.units)},
            {"outcome", outcome(record.outcome)},
            {"integrator", record.integrator},
            {"step", json_number(record.plan.step)},
            {"end", json_number(record.plan.end)},
            {"steps", record.steps},
            {"evaluations", record.evaluations},
            {"carried",
             {{"bodies", record.bodies.size()},
              {"degrees_of_freedom", record.coordinates},
              {"contacts", record.contacts},
              {"cables", record.cables},
              {"law_instances", record.laws}}},
            {"history_rows", record.history.rows.size()},
            {"history_rows_cut", record.rows_cut},
            {"ledger", ledger(record)},
            {"extremes", extremes(record)},
            {"failures", failures(record)},
            {"bodies", bodies(record)},
            {"watched", record.watched},
            {"warnings", record.warnings},
            {"notes", record.notes}};
  if (!record.integrator_why.empty()) json["integrator_why"] = record.integrator_why;
  if (record.events) json["events"] = *record.events;
  if (!resume.empty()) json["resume"] = resume;
  return json.dump(2) + "\n";
}

std::string final_state_json(const RunRecord& record) {
  const Json json{{"schema", 1},
                  {"title", record.title},
                  {"units", units(record.units)},
                  {"outcome", outcome(record.outcome)},
                  {"time", json_number(record.outcome.time)},
                  {"bodies", bodies(record)},
                  {"cables", parts(record.cables_left)},
                  {"hangers", parts(record.hangers_left)}};
  return json.dump(2) + "\n";
}

}  // namespace talus
