#include "verification/problems/program/agreement/expected_fence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace talus::verification::problems::agreeing_files {
namespace {

/// A force over all rows: its largest size, and its impulse by the trapezoidal rule.
struct Force {
  std::vector<Vector> values;

  [[nodiscard]] std::size_t peak_row() const {
    const auto found = std::ranges::max_element(values, {}, [](const Vector& v) { return size(v); });
    return static_cast<std::size_t>(found - values.begin());
  }
  [[nodiscard]] Json json(const Run& run, const Json& found) const {
    const double newton = run.facts.units->newton, peak = newton * size(values[peak_row()]);
    Json at_peak = Json::array(), impulse = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0.0;
      for (std::size_t row = 1; row < values.size(); ++row)
        sum += 0.5 * (values[row][i] + values[row - 1][i]) * (run.time(row) - run.time(row - 1));
      at_peak.push_back(scaled(newton * values[peak_row()][i], peak));
      impulse.push_back(scaled(newton * sum, peak * run.time(run.rows() - 1)));
    }
    // Rounding errors decide which row has the largest of forces that are equal to within a few of them.
    const double at = found.value("peak_time", -1.0);
    double time = run.time(peak_row());
    for (std::size_t row = 0; row < values.size(); ++row)
      if (run.time(row) == at && newton * size(values[row]) > (1.0 - 1e-12) * peak) time = at;
    return {{"peak", peak}, {"peak_time", time}, {"at_peak", at_peak}, {"impulse", impulse}};
  }
};

/// Sum of the tensions of the top cables at a point of a column or at an anchor, each towards its other end [force].
Force pull_at(const Run& run, const Vector& start, int body) {
  Force force{.values = std::vector<Vector>(run.rows(), Vector{})};
  for (const Cable& cable : run.facts.cables) {
    for (const auto& [here, there] : {std::pair{cable.from, cable.to}, std::pair{cable.to, cable.from}}) {
      const bool is_anchor = body < 0 && here.body < 0 && here.x == start[0];
      if (!cable.top || (!is_anchor && (body < 0 || here.body != body))) continue;
      for (std::size_t row = 0; row < run.rows(); ++row) {
        const Vector along = between(run.position(here, row), run.position(there, row));
        const double pull = run.history.at(cable.name + ".tension")[row] / size(along);
        for (std::size_t i = 0; i < 3; ++i)
          force.values[row][i] += pull * along[i];
      }
    }
  }
  return force;
}

/// The pull on a column's top joint in its plane; the central column is also pulled by the mirror images of its cables.
Force hanger_force(const Run& run, int body) {
  const Part& column = run.facts.bodies[static_cast<std::size_t>(body)];
  Force force = pull_at(run, {}, body);
  for (Vector& value : force.values) {
    for (double& component : value)
      component *= column.along == 0.0 ? 2.0 : 1.0;
    value[2] = 0.0;
  }
  return force;
}

/// What a rock does, from the rows.
struct Passage {
  std::string name, verdict{};
  double mass{};
  std::size_t touch{}, exit{}, stop{};  ///< rows
  double vx{}, vy{}, spin{};            ///< of the approach
  double approach{}, exit_energy{}, end_energy{}, travel{};
  bool separated{}, turned{};
};

/// A rock touches the fence in the rows in which it overlaps a column or presses it.
Passage passage_of(const Run& run, std::size_t r) {
  const Part& rock = run.facts.bodies[r + 1];
  const auto column = [&](const char* quantity) -> const std::vector<double>& {
    return run.history.at(rock.name + quantity);
  };
  const std::size_t last = run.rows() - 1;
  const auto energy = [&](double vx, double vy, double spin) {
    return 0.5 * (rock.mass * (vx * vx + vy * vy) + rock.inertia * spin * spin);
  };
  const auto energy_at = [&](std::size_t row) {
    return energy(column(".vx")[row], column(".vy")[row], column(".spin")[row]);
  };
  Passage found{.name = rock.name, .mass = rock.mass};
  found.touch = last + 1;
  for (std::size_t row = 0; row <= last; ++row) {
    double maximum = 0.0;
    for (const char* with : {"-column1", "-back_column1"})
      for (const char* quantity : {".overlap", ".force"})
        maximum = std::max(maximum, run.history.at(rock.name + with + quantity)[row]);
    if (maximum > 0.0) found.touch = std::min(found.touch, row), found.exit = std::min(row + 1, last);
    found.separated = !(maximum > 0.0);
  }
  if (found.touch > last) throw std::runtime_error(rock.name + " does not touch the fence");
  found.vx = rocks[r].speed, found.spin = rocks[r].spin;
  if (found.touch > 0) {
    const std::size_t before = found.touch - 1;
    found.vx = column(".vx")[before], found.vy = column(".vy")[before], found.spin = column(".spin")[before];
  }
  found.approach = energy(found.vx, found.vy, found.spin);
  found.exit_energy = energy_at(found.exit), found.end_energy = energy_at(last);
  found.stop = found.exit;
  for (std::size_t row = found.touch; row <= found.exit; ++row) {
    found.travel = std::max(found.travel, column(".x")[found.touch] - column(".x")[row]);
    if (!found.turned && column(".vx")[row] >= 0.0) found.turned = true, found.stop = row;
  }
  found.verdict = column(".vx")[last] >= 0.0 ? "stopped" : "undecided";
  return found;
}

Json vector_of(double x, double y, double scale) { return {scaled(x, scale), scaled(y, scale)}; }

/// The largest tension of a cable with its row and its ratio to the yield force.
struct Peak {
  std::string name;
  double force{}, time{}, limit{};
};
Json json_of(const Peak& peak) {
  Json json{{"name", peak.name}, {"peak", peak.force}, {"time", peak.time}, {"margin", nullptr}};
  if (peak.limit > 0.0) json["margin"] = peak.force / peak.limit;
  return json;
}
Peak largest(const std::vector<Peak>& peaks, bool over_limit) {
  return *std::ranges::max_element(peaks, {}, [&](const Peak& p) { return over_limit ? p.force / p.limit : p.force; });
}

Peak peak_of(const Run& run, const Cable& cable) {
  const std::vector<double>& tension = run.history.at(cable.name + ".tension");
  const auto at = std::ranges::max_element(tension);
  return {cable.name, *at, run.time(static_cast<std::size_t>(at - tension.begin())), cable.yield};
}

/// One of the three states drawn in the sheet [m].
Json drawn(const Run& run, const char* name, std::size_t row) {
  const double metre = run.facts.units->metre;
  Json bodies = Json::array(), cables = Json::array();
  for (const Part& body : run.facts.bodies) {
    if (body.shape == Shape::plane) continue;
    Json points = Json::array();
    for (const auto& [u, v] : outline_of(body, 0.0)) {
      const Vector at = run.position(body, u, v, row);
      points.push_back({scaled(metre * at[0], 1.0), scaled(metre * at[1], 1.0)});
    }
    bodies.push_back({{"name", body.name}, {"layer", body.layer}, {"outline", points}});
  }
  for (const Cable& cable : run.facts.cables) {
    Json ends = Json::array();
    for (const End& end : {cable.from, cable.to}) {
      const Vector at = run.position(end, row);
      ends.push_back({scaled(metre * at[0], 1.0), scaled(metre * at[1], 1.0), scaled(metre * at[2], 1.0)});
    }
    cables.push_back({{"layer", cable.layer}, {"cable", cable.top ? "top" : "bottom"}, {"ends", ends}});
  }
  return {{"name", name}, {"time", run.time(row)}, {"bodies", bodies}, {"cables", cables}};
}

/// Height of a layer's lowest top joint or highest bottom joint above the ground [m].
Json height_of(const Run& run, int layer, bool top, const Json& found) {
  std::vector<double> heights;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    double extreme = top ? infinite : -infinite;
    for (const Part& body : run.facts.bodies) {
      if (body.layer != layer) continue;
      const double height = run.position(body, 0.0, top ? y_top : y_bottom, row)[1] - ground_top;
      extreme = top ? std::min(extreme, height) : std::max(extreme, height);
    }
    heights.push_back(run.facts.units->metre * extreme);
  }
  const auto at = top ? std::ranges::min_element(heights) : std::ranges::max_element(heights);
  double time = run.time(static_cast<std::size_t>(at - heights.begin()));
  // As for the largest force.
  for (std::size_t row = 0; row < heights.size(); ++row)
    if (run.time(row) == found["extreme_time"].get<double>() && std::abs(heights[row] - *at) < 1e-12)
      time = run.time(row);
  return {{"start", heights.front()}, {"extreme", *at}, {"extreme_time", time}, {"end", heights.back()}};
}

}  // namespace

Json expected_verdict(const Run& run) {
  Json list = Json::array();
  std::string worst = "stopped";
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const Passage rock = passage_of(run, r);
    if (rock.verdict == "undecided") worst = rock.verdict;
    const auto velocity = [&](std::size_t row) {
      return vector_of(run.history.at(rock.name + ".vx")[row], run.history.at(rock.name + ".vy")[row], 10.0);
    };
    list.push_back({{"name", rock.name},
                    {"verdict", rock.verdict},
                    {"passed_time", 0.0},
                    {"touched", true},
                    {"last_contact_time", run.time(rock.exit)},
                    {"still_touching", !rock.separated},
                    {"approach_energy", rock.approach},
                    {"velocity_after", rock.separated ? velocity(rock.exit) : Json(nullptr)},
                    {"energy_after", rock.separated ? Json(rock.exit_energy) : Json(nullptr)},
                    {"velocity_at_end", velocity(run.rows() - 1)},
                    {"energy_at_end", rock.end_energy}});
  }
  std::vector<Peak> cables, hangers, anchors;
  for (const Cable& cable : run.facts.cables) {
    cables.push_back(peak_of(run, cable));
    if (cable.to.body >= 0) continue;
    const Force force = pull_at(run, {cable.to.x, 0.0, 0.0}, -1);
    anchors.push_back({"anchor", size(force.values[force.peak_row()]), run.time(force.peak_row()), 0.0});
  }
  for (std::size_t i = 0; i < run.facts.bodies.size(); ++i) {
    if (run.facts.bodies[i].layer == 0) continue;
    const Force force = hanger_force(run, static_cast<int>(i));
    hangers.push_back(
        {run.facts.bodies[i].name, size(force.values[force.peak_row()]), run.time(force.peak_row()), hanger_strength});
  }
  return {{"fence", worst},
          {"rocks", list},
          {"largest_anchor_force", json_of(largest(anchors, false))},
          {"largest_cable_force", json_of(largest(cables, false))},
          {"cable_closest_to_limit", json_of(largest(cables, true))},
          {"largest_hanger_force", json_of(largest(hangers, false))},
          {"hanger_closest_to_limit", json_of(largest(hangers, true))}};
}

Json expected_sheet(const Run& run, const Json& found, double metre) {
  const Facts& facts = run.facts;
  const Units& units = *facts.units;
  const double newton = units.newton, joule = units.joule();
  const std::size_t last = run.rows() - 1;
  Json passages = Json::array();
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const Passage rock = passage_of(run, r);
    const auto velocity = [&](std::size_t row) {
      return vector_of(metre * run.history.at(rock.name + ".vx")[row], metre * run.history.at(rock.name + ".vy")[row],
                       10.0);
    };
    passages.push_back({{"name", rock.name},
                        {"mass", units.kilogram() * rock.mass},
                        {"approach_velocity", vector_of(metre * rock.vx, metre * rock.vy, 10.0)},
                        {"approach_spin", rock.spin},
                        {"approach_energy", joule * rock.approach},
                        {"touched", true},
                        {"verdict", rock.verdict},
                        {"passed_time", 0.0},
                        {"end_velocity", velocity(last)},
                        {"end_energy", joule * rock.end_energy},
                        {"touch_time", run.time(rock.touch)},
                        {"separated", rock.separated},
                        {"exit_time", run.time(rock.exit)},
                        {"exit_velocity", velocity(rock.exit)},
                        {"exit_spin", run.history.at(rock.name + ".spin")[rock.exit]},
                        {"exit_energy", joule * rock.exit_energy},
                        {"energy_loss_fraction", 1.0 - rock.exit_energy / rock.approach},
                        {"turned", rock.turned},
                        {"braking_time", run.time(rock.stop) - run.time(rock.touch)},
                        {"travel", scaled(metre * rock.travel, 1.0)}});
  }
  Json layers = Json::array(), columns = Json::array(), segments = Json::array(), anchors = Json::array();
  for (const int layer : {1, 2}) {
    const Json& known = found["layers"][static_cast<std::size_t>(layer - 1)];
    layers.push_back({{"top", height_of(run, layer, true, known["top"])},
                      {"bottom", height_of(run, layer, false, known["bottom"])}});
  }
  double travel = 0.0;
  std::size_t travel_row = 0;
  std::vector<Force> hangers;
  for (std::size_t i = 0; i < facts.bodies.size(); ++i) {
    const Part& body = facts.bodies[i];
    if (body.layer == 0) continue;
    std::vector<double> away;
    for (const double x : run.history.at(body.name + ".x"))
      away.push_back(std::abs(x - run.history.at(body.name + ".x").front()));
    const auto row = static_cast<std::size_t>(std::ranges::max_element(away) - away.begin());
    if (away[row] > travel) travel = away[row], travel_row = row;
    hangers.push_back(hanger_force(run, static_cast<int>(i)));
    const Json& known = found["columns"][columns.size()]["hanger"];
    const Json hanger = hangers.back().json(run, known);
    columns.push_back({{"name", body.name},
                       {"layer", body.layer},
                       {"along", metre * body.along},
                       {"travel", scaled(metre * away[row], 1.0)},
                       {"travel_time", run.time(row)},
                       {"limit", newton * hanger_strength},
                       {"margin", hanger["peak"].get<double>() / (newton * hanger_strength)},
                       {"hanger", hanger}});
  }
  for (const Cable& cable : facts.cables) {
    const std::vector<double>& tension = run.history.at(cable.name + ".tension");
    const Peak peak = peak_of(run, cable);
    double impulse = 0.0;
    for (std::size_t row = 1; row <= last; ++row)
      impulse += 0.5 * (tension[row] + tension[row - 1]) * (run.time(row) - run.time(row - 1));
    segments.push_back({{"name", cable.name},
                        {"layer", cable.layer},
                        {"cable", cable.top ? "top" : "bottom"},
                        {"peak", newton * peak.force},
                        {"peak_time", peak.time},
                        {"impulse", newton * impulse},
                        {"limit", newton * cable.yield},
                        {"margin", peak.force / cable.yield}});
    if (cable.to.body >= 0) continue;
    const Json& known = found["anchors"][anchors.size()]["force"];
    anchors.push_back({{"layer", cable.layer},
                       {"position", {metre * cable.to.x, metre * cable.to.y, metre * cable.to.along}},
                       {"force", pull_at(run, {cable.to.x, 0.0, 0.0}, -1).json(run, known)}});
  }
  const auto energies_at = [&](std::size_t row) {
    Json json;
    for (const std::string& part : energies())
      json[part] = joule * run.history.at("energy." + part)[row];
    return json;
  };
  Json dissipated;
  for (const std::string& part : mechanisms())
    dissipated[part] = joule * run.history.at("dissipated." + part)[last];
  Json names{"time"}, rows = Json::array();
  for (const char* rock : {"rock1", "rock2"})
    for (const char* quantity : {".x", ".y", ".vx"})
      names.push_back(std::string(rock) + quantity);
  for (const char* force : {"hanger", "top", "bottom"})
    names.push_back(force);
  for (std::size_t row = 0; row <= last; ++row) {
    Json numbers{run.time(row)};
    for (const char* rock : {"rock1", "rock2"})
      for (const char* quantity : {".x", ".y", ".vx"})
        numbers.push_back(metre * run.history.at(std::string(rock) + quantity)[row]);
    double hanger = 0.0, top = 0.0, bottom = 0.0;
    for (const Force& force : hangers)
      hanger = std::max(hanger, size(force.values[row]));
    for (const Cable& cable : facts.cables) {
      double& maximum = cable.top ? top : bottom;
      maximum = std::max(maximum, run.history.at(cable.name + ".tension")[row]);
    }
    for (const double force : {hanger, top, bottom})
      numbers.push_back(newton * force);
    rows.push_back(numbers);
  }
  const double reach = metre * 100.0 * fence_span;
  return {{"schema", 3},
          {"title", facts.title},
          {"units", "SI"},
          {"verdict", expected_verdict(run)["fence"]},
          {"quality", run.summary["quality"]},
          {"run",
           {{"outcome", "finished"},
            {"time", facts.steps * facts.step},
            {"integrator", facts.integrator},
            {"step", facts.step},
            {"steps", facts.steps}}},
          {"fence",
           {{"layers", 2},
            {"columns", 2 * columns_of_half - 1},
            {"half_model", true},
            {"span", metre * fence_span},
            {"sag", metre * sag},
            {"spacing", metre * spacing},
            {"bottom_cable", true},
            {"scene_units", units.system},
            {"travel", scaled(metre * travel, 1.0)},
            {"travel_time", run.time(travel_row)}}},
          {"rocks", passages},
          {"layers", layers},
          {"columns", columns},
          {"segments", segments},
          {"anchors", anchors},
          {"events", run.summary["failures"]},
          {"energy",
           {{"start", energies_at(0)},
            {"end", energies_at(last)},
            {"dissipated", dissipated},
            {"balance_error", joule * run.history.at("balance_error.energy")[last]},
            {"scale", joule * energy_scale(run)}}},
          {"drawing",
           {{"ground", {{-reach, metre * ground_top}, {reach, metre * ground_top}}},
            {"column_half_width", metre * column_a},
            {"states", {drawn(run, "start", 0), drawn(run, "largest travel", travel_row), drawn(run, "end", last)}}}},
          {"history", {{"columns", names}, {"rows", rows}}}};
}

Json expected_codes(const Run& run, const std::string& csv) {
  struct Code {
    int number;
    const char *name, *title;
    std::string unit;
  };
  const Units& units = *run.facts.units;
  const std::vector<Code> codes{
      {15, "mass", "ELEMENT MASS", units.mass},
      {16, "inertia", "ELEMENT MASS MOMENT OF INERTIA", units.mass + " " + units.length + "^2"},
      {35, "kinetic_translation", "ELEMENT KINETIC ENERGY (TRANSLATIONAL)", units.energy},
      {36, "kinetic_rotation", "ELEMENT KINETIC ENERGY (ROTATIONAL)", units.energy},
      {37, "kinetic", "ELEMENT KINETIC ENERGY (TOTAL)", units.energy},
      {38, "gravitational", "ELEMENT GRAVITATIONAL ENERGY", units.energy},
      {48, "top_tension", "TENSION IN TOP CABLE", units.force},
      {51, "top_joint_force", "FORCE IN TOP JOINT OF ATTENUATOR", units.force}};
  Json columns = Json::array();
  columns.push_back({{"name", "time"}, {"unit", "s"}, {"values", run.history.values[0]}});
  for (std::size_t i = 1; i < run.facts.bodies.size(); ++i) {
    const Part& body = run.facts.bodies[i];
    const Force hanger = body.layer > 0 ? hanger_force(run, static_cast<int>(i)) : Force{};
    const auto top = std::ranges::find_if(
        run.facts.cables, [&](const Cable& cable) { return cable.top && cable.from.body == static_cast<int>(i); });
    for (const Code& code : codes) {
      if (code.number >= 48 && body.layer == 0) continue;
      Json values = Json::array();
      for (std::size_t row = 0; row < run.rows(); ++row) {
        const double vx = run.of(body, ".vx", row, 0.0), vy = run.of(body, ".vy", row, 0.0),
                     spin = run.of(body, ".spin", row, 0.0);
        const double along = 0.5 * body.mass * (vx * vx + vy * vy), about = 0.5 * body.inertia * spin * spin,
                     weight = body.mass * run.facts.gravity;
        values.push_back(code.number == 15   ? Json(body.mass)
                         : code.number == 16 ? Json(body.inertia)
                         : code.number == 35 ? Json(along)
                         : code.number == 36 ? Json(about)
                         : code.number == 37 ? Json(along + about)
                         : code.number == 38 ? scaled(weight * run.of(body, ".y", row, 0.0), weight)
                         : code.number == 48 ? Json(run.history.at(top->name + ".tension")[row])
                                             : scaled(size(hanger.values[row]), 1e3));
      }
      columns.push_back({{"name", fmt::format("element{}.{}", body.number, code.name)},
                         {"element", body.number},
                         {"code", code.number},
                         {"title", code.title},
                         {"unit", code.unit},
                         {"values", values}});
    }
  }
  // The comments at the head of the CSV file say what is skipped; the program prints it, too.
  Json skipped = Json::array();
  for (std::size_t at = 0; csv.compare(at, 2, "# ") == 0; at = csv.find('\n', at) + 1)
    skipped.push_back(csv.substr(at + 2, csv.find('\n', at) - at - 2));
  return {
      {"schema", 1}, {"title", run.facts.title}, {"units", units.system}, {"skipped", skipped}, {"columns", columns}};
}

}  // namespace talus::verification::problems::agreeing_files
