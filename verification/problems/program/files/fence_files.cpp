#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fence_files {
namespace {

using records::Csv;
using records::Json;
using records::Node;
using Vector = std::array<double, 3>;

// International foot and avoirdupois pound, exact by definition (1959), and standard gravity.
constexpr double metre = 0.3048, newton = 0.45359237 * 9.80665, kilogram = newton / metre, joule = newton * metre;

/// The scene of Table 2 with its spin in revolutions per minute.
std::string scene_text(const Setup& setup) {
  std::string text = records::read_whole(case_file("fence/table_2.toml"));
  replace(text, "spin = \"34 rad/s\"", fmt::format("spin = \"{} rpm\"", 34.0 * 30.0 / std::numbers::pi));
  if (setup.has("slower_rock")) replace(text, "-65 ft/s", "-64.99 ft/s");
  return text;
}

/// Largest difference a - b of two lists, relative to the largest |b|.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i)
    scale = std::max(scale, std::abs(b[i])), keep_worst(largest, a.at(i) - b[i]);
  return largest / scale;
}

double size(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// The force on an anchor at each state of the geometry: sum of the tensions of the cables that end there, each towards
/// its other end [N].
struct AnchorForces {
  std::vector<double> times;
  std::vector<Vector> forces;
};
AnchorForces anchor_forces(const TemporaryFolder& folder, const Vector& anchor, const Setup& setup) {
  const double sign = setup.has("cable_pushes") ? -1.0 : 1.0;
  AnchorForces found;
  for (const auto& [time, text] : geometry_states(folder, "out", "fence")) {
    const std::vector<double> points = data_array(text, "Points"), offsets = data_array(text, "offsets"),
                              cables = data_array(text, "cable"), tensions = data_array(text, "tension");
    Vector force{};
    for (std::size_t line = 1; line < cables.size(); ++line) {
      if (cables[line] < 0.0) continue;
      const auto point = [&](double i) {
        const auto first = 3 * static_cast<std::size_t>(i);
        return Vector{metre * points.at(first), metre * points.at(first + 1), metre * points.at(first + 2)};
      };
      const Vector begin = point(offsets[line - 1]), end = point(offsets[line] - 1.0);
      for (const auto& [here, there] : {std::pair{begin, end}, std::pair{end, begin}}) {
        const auto off = [](const Vector& a, const Vector& b) { return Vector{b[0] - a[0], b[1] - a[1], b[2] - a[2]}; };
        if (size(off(here, anchor)) > 1e-9) continue;
        const Vector along = off(here, there);
        for (std::size_t i = 0; i < 3; ++i)
          force[i] += sign * newton * tensions[line] * along[i] / size(along);
      }
    }
    found.times.push_back(time);
    found.forces.push_back(force);
  }
  return found;
}

void check_rock(const Node& sheet, const Csv& history, const Csv& codes, Findings& findings) {
  const Node rock = sheet.at("rocks").list().at(0);
  const double mass = rock.at("mass").number() / kilogram;
  const auto vx = column(codes, "element2.vx"), vy = column(codes, "element2.vy"),
             spin = column(codes, "element2.omega");
  const auto along = column(codes, "element2.kinetic_translation"), about = column(codes, "element2.kinetic_rotation");
  std::vector<double> translation, inertia, constant;
  for (std::size_t i = 0; i < vx.size(); ++i) {
    translation.push_back(0.5 * mass * (vx[i] * vx[i] + vy[i] * vy[i]));
    inertia.push_back(2.0 * about[i] / (spin[i] * spin[i])), constant.push_back(inertia.front());
  }
  const Tolerance round_off = Tolerance::round_off(1e-13, "about ten roundings, in 17 digits");
  findings.expect("history of the deck: energy of translation, largest error", largest_difference(along, translation),
                  0.0, round_off);
  findings.expect("history of the deck: moment of inertia from the energy of rotation, largest change",
                  largest_difference(inertia, constant), 0.0, round_off);
  findings.expect(
      "history of the deck: energy of the rock at the start over that of the energy balance",
      (along.front() + about.front()) / column(history, "energy.kinetic").front(), 1.0,
      Tolerance::round_off(1e-7, "only the rock moves; half a step's kick sets the column that it touches in motion"));
  findings.expect("sheet: velocity of the rock at the end",
                  rock.at("end_velocity").list().at(0).number() / (metre * column(history, "rock.vx").back()), 1.0,
                  round_off);
  findings.expect("sheet: energy of the rock at the end",
                  rock.at("end_energy").number() / (joule * (along.back() + about.back())), 1.0, round_off);
  findings.expect("sheet: velocity of approach", rock.at("approach_velocity").list().at(0).number(), -65.0 * metre,
                  round_off, "m/s");
  findings.expect("sheet: spin of approach, given in revolutions per minute", rock.at("approach_spin").number(), 34.0,
                  round_off, "rad/s");
  findings.expect(
      "sheet: energy of approach",
      rock.at("approach_energy").number() / (0.5 * joule * (mass * 65.0 * 65.0 + inertia.front() * 34.0 * 34.0)), 1.0,
      round_off);
}

/// Columns of elements 3 to 6 in the history by codes against those of their bodies, columns 1 to 4.
void check_elements(const Csv& history, const Csv& codes, Findings& findings) {
  double differing = 0.0;
  for (int element = 3; element <= 6; ++element) {
    const std::string of_element = fmt::format("element{}.", element), number = fmt::to_string(element - 2);
    for (const auto& [code, quantity] :
         {std::pair{"vx", "column" + number + ".vx"}, std::pair{"vy", "column" + number + ".vy"},
          std::pair{"omega", "column" + number + ".spin"}, std::pair{"top_tension", "top" + number + ".tension"},
          std::pair{"bottom_tension", "bottom" + number + ".tension"}})
      differing += column(codes, of_element + code) == column(history, quantity) ? 0.0 : 1.0;
  }
  findings.expect("history of the deck: columns of four elements that differ from those of their bodies and cables",
                  differing, 0.0, Tolerance::exact("the same numbers, written twice"));
}

void check_fence(const Node& sheet, const Csv& history, Findings& findings) {
  const std::vector<double> x = column(history, "column1.x"), tension = column(history, "top1.tension");
  double travel = 0.0;
  for (const double at : x)
    travel = std::max(travel, metre * std::abs(at - x.front()));
  findings.expect("sheet: travel of the central column over the largest in the history",
                  sheet.at("columns").list().at(0).at("travel").number() / travel, 1.0,
                  Tolerance::round_off(1e-13, "the travel is largest at the end, which has a row"));
  findings.expect_between(
      "sheet: largest tension of the first segment over the largest in the history",
      sheet.at("segments").list().at(0).at("peak").number() / (newton * *std::ranges::max_element(tension)),
      1.0 - 1e-13, 1.011,
      "the rows next to the largest value are lower by 1.1 %: between two rows the tension rises by less");
}

void check_anchor(const TemporaryFolder& folder, const Node& sheet, Findings& findings, const Setup& setup) {
  const Node anchor = sheet.at("anchors").list().at(0);
  const auto vector = [](const Node& node) {
    const std::vector<Node> list = node.list();
    return Vector{list.at(0).number(), list.at(1).number(), list.at(2).number()};
  };
  const AnchorForces found = anchor_forces(folder, vector(anchor.at("position")), setup);
  // Trapezoidal rule over every state (1) or every other state (2).
  const auto impulse = [&](std::size_t every) {
    Vector sum{};
    for (std::size_t n = every; n < found.times.size(); n += every) {
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += 0.5 * (found.times[n] - found.times[n - every]) * (found.forces[n][i] + found.forces[n - every][i]);
    }
    return sum;
  };
  const Vector recorded = vector(anchor.at("force").at("impulse")), fine = impulse(1), coarse = impulse(2);
  double worst = 0.0, allowed = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    keep_worst(worst, fine[i] / recorded[i] - 1.0), keep_worst(allowed, (coarse[i] - fine[i]) / recorded[i]);
  findings.expect(
      "sheet: impulse of the anchor from the states of the geometry, largest error of three components", worst, 0.0,
      Tolerance::truncation(std::abs(allowed), 1.0,
                            "trapezoidal rule with 101 states compared with 100,001 in the run: its error falls by a "
                            "factor of four if the number of states is doubled, so that the results with all states "
                            "and with every other state differ by three times the error"));
  std::vector<double> sizes;
  for (const Vector& force : found.forces)
    sizes.push_back(size(force));
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  const double before = peak > 0 ? sizes[peak - 1] : sizes[peak], after = sizes[std::min(peak + 1, sizes.size() - 1)];
  findings.expect_between("sheet: largest force of the anchor over the largest of the states of the geometry",
                          anchor.at("force").at("peak").number() / sizes[peak], 1.0 - 1e-13,
                          2.0 - std::min(before, after) / sizes[peak],
                          "between two states the force exceeds both by less than it falls to the next state");
}

/// The sample fence with contacts by resultants and a top cable that yields, and a second rock whose numbers all
/// differ. Away from the fence, it is held in y and turns about its fixed point.
std::string numbered_text() {
  std::string text = records::read_whole(case_file("fence/sample2.toml"));
  replace(text, "rules = \"1993\"\n", "");
  replace(text, "limit_top = \"100000000 lbf\"", "limit_top = \"30000 lbf\"");
  replace(text, "history_every = 30", "history_every = 1");
  replace(text, "[51, 52, 48, 6, 7, 8, 35, 36]", "[3, 4, 5, 18, 21, 34, 47, 60]");
  replace(text, "[fence.column]", R"([[fence.rock]]
a = "1.1 ft"
b = "1.1 ft"
density = "5.13 slug/ft^3"
angle = "0.2 rad"
spin = "2 rad/s"
moment = "50 lbf ft"
position = ["20 ft", "30 ft"]
velocity = ["-1 ft/s", "0 ft/s"]
force = ["-300 lbf", "200 lbf"]
fixed_point = ["0.3 ft", "-0.4 ft"]
held = ["y"]

[fence.column])");
  return text + "\n[fence.options]\nhardening = 0.02\n";
}

/// Histories by codes of positions, of numbers of the deck, and of cables, and the rows of a rock in the listing.
void check_codes(const TemporaryFolder& folder, Findings& findings) {
  folder.write("numbers.toml", numbered_text());
  (void)talus_output(folder, {"run", "numbers.toml", "--out", "numbers", "--end", "15 ms"});
  const Csv codes = records::read_csv(folder.path() / "numbers/numbers.history.csv"),
            history = records::read_csv(folder.path() / "numbers/history.csv");
  const auto code = [&](int element, const char* of) {
    return column(codes, fmt::format("element{}.{}", element, of));
  };
  double differing = 0.0, deck = 0.0, lengths = 0.0, stretches = 0.0, largest = 0.0;
  for (const auto& [element, body] :
       {std::pair{2, "rock1"}, {3, "rock2"}, {4, "column1"}, {5, "column2"}, {6, "column3"}})
    for (const auto& [of, quantity] : {std::pair{"x", "x"}, {"y", "y"}, {"theta", "angle"}})
      differing += code(element, of) == column(history, fmt::format("{}.{}", body, quantity)) ? 0.0 : 1.0;
  findings.expect("history by codes: positions and rotations that differ from those of their bodies", differing, 0.0,
                  Tolerance::exact("the same numbers, written twice"));
  for (const auto& [element, force, held, fixed_point] : {std::tuple{2, 0.0, 0.0, 0.0},
                                                          {3, 200.0, 1.0, -0.4},
                                                          {4, 0.0, 0.0, 0.0},
                                                          {5, 0.0, 0.0, 0.0},
                                                          {6, 0.0, 0.0, 0.0}}) {
    keep_worst(deck, code(element, "applied_force_y").back() - force);
    keep_worst(deck, code(element, "held_y").back() - held);
    keep_worst(deck, code(element, "fixed_point_y").back() - fixed_point);
  }
  findings.expect("history by codes: numbers of the records of rocks and columns, largest error", deck, 0.0,
                  Tolerance::round_off(1e-13, "two roundings of numbers up to 200, 2.8e-14 each"));
  // Columns are 2.5 ft apart along the fence; bottom joints are 4 ft below their centres.
  const auto joint = [&](int number, std::size_t row) {
    const auto of = [&](const char* what) { return column(history, fmt::format("column{}.{}", number, what))[row]; };
    return std::array{of("x") + 4.0 * std::sin(of("angle")), of("y") - 4.0 * std::cos(of("angle"))};
  };
  const Json state = records::read_json(folder.path() / "numbers/final_state.json");
  for (const int number : {1, 2, 3}) {
    const std::vector<double> length = code(number + 3, "bottom_length");
    for (const std::size_t row : {std::size_t{0}, length.size() / 2, length.size() - 1}) {
      const auto [x, y] = joint(number, row);
      const auto [next_x, next_y] = joint(number + 1, row);
      keep_worst(lengths, length[row] / std::hypot(next_x - x, next_y - y, 2.5) - 1.0);
    }
    for (const Json& cable : state.at("cables")) {
      if (cable.at("name") != fmt::format("top{}", number)) continue;
      const double stretch = cable.at("plastic_stretch").get<double>();
      keep_worst(stretches, code(number + 3, "top_plastic_stretch").back() - stretch), keep_largest(largest, stretch);
    }
  }
  findings.expect("history by codes: lengths of bottom cables from the positions of the columns, largest error",
                  lengths, 0.0, Tolerance::round_off(5e-15, "twenty roundings of lengths up to 8 ft, 1.1e-16 each"));
  findings.expect_true("history by codes: a top cable has yielded", largest > 0.0,
                       "the rock reaches the column within 2 ms, and its cable 2 % of stretch soon after");
  findings.expect(
      "history by codes: plastic elongations less those of the final state, over the largest, largest error",
      stretches / largest, 0.0,
      Tolerance::round_off(1e-12, "the same state, whose modes are updated twice; the first segment has yielded"));
  // By columns of the listing: x, y, theta, vx, vy, spin, fx, fy, moment; then what is held, and the fixed point.
  const std::string listing = squeezed(folder.read("numbers/numbers.OUT"));
  Differences rows;
  rows.contains("initial conditions", listing,
                "\n 3 .200E+02 .300E+02 .200E+00 -.100E+01 .000E+00 .200E+01 -.300E+03 .200E+03 .500E+02\n");
  rows.contains("fixities", listing, "\n 3 0 1 0 .300E+00 -.400E+00\n");
  rows.expect_none(findings, "listing: rows of the second rock that differ",
                   "numbers of the scene with three digits, in the order of the deck's record");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("fence");
  const TemporaryFolder folder;
  folder.write("fence.toml", scene_text(setup));
  (void)talus_output(folder, {"run", "fence.toml", "--out", "out", "--sheet"});
  const Json sheet_json = records::read_json(folder.path() / "out/sheet.json"),
             summary = records::read_json(folder.path() / "out/summary.json");
  findings.count(summary.at("evaluations").get<long>());
  const Node sheet{sheet_json, "sheet.json"};
  const Csv history = records::read_csv(folder.path() / "out/history.csv"),
            codes = records::read_csv(folder.path() / "out/fence.history.csv");
  check_rock(sheet, history, codes, findings);
  check_elements(history, codes, findings);
  check_fence(sheet, history, findings);
  check_anchor(folder, sheet, findings, setup);
  if (setup.needs("history by codes") || setup.needs("listing")) check_codes(folder, findings);
}

}  // namespace

Case definition() {
  return {
      .id = "fence_files",
      .title = "Output files of a fence",
      .requirements = {{"G4", {"fence"}}},
      .main_checks = {"sheet: impulse of the anchor from the states of the geometry, largest error of three components",
                      "sheet: energy of approach"},
      .source = "Mustoe & Huttelmaier 1993, Table 2 and sample deck (scenes)",
      .faults = {{"slower_rock", "a rock of 64.99 ft/s", "sheet: velocity of approach"},
                 {"cable_pushes", "cables that push on the anchor",
                  "sheet: impulse of the anchor from the states of the geometry, largest error of three components"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::fence_files
