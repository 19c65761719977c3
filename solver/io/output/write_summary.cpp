#include "solver/io/output/write_summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include "verification/record/json_number.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;
using records::json_number;

Json components(Vec2 value) { return Json::array({json_number(value.x), json_number(value.y)}); }

Json outcome(const Outcome& outcome) {
  Json json{{"kind", name_of(outcome.kind)}, {"time", json_number(outcome.time)}};
  if (!outcome) json["message"] = outcome.message;
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
  Json dissipated = Json::object();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    dissipated[std::string{name_of(static_cast<Mechanism>(i))}] = json_number(accounts.dissipated[i]);
  return {{"energy",
           {{"kinetic", json_number(e.kinetic)},
            {"gravity", json_number(e.gravity)},
            {"applied", json_number(e.applied)},
            {"contacts", json_number(e.contacts)},
            {"cables", json_number(e.cables)},
            {"total", json_number(e.total())}}},
          {"dissipated", dissipated},
          {"energy_balance_error", json_number(accounts.energy_balance_error)},
          {"largest_energy_balance_error", json_number(record.largest_energy_balance_error)},
          {"energy_scale", json_number(record.energy_scale)},
          {"momentum", components(accounts.momenta.linear)},
          {"momentum_balance_error", components(accounts.momentum_balance_error)},
          {"angular_momentum", json_number(accounts.momenta.angular)},
          {"angular_momentum_balance_error", json_number(accounts.angular_momentum_balance_error)}};
}

Json extremes(const RunRecord& record) {
  Json json = Json::array();
  for (const ExtremeRecord& item : record.extremes) {
    json.push_back({{"name", item.column.name},
                    {"unit", symbol(record.units, item.column.dimension)},
                    {"minimum", json_number(item.extreme.minimum)},
                    {"minimum_time", json_number(item.extreme.minimum_time)},
                    {"maximum", json_number(item.extreme.maximum)},
                    {"maximum_time", json_number(item.extreme.maximum_time)}});
  }
  return json;
}

Json failures(const RunRecord& record) {
  Json json = Json::array();
  for (const Failure& failure : record.failures)
    json.push_back({{"time", json_number(failure.time)}, {"part", failure.part}, {"event", failure.what}});
  return json;
}

Json parts(const std::vector<PartState>& states) {
  Json json = Json::array();
  for (const PartState& state : states)
    json.push_back({{"name", state.name}, {"mode", state.mode}, {"plastic_stretch", json_number(state.stretch)}});
  return json;
}

/// The number of impacts, and the largest ones.
Json impacts(const std::vector<ImpactRecord>& all) {
  Json largest = Json::array();
  for (const std::size_t i : largest_impacts(all, impacts_of_summary)) {
    const RecordedImpact& impact = all[i].impact;
    const auto restitution = impact.restitution();
    largest.push_back({{"number", i + 1},
                       {"contact", all[i].contact},
                       {"touch_time", json_number(impact.touch_time)},
                       {"approach_speed", json_number(impact.approach_speed)},
                       {"restitution", restitution ? Json(json_number(*restitution)) : Json(nullptr)},
                       {"peak_force", json_number(impact.peak_force)},
                       {"largest_overlap", json_number(impact.largest_overlap)},
                       {"normal_impulse", json_number(impact.normal_impulse)}});
  }
  return {{"count", all.size()}, {"largest", std::move(largest)}};
}

Json bodies(const RunRecord& record) {
  Json json = Json::array();
  for (const BodyState& body : record.bodies) {
    json.push_back({{"name", body.name},
                    {"position", components(body.p)},
                    {"angle", json_number(body.angle)},
                    {"velocity", components(body.v)},
                    {"spin", json_number(body.spin)}});
  }
  return json;
}

/// A largest force; `margin` is its ratio to the limit, null if there is none.
Json force(const std::string& name, double peak, double time, double margin) {
  Json json{{"name", name}, {"peak", json_number(peak)}, {"time", json_number(time)}, {"margin", nullptr}};
  if (margin > 0.0) json["margin"] = json_number(margin);
  return json;
}

/// The verdict on the fence and its rocks, and the largest forces on its parts.
Json verdict(const RunRecord& record) {
  const scenes::FenceSummary& fence = *record.fence;
  Json rocks = Json::array();
  for (const scenes::RockPassage& rock : fence.rocks) {
    rocks.push_back({{"name", rock.name},
                     {"verdict", name_of(rock.verdict)},
                     {"passed_time", json_number(rock.passed_time)},
                     {"touched", rock.touched},
                     {"last_contact_time", rock.touched ? Json(json_number(rock.exit_time)) : Json(nullptr)},
                     {"still_touching", rock.touched && !rock.left},
                     {"approach_energy", json_number(rock.approach_energy)},
                     {"velocity_after", rock.left ? components(rock.exit_velocity) : Json(nullptr)},
                     {"energy_after", rock.left ? Json(json_number(rock.exit_energy)) : Json(nullptr)},
                     {"velocity_at_end", components(rock.end_velocity)},
                     {"energy_at_end", json_number(rock.end_energy)}});
  }
  Json json{{"fence", name_of(fence.verdict())}, {"rocks", std::move(rocks)}};
  const auto cable = [&record](const scenes::SegmentRecord& segment) {
    return force(record.cables_left[index(segment.cable)].name, segment.peak, segment.peak_time, segment.margin());
  };
  const auto hanger = [&record](const scenes::ColumnRecord& column) {
    return force(record.bodies[index(column.body)].name, column.hanger.peak, column.hanger.peak_time, column.margin());
  };
  if (const auto* anchor = fence.largest_anchor())
    json["largest_anchor_force"] = force("anchor", anchor->force.peak, anchor->force.peak_time, 0.0);
  if (const auto* found = fence.largest_segment()) json["largest_cable_force"] = cable(*found);
  if (const auto* found = fence.closest_segment(); found && found->margin() > 0.0)
    json["cable_closest_to_limit"] = cable(*found);
  if (const auto* found = fence.largest_hanger()) json["largest_hanger_force"] = hanger(*found);
  if (const auto* found = fence.closest_hanger(); found && found->margin() > 0.0)
    json["hanger_closest_to_limit"] = hanger(*found);
  return json;
}

}  // namespace

nlohmann::ordered_json quality_json(const RunQuality& quality, double time_size) {
  Json json{
      {"usable", quality.flaw.empty()}, {"flaw", quality.flaw}, {"enforced", quality.enforced}, {"step", quality.step}};
  json["energy_balance"] = quality.balance ? Json(json_number(*quality.balance)) : Json("off");
  if (quality.contact_steps) json["steps_in_shortest_contact"] = json_number(*quality.contact_steps);
  if (const auto& last = quality.last_contact) {
    json["last_contact"] = {
        {"name", last->name}, {"time", json_number(last->time * time_size)}, {"touching", last->touching}};
  }
  for (const auto& [a, b] : quality.undeclared_overlaps)
    json["undeclared_overlaps"].push_back({a, b});
  if (const auto& repeat = quality.repeat) {
    json["repeat"] = {{"change_of_speed", repeat->change},
                      {"failure", repeat->failure},
                      {"verdict", name_of(repeat->verdict)},
                      {"change_of_largest_cable_force", json_number(repeat->cable_change)}};
  }
  if (const auto& repair = quality.repair) {
    json["repair"] = {{"option", repair->option}, {"flaw", repair->flaw}, {"verdict", name_of(repair->verdict)}};
    json["repair"]["energy_balance"] = repair->balance ? Json(json_number(*repair->balance)) : Json("off");
  }
  return json;
}

std::string summary_json(const RunRecord& record, const std::string& resume) {
  Json json{{"schema", 2},
            {"title", record.title},
            {"units", units(record.units)},
            {"outcome", outcome(record.outcome)},
            {"quality", quality_json(record.quality)},
            {"integrator", record.integrator},
            {"step", json_number(record.plan.step)},
            {"end", json_number(record.plan.end)},
            {"steps", record.steps},
            {"evaluations", record.evaluations},
            {"model",
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
            {"monitor", record.watched},
            {"warnings", record.warnings},
            {"notes", record.notes}};
  if (record.fence) json["verdict"] = verdict(record);
  if (record.impacts) json["impacts"] = impacts(*record.impacts);
  if (!record.integrator_reason.empty()) json["integrator_reason"] = record.integrator_reason;
  if (record.events) json["events"] = *record.events;
  if (!resume.empty()) json["resume"] = resume;
  return json.dump(2) + "\n";
}

std::string final_state_json(const RunRecord& record) {
  const Json json{{"schema", 2},
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
