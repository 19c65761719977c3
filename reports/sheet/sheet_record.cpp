#include "reports/sheet/sheet_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/base/error.hpp"
#include "verification/record/json_node.hpp"

namespace talus::reports {
namespace {

using records::Json;
using records::Node;

constexpr int sheet_schema = 3;

template <std::size_t count>
std::array<double, count> numbers(const Node& node) {
  const std::vector<Node> list = node.list();
  if (list.size() != count) node.fail(fmt::format("must be {} numbers, found {}", count, list.size()));
  std::array<double, count> found{};
  for (std::size_t i = 0; i < count; ++i)
    found[i] = list[i].finite();
  return found;
}

SheetForce force(const Node& node) {
  return {node.at("peak").finite(), node.at("peak_time").finite(), numbers<3>(node.at("at_peak")),
          numbers<3>(node.at("impulse"))};
}

std::string verdict(const Node& node) {
  return node.one_of({"stopped", "undecided", "passed_under", "passed_over", "broke_through"});
}

std::optional<double> balance(const Node& node) {
  if (node.at("energy_balance").json().is_string()) return std::nullopt;
  return node.at("energy_balance").finite();
}

SheetQuality quality(const Node& node) {
  SheetQuality found{.usable = node.at("usable").flag(),
                     .flaw = node.at("flaw").text(),
                     .step = node.at("step").text(),
                     .balance = balance(node),
                     .contact_steps = {},
                     .touching = {},
                     .repeat = {},
                     .repair = {}};
  if (node.has("steps_in_shortest_contact")) found.contact_steps = node.at("steps_in_shortest_contact").finite();
  if (node.has("last_contact") && node.at("last_contact").at("touching").flag())
    found.touching = node.at("last_contact").at("name").text();
  if (node.has("repeat")) {
    const Node repeat = node.at("repeat");
    found.repeat = {repeat.at("change_of_speed").finite(), repeat.at("failure").text(), verdict(repeat.at("verdict")),
                    repeat.at("change_of_largest_cable_force").finite()};
  }
  if (node.has("repair")) {
    const Node repair = node.at("repair");
    found.repair = {repair.at("option").text(), repair.at("flaw").text(), verdict(repair.at("verdict")),
                    balance(repair)};
  }
  return found;
}

SheetRock rock(const Node& node) {
  SheetRock found{.name = node.at("name").text(),
                  .verdict = verdict(node.at("verdict")),
                  .passed_time = node.at("passed_time").finite(),
                  .end_energy = node.at("end_energy").finite(),
                  .end_velocity = numbers<2>(node.at("end_velocity")),
                  .mass = node.at("mass").finite(),
                  .approach_energy = node.at("approach_energy").finite(),
                  .approach_velocity = numbers<2>(node.at("approach_velocity")),
                  .touched = node.at("touched").flag()};
  if (!found.touched) return found;
  found.left = node.at("separated").flag();
  found.turned = node.at("turned").flag();
  found.touch_time = node.at("touch_time").finite();
  found.exit_time = node.at("exit_time").finite();
  found.exit_energy = node.at("exit_energy").finite();
  found.energy_loss_fraction = node.at("energy_loss_fraction").number();
  found.braking_time = node.at("braking_time").finite();
  found.travel = node.at("travel").finite();
  found.exit_velocity = numbers<2>(node.at("exit_velocity"));
  return found;
}

SheetHeight height(const Node& node) {
  return {node.at("start").finite(), node.at("extreme").finite(), node.at("extreme_time").finite(),
          node.at("end").finite()};
}

/// Changes of the energies that are present, non-zero losses, and the energy balance error.
std::vector<SheetEnergy> energies(const Node& sheet) {
  if (sheet.at("energy").json().is_string()) return {};
  const Node node = sheet.at("energy");
  std::vector<SheetEnergy> lines{{"kinetic energy at the start", node.at("start").at("kinetic").finite()},
                                 {"kinetic energy at the end", node.at("end").at("kinetic").finite()}};
  for (const auto& [key, label] : {std::pair{"gravity", "gained in height"},
                                   {"cables", "gained in cables"},
                                   {"contacts", "gained in contacts"},
                                   {"applied", "gained in applied forces"}}) {
    const double change = node.at("end").at(key).finite() - node.at("start").at(key).finite();
    if (std::abs(change) > 1e-9 * node.at("scale").finite()) lines.push_back({label, change});
  }
  std::map<std::string, double> losses;  // sorted by name
  for (const auto& [mechanism, energy] : node.at("dissipated").members())
    losses[mechanism] = energy.finite();
  for (const auto& [mechanism, energy] : losses) {
    std::string label = mechanism;
    std::replace(label.begin(), label.end(), '_', ' ');
    if (energy != 0.0) lines.push_back({"dissipated: " + label, energy});
  }
  lines.push_back({"energy balance error", node.at("balance_error").finite()});
  return lines;
}

SheetState state(const Node& node) {
  SheetState found{.name = node.at("name").text(), .time = node.at("time").finite(), .bodies = {}, .cables = {}};
  for (const Node& body : node.at("bodies").list()) {
    found.bodies.push_back({body.at("name").text(), body.at("layer").integer(), {}});
    for (const Node& point : body.at("outline").list())
      found.bodies.back().outline.push_back(numbers<2>(point));
  }
  for (const Node& cable : node.at("cables").list()) {
    const std::vector<Node> ends = cable.at("ends").list();
    if (ends.size() != 2) cable.fail("must have two ends");
    found.cables.push_back({cable.at("layer").integer(),
                            cable.at("cable").one_of({"top", "bottom"}) == "top",
                            {numbers<3>(ends[0]), numbers<3>(ends[1])}});
  }
  return found;
}

void read_forces(const Node& sheet, SheetRecord& record) {
  for (const Node& node : sheet.at("columns").list()) {
    record.columns.push_back({node.at("name").text(), node.at("layer").integer(), node.at("along").finite(),
                              node.at("travel").finite(), node.at("travel_time").finite(), node.at("margin").finite(),
                              force(node.at("hanger"))});
  }
  for (const Node& node : sheet.at("segments").list()) {
    record.segments.push_back({node.at("name").text(), node.at("layer").integer(),
                               node.at("cable").one_of({"top", "bottom"}) == "top", node.at("peak").finite(),
                               node.at("peak_time").finite(), node.at("margin").finite()});
  }
  for (const Node& node : sheet.at("anchors").list())
    record.anchors.push_back({node.at("layer").integer(), numbers<3>(node.at("position")), force(node.at("force"))});
  for (const Node& node : sheet.at("events").list())
    record.events.push_back({node.at("time").finite(), node.at("part").text(), node.at("event").text()});
}

void read_drawing(const Node& sheet, SheetRecord& record) {
  const Node drawing = sheet.at("drawing");
  for (const Node& point : drawing.at("ground").list())
    record.ground.push_back(numbers<2>(point));
  record.column_half_width = drawing.at("column_half_width").finite();
  for (const Node& node : drawing.at("states").list())
    record.states.push_back(state(node));
  record.history_columns = sheet.at("history").at("columns").texts();
  for (const Node& row : sheet.at("history").at("rows").list()) {
    std::vector<double>& values = record.history.emplace_back();
    for (const Node& value : row.list())
      values.push_back(value.finite());
    if (values.size() != record.history_columns.size()) row.fail("must have a number for each column");
  }
}

}  // namespace

SheetRecord read_sheet(const std::filesystem::path& file) {
  const Json all = records::read_json(file);
  const Node sheet{all, file.string()};
  if (const Node found = sheet.at("schema"); found.integer() != sheet_schema) {
    found.fail(fmt::format("must be {}, found {}: run the fence again with --sheet, by this version of talus",
                           sheet_schema, found.integer()));
  }
  const Node run = sheet.at("run"), fence = sheet.at("fence");
  SheetRecord record;
  record.title = sheet.at("title").text();
  record.outcome = run.at("outcome").text();
  record.verdict = verdict(sheet.at("verdict"));
  record.quality = quality(sheet.at("quality"));
  record.us_units = fence.at("scene_units").text() == "US";
  record.integrator = run.at("integrator").text();
  record.end = run.at("time").finite();
  record.step = run.at("step").finite();
  record.steps = run.at("steps").integer();
  record.layers = fence.at("layers").integer();
  record.columns_of_layer = fence.at("columns").integer();
  record.half_model = fence.at("half_model").flag();
  record.span = fence.at("span").finite();
  record.sag = fence.at("sag").finite();
  record.spacing = fence.at("spacing").finite();
  record.travel = fence.at("travel").finite();
  record.travel_time = fence.at("travel_time").finite();
  for (const Node& node : sheet.at("rocks").list())
    record.rocks.push_back(rock(node));
  for (const Node& node : sheet.at("layers").list())
    record.heights.push_back({height(node.at("top")), height(node.at("bottom"))});
  read_forces(sheet, record);
  record.energies = energies(sheet);
  read_drawing(sheet, record);
  return record;
}

}  // namespace talus::reports
