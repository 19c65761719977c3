#include "reports/sheet_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::reports {
namespace {

/// SI size of what the US columns count in; exact by definition (1959; CGPM 1901 for g_n).
constexpr double foot = 0.3048;
constexpr double pound = 0.45359237;
constexpr double pound_force = pound * 9.80665;
constexpr double kip = 1000.0 * pound_force;

constexpr std::size_t longest = 14;  ///< rows of a table, so that the sheet stays one page

using Row = std::vector<std::string>;

double size(Triple v) { return std::hypot(v[0], v[1], v[2]); }
double size(Pair v) { return std::hypot(v[0], v[1]); }

/// Four digits, without an exponent where that is shorter.
std::string digits(double value) {
  if (value != 0.0 && std::abs(value) >= 1e4 && std::abs(value) < 1e7) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}
std::string seconds(double value) { return fmt::format("{:.4f}", value); }
std::string per_cent(double share) { return fmt::format("{:.1f}", 100.0 * share); }

/// The same quantity twice: in `si` of SI, in `us` of SI.
void add(Row& row, double value, double si, double us) {
  row.push_back(digits(value / si));
  row.push_back(digits(value / us));
}
void add_blank(Row& row, std::size_t count) { row.insert(row.end(), count, ""); }

void cut(SheetTable& table) {
  if (table.rows.size() <= longest) return;
  table.note +=
      fmt::format("{}{} more are in sheet.json. ", table.note.empty() ? "" : " ", table.rows.size() - longest);
  table.rows.resize(longest);
}

SheetTable hanger_table(const SheetRecord& record) {
  SheetTable table{"Hangers (top joints) and cable segments: peaks",
                   SheetTable::Place::page,
                   {{"column"},
                    {"hanger", "kN"},
                    {"hanger", "kip"},
                    {"hanger", "at s"},
                    {"hanger", "% of limit"},
                    {"hanger", "angle, deg"},
                    {"hanger", "kN s"},
                    {"hanger", "kip s"},
                    {"top segment outwards", "kN"},
                    {"top segment outwards", "kip"},
                    {"top segment outwards", "at s"},
                    {"top segment outwards", "% of limit"},
                    {"bottom segment outwards", "kN"},
                    {"bottom segment outwards", "kip"},
                    {"bottom segment outwards", "at s"},
                    {"bottom segment outwards", "% of limit"}},
                   {}};
  for (const SheetColumn& column : record.columns) {
    const SheetForce& hanger = column.hanger;
    Row row{column.name};
    add(row, hanger.peak, 1e3, kip);
    row.push_back(seconds(hanger.peak_time));
    row.push_back(column.margin > 0.0 ? per_cent(column.margin) : "none");
    row.push_back(fmt::format("{:.0f}", std::atan2(hanger.at_peak[1], hanger.at_peak[0]) * 180.0 / std::numbers::pi));
    add(row, size(hanger.impulse), 1e3, kip);
    for (const char* cable : {"top", "bottom"}) {
      std::string name = column.name;
      name.replace(name.find("column"), 6, cable);
      const auto segment = std::find_if(record.segments.begin(), record.segments.end(),
                                        [&](const SheetSegment& s) { return s.name == name; });
      if (segment == record.segments.end()) {
        add_blank(row, 4);
        continue;
      }
      if (segment->peak == 0.0) {
        row.insert(row.end(), {"slack", "", "", ""});
        continue;
      }
      add(row, segment->peak, 1e3, kip);
      row.push_back(seconds(segment->peak_time));
      row.push_back(per_cent(segment->margin));
    }
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Hanger: sum of the top cable's pulls on the column; angle from +x, up positive; impulse over the whole run, "
      "with "
      "what it carries at rest. Limit: where a hanger breaks, a cable yields or breaks.";
  cut(table);
  return table;
}

SheetTable anchor_table(const SheetRecord& record) {
  SheetTable table{"Anchors: force of the cables on them",
                   SheetTable::Place::left,
                   {{"layer, z"},
                    {"peak", "kN"},
                    {"peak", "kip"},
                    {"peak", "at s"},
                    {"direction", "x"},
                    {"direction", "y"},
                    {"direction", "z"},
                    {"impulse", "kN s"},
                    {"impulse", "kip s"}},
                   {}};
  for (const SheetAnchor& anchor : record.anchors) {
    const SheetForce& force = anchor.force;
    Row row{fmt::format("{}, {:.3g} m", anchor.layer, anchor.place[2])};
    add(row, force.peak, 1e3, kip);
    row.push_back(seconds(force.peak_time));
    for (const double part : force.at_peak)
      row.push_back(fmt::format("{:.3f}", force.peak > 0.0 ? part / force.peak : 0.0));
    add(row, size(force.impulse), 1e3, kip);
    table.rows.push_back(std::move(row));
  }
  if (record.half_model) table.note = "The half model: the other side's are the same with -z. ";
  cut(table);
  return table;
}

SheetTable travel_table(const SheetRecord& record) {
  SheetTable table{
      "Travel and heights over the ground", SheetTable::Place::right, {{""}, {"", "m"}, {"", "ft"}, {"", "at s"}}, {}};
  const auto line = [&](const std::string& words, double value, double time) {
    Row row{words};
    add(row, value, 1.0, foot);
    row.push_back(seconds(time));
    table.rows.push_back(std::move(row));
  };
  line("largest travel of a column", record.travel, record.travel_time);
  for (std::size_t i = 0; i < record.heights.size(); ++i) {
    const SheetHeight &top = record.heights[i].top, &bottom = record.heights[i].bottom;
    const std::string layer = record.heights.size() > 1 ? fmt::format("layer {}: ", i + 1) : "";
    line(layer + "lowest top joint, start", top.start, 0.0);
    line(layer + "lowest top joint, least", top.extreme, top.extreme_time);
    line(layer + "lowest top joint, end", top.end, record.end);
    line(layer + "gap below, start", bottom.start, 0.0);
    line(layer + "gap below, largest", bottom.extreme, bottom.extreme_time);
    line(layer + "gap below, end", bottom.end, record.end);
  }
  return table;
}

/// The part that comes nearest to its limit, in words; empty when nothing has one.
std::string nearest_to_limit(const SheetRecord& record) {
  double margin = 0.0;
  std::string name;
  for (const SheetSegment& segment : record.segments) {
    if (segment.margin > margin) margin = segment.margin, name = segment.name;
  }
  for (const SheetColumn& column : record.columns) {
    if (column.margin > margin) margin = column.margin, name = "the hanger of " + column.name;
  }
  return name.empty() ? "" : fmt::format("Nearest to its limit: {}, {} %.", name, per_cent(margin));
}

SheetTable event_table(const SheetRecord& record) {
  SheetTable table{"Order of yields and breaks", SheetTable::Place::left, {{"at s"}, {"part"}, {"what"}}, {}};
  for (const SheetEvent& event : record.events)
    table.rows.push_back({fmt::format("{:.5f}", event.time), event.part, event.what});
  if (record.events.empty()) {
    table.rows.push_back({"", "none", ""});
    table.note = nearest_to_limit(record);
  }
  constexpr std::size_t most = 10;
  if (table.rows.size() > most) {
    table.note = fmt::format("{} more are in sheet.json.", table.rows.size() - most);
    table.rows.resize(most);
  }
  return table;
}

SheetTable energy_table(const SheetRecord& record) {
  SheetTable table{"Energy of rocks and fence", SheetTable::Place::right, {{""}, {"", "kJ"}, {"", "kip ft"}}, {}};
  for (const SheetEnergy& line : record.energies) {
    Row row{line.name};
    add(row, line.value, 1e3, foot * kip);
    table.rows.push_back(std::move(row));
  }
  if (record.energies.empty()) table.note = "The run kept no ledger.";
  return table;
}

}  // namespace

SheetTable rock_table(const SheetRecord& record) {
  SheetTable table{"Rocks",
                   SheetTable::Place::page,
                   {{"rock"},
                    {"mass", "kg"},
                    {"mass", "lb"},
                    {"speed before", "m/s"},
                    {"speed before", "ft/s"},
                    {"energy before", "kJ"},
                    {"energy before", "kip ft"},
                    {"touch", "s"},
                    {"exit", "s"},
                    {"speed after", "m/s"},
                    {"speed after", "ft/s"},
                    {"x velocity after", "m/s"},
                    {"x velocity after", "ft/s"},
                    {"energy after", "kJ"},
                    {"energy after", "kip ft"},
                    {"taken", "%"},
                    {"braking", "s"},
                    {"travel", "m"},
                    {"travel", "ft"}},
                   {}};
  std::string still, on;
  for (const SheetRock& rock : record.rocks) {
    Row row{rock.name};
    add(row, rock.mass, 1.0, pound);
    add(row, size(rock.approach_velocity), 1.0, foot);
    add(row, rock.approach_energy, 1e3, foot * kip);
    if (!rock.touched) {
      row.push_back("never");
      add_blank(row, 11);
      table.rows.push_back(std::move(row));
      continue;
    }
    row.push_back(seconds(rock.touch_time));
    row.push_back(seconds(rock.exit_time));
    add(row, size(rock.exit_velocity), 1.0, foot);
    add(row, rock.exit_velocity[0], 1.0, foot);
    add(row, rock.exit_energy, 1e3, foot * kip);
    row.push_back(per_cent(rock.energy_taken));
    row.push_back(seconds(rock.braking_time));
    add(row, rock.travel, 1.0, foot);
    table.rows.push_back(std::move(row));
    if (!rock.left) still += (still.empty() ? "" : ", ") + rock.name;
    if (!rock.turned) on += (on.empty() ? "" : ", ") + rock.name;
  }
  table.note = "Exit: after the last touch of a column. Energy: of translation and rotation.";
  if (!on.empty()) table.note += " Went on without turning, braking until its exit: " + on + ".";
  if (!still.empty()) table.note += " Still touching at the end of the run: " + still + ".";
  cut(table);
  return table;
}

std::vector<SheetTable> fence_tables(const SheetRecord& record) {
  return {hanger_table(record), anchor_table(record), event_table(record), travel_table(record), energy_table(record)};
}

}  // namespace talus::reports
