#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "verification/problems/program/files/impact_rows.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::impact_table {

std::vector<Row> rows_of(const records::Csv& table) {
  std::vector<Row> rows(table.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < table.header().size(); ++c) {
      const std::string& head = table.header()[c];
      const std::string text{table.cell(i, c)};
      if (head == "contact") rows[i].contact = text;
      if (head == "body_a") rows[i].body_a = text;
      if (head == "body_b") rows[i].body_b = text;
      if (head == "contact" || head.starts_with("body_")) continue;
      rows[i].numbers[head.substr(0, head.find(' '))] =
          text.empty() ? std::numeric_limits<double>::quiet_NaN() : table.number(i, c);
    }
  }
  return rows;
}

namespace {

constexpr double weight = 10.0, yard_end = 0.5, yard_step = 5e-5;

/// A box that turns and is nearly level in the first state in which its lower corners overlap the ground: the left one
/// by 2.4e-5 m, the right one by 1.6e-5 m. In the state before, neither overlaps. Another box is its mirror image.
constexpr int tipped_state = 20;
constexpr double tipped_speed = 1.0, tipped_spin = 0.5, tipped_time = tipped_state * yard_step, tipped_angle = 1e-5,
                 box_width = 0.4, box_height = 0.25,
                 tipped_y = box_height - 2e-5 + tipped_speed * tipped_time + 0.5 * weight * tipped_time * tipped_time;

/// Undamped contacts with friction, in steps of equal length: the trapezoidal sum of the forces at the states is the
/// momentum that velocity Verlet adds.
std::string yard_text(const Setup& setup) {
  std::string text = fmt::format(R"(
title = "Impacts in a yard"
units = "SI"
gravity = ["0 m/s^2", "-{} m/s^2"]

[[body]]
name = "left"
mobility = "free"
mass = "2 kg"
inertia = "0.3 kg m^2"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["-0.51 m", "5 m"]
velocity = ["3 m/s", "0.5 m/s"]
spin = "4 rad/s"

[[body]]
name = "right"
mobility = "free"
mass = "1 kg"
inertia = "0.1 kg m^2"
shape = {{ kind = "circle", radius = "0.4 m" }}
position = ["0.41 m", "5.3 m"]
velocity = ["-1 m/s", "0 m/s"]

[[body]]
name = "hopper"
mobility = "particle"
mass = "1 kg"
shape = {{ kind = "circle", radius = "0.25 m" }}
position = ["4 m", "0.251 m"]
velocity = ["1 m/s", "-0.5 m/s"]

[[body]]
name = "sleeper"
mobility = "free"
mass = "1 kg"
inertia = "0.1 kg m^2"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["8 m", "{} m"]

[[body]]
name = "box"
mobility = "free"
mass = "3 kg"
inertia = "0.5 kg m^2"
shape = {{ kind = "rectangle", half_width = "0.4 m", half_height = "0.25 m" }}
position = ["12 m", "0.3 m"]
velocity = ["0 m/s", "-1 m/s"]

[[body]]
name = "ground"
mobility = "fixed"
shape = {{ kind = "half_plane" }}
position = ["0 m", "0 m"]
)",
                                 weight, 0.5 - weight / 1e6);
  for (const auto& [name, sign] : {std::pair{"tipped", 1.0}, {"mirrored", -1.0}})
    text += fmt::format(R"(
[[body]]
name = "{}"
mobility = "free"
mass = "3 kg"
inertia = "0.5 kg m^2"
shape = {{ kind = "rectangle", half_width = "{} m", half_height = "{} m" }}
position = ["{} m", "{} m"]
velocity = ["0 m/s", "-{} m/s"]
angle = "{} rad"
spin = "{} rad/s"
)",
                        name, box_width, box_height, sign * 16.0, tipped_y, tipped_speed,
                        sign * (tipped_angle - tipped_spin * tipped_time), sign * tipped_spin);
  const auto contact = [&](const char* name, const char* between, const char* method) {
    text += fmt::format(R"(
[[contact]]
name = "{}"
between = [{}]
law = "linear_spring_dashpot"
method = "{}"
stiffness = "1e6 N/m"
damping = "{} N s/m"
friction = 0.3
shear_stiffness = "5e5 N/m"
shear_damping = "0 N s/m"
)",
                        name, between, method, setup.has("damped_yard") ? 50.0 : 0.0);
  };
  contact("pair", R"("left", "right")", "resultant");
  contact("hops", R"("ground", "hopper")", "resultant");
  contact("rest", R"("sleeper", "ground")", "resultant");
  contact("landing", R"("ground", "box")", "nodes");
  contact("tipping", R"("tipped", "ground")", "nodes");
  contact("mirrored tipping", R"("mirrored", "ground")", "nodes");
  return text + fmt::format(R"(
[run]
integrator = "velocity_verlet"
step = "{} s"
end = "{} s"
)",
                            yard_step, yard_end);
}

}  // namespace

void check_yard(Findings& findings, const Setup& setup) {
  const TemporaryFolder folder;
  folder.write("yard.toml", yard_text(setup));
  (void)talus_output(folder, {"run", "yard.toml", "--impacts", "--out", "yard"});
  const std::vector<Row> rows = rows_of(records::read_csv(folder.path() / "yard/impacts.csv"));
  const records::Json json = records::read_json(folder.path() / "yard/final_state.json");
  const records::Node state{json, "final_state.json"};
  const double end = state.at("time").number();
  struct Start {
    const char* name;
    double mass, vx, vy;
  };
  double worst = 0.0;
  for (const Start& body :
       {Start{"left", 2.0, 3.0, 0.5}, Start{"right", 1.0, -1.0, 0.0}, Start{"hopper", 1.0, 1.0, -0.5},
        Start{"sleeper", 1.0, 0.0, 0.0}, Start{"box", 3.0, 0.0, -1.0}, Start{"tipped", 3.0, 0.0, -tipped_speed},
        Start{"mirrored", 3.0, 0.0, -tipped_speed}}) {
    double x = 0.0, y = 0.0, size = 1.0;
    for (const Row& row : rows) {
      const double sign = row.body_b == body.name ? 1.0 : row.body_a == body.name ? -1.0 : 0.0;
      x += sign * row["impulse_x"], y += sign * row["impulse_y"];
      if (sign != 0.0) size += row["normal_impulse"];
    }
    const std::vector<records::Node> bodies = state.at("bodies").list();
    const auto found =
        std::ranges::find_if(bodies, [&](const records::Node& node) { return node.at("name").text() == body.name; });
    const std::vector<records::Node> velocity = found->at("velocity").list();
    keep_worst(worst, (body.mass * (velocity.at(0).number() - body.vx) - x) / size);
    keep_worst(worst, (body.mass * (velocity.at(1).number() - body.vy + weight * end) - y) / size);
  }
  findings.expect("impulses less the change of momentum, over the sum of impulses, largest", worst, 0.0,
                  Tolerance::round_off(1e-11,
                                       "velocity Verlet adds h F in each state, and half of it in the first and the "
                                       "last: the trapezoidal rule. 10,000 additions of numbers of up to 10 N s, each "
                                       "rounded to 1e-15"));
  // The hopper leaves with the speed of its approach: flights of 2 v/g, and contacts d'' = g - w^2 d.
  const double speed = std::sqrt(0.25 + 2.0 * weight * 0.001), w = 1000.0;
  const double contact = (std::numbers::pi + 2.0 * std::atan(weight / (w * speed))) / w;
  const double period = 2.0 * speed / weight + contact, first = (speed - 0.5) / weight;
  std::map<std::string, std::vector<Row>> of;
  for (const Row& row : rows)
    of[row.contact].push_back(row);
  findings.expect("impacts of a hopper", static_cast<double>(of["hops"].size()),
                  1.0 + std::floor((yard_end - first) / period),
                  Tolerance::exact("one in each period of flight and contact, without loss"));
  double touches = 0.0;
  for (std::size_t i = 0; i < of["hops"].size(); ++i)
    keep_worst(touches, of["hops"][i]["touch_time"] - first - period * static_cast<double>(i));
  findings.expect("touches of the hopper, largest error", touches, 0.0,
                  Tolerance::truncation(0.5 * (2.0 * speed / weight) * std::pow(w * yard_step, 2), 1.0,
                                        "four flights, before each of which velocity Verlet leaves the contact with a "
                                        "speed that is wrong by at most (w h)^2/8"),
                  "s");
  double numbering = 0.0, order = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    numbering += rows[i]["number"] != static_cast<double>(i + 1);
    order += i > 0 && rows[i]["touch_time"] < rows[i - 1]["touch_time"] - yard_step;
  }
  findings.expect("rows out of number or order", numbering + order, 0.0,
                  Tolerance::exact("numbered from 1 in the order in which the impacts begin"));
  const records::Json summary = records::read_json(folder.path() / "yard/summary.json");
  const records::Json& impacts = summary.at("impacts");
  constexpr std::size_t listed = 5;
  std::vector<Row> by_force = rows;
  std::ranges::stable_sort(by_force, std::greater{}, [](const Row& row) { return row["peak_force"]; });
  double other = impacts.at("count").get<std::size_t>() == rows.size() && rows.size() > listed ? 0.0 : 1.0;
  other += impacts.at("largest").size() == listed ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min({listed, rows.size(), impacts.at("largest").size()}); ++i)
    other += impacts.at("largest").at(i).at("number").get<double>() == by_force[i]["number"] ? 0.0 : 1.0;
  findings.expect("summary of more impacts than it lists: count and numbers of the largest that differ", other, 0.0,
                  Tolerance::exact("it counts all rows of the table, and lists the five of the largest forces"));
  const std::vector<Row>&rest = of["rest"], &landing = of["landing"];
  const bool lasting = rest.size() == 1 && rest[0]["from_start"] == 1.0 && rest[0]["ended"] == 0.0 &&
                       rest[0]["touch_time"] == 0.0 && std::isnan(rest[0]["separation_time"]) &&
                       std::isnan(rest[0]["separation_speed"]) && std::isnan(rest[0]["slip_after"]) &&
                       std::isnan(rest[0]["restitution"]);
  findings.expect_true("a body at rest: one row without an end", lasting,
                       "it touches at the start and at the end of the run; what has not happened is an empty cell");
  findings.expect("impulse of the body at rest over its weight", rest.at(0)["normal_impulse"] / (weight * end), 1.0,
                  Tolerance::round_off(1e-9, "overlap and weight balance to the rounding of 0.49999 m: 1e-11 of it"));
  // Both nodes act together, with 2 k.
  const double struck = std::sqrt(1.0 + 2.0 * weight * 0.05), frequency = std::sqrt(2e6 / 3.0);
  const double flight = 2.0 * struck / weight + std::numbers::pi / frequency, rest_force = 3.0 * weight;
  findings.expect("impacts of a box that lands flat on two nodes", static_cast<double>(landing.size()),
                  1.0 + std::floor((yard_end - (struck - 1.0) / weight) / flight),
                  Tolerance::exact("one for both nodes, in each period of flight and contact"));
  findings.expect("largest force on the box", landing.at(0)["peak_force"],
                  rest_force + std::hypot(rest_force, struck * std::sqrt(2e6 * 3.0)),
                  Tolerance::truncation(
                      0.125 * std::pow(frequency * yard_step, 2), 1.0,
                      "half a step from the maximum at most: (w h)^2/8 of it. The force of one node is half of it")
                      .relative());
  // The speed of the left corner in the state before; the right one is slower by 0.4 m/s.
  const double fall = tipped_speed + weight * (tipped_time - yard_step),
               arm = box_width * std::cos(tipped_angle) - box_height * std::sin(tipped_angle);
  findings.expect(
      "approach speed of a turning box at the deeper of two nodes", of["tipping"].at(0)["approach_speed"],
      fall + tipped_spin * arm,
      Tolerance::round_off(1e-14,
                           "twenty steps that each round a speed of 1 m/s by 1.1e-16, an arm from positions "
                           "of 16 m, rounded to 1.8e-15 m, times the spin"),
      "m/s");
  double mirrored = 0.0;
  for (const auto& [column, sign] : {std::pair{"touch_time", 1.0},
                                     {"approach_speed", 1.0},
                                     {"separation_time", 1.0},
                                     {"separation_speed", 1.0},
                                     {"slip_before", -1.0},
                                     {"slip_after", -1.0},
                                     {"normal_impulse", 1.0},
                                     {"tangential_impulse", -1.0}})
    keep_worst(mirrored, of["mirrored tipping"].at(0)[column] - sign * of["tipping"].at(0)[column]);
  findings.expect(
      "first impact of the mirror image of a turning box, largest difference from that of the box", mirrored, 0.0,
      Tolerance::round_off(1e-11,
                           "the same numbers but for the order of the two nodes in sums; some hundred steps "
                           "of a contact whose overlaps of 1e-5 m are rounded to 1e-17 m"));
}

}  // namespace talus::verification::problems::impact_table
