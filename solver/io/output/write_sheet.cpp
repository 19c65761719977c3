#include "solver/io/output/write_sheet.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/io/output/write_summary.hpp"
#include "solver/model/outline.hpp"
#include "verification/record/json_number.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;
using scenes::FenceSummary;
using scenes::ForceRecord;

/// Writes the sheet of one run; converts all quantities to SI.
class Sheet {
 public:
  Sheet(const RunRecord& record, const FenceInput& input, const Dynamics& dynamics, const scenes::FenceMonitor& watch,
        const State& end)
      : record_{record}, input_{input}, dynamics_{dynamics}, watch_{watch}, summary_{watch.summary()}, end_{end} {}

  Json json() const {
    return {{"schema", 3},
            {"title", record_.title},
            {"units", "SI"},
            {"verdict", name_of(summary_.verdict())},
            {"quality", quality_json(record_.quality, si_size(record_.units, dimension::time))},
            {"run", run()},
            {"fence", fence()},
            {"rocks", rocks()},
            {"layers", layers()},
            {"columns", columns()},
            {"segments", segments()},
            {"anchors", anchors()},
            {"events", events()},
            {"energy", energy()},
            {"drawing", drawing()},
            {"history", history()}};
  }

 private:
  Json in_si(double value, Dimension dimension) const {
    return records::json_number(value * si_size(record_.units, dimension));
  }
  Json length(double value) const { return in_si(value, dimension::length); }
  Json time(double value) const { return in_si(value, dimension::time); }
  Json position(Vec2 p) const { return Json::array({length(p.x), length(p.y)}); }
  Json position(Vec2 p, double z) const { return Json::array({length(p.x), length(p.y), length(z)}); }
  Json vector(Vec3 v, Dimension d) const { return Json::array({in_si(v.x, d), in_si(v.y, d), in_si(v.z, d)}); }
  const Cable& cable(CableId id) const { return dynamics_.model().cables[index(id)]; }

  Json force(const ForceRecord& record) const {
    return {{"peak", in_si(record.peak, dimension::force)},
            {"peak_time", time(record.peak_time)},
            {"at_peak", vector(record.at_peak, dimension::force)},
            {"impulse", vector(record.impulse, dimension::momentum)}};
  }

  Json run() const {
    return {{"outcome", name_of(record_.outcome.kind)},
            {"time", time(record_.outcome.time)},
            {"integrator", record_.integrator},
            {"step", time(record_.plan.step)},
            {"steps", record_.steps}};
  }

  Json fence() const {
    const scenes::Fence& fence = input_.fence;
    return {{"layers", fence.layers},
            {"columns", fence.columns},
            {"half_model", fence.options.symmetry == scenes::FenceSymmetry::half},
            {"span", length(fence.span)},
            {"sag", length(fence.sag)},
            {"spacing", length(fence.spacing)},
            {"bottom_cable", fence.connections == 2},
            {"scene_units", record_.units.name},
            {"travel", length(summary_.travel)},
            {"travel_time", time(summary_.at_travel.t)}};
  }

  Json rocks() const;
  Json layers() const;
  Json columns() const;
  Json segments() const;
  Json anchors() const;
  Json events() const;
  Json energy() const;
  Json drawing() const;
  Json drawn(const char* name, const State& state) const;
  Json history() const;

  const RunRecord& record_;
  const FenceInput& input_;
  const Dynamics& dynamics_;
  const scenes::FenceMonitor& watch_;
  const FenceSummary& summary_;
  const State& end_;
};

Json Sheet::rocks() const {
  Json list = Json::array();
  const auto velocity = [&](Vec2 v) {
    return Json::array({in_si(v.x, dimension::velocity), in_si(v.y, dimension::velocity)});
  };
  for (const scenes::RockPassage& rock : summary_.rocks) {
    Json json{{"name", rock.name},
              {"mass", in_si(rock.mass, dimension::mass)},
              {"approach_velocity", velocity(rock.approach_velocity)},
              {"approach_spin", rock.approach_spin},
              {"approach_energy", in_si(rock.approach_energy, dimension::energy)},
              {"touched", rock.touched},
              {"verdict", name_of(rock.verdict)},
              {"passed_time", time(rock.passed_time)},
              {"end_velocity", velocity(rock.end_velocity)},
              {"end_energy", in_si(rock.end_energy, dimension::energy)}};
    if (rock.touched) {
      json.update({{"touch_time", time(rock.touch_time)},
                   {"separated", rock.left},
                   {"exit_time", time(rock.exit_time)},
                   {"exit_velocity", velocity(rock.exit_velocity)},
                   {"exit_spin", rock.exit_spin},
                   {"exit_energy", in_si(rock.exit_energy, dimension::energy)},
                   {"energy_loss_fraction", records::json_number(rock.energy_loss_fraction())},
                   {"turned", rock.turned},
                   {"braking_time", time(rock.braking_time)},
                   {"travel", length(rock.travel)}});
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json Sheet::layers() const {
  Json list = Json::array();
  const auto height = [&](const scenes::LayerRecord::Height& h) {
    return Json{{"start", length(h.start)},
                {"extreme", length(h.extreme)},
                {"extreme_time", time(h.extreme_time)},
                {"end", length(h.end)}};
  };
  for (const scenes::LayerRecord& layer : summary_.layers)
    list.push_back({{"top", height(layer.top)}, {"bottom", height(layer.bottom)}});
  return list;
}

Json Sheet::columns() const {
  Json list = Json::array();
  for (const scenes::ColumnRecord& column : summary_.columns) {
    const std::vector<Joint>& joints = dynamics_.cables().joints();
    const auto joint =
        std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.on_body && j.body == column.body; });
    list.push_back({{"name", dynamics_.model().bodies[index(column.body)].name},
                    {"layer", column.layer},
                    {"along", length(joint->along)},
                    {"travel", length(column.travel)},
                    {"travel_time", time(column.travel_time)},
                    {"limit", in_si(column.limit, dimension::force)},
                    {"margin", column.margin()},
                    {"hanger", force(column.hanger)}});
  }
  return list;
}

Json Sheet::segments() const {
  Json list = Json::array();
  for (const scenes::SegmentRecord& segment : summary_.segments) {
    list.push_back({{"name", cable(segment.cable).name},
                    {"layer", segment.layer},
                    {"cable", segment.top ? "top" : "bottom"},
                    {"peak", in_si(segment.peak, dimension::force)},
                    {"peak_time", time(segment.peak_time)},
                    {"impulse", in_si(segment.impulse, dimension::momentum)},
                    {"limit", in_si(segment.limit, dimension::force)},
                    {"margin", segment.margin()}});
  }
  return list;
}

Json Sheet::anchors() const {
  Json list = Json::array();
  for (const scenes::AnchorRecord& anchor : summary_.anchors) {
    const Joint& joint = dynamics_.cables().joints()[anchor.joint];
    list.push_back(
        {{"layer", anchor.layer}, {"position", position(joint.p, joint.along)}, {"force", force(anchor.force)}});
  }
  return list;
}

Json Sheet::events() const {
  Json list = Json::array();
  for (const Failure& failure : record_.failures)
    list.push_back({{"time", time(failure.time)}, {"part", failure.part}, {"event", failure.what}});
  return list;
}

Json Sheet::energy() const {
  if (!record_.plan.ledger) return "off";
  const auto parts = [&](const Energies& e) {
    return Json{{"kinetic", in_si(e.kinetic, dimension::energy)},
                {"gravity", in_si(e.gravity, dimension::energy)},
                {"applied", in_si(e.applied, dimension::energy)},
                {"contacts", in_si(e.contacts, dimension::energy)},
                {"cables", in_si(e.cables, dimension::energy)}};
  };
  Json dissipated = Json::object();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    dissipated[std::string{name_of(static_cast<Mechanism>(i))}] =
        in_si(record_.accounts.dissipated[i], dimension::energy);
  return {{"start", parts(record_.start_energies)},
          {"end", parts(record_.accounts.energies)},
          {"dissipated", dissipated},
          {"balance_error", in_si(record_.accounts.energy_balance_error, dimension::energy)},
          {"scale", in_si(record_.energy_scale, dimension::energy)}};
}

/// The geometry of one state: outlines seen along the fence, cables in space.
Json Sheet::drawn(const char* name, const State& state) const {
  Workspace work = dynamics_.workspace();
  dynamics_.update_all(state, work);
  const Model& model = dynamics_.model();
  Json bodies = Json::array(), cables = Json::array();
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (i == index(*input_.made.members.front().body)) continue;
    const auto is = [i](const scenes::ColumnRecord& column) { return index(column.body) == i; };
    const auto column = std::find_if(summary_.columns.begin(), summary_.columns.end(), is);
    Json points = Json::array();
    for (const Vec2 p : outline(model.bodies[i], 0.0))
      points.push_back(position(world_point(work.poses[i], p)));
    bodies.push_back({{"name", model.bodies[i].name},
                      {"layer", column == summary_.columns.end() ? 0 : column->layer},
                      {"outline", std::move(points)}});
  }
  for (const scenes::SegmentRecord& segment : summary_.segments) {
    const CableForces::Ends ends = dynamics_.cables().ends()[index(segment.cable)];
    Json points = Json::array();
    for (const std::size_t j : {ends.a, ends.b})
      points.push_back(position(work.joints.p_WP(j), dynamics_.cables().joints()[j].along));
    cables.push_back(
        {{"layer", segment.layer}, {"cable", segment.top ? "top" : "bottom"}, {"ends", std::move(points)}});
  }
  return {{"name", name}, {"time", time(state.t)}, {"bodies", std::move(bodies)}, {"cables", std::move(cables)}};
}

Json Sheet::drawing() const {
  const Body& ground = dynamics_.model().bodies[index(*input_.made.members.front().body)];
  const Pose ground_pose{ground.p_WB, rotation(ground.angle), {}, 0.0};
  Json line = Json::array();
  for (const Vec2 p : outline(ground, 100.0 * input_.fence.span))
    line.push_back(position(world_point(ground_pose, p)));
  return {{"ground", std::move(line)},
          {"column_half_width", length(input_.fence.column.a)},
          {"states", Json::array({drawn("start", summary_.start), drawn("largest travel", summary_.at_travel),
                                  drawn("end", end_)})}};
}

Json Sheet::history() const {
  const History& history = watch_.history();
  Json columns = Json::array(), rows = Json::array();
  for (const Column& column : history.columns)
    columns.push_back(column.name);
  for (const std::vector<double>& row : history.rows) {
    Json numbers = Json::array();
    for (std::size_t i = 0; i < row.size(); ++i)
      numbers.push_back(in_si(row[i], history.columns[i].dimension));
    rows.push_back(std::move(numbers));
  }
  return {{"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

}  // namespace

std::string sheet_json(const RunRecord& record, const FenceInput& input, const Dynamics& dynamics,
                       const scenes::FenceMonitor& watch, const State& end) {
  return Sheet{record, input, dynamics, watch, end}.json().dump(1) + "\n";
}

}  // namespace talus
