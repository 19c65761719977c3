#include "verification/problems/program/agreement/expected_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "verification/record/csv.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// Texts of the summary, each of which must be printed; their number is that of the printed lines.
Json all_printed(const Json& texts, const std::string& before, const std::string& lines, std::size_t expected) {
  Json list = Json::array();
  for (const Json& text : texts)
    list.push_back(as_printed(text.get<std::string>(), before, lines));
  while (list.size() < expected)
    list.push_back("a line that was printed");
  return list;
}

Json units_of(const Units& units) {
  return {{"system", units.system},
          {"length", units.length},
          {"time", "s"},
          {"mass", units.mass},
          {"force", units.force},
          {"energy", units.energy},
          {"momentum", units.momentum},
          {"angular_momentum", units.angular_momentum}};
}

/// Minimum, maximum and their first times, over the rows, which are of all steps.
Json extremes_of(const Run& run) {
  Json list = Json::array();
  for (std::size_t i = 1; i < run.history.names.size(); ++i) {
    const std::vector<double>& values = run.history.values[i];
    const auto low = std::ranges::min_element(values) - values.begin(),
               high = std::ranges::max_element(values) - values.begin();
    list.push_back({{"name", run.history.names[i]},
                    {"unit", unit_of(run.history.names[i], *run.facts.units)},
                    {"minimum", values[static_cast<std::size_t>(low)]},
                    {"minimum_time", run.time(static_cast<std::size_t>(low))},
                    {"maximum", values[static_cast<std::size_t>(high)]},
                    {"maximum_time", run.time(static_cast<std::size_t>(high))}});
  }
  return list;
}

Json bodies_of(const Run& run) {
  Json list = Json::array();
  const std::size_t last = run.rows() - 1;
  for (const Part& body : run.facts.bodies) {
    list.push_back({{"name", body.name},
                    {"position", {run.of(body, ".x", last, body.x), run.of(body, ".y", last, body.y)}},
                    {"angle", run.of(body, ".angle", last, body.angle)},
                    {"velocity", {run.of(body, ".vx", last, 0.0), run.of(body, ".vy", last, 0.0)}},
                    {"spin", run.of(body, ".spin", last, 0.0)}});
  }
  return list;
}

double largest_balance_error(const Run& run) {
  double largest = 0.0;
  for (const double error : run.history.at("balance_error.energy"))
    keep_largest(largest, error);
  return largest;
}

Json ledger_of(const Run& run) {
  const std::size_t last = run.rows() - 1;
  Json energy, dissipated;
  for (const std::string& part : energies())
    energy[part] = run.history.at("energy." + part)[last];
  energy["total"] = total(run, "energy", energies(), last);
  for (const std::string& part : mechanisms())
    dissipated[part] = run.history.at("dissipated." + part)[last];
  const Sums sums = sums_of(run, last);
  const auto balance = [&](const char* of) { return run.history.at(std::string("balance_error.") + of)[last]; };
  return {{"energy", energy},
          {"dissipated", dissipated},
          {"energy_balance_error", balance("energy")},
          {"largest_energy_balance_error", largest_balance_error(run)},
          {"energy_scale", energy_scale(run)},
          {"momentum", {scaled(sums.x, sums.momentum_scale), scaled(sums.y, sums.momentum_scale)}},
          {"momentum_balance_error", {balance("momentum_x"), balance("momentum_y")}},
          {"angular_momentum", scaled(sums.angular, sums.angular_scale)},
          {"angular_momentum_balance_error", balance("angular_momentum")}};
}

/// Plastic stretch after a largest tension.
double plastic_stretch(const Cable& cable, double tension) {
  return std::max(0.0, tension - cable.yield) * (1.0 / cable.hardening - 1.0) / cable.stiffness;
}

struct Event {
  double time;
  std::string part, event;
};

/// Cables yield in the first row with at least the elongation of their yield force, and break likewise.
std::vector<Event> events_of(const Run& run) {
  std::vector<Event> events;
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>& elongation = run.history.at(cable.name + ".elongation");
    const auto add = [&](double limit, const char* what) {
      const auto reached = std::ranges::find_if(elongation, [limit](double now) { return now >= limit; });
      if (reached == elongation.end()) return;
      events.push_back({run.time(static_cast<std::size_t>(reached - elongation.begin())),
                        fmt::format("cable '{}'", cable.name), what});
    };
    if (cable.yield < infinite) add(cable.yield / cable.stiffness, "yields");
    if (cable.strength < infinite) add(elongation_at_break(cable), "breaks");
  }
  std::ranges::sort(events, {}, &Event::time);
  return events;
}

/// Modes and plastic stretch at the end.
Json cables_of(const Run& run) {
  Json list = Json::array();
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>&tensions = run.history.at(cable.name + ".tension"),
          &elongations = run.history.at(cable.name + ".elongation");
    const double peak = *std::ranges::max_element(tensions);
    bool broken = false;
    for (const Event& event : events_of(run))
      broken = broken || (event.event == "breaks" && event.part == fmt::format("cable '{}'", cable.name));
    double stretch = broken                  ? plastic_stretch(cable, cable.strength)
                     : cable.hardening > 0.0 ? plastic_stretch(cable, peak)
                     : cable.yield < infinite
                         ? std::max(0.0, *std::ranges::max_element(elongations) - cable.yield / cable.stiffness)
                         : 0.0;
    const bool yields = stretch > 0.0 && tensions.back() == peak;
    list.push_back({{"name", cable.name},
                    {"mode", broken                  ? "broken"
                             : yields                ? "yielding"
                             : tensions.back() > 0.0 ? "taut"
                                                     : "slack"},
                    {"plastic_stretch", scaled(stretch, stretch > 0.0 ? stretch : 1.0)}});
  }
  return list;
}

/// Names of discs that are pushed into each other, or into the ground, by more than 1 % of the smaller radius, without
/// a contact between them; the contacts are named after their bodies.
Json undeclared_overlaps_of(const Run& run) {
  Json pairs = Json::array();
  const std::vector<Part>& bodies = run.facts.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Part &first = bodies[i], &second = bodies[j];
      if (first.shape == Shape::none || second.shape != Shape::circle) continue;
      const bool is_plane = first.shape == Shape::plane;
      const double reach = second.a + (is_plane ? 0.0 : first.a),
                   smaller = is_plane ? second.a : std::min(first.a, second.a);
      const auto is_named = [&](const std::string& a, const std::string& b) {
        return std::ranges::find(run.facts.contacts, a + "-" + b) != run.facts.contacts.end();
      };
      if (is_named(first.name, second.name) || is_named(second.name, first.name)) continue;
      bool overlaps = false;
      for (std::size_t row = 0; row < run.rows(); ++row) {
        const Vector apart = between(run.position(first, 0.0, 0.0, row), run.position(second, 0.0, 0.0, row));
        overlaps = overlaps || reach - (is_plane ? apart[1] : size(apart)) > 0.01 * smaller;
      }
      if (overlaps) pairs.push_back({first.name, second.name});
    }
  }
  return pairs;
}

Json quality_of(const Run& run) {
  const Json& found = run.summary["quality"];
  const double balance = relative_balance_error(run);
  Json json{{"usable", balance < 0.01}, {"flaw", ""}, {"enforced", true}};
  const std::string step = found["step"];
  json["step"] = !run.facts.integrator_step.empty()                         ? run.facts.integrator_step
                 : run.printed.find(" " + step + "; ") != std::string::npos ? step
                                                                            : "as printed";
  json["energy_balance"] = balance;
  if (found.contains("steps_in_shortest_contact")) {
    // The monitor prints four digits.
    const std::string line = "  steps in the shortest contact";
    const std::size_t at = run.printed.find(line);
    const double printed = at == std::string::npos ? 0.0 : std::stod(run.printed.substr(at + line.size()));
    const double steps = found["steps_in_shortest_contact"];
    json["steps_in_shortest_contact"] = std::abs(steps - printed) < 6e-4 * printed ? steps : printed;
  }
  json["last_contact"] = last_contact_of(run);
  if (!run.facts.mirrored) json["undeclared_overlaps"] = undeclared_overlaps_of(run);
  return json;
}

Json outcome_of(const Run& run) { return {{"kind", "finished"}, {"time", run.facts.steps * run.facts.step}}; }

}  // namespace

Vector between(const Vector& a, const Vector& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double size(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Run run_of(const TemporaryFolder& folder, Facts facts, const std::vector<std::string>& more, int exit_code) {
  folder.write(facts.file + ".toml", facts.text);
  std::vector<std::string> arguments{"run", facts.file + ".toml", "--out", facts.file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramEnd end = run_talus(folder, arguments);
  if (end.exit_code != exit_code)
    throw std::runtime_error(fmt::format("the program ended with {}: {}", end.exit_code, end.messages));
  const auto json = [&](const char* name) { return records::read_json(folder.path() / facts.file / name); };
  Run run{.facts = facts,
          .printed = end.output,
          .messages = end.messages,
          .summary = json("summary.json"),
          .state = json("final_state.json"),
          .plot = json("plot.json"),
          .history = Columns{records::read_csv(folder.path() / facts.file / "history.csv")},
          .states = geometry_states(folder, facts.file, facts.file)};
  for (Cable& cable : run.facts.cables) {
    if (cable.stiffness > 0.0) continue;
    const double length = size(between(run.position(cable.from, 0), run.position(cable.to, 0)));
    cable.stiffness = young * (cable.top ? area_top : 2.0 * area_bottom) / length;
    cable.rest = cable.top ? length - run.history.at(cable.name + ".tension")[0] / cable.stiffness : length + slack;
  }
  if (run.facts.step == 0.0) {
    const Part& column = run.body("column1");
    run.facts.step = 2.0 * std::numbers::pi * std::sqrt(column.mass / (2.0 * run.facts.cables.front().stiffness)) /
                     100.0 * run.facts.step_factor;
  }
  return run;
}

Json as_printed(const std::string& text, const std::string& before, const std::string& lines) {
  return lines.find(before + text + "\n") != std::string::npos ? text : fmt::format("not printed after '{}'", before);
}

long printed_number(const std::string& lines, const std::string& before) {
  const std::size_t at = lines.find(before);
  return at == std::string::npos ? -1 : std::stol(lines.substr(at + before.size()));
}

std::string unit_of(const std::string& name, const Units& units) {
  const std::map<std::string, std::string> endings{{"time", "s"},
                                                   {".x", units.length},
                                                   {".y", units.length},
                                                   {".vx", units.length + "/s"},
                                                   {".vy", units.length + "/s"},
                                                   {".angle", "rad"},
                                                   {".spin", "rad/s"},
                                                   {".overlap", units.length},
                                                   {".force", units.force},
                                                   {".elongation", units.length},
                                                   {".tension", units.force},
                                                   {"balance_error.momentum_x", units.momentum},
                                                   {"balance_error.momentum_y", units.momentum},
                                                   {"balance_error.angular_momentum", units.angular_momentum}};
  if (const auto whole = endings.find(name); whole != endings.end()) return whole->second;
  if (name.starts_with("energy.") || name.starts_with("dissipated.") || name == "balance_error.energy")
    return units.energy;
  const auto ending = endings.find(name.substr(std::min(name.rfind('.'), name.size())));
  return ending == endings.end() ? "" : ending->second;
}

const std::vector<std::string>& energies() {
  static const std::vector<std::string> names{"kinetic", "gravity", "applied", "contacts", "cables"};
  return names;
}

const std::vector<std::string>& mechanisms() {
  static const std::vector<std::string> names{"contact_damping", "contact_release", "cable_damping", "cable_release",
                                              "cable_yield",     "cable_break",     "hanger_break",  "friction"};
  return names;
}

std::vector<std::string> expected_columns(const Facts& facts) {
  std::vector<std::string> names{"time"};
  const auto add = [&](const std::string& of, const std::vector<std::string>& quantities) {
    for (const std::string& quantity : quantities)
      names.push_back(of + "." + quantity);
  };
  for (const Part& body : facts.bodies) {
    if (!body.moves) continue;
    add(body.name, {"x", "y", "vx", "vy"});
    if (body.turns) add(body.name, {"angle", "spin"});
  }
  for (const std::string& contact : facts.contacts)
    add(contact, {"overlap", "force"});
  for (const Cable& cable : facts.cables)
    add(cable.name, {"elongation", "tension"});
  add("energy", energies()), add("dissipated", mechanisms()),
      add("balance_error", {"energy", "momentum_x", "momentum_y", "angular_momentum"});
  return names;
}

double total(const Run& run, const std::string& of, const std::vector<std::string>& parts, std::size_t row) {
  double sum = 0.0;
  for (const std::string& part : parts)
    sum += run.history.at(of + "." + part)[row];
  return sum;
}

double energy_scale(const Run& run) {
  double scale = 0.0;
  for (const std::string& name : energies()) {
    const std::vector<double>& values = run.history.at("energy." + name);
    for (const double value : values)
      scale = std::max(scale, std::abs(name == "kinetic" ? value : value - values.front()));
  }
  return scale;
}

Json last_contact_of(const Run& run) {
  const std::string name = run.summary["quality"]["last_contact"]["name"];
  for (std::size_t row = run.rows(); row-- > 0;) {
    bool any = false, named = false;
    for (const std::string& contact : run.facts.contacts) {
      const bool acts =
          run.history.at(contact + ".overlap")[row] > 0.0 || run.history.at(contact + ".force")[row] > 0.0;
      any = any || acts, named = named || (acts && contact == name);
    }
    if (!any) continue;
    const bool touching = row + 1 == run.rows();
    return {
        {"name", named ? name : "one that acts"}, {"time", run.time(touching ? row : row + 1)}, {"touching", touching}};
  }
  return nullptr;
}

double relative_balance_error(const Run& run) { return largest_balance_error(run) / energy_scale(run); }

Sums sums_of(const Run& run, std::size_t row) {
  Sums sums;
  for (const Part& body : run.facts.bodies) {
    if (!body.moves) continue;
    const double m = body.multiplicity * body.mass, inertia = body.multiplicity * body.inertia,
                 x = run.of(body, ".x", row, 0.0), y = run.of(body, ".y", row, 0.0), vx = run.of(body, ".vx", row, 0.0),
                 vy = run.of(body, ".vy", row, 0.0), spin = run.of(body, ".spin", row, 0.0);
    sums.x += m * vx, sums.y += m * vy, sums.angular += m * (x * vy - y * vx) + inertia * spin;
    sums.kinetic += 0.5 * (m * (vx * vx + vy * vy) + inertia * spin * spin);
    sums.gravity += m * run.facts.gravity * y;
    sums.momentum_scale += m * std::hypot(vx, vy);
    sums.angular_scale += m * std::hypot(x, y) * std::hypot(vx, vy) + inertia * std::abs(spin);
    sums.gravity_scale += m * run.facts.gravity * std::abs(y);
  }
  return sums;
}

double elongation_at_break(const Cable& cable) {
  return cable.strength / cable.stiffness + plastic_stretch(cable, cable.strength);
}

Json expected_summary(const Run& run) {
  const Facts& facts = run.facts;
  const auto rows = run.rows();
  Json failures = Json::array();
  for (const Event& event : events_of(run))
    failures.push_back({{"time", event.time}, {"part", event.part}, {"event", event.event}});
  Json json{{"schema", 2},
            {"title", facts.title},
            {"units", units_of(*facts.units)},
            {"outcome", outcome_of(run)},
            {"quality", quality_of(run)},
            {"integrator", facts.integrator},
            {"step", facts.step},
            {"end", facts.steps * facts.step},
            {"steps", facts.steps},
            {"evaluations", facts.steps + 1},
            {"model",
             {{"bodies", facts.bodies.size()},
              {"degrees_of_freedom", facts.degrees_of_freedom},
              {"contacts", facts.contacts.size()},
              {"cables", facts.cables.size()},
              {"law_instances", facts.law_instances}}},
            {"history_rows", rows},
            {"history_rows_cut", 0},
            {"ledger", ledger_of(run)},
            {"extremes", extremes_of(run)},
            {"failures", failures},
            {"bodies", bodies_of(run)}};
  // The monitor's lines are those between two heads.
  const std::size_t head = run.printed.find("run monitor\n");
  const std::string monitor = head == std::string::npos ? "" : run.printed.substr(head);
  json["monitor"] = all_printed(run.summary["monitor"], "\n  ", monitor, count(monitor, "\n  "));
  const std::string warning = "talus: warning: ", note = "note: ";
  json["warnings"] = all_printed(run.summary["warnings"], warning, run.messages + "\n", count(run.messages, warning));
  json["notes"] = all_printed(run.summary["notes"], note, run.printed, count(run.printed, note));
  return json;
}

Json expected_final_state(const Run& run) {
  Json hangers = Json::array();
  for (const std::string& name : run.facts.hangers)
    hangers.push_back({{"name", name}, {"mode", "holds"}, {"plastic_stretch", 0.0}});
  return {{"schema", 2},
          {"title", run.facts.title},
          {"units", units_of(*run.facts.units)},
          {"outcome", outcome_of(run)},
          {"time", run.time(run.rows() - 1)},
          {"bodies", bodies_of(run)},
          {"cables", cables_of(run)},
          {"hangers", hangers}};
}

Json expected_plot(const Run& run) {
  struct Kind {
    std::string name, title, axis, unit;
    std::vector<std::string> parts;  ///< of names of columns: endings, or the whole beginning if it ends with a point
  };
  const Units& units = *run.facts.units;
  const std::vector<Kind> kinds{
      {"positions", "Positions of the centres of mass", "position", units.length, {".x", ".y"}},
      {"angles", "Angles", "angle", "rad", {".angle"}},
      {"velocities", "Velocities", "velocity", units.length + "/s", {".vx", ".vy"}},
      {"spins", "Angular velocities", "angular velocity", "rad/s", {".spin"}},
      {"overlaps", "Overlaps of the contacts", "overlap", units.length, {".overlap"}},
      {"contact_forces", "Contact forces", "force", units.force, {".force"}},
      {"tensions", "Cable tensions", "tension", units.force, {".tension"}},
      {"energies", "Energies", "energy", units.energy, {"energy."}},
      {"dissipation", "Dissipated energy, by mechanism", "energy", units.energy, {"dissipated."}},
      {"energy_balance_error", "Energy balance error", "energy", units.energy, {"balance_error.energy"}}};
  Json figures = Json::array();
  for (const Kind& kind : kinds) {
    Json series = Json::array();
    for (std::size_t i = 1; i < run.history.names.size(); ++i) {
      const std::string& name = run.history.names[i];
      const bool drawn = std::ranges::any_of(
          kind.parts, [&](const std::string& part) { return name.starts_with(part) || name.ends_with(part); });
      if (!drawn || std::ranges::all_of(run.history.values[i], [](double value) { return value == 0.0; })) continue;
      series.push_back({{"label", name}, {"x", "time [s]"}, {"y", run.history.heads[i]}, {"style", "lines"}});
    }
    if (series.empty()) continue;
    figures.push_back({{"name", kind.name},
                       {"title", kind.title},
                       {"caption", fmt::format("{}: {}.", run.facts.title, kind.title)},
                       {"x", {{"label", "time"}, {"unit", "s"}, {"log", false}}},
                       {"y", {{"label", kind.axis}, {"unit", kind.unit}, {"log", false}}},
                       {"csv", "history.csv"},
                       {"series", series},
                       {"slopes", Json::array()},
                       {"lines", Json::array()}});
  }
  Json bodies = Json::array(), cables = Json::array(), histories = Json::array();
  for (std::size_t i = 0; i < run.facts.bodies.size(); ++i) {
    const Part& body = run.facts.bodies[i];
    bodies.push_back({{"name", body.name},
                      {"number", body.number > 0 ? body.number : static_cast<int>(i) + 1},
                      {"kind", body.kind}});
  }
  for (const Cable& cable : run.facts.cables)
    cables.push_back(cable.name);
  if (run.facts.mirrored) histories.push_back(run.facts.file + ".history.csv");
  histories.push_back("history.csv");
  return {
      {"schema", 1},
      {"title", run.facts.title},
      {"units", units.system},
      {"histories", histories},
      {"geometry",
       {{"index", run.facts.file + ".pvd"}, {"bodies", bodies}, {"cables", cables}, {"mirrored", run.facts.mirrored}}},
      {"figures", figures}};
}

std::vector<std::array<double, 2>> outline_of(const Part& body, double reach) {
  std::vector<std::array<double, 2>> points;
  if (body.shape == Shape::plane) return {{-reach, 0.0}, {reach, 0.0}};
  if (body.shape == Shape::box) {
    points = {{body.a, body.b}, {-body.a, body.b}, {-body.a, -body.b}, {body.a, -body.b}};
  } else if (body.shape == Shape::circle) {
    for (int i = 0; i < 96; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 96.0;
      points.push_back({body.a * std::cos(angle), body.a * std::sin(angle)});
    }
  }
  if (!points.empty()) points.push_back(points.front());
  return points;
}

}  // namespace talus::verification::problems::agreeing_files
