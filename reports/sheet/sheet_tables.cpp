#include "reports/sheet/sheet_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/sheet/sheet_units.hpp"

namespace talus::reports {
namespace {

/// Maximum rows of the tables, so that the sheet fits one page: of rocks and anchors, and of rocks and hangers
/// together.
constexpr std::size_t longest = 5, longest_together = 12;

using Row = std::vector<std::string>;

std::string seconds(double value) { return fmt::format("{:.4f}", value); }
std::string per_cent(double fraction) { return fmt::format("{:.1f}", 100.0 * fraction); }

void add_blank(Row& row, std::size_t count) { row.insert(row.end(), count, ""); }

SheetTable hanger_table(const SheetRecord& record) {
  SheetTable table{"Hangers (top joints) and cable segments outwards of them: peaks",
                   SheetTable::Location::page,
                   {{"", "column"},
                    head("hanger", record.us_units, force_units),
                    {"hanger", "at s"},
                    {"hanger", "% limit"},
                    {"hanger", "deg"},
                    head("hanger", record.us_units, impulse_units),
                    head("top segment", record.us_units, force_units),
                    {"top segment", "at s"},
                    {"top segment", "% limit"},
                    head("bottom segment", record.us_units, force_units),
                    {"bottom segment", "at s"},
                    {"bottom segment", "% limit"}},
                   {}};
  for (const SheetColumn& column : record.columns) {
    const SheetForce& hanger = column.hanger;
    Row row{column.name, both(record.us_units, hanger.peak, force_units), seconds(hanger.peak_time)};
    row.push_back(column.margin > 0.0 ? per_cent(column.margin) : "none");
    row.push_back(fmt::format("{:.0f}", std::atan2(hanger.at_peak[1], hanger.at_peak[0]) * 180.0 / std::numbers::pi));
    row.push_back(both(record.us_units, size(hanger.impulse), impulse_units));
    for (const char* cable : {"top", "bottom"}) {
      std::string name = column.name;
      name.replace(name.find("column"), 6, cable);
      const auto segment = std::find_if(record.segments.begin(), record.segments.end(),
                                        [&](const SheetSegment& s) { return s.name == name; });
      if (segment == record.segments.end()) {
        add_blank(row, 3);
        continue;
      }
      if (segment->peak == 0.0) {
        row.insert(row.end(), {"slack", "", ""});
        continue;
      }
      row.insert(row.end(), {both(record.us_units, segment->peak, force_units), seconds(segment->peak_time)});
      row.push_back(per_cent(segment->margin));
    }
    table.rows.push_back(std::move(row));
  }
  table.note = "Hanger: the top cable's pull on the column; deg from +x, up positive; impulse over the whole run.";
  cut(table, longest_together - std::min(longest, record.rocks.size()), "sheet.json");
  return table;
}

SheetTable anchor_table(const SheetRecord& record) {
  SheetTable table{"Anchors: force of the cables on them",
                   SheetTable::Location::left,
                   {{"", "layer, z"},
                    head("peak", record.us_units, force_units),
                    {"peak", "at s"},
                    {"direction", "x"},
                    {"direction", "y"},
                    {"direction", "z"},
                    head("impulse", record.us_units, impulse_units)},
                   {}};
  for (const SheetAnchor& anchor : record.anchors) {
    const SheetForce& force = anchor.force;
    Row row{fmt::format("{}, {:.3g} m", anchor.layer, anchor.position[2]),
            both(record.us_units, force.peak, force_units), seconds(force.peak_time)};
    for (const double part : force.at_peak)
      row.push_back(fmt::format("{:.2f}", force.peak > 0.0 ? part / force.peak : 0.0));
    row.push_back(both(record.us_units, size(force.impulse), impulse_units));
    table.rows.push_back(std::move(row));
  }
  if (record.half_model) table.note = "The half model: the other side's are the same with -z. ";
  cut(table, longest, "sheet.json");
  return table;
}

SheetTable height_table(const SheetRecord& record) {
  SheetTable table{"Heights over the ground, and the largest displacement of a column",
                   SheetTable::Location::page,
                   {{"", ""},
                    head("start", record.us_units, length_units),
                    head("extreme", record.us_units, length_units),
                    {"extreme", "at s"},
                    head("end", record.us_units, length_units)},
                   {}};
  const auto line = [&](const std::string& label, const SheetHeight& height) {
    table.rows.push_back({label, both(record.us_units, height.start, length_units),
                          both(record.us_units, height.extreme, length_units), seconds(height.extreme_time),
                          both(record.us_units, height.end, length_units)});
  };
  for (std::size_t i = 0; i < record.heights.size(); ++i) {
    const std::string layer = record.heights.size() > 1 ? fmt::format("layer {}: ", i + 1) : "";
    line(layer + "lowest top joint (minimum)", record.heights[i].top);
    line(layer + "gap below the columns (maximum)", record.heights[i].bottom);
  }
  table.rows.push_back({"displacement of a column along x (maximum)", "",
                        both(record.us_units, record.travel, length_units), seconds(record.travel_time), ""});
  return table;
}

/// The part that is closest to its limit, as text; empty if no part has a limit.
std::string nearest_to_limit(const SheetRecord& record) {
  double margin = 0.0;
  std::string name;
  for (const SheetSegment& segment : record.segments) {
    if (segment.margin > margin) margin = segment.margin, name = segment.name;
  }
  for (const SheetColumn& column : record.columns) {
    if (column.margin > margin) margin = column.margin, name = "the hanger of " + column.name;
  }
  return name.empty() ? "" : fmt::format("Closest to its limit: {}, {} %.", name, per_cent(margin));
}

SheetTable event_table(const SheetRecord& record) {
  SheetTable table{"Order of yields and breaks",
                   SheetTable::Location::left,
                   {{"", "at s"}, {"", "part", true}, {"", "what", true}},
                   {}};
  for (const SheetEvent& event : record.events)
    table.rows.push_back({fmt::format("{:.5f}", event.time), event.part, event.what});
  if (record.events.empty()) {
    table.rows.push_back({"", "none", ""});
    table.note = nearest_to_limit(record);
  }
  cut(table, 4, "sheet.json");
  return table;
}

SheetTable energy_table(const SheetRecord& record) {
  SheetTable table{"Energy of rocks and fence",
                   SheetTable::Location::right,
                   {{"", ""}, head("", record.us_units, energy_units)},
                   {}};
  for (const SheetEnergy& line : record.energies)
    table.rows.push_back({line.name, both(record.us_units, line.value, energy_units)});
  if (record.energies.empty()) table.note = "The run kept no energy balance.";
  return table;
}

}  // namespace

SheetTable rock_table(const SheetRecord& record) {
  SheetTable table{"Rocks",
                   SheetTable::Location::top,
                   {{"", "rock"},
                    head("mass", record.us_units, mass_units),
                    head("before", record.us_units, speed_units),
                    head("before", record.us_units, energy_units),
                    {"contact", "from s"},
                    {"contact", "to s"},
                    head("after", record.us_units, speed_units),
                    head("after", record.us_units, energy_units),
                    {"taken", "%"},
                    {"braking", "s"},
                    head("advance", record.us_units, length_units)},
                   {}};
  for (const SheetRock& rock : record.rocks) {
    Row row{rock.name, both(record.us_units, rock.mass, mass_units),
            both(record.us_units, size(rock.approach_velocity), speed_units),
            both(record.us_units, rock.approach_energy, energy_units)};
    if (!rock.touched) {
      row.push_back("never");
      add_blank(row, 6);
      table.rows.push_back(std::move(row));
      continue;
    }
    row.insert(row.end(), {seconds(rock.touch_time), seconds(rock.exit_time)});
    row.push_back(both(record.us_units, size(rock.exit_velocity), speed_units));
    row.push_back(both(record.us_units, rock.exit_energy, energy_units));
    row.insert(row.end(), {per_cent(rock.energy_loss_fraction), seconds(rock.braking_time)});
    row.push_back(both(record.us_units, rock.travel, length_units));
    table.rows.push_back(std::move(row));
  }
  table.note =
      "After: when the last contact with a column ends. Braking: until the rock no longer advances, at most until "
      "then.";
  cut(table, longest, "sheet.json");
  return table;
}

std::vector<SheetTable> fence_tables(const SheetRecord& record) {
  return {rock_table(record),   hanger_table(record), height_table(record),
          anchor_table(record), event_table(record),  energy_table(record)};
}

}  // namespace talus::reports
