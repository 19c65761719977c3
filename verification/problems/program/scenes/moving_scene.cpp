#include "verification/problems/program/scenes/moving_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/motion/damped_oscillator.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::scene_fields {

using records::Json;
using records::Node;

namespace {

/// Constants of the moving scene that occur in several bodies.
constexpr double mass = 2.0, speed = 3.0, stiffness = 200.0, yield = 20.0, end = 0.9;
constexpr double across = 0.75;  // position of the cable of the hung body, and of its hook, across the plane

std::string moving_scene() {
  const auto particle = [](const std::string& name, double x, double y, double vx, double vy, const std::string& more) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"{} kg\"\nposition = [\"{} m\", \"{} m\"]\n"
        "velocity = [\"{} m/s\", \"{} m/s\"]\n{}",
        name, mass, x, y, vx, vy, more);
  };
  double y = 50.0;
  const auto pulled = [&](const std::string& name, const std::string& more, double z = 0.0) {
    y += 5.0;
    const std::string third = z == 0.0 ? "" : fmt::format(", \"{} m\"", z);
    return particle(name, 5.0, y, speed, 0.0, "") +
           fmt::format(
               "[[cable]]\nname = \"of_{0}\"\nlaw = \"elastic_plastic\"\nfrom = {{ point = [\"0 m\", \"{1} m\"{4}] }}\n"
               "to = {{ body = \"{0}\", point = [\"0 m\", \"0 m\"{4}] }}\nrest_length = \"5 m\"\nstiffness = \"{2} "
               "N/m\"\n{3}",
               name, y, stiffness, more, third);
  };
  const std::string circle = "shape = { kind = \"circle\", radius = \"0.5 m\" }\n";
  const std::string limit = fmt::format("yield = \"{} N\"\n", yield);
  const auto on_ground = [](const std::string& name, const std::string& law) {
    return fmt::format("[[contact]]\nname = \"of_{0}\"\nbetween = [\"{0}\", \"ground\"]\nstiffness = \"1000 N/m\"\n{1}",
                       name, law);
  };
  const std::string pressed = circle + "force = [\"0 N\", \"-30 N\"]\n",
                    spring = "law = \"linear_spring_dashpot\"\ndamping = \"0 N s/m\"\nshear_stiffness = \"400 N/m\"\n";
  std::string text =
      "title = \"Bodies with final states in closed form\"\nunits = \"SI\"\n[[body]]\nname = \"ground\"\nmobility = "
      "\"fixed\"\nposition = [\"0 m\", \"0 m\"]\n"
      "shape = { kind = \"half_plane\" }\n";
  text += pulled("hard", limit + "hardening = \"15 N/m\"\n") +
          pulled("table", limit + "table = [[\"0.1 m\", \"23 N\"], [\"0.2 m\", \"24 N\"]]\n") +
          pulled("strong", "strength = \"30 N\"\n") + pulled("torn", limit + "rupture = \"0.12 m\"\n") +
          pulled("hung", "", across) +
          fmt::format(
              "[[hanger]]\nname = \"hook\"\nbody = \"hung\"\npoint = [\"0 m\", \"0 m\", \"{} m\"]\n"
              "strength = \"25 N\"\n",
              across);
  text += particle("dented", 0.0, 0.5, 0.0, -1.5, circle) +
          on_ground("dented", "law = \"latching_spring\"\nunloading_stiffness = \"1500 N/m\"\ngrowth = \"5 1/m\"\n");
  text += particle("stuck", 5.0, 0.47, 0.3, 0.0, pressed) +
          on_ground("stuck", spring + "friction = 0.9\nshear_damping = \"5 N s/m\"\n");
  text += particle("sliding", 15.0, 0.47, 8.0, 0.0, pressed) +
          on_ground("sliding", spring + "friction = 0.35\nshear_damping = \"0 N s/m\"\n");
  return text + fmt::format(
                    "[run]\nintegrator = \"stormer_cowell\"\ntolerance = 1e-12\nstep = \"0.02 s\"\nend = \"{} "
                    "s\"\nledger = \"off\"\n",
                    end);
}

/// Yield force after plastic elongations, constant after the last.
class YieldCurve {
 public:
  explicit YieldCurve(std::vector<std::pair<double, double>> points) : points_{std::move(points)} {}
  double force(double stretch) const {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const auto [x0, f0] = points_[i - 1];
      const auto [x1, f1] = points_[i];
      if (stretch <= x1) return f0 + (f1 - f0) * (stretch - x0) / (x1 - x0);
    }
    return points_.back().second;
  }
  /// Energy of a cable yielding at this stretch: plastic work and elastic energy.
  double energy(double stretch) const {
    double work = std::max(0.0, stretch - points_.back().first) * points_.back().second;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double from = points_[i - 1].first, to = std::min(stretch, points_[i].first);
      if (to > from) work += 0.5 * (to - from) * (force(from) + force(to));
    }
    return work + 0.5 * force(stretch) * force(stretch) / stiffness;
  }
  /// The stretch at which a cable has stopped this kinetic energy.
  double stretch(double kinetic) const {
    double low = 0.0, high = kinetic / points_.front().second;
    for (int n = 0; n < 100; ++n) {
      const double middle = 0.5 * (low + high);
      (energy(middle) < kinetic ? low : high) = middle;
    }
    return low;
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

/// Names and values of the final state with closed forms: plastic elongations of cables, positions and velocities.
std::map<std::string, double> final_values(const Written& of, const Setup& setup) {
  std::map<std::string, double> values;
  const double kinetic = 0.5 * mass * speed * speed;
  const double hardening = setup.has("no_hardening") ? 0.0 : of("of_hard.hardening");
  values["of_hard"] = YieldCurve{{{0.0, yield}, {1.0, yield + hardening}}}.stretch(kinetic);
  values["of_table"] = YieldCurve{{{0.0, yield},
                                   {of("of_table.table[0][0]"), of("of_table.table[0][1]")},
                                   {of("of_table.table[1][0]"), of("of_table.table[1][1]")}}}
                           .stretch(kinetic);
  const auto after = [&](double energy) { return std::sqrt(speed * speed - 2.0 * energy / mass); };
  const auto elastic = [&](double force) { return 0.5 * force * force / stiffness; };
  values["of_torn"] = of("of_torn.rupture");
  values["torn.vx"] = after(yield * of("of_torn.rupture") + elastic(yield));
  values["strong.vx"] = after(elastic(of("of_strong.strength")));
  values["hung.vx"] = after(elastic(of("hook.strength")));
  {  // The unloading stiffness grows with the largest force.
    const double k = of("of_dented.stiffness"), approach = of("dented.velocity[1]");
    const double largest = std::abs(approach) * std::sqrt(mass / k);
    values["dented.vy"] =
        -approach * std::sqrt(k / (of("of_dented.unloading_stiffness") + of("of_dented.growth") * k * largest));
  }
  const double shear = of("of_stuck.shear_stiffness"), frequency = std::sqrt(shear / mass);
  values["stuck.x"] =
      of("stuck.position[0]") +
      reference::state_at(
          {frequency, of("of_stuck.shear_damping") / (2.0 * mass * frequency), 0.0, of("stuck.velocity[0]")}, end)
          .displacement;
  // The disc sticks until its spring has the force of friction.
  const double friction = -of("of_sliding.friction") * of("sliding.force[1]"), start = of("sliding.velocity[0]");
  const double stuck = friction / shear, time = std::asin(stuck * frequency / start) / frequency;
  const double slips = std::sqrt(start * start - shear / mass * stuck * stuck), sliding = end - time;
  values["sliding.vx"] = slips - friction / mass * sliding;
  values["sliding.x"] = of("sliding.position[0]") + stuck + slips * sliding - 0.5 * friction / mass * sliding * sliding;
  return values;
}

/// Yielding and breaking parts with the output at which this is found, in the order of the summary.
std::vector<std::tuple<double, std::string, std::string>> expected_events(const Written& of) {
  const double frequency = std::sqrt(stiffness / mass), interval = of("run.step");
  const auto reached = [&](double force) { return std::asin(force * frequency / (stiffness * speed)) / frequency; };
  const auto found = [&](double time) { return interval * std::ceil(time / interval); };
  // The torn cable elongates at constant force: v t - F t^2/(2 m) = rupture.
  const double slower = std::sqrt(speed * speed - yield * yield / (stiffness * mass)), slowing = yield / mass;
  const double torn =
      reached(yield) + (slower - std::sqrt(slower * slower - 2.0 * slowing * of("of_torn.rupture"))) / slowing;
  std::vector<std::tuple<double, std::string, std::string>> events{
      {found(reached(of("of_strong.strength"))), "cable 'of_strong'", "breaks"},
      {found(reached(of("hook.strength"))), "hanger 'hook'", "breaks"},
      {found(torn), "cable 'of_torn'", "breaks"}};
  for (const char* const name : {"hard", "table", "torn"})
    events.emplace_back(found(reached(yield)), fmt::format("cable 'of_{}'", name), "yields");
  std::ranges::sort(events);
  return events;
}

/// Number of states of the geometry in which the end of the hung body's cable has another body than the hung body until
/// its hook breaks, or than none, -1, afterwards. At least one state of either kind is required.
double wrong_ends(const TemporaryFolder& folder, const Node& state, const Written& of) {
  const auto index_of = [](const std::vector<Node>& list, const char* name) {
    const auto found = std::ranges::find_if(list, [&](const Node& node) { return node.at("name").text() == name; });
    return static_cast<double>(found - list.begin());
  };
  const double body = index_of(state.at("bodies").list(), "hung"),
               cable = index_of(state.at("cables").list(), "of_hung");
  const double frequency = std::sqrt(stiffness / mass),
               breaks = std::asin(of("hook.strength") * frequency / (stiffness * speed)) / frequency;
  double wrong = 0.0, before = 0.0, after = 0.0;
  for (const auto& [time, text] : geometry_states(folder, "moving", "moving")) {
    const std::vector<double> cables = data_array(text.substr(text.find("<CellData>")), "cable"),
                              bodies = data_array(text.substr(text.find("<PointData>")), "body"),
                              offsets = data_array(text, "offsets");
    const auto line = static_cast<std::size_t>(std::ranges::find(cables, cable) - cables.begin());
    const double expected = time < breaks ? body : -1.0;
    (time < breaks ? before : after) += 1.0;
    wrong += bodies.at(static_cast<std::size_t>(offsets.at(line)) - 1) == expected ? 0.0 : 1.0;
  }
  return before > 0.0 && after > 0.0 ? wrong : std::nan("");
}

void check_events(const TemporaryFolder& folder, const Node& summary, const Node& state, const Written& of,
                  Findings& findings) {
  std::vector<std::tuple<double, std::string, std::string>> events;
  for (const Node& event : summary.at("failures").list())
    events.emplace_back(event.at("time").number(), event.at("part").text(), event.at("event").text());
  std::ranges::sort(events);
  const auto expected = expected_events(of);
  double wrong = std::abs(static_cast<double>(events.size()) - static_cast<double>(expected.size()));
  for (std::size_t i = 0; i < std::min(events.size(), expected.size()); ++i) {
    const auto& [time, part, event] = events[i];
    const auto& [exact, of_part, of_event] = expected[i];
    wrong += std::abs(time - exact) < 1e-12 && part == of_part && event == of_event ? 0.0 : 1.0;
  }
  for (const Node& cable : state.at("cables").list()) {
    const std::string name = cable.at("name").text();
    wrong += (cable.at("mode").text() == "broken") == (name == "of_strong" || name == "of_torn") ? 0.0 : 1.0;
  }
  const std::vector<Node> hangers = state.at("hangers").list();
  const bool broken = hangers.size() == 1 && hangers[0].at("name").text() == "hook" &&
                      hangers[0].at("mode").text() == "broken" && hangers[0].at("plastic_stretch").number() == 0.0;
  wrong += broken ? 0.0 : 1.0;
  wrong += wrong_ends(folder, state, of);
  const Json units{{"system", "SI"}, {"length", "m"},   {"time", "s"},       {"mass", "kg"},
                   {"force", "N"},   {"energy", "N m"}, {"momentum", "N s"}, {"angular_momentum", "N m s"}};
  wrong += state.at("units").json() == units && summary.at("units").json() == units ? 0.0 : 1.0;
  for (const Node& file : {summary, state}) {
    const Node outcome = file.at("outcome");
    wrong += outcome.at("kind").text() == "finished" && std::abs(outcome.at("time").number() - end) < 1e-12 ? 0.0 : 1.0;
    wrong += file.at("title").text() == "Bodies with final states in closed form" ? 0.0 : 1.0;
  }
  findings.expect("yielding and breaking parts, modes, ends of a broken hanger, units, title and end that differ",
                  wrong, 0.0,
                  Tolerance::exact("the next output after the closed form's time, rounded by less than 1e-12 s"));
}

/// Columns of the moving scene beside the final state and laws: every body, contact and cable.
void check_columns(const records::Csv& history, const std::map<std::string, double>& found, const Written& of,
                   Findings& findings) {
  double last = 0.0, laws = 0.0, compared = 0.0;
  const std::size_t rows = history.rows();
  const auto at = [&](std::size_t row, const std::string& column) { return history.number(row, column); };
  for (const std::string& body : of.bodies()) {
    if (body == "ground") continue;
    for (const auto& [part, unit] :
         {std::pair{"x", "m"}, std::pair{"y", "m"}, std::pair{"vx", "m/s"}, std::pair{"vy", "m/s"}}) {
      const std::string name = fmt::format("{}.{}", body, part);
      keep_worst(last, at(rows - 1, fmt::format("{} [{}]", name, unit)) - found.at(name)), ++compared;
    }
    const bool pulled = body != "dented" && body != "stuck" && body != "sliding";
    compared += 2.0;
    for (std::size_t row = 0; row < rows; ++row) {
      const double x = at(row, body + ".x [m]"), y = at(row, body + ".y [m]");
      if (pulled) {
        const double elongation = at(row, fmt::format("of_{}.elongation [m]", body));
        // A broken cable, or one without its hanger, is not followed.
        if (elongation != 0.0 && body != "strong" && body != "torn" && body != "hung")
          keep_worst(laws, elongation - (x - 5.0));
        if (row < 2) keep_worst(laws, elongation - (x - 5.0));
        if (row < 2) keep_worst(laws, at(row, fmt::format("of_{}.tension [N]", body)) / stiffness - elongation);
      } else {
        const double overlap = at(row, fmt::format("of_{}.overlap [m]", body)), vy = at(row, body + ".vy [m/s]");
        keep_worst(laws, overlap - (0.5 - y));
        if (body == "dented" && vy >= 0.0) continue;  // K2
        keep_worst(laws,
                   at(row, fmt::format("of_{}.force [N]", body)) / of(fmt::format("of_{}.stiffness", body)) - overlap);
      }
    }
  }
  findings.expect("history of the moving scene: columns that are not compared",
                  static_cast<double>(history.header().size()) - 1.0 - compared, 0.0,
                  Tolerance::exact("four of each body, two of each contact and cable"));
  findings.expect("history of the moving scene: last row beside the final state, largest difference", last, 0.0,
                  Tolerance::exact("the same numbers"));
  findings.expect(
      "history of the moving scene: overlaps, elongations and linear forces over stiffness, largest error", laws, 0.0,
      Tolerance::round_off(1e-14, "differences of positions up to 16 m, rounded to 1.8e-15 m, thrice"), "m");
}

}  // namespace

void check_moving(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const std::string text = moving_scene();
  folder.write("moving.toml", text);
  (void)talus_output(folder, {"run", "moving.toml", "--out", "moving", "--frames", "9"});
  const Json state = records::read_json(folder.path() / "moving/final_state.json"),
             summary = records::read_json(folder.path() / "moving/summary.json");
  std::map<std::string, double> found;
  for (const Node& body : Node{state, "final_state.json"}.at("bodies").list()) {
    const std::string name = body.at("name").text();
    for (const std::size_t i : {0u, 1u}) {
      found[name + (i == 0 ? ".x" : ".y")] = body.at("position").list().at(i).number();
      found[name + (i == 0 ? ".vx" : ".vy")] = body.at("velocity").list().at(i).number();
    }
  }
  for (const Node& cable : Node{state, "final_state.json"}.at("cables").list())
    found[cable.at("name").text()] = cable.at("plastic_stretch").number();
  double worst = 0.0;
  for (const auto& [name, value] : final_values(Written{text}, setup))
    keep_worst(worst, found.at(name) - value);
  findings.expect(
      "final state: plastic elongations, positions and velocities, largest error", worst, 0.0,
      Tolerance::truncation(1e-11, 1.0, "the error that the integrator accepts, 1e-12 of distances up to 8 m"));
  check_columns(records::read_csv(folder.path() / "moving/history.csv"), found, Written{text}, findings);
  check_events(folder, Node{summary, "summary.json"}, Node{state, "final_state.json"}, Written{text}, findings);
  findings.expect_true("no balance in the summary", summary.at("ledger") == "off", "none is requested");
}

}  // namespace talus::verification::problems::scene_fields
