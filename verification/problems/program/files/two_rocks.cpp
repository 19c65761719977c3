#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/files/animation_page.hpp"
#include "verification/problems/program/files/drawn_sheet.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"
#include "verification/study/program/sweep_results.hpp"
#include "verification/study/program/table_units.hpp"

namespace talus::verification::problems::two_rocks {
namespace {

using records::Csv;
using records::Json;
using records::Node;

// International foot and avoirdupois pound, exact by definition (1959), and standard gravity.
constexpr double metre = 0.3048, newton = 0.45359237 * 9.80665, joule = newton * metre;
const std::string integrator = "auto", end = "30 ms";

/// The sample deck as a scene, with a second, smaller rock that hits above the first and a little later, and with top
/// and bottom cables of different limits. The history has a row for every step; the history by codes has the
/// constants of the cables.
std::string scene_text(const std::string& deck) {
  std::string text = deck;
  const std::size_t first = text.find("[[fence.rock]]"), column = text.find("[fence.column]");
  std::string rock = text.substr(first, column - first), second = rock;
  for (std::string* const of : {&rock, &second}) {
    const bool is_first = of == &rock;
    if (!is_first)
      replace(*of, "a = \"1.201 ft\"", "a = \"1.1 ft\""), replace(*of, "b = \"1.201 ft\"", "b = \"1.1 ft\"");
    replace(*of, "position = [\"2.451 ft\", \"0 ft\"]",
            is_first ? "position = [\"2.451 ft\", \"-1.3 ft\"]" : "position = [\"2.55 ft\", \"1.3 ft\"]");
    if (!is_first) replace(*of, "-65 ft/s", "-50 ft/s"), replace(*of, "34 rad/s", "-20 rad/s");
  }
  text.replace(first, column - first, rock + second);
  replace(text, "history_every = 30", "history_every = 1");
  replace(text, "limit_bottom = \"100000000 lbf\"", "limit_bottom = \"90000000 lbf\"");
  replace(text, "[51, 52, 48, 6, 7, 8, 35, 36]", "[51, 55, 56, 57, 58, 59, 35, 36]");
  return text;
}

/// Largest difference between a sheet's numbers and their references, each relative to its scale.
class Worst {
 public:
  void compare(double found, double exact, double scale) { keep_worst(worst_, (found - exact) / scale); }
  double error() const { return worst_; }

 private:
  double worst_{};
};

Tolerance of_units() {
  return Tolerance::round_off(
      5e-15,
      "about ten roundings between feet and metres, 1.1e-16 each, in 17 digits, and as many again "
      "in the program's numbers; twice that");
}

/// A rock touches the fence in the rows in which it overlaps a column or presses it: at the start it may press without
/// overlap.
void check_rocks(const Node& sheet, const Csv& history, const Csv& codes, Findings& findings, const Setup& setup) {
  const std::vector<double> time = column(history, "time");
  const std::size_t last = time.size() - 1;
  Worst velocities, energies, times, travels;
  for (const std::size_t r : {0U, 1U}) {
    const Node rock = sheet.at("rocks").list().at(r);
    const std::size_t of = setup.has("first_rock_alone") ? 0 : r;
    const std::string name = fmt::format("rock{}", of + 1), element = fmt::format("element{}", of + 2);
    const std::vector<double> x = column(history, name + ".x"), vx = column(history, name + ".vx"),
                              vy = column(history, name + ".vy"), spin = column(history, name + ".spin"),
                              front = column(history, name + "-column1.overlap"),
                              back = column(history, name + "-back_column1.overlap"),
                              front_force = column(history, name + "-column1.force"),
                              back_force = column(history, name + "-back_column1.force"),
                              along = column(codes, element + ".kinetic_translation"),
                              about = column(codes, element + ".kinetic_rotation");
    std::size_t touch = last + 1, exit = 0;
    for (std::size_t row = 0; row <= last; ++row)
      if (std::max({front[row], back[row], front_force[row], back_force[row]}) > 0.0)
        touch = std::min(touch, row), exit = std::min(row + 1, last);
    const auto velocity = [&](const char* key, double along_x, double along_y) {
      const std::vector<Node> v = rock.at(key).list();
      velocities.compare(v.at(0).number(), metre * along_x, 10.0);
      velocities.compare(v.at(1).number(), metre * along_y, 10.0);
    };
    const auto energy = [&](std::size_t row) { return joule * (along[row] + about[row]); };
    // The approach is the row before the touch; for a rock that touches from the start, the scene's initial values.
    double approach = 0.0;
    if (touch > 0) {
      velocity("approach_velocity", vx[touch - 1], vy[touch - 1]);
      velocities.compare(rock.at("approach_spin").number(), spin[touch - 1], 10.0);
      approach = energy(touch - 1);
    } else {
      velocity("approach_velocity", -65.0, 0.0);
      velocities.compare(rock.at("approach_spin").number(), 34.0, 10.0);
      approach = joule * (along[0] * 65.0 * 65.0 / (vx[0] * vx[0] + vy[0] * vy[0]) +
                          about[0] * 34.0 * 34.0 / (spin[0] * spin[0]));
    }
    velocity("exit_velocity", vx[exit], vy[exit]), velocity("end_velocity", vx[last], vy[last]);
    velocities.compare(rock.at("exit_spin").number(), spin[exit], 10.0);
    energies.compare(rock.at("approach_energy").number(), approach, approach);
    energies.compare(rock.at("exit_energy").number(), energy(exit), approach);
    energies.compare(rock.at("end_energy").number(), energy(last), approach);
    energies.compare(rock.at("energy_loss_fraction").number(), 1.0 - energy(exit) / approach, 1.0);
    times.compare(rock.at("touch_time").number(), time[touch], time[last]);
    times.compare(rock.at("exit_time").number(), time[exit], time[last]);
    double travel = 0.0;
    for (std::size_t row = touch; row <= exit; ++row)
      travel = std::max(travel, x[touch] - x[row]);
    travels.compare(rock.at("travel").number(), metre * travel, 0.1);
  }
  findings.expect("sheet: velocities and spins of both rocks, largest error", velocities.error(), 0.0, of_units());
  findings.expect("sheet: energies of both rocks over those at the start, largest error", energies.error(), 0.0,
                  of_units());
  findings.expect("sheet: times of touch and exit of both rocks over the duration, largest error", times.error(), 0.0,
                  of_units());
  findings.expect("sheet: travel of both rocks, largest error", travels.error(), 0.0, of_units());
}

/// Peaks and integrals of all columns and segments, including the second layer, from the rows of all steps.
void check_parts(const Node& sheet, const Csv& history, const Csv& codes, Findings& findings) {
  const std::vector<double> time = column(history, "time");
  Worst travels, peaks, impulses, times;
  const auto peak_row = [&](const std::vector<double>& values) {
    return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  };
  double fence = 0.0;
  for (const Node& part : sheet.at("columns").list()) {
    const std::vector<double> x = column(history, part.at("name").text() + ".x");
    std::vector<double> away;
    for (const double at : x)
      away.push_back(metre * std::abs(at - x.front()));
    const std::size_t row = peak_row(away);
    travels.compare(part.at("travel").number(), away[row], 0.1);
    fence = std::max(fence, away[row]);
    if (away[row] > 0.0) times.compare(part.at("travel_time").number(), time[row], time.back());
  }
  travels.compare(sheet.at("fence").at("travel").number(), fence, 0.1);
  // The first columns of the first layer are elements 4 to 6.
  for (const std::size_t c : {0U, 1U, 2U}) {
    const std::vector<double> force = column(codes, fmt::format("element{}.top_joint_force", c + 4));
    const Node hanger = sheet.at("columns").list().at(c).at("hanger");
    peaks.compare(hanger.at("peak").number(), newton * force[peak_row(force)], newton * 1e4);
    times.compare(hanger.at("peak_time").number(), time[peak_row(force)], time.back());
  }
  for (const Node& part : sheet.at("segments").list()) {
    const std::vector<double> tension = column(history, part.at("name").text() + ".tension");
    double impulse = 0.0;
    for (std::size_t row = 1; row < time.size(); ++row)
      impulse += 0.5 * (tension[row] + tension[row - 1]) * (time[row] - time[row - 1]);
    peaks.compare(part.at("peak").number(), newton * tension[peak_row(tension)], newton * 1e5);
    impulses.compare(part.at("impulse").number(), newton * impulse, newton * 1e3);
    times.compare(part.at("peak_time").number(), time[peak_row(tension)], time.back());
  }
  findings.expect("sheet: travel of all columns, largest error", travels.error(), 0.0, of_units());
  findings.expect("sheet: largest forces of hangers and segments, largest error", peaks.error(), 0.0, of_units());
  findings.expect("sheet: impulses of the segments, largest error", impulses.error(), 0.0,
                  Tolerance::round_off(1e-14,
                                       "trapezoidal sums of 363 terms, each rounded by 1.1e-16 of the sum: 2e-15 as a "
                                       "walk, five times that"));
  findings.expect("sheet: times of the largest travels and forces over the duration, largest error", times.error(), 0.0,
                  of_units());
  // Cables that begin at the first columns, 2.5 ft apart, with stiffnesses of lengths without slack. Bottom cables are
  // slack, by 0.5 ft at the start; no cable yields.
  Worst cables;
  for (const Node& part : sheet.at("segments").list()) {
    const std::string name = part.at("name").text();
    const bool top = name.starts_with("top");
    const std::string kind = top ? "top" : "bottom";
    if (!name.starts_with(kind) || name.back() > '3') continue;
    const int of_column = name.back() - '0';
    const auto code = [&](const char* of) {
      return column(codes, fmt::format("element{}.{}_{}", of_column + 3, kind, of));
    };
    const auto height = [&](int c) { return column(history, fmt::format("column{}.y", c)).front(); };
    const double limit = part.at("limit").number() / newton;
    cables.compare(code("limit").back(), limit, limit);
    const std::vector<double> stiffness = code("stiffness"), elongation = column(history, name + ".elongation"),
                              tension = column(history, name + ".tension");
    for (std::size_t row = 0; row < time.size(); ++row) {
      cables.compare(std::max(0.0, stiffness[row] * elongation[row]), tension[row], 1e5);
    }
    const double length = std::hypot(2.5, height(of_column + 1) - height(of_column));
    const double of_unit_length = 20e6 * (top ? 1.076 : 2.0 * 0.25);  // of two bottom strands
    cables.compare(stiffness.back() * length, of_unit_length, of_unit_length);
    if (top) continue;
    cables.compare(code("rest_length").back(), length + 0.5, length);
  }
  findings.expect("history by codes: limits, stiffnesses and rest lengths of the cables, largest error", cables.error(),
                  0.0, of_units());
  Worst rows;
  const Node drawn = sheet.at("history");
  const std::vector<std::string> names = drawn.at("columns").texts();
  const std::vector<Node> lines = drawn.at("rows").list();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].starts_with("rock")) continue;
    const std::vector<double> values = column(history, names[i]);
    for (std::size_t row = 0; row < std::max(lines.size(), values.size()); row += 20)
      rows.compare(lines.at(row).list().at(i).number(), metre * values.at(row), 10.0);
  }
  findings.expect("sheet: history of the rocks, largest error", rows.error(), 0.0, of_units());
}

/// Compares the verdicts and numbers of summary.json, in the scene's units, with those of the sheet.
void check_verdict(const Node& sheet, const Node& summary, const std::string& printed, Findings& findings) {
  Worst worst;
  const Node verdict = summary.at("verdict");
  double differing = verdict.at("fence").text() == sheet.at("verdict").text() ? 0.0 : 1.0;
  for (const std::size_t r : {0U, 1U}) {
    const Node rock = verdict.at("rocks").list().at(r), known = sheet.at("rocks").list().at(r);
    differing += rock.at("verdict").text() == known.at("verdict").text() ? 0.0 : 1.0;
    differing += rock.at("still_touching").flag() == !known.at("separated").flag() ? 0.0 : 1.0;
    worst.compare(rock.at("approach_energy").number(), known.at("approach_energy").number() / joule, 1e4);
    worst.compare(rock.at("energy_at_end").number(), known.at("end_energy").number() / joule, 1e4);
    worst.compare(rock.at("velocity_at_end").list().at(0).number(),
                  known.at("end_velocity").list().at(0).number() / metre, 10.0);
    worst.compare(rock.at("last_contact_time").number(), known.at("exit_time").number(), 1e-2);
    const double remains = known.at(known.at("separated").flag() ? "exit_energy" : "end_energy").number();
    const std::string part = fmt::format("({:.1f} %)", 100.0 * remains / known.at("approach_energy").number());
    const std::size_t line = printed.find("\n  " + rock.at("name").text());
    differing += printed.substr(line, printed.find('\n', line + 1) - line).find(part) != std::string::npos ? 0.0 : 1.0;
    if (!known.at("separated").flag()) continue;
    worst.compare(rock.at("energy_after").number(), known.at("exit_energy").number() / joule, 1e4);
    worst.compare(rock.at("velocity_after").list().at(1).number(),
                  known.at("exit_velocity").list().at(1).number() / metre, 10.0);
  }
  double largest = 0.0;
  for (const Node& part : sheet.at("segments").list())
    largest = std::max(largest, part.at("peak").number());
  worst.compare(verdict.at("largest_cable_force").at("peak").number(), largest / newton, 1e5);
  findings.expect("verdicts and printed percentages of energy that differ from those of the sheet", differing, 0.0,
                  Tolerance::exact("for the fence and each rock; of a rock that has left, the energy after its last "
                                   "contact, otherwise that at the end, in percent of that of the approach"));
  findings.expect("summary.json: numbers of the verdict against those of the sheet, largest error", worst.error(), 0.0,
                  of_units());
}

/// The first rock alone, which does not reach the fence before the end, in feet and in metres. Both listings are in
/// feet. The listing of both rocks has the contact stiffness of the first.
void check_alone(const TemporaryFolder& folder, const std::string& deck, Findings& findings, const Setup& setup) {
  std::string text = deck;
  replace(text, "position = [\"2.451 ft\", \"0 ft\"]", "position = [\"4 ft\", \"-1.3 ft\"]");
  if (setup.has("second_rock_alone")) replace(text, "a = \"1.201 ft\"", "a = \"1.1 ft\"");
  std::string in_metres = text;
  replace(in_metres, "units = \"US\"", "units = \"SI\"");
  folder.write("alone.toml", text), folder.write("alone_in_metres.toml", in_metres);
  Differences differences;
  for (const std::string name : {"alone", "alone_in_metres"}) {
    (void)talus_output(folder, {"run", name + ".toml", "--out", name, "--integrator", integrator, "--end", "15 ms"});
    const Json summary = records::read_json(folder.path() / name / "summary.json");
    const Json& rock = summary["verdict"]["rocks"][0];
    for (const char* flag : {"touched", "still_touching"})
      differences.compare(flag, rock.at(flag), Json(false));
    for (const char* after : {"last_contact_time", "velocity_after", "energy_after"})
      differences.compare(after, rock.at(after), Json(nullptr));
  }
  const std::string listing = folder.read("alone/alone.OUT"), of_both = folder.read("out/fence.OUT");
  differences.holds("states of the listing", listing.find("time = .993E-02 secs") != std::string::npos);
  differences.compare("listing in metres", folder.read("alone_in_metres/alone_in_metres.OUT"), listing);
  // A run that ends as the rock leaves, after 19 of 20 steps and between two printed states, lists its last state.
  std::string leaving = text;
  replace(leaving, "[\"4 ft\", \"-1.3 ft\"]", "[\"6 ft\", \"30 ft\"]"), replace(leaving, "-65 ft/s", "-100 ft/s");
  folder.write("leaving.toml", leaving + "\n[fence.options]\nend = \"exit\"\nexit_x = \"5.815 ft\"\n");
  (void)talus_output(folder, {"run", "leaving.toml", "--out", "leaving", "--integrator", "velocity_verlet", "--step",
                              "0.1 ms", "--end", "2 ms"});
  differences.holds("state of a stop in the listing",
                    folder.read("leaving/leaving.OUT").find("time = .190E-02 secs") != std::string::npos);
  const auto line = [](const std::string& of, const std::string& begin) {
    const std::size_t at = of.find(begin);
    return at == std::string::npos ? "no line" : of.substr(at, of.find('\n', at) - at);
  };
  const std::string stiffness = "Normal contact stiffness (rock/fence) = ";
  differences.contains("stiffness in the listing", listing, stiffness);
  differences.compare("stiffness in the listing", line(of_both, stiffness), line(listing, stiffness));
  const double of_units = units_error(records::read_csv(folder.path() / "alone/alone.history.csv"),
                                      records::read_csv(folder.path() / "alone_in_metres/alone_in_metres.history.csv"));
  findings.expect(
      "first rock alone: columns of the history in US units over those in SI units, largest difference "
      "over the largest value",
      of_units, 0.0,
      Tolerance::round_off(1e-10,
                           "a run has the units of its scene: roundings of 1e-16 in some thousand "
                           "steps, which the frequency of the cables multiplies by a thousand"));
  differences.expect_none(findings, "first rock alone: listings and members of summary.json that differ",
                          "three digits of a run in metres and in feet; the listing states the contact stiffness of "
                          "the first rock; a rock that has not touched the fence has no time or speed of an exit");
}

/// Histories by codes of both rocks' outlines, and of the forces of the segments that begin at the first columns; the
/// speeds at which the rocks still advance.
void check_codes(const TemporaryFolder& folder, const std::string& deck, Findings& findings) {
  std::string text = scene_text(deck);
  replace(text, "[51, 55, 56, 57, 58, 59, 35, 36]", "[9, 10, 35, 36]");
  // The 182 steps are no multiple of this: the last row is one more.
  replace(text, "history_every = 1", "history_every = 11");
  folder.write("codes.toml", text);
  replace(text, "[9, 10, 35, 36]", "[46, 48, 49, 50, 52, 53, 54]");
  folder.write("forces.toml", text);
  const auto run = [&](const std::string& name) {
    return talus_output(folder, {"run", name + ".toml", "--out", name, "--integrator", integrator, "--end", "15 ms"});
  };
  const std::string printed = run("codes");
  (void)run("forces");
  const Csv codes = records::read_csv(folder.path() / "codes/codes.history.csv"),
            cables = records::read_csv(folder.path() / "forces/forces.history.csv"),
            history = records::read_csv(folder.path() / "codes/history.csv");
  // vx alone: the first rock also moves down, and its speed is another number in four digits.
  Differences advancing;
  for (const std::string name : {"rock1", "rock2"}) {
    const std::string line = printed.substr(std::min(printed.size(), printed.find("\n  " + name)));
    advancing.contains(name, line.substr(0, line.find('\n', 1)),
                       fmt::format("; it still advances at {:.4g} ft/s: ", -column(history, name + ".vx").back()));
  }
  advancing.expect_none(findings, "history by codes: printed speeds at which the rocks advance that differ",
                        "four digits of the last row's vx");
  const Json summary = records::read_json(folder.path() / "codes/summary.json");
  const double step = summary.at("step").get<double>(), steps = summary.at("steps").get<double>();
  std::vector<double> times;
  for (double n = 0.0; n < steps; n += 11.0)
    times.push_back(n * step);
  times.push_back(steps * step);
  expect_each(findings, "history by codes: times of every eleventh step and of the last one, largest error",
              column(codes, "time"), times, Tolerance::round_off(1e-13, "182 additions of a step"), "s");
  Worst outlines, forces;
  for (const auto& [element, x, y] :
       {std::tuple{2, 1.201, 1.201}, {3, 1.1, 1.1}, {4, 1.25, 4.0}, {5, 1.25, 4.0}, {6, 1.25, 4.0}}) {
    outlines.compare(column(codes, fmt::format("element{}.half_length_x", element)).back(), x, x);
    outlines.compare(column(codes, fmt::format("element{}.half_length_y", element)).back(), y, y);
  }
  findings.expect("history by codes: half-widths of both rocks and three columns, largest error", outlines.error(), 0.0,
                  of_units());
  // Columns are 2.5 ft apart along the fence; bottom cables are slack.
  for (const int element : {4, 5, 6}) {
    const auto code = [&](const char* of) { return column(cables, fmt::format("element{}.{}", element, of)); };
    const std::vector<double> length = code("top_length"), tension = code("top_tension"), x = code("top_tension_x"),
                              y = code("top_tension_y"), bottom = code("bottom_tension"),
                              bottom_x = code("bottom_tension_x"), bottom_y = code("bottom_tension_y");
    for (std::size_t row = 0; row < length.size(); ++row) {
      const double across = std::sqrt(1.0 - std::pow(2.5 / length[row], 2));
      forces.compare(std::hypot(x[row], y[row]), tension[row] * across, 1e4);
      if (bottom[row] == 0.0) forces.compare(std::hypot(bottom_x[row], bottom_y[row]), 0.0, 1e4);
    }
    forces.compare(bottom.front(), 0.0, 1e4);
  }
  findings.expect("history by codes: components of cable forces across the fence, largest error", forces.error(), 0.0,
                  Tolerance::round_off(1e-12,
                                       "of a length of 2.5 ft and one across of 0.1 ft: the difference of their "
                                       "squares loses three digits"));
}

/// Loads on a rock that is pushed and turned on its way to the fence: those of the deck and the weight until it
/// touches, and their impulses up to the end beside the changes of its momentum.
void check_loads(const TemporaryFolder& folder, const std::string& deck, Findings& findings) {
  std::string text = deck;
  replace(text,
          "moment = \"0 lbf ft\"\nposition = [\"2.451 ft\", \"0 ft\"]\nvelocity = [\"-65 ft/s\", \"0 ft/s\"]\n"
          "force = [\"0 lbf\", \"0 lbf\"]",
          "moment = \"300 lbf ft\"\nposition = [\"2.6 ft\", \"-1.3 ft\"]\nvelocity = [\"-65 ft/s\", \"0 ft/s\"]\n"
          "force = [\"-3000 lbf\", \"2000 lbf\"]");
  replace(text, "history_every = 30", "history_every = 1");
  replace(text, "[51, 52, 48, 6, 7, 8, 35, 36]", "[6, 7, 8, 15, 16, 23, 24, 25]");
  folder.write("loads.toml", text);
  (void)talus_output(folder, {"run", "loads.toml", "--out", "loads", "--integrator", integrator, "--end", "8 ms"});
  const Csv codes = records::read_csv(folder.path() / "loads/loads.history.csv");
  const std::vector<double> time = column(codes, "time");
  const double touch = 0.149 / 65.0;
  Worst flight, impulses;
  for (const int element : {2, 3, 4, 5, 6}) {
    const auto code = [&](const std::string& of) { return column(codes, fmt::format("element{}.{}", element, of)); };
    const double mass = code("mass").front(), inertia = code("inertia").front();
    for (const auto& [velocity, load, inert, given] : {std::tuple{"vx", "load_x", mass, -3000.0},
                                                       {"vy", "load_y", mass, 2000.0 - 32.18 * mass},
                                                       {"omega", "load_moment", inertia, 300.0}}) {
      const std::vector<double> v = code(velocity), loads = code(load);
      double impulse = 0.0, largest = 0.0, interval = 0.0;
      for (std::size_t row = 1; row < time.size(); ++row) {
        const double h = time[row] - time[row - 1];
        impulse += 0.5 * h * (loads[row] + loads[row - 1]);
        keep_largest(largest, loads[row]), keep_largest(interval, h);
        if (element != 2 || time[row] > 0.95 * touch) continue;
        flight.compare(loads[row], given, 3000.0);
        flight.compare(inert * (v[row] - v[row - 1]) / h, given, 3000.0);
      }
      impulses.compare(impulse, inert * (v.back() - v.front()), 0.5 * interval * largest);
    }
  }
  findings.expect(
      "history by codes: loads on a rock in flight, largest error", flight.error(), 0.0,
      Tolerance::round_off(1e-12, "speeds of 65 ft/s change by 0.007 ft/s in a step: four digits are lost"));
  findings.expect(
      "history by codes: impulses of the loads less changes of momentum, over those of the largest load in half a "
      "step, largest",
      impulses.error(), 0.0,
      Tolerance::truncation(1.0, 1.0,
                            "a dashpot begins to act with a jump of the force, which the sum of trapezoids "
                            "shifts by up to half a step"));
}

/// Two blocks of power 0 with one resultant for each contact: both outlines are rectangles, with corners at (a, b). A
/// superellipse of n = 20, as nodal contacts have, is 3.4 % short of them.
void check_blocks(const TemporaryFolder& folder, const std::string& deck, Findings& findings) {
  std::string text = scene_text(deck) + "\n[fence.options]\ncontact = \"resultant\"\n";
  for (int rock = 0; rock < 2; ++rock) {
    replace(text, "\"ellipsoid\"", "\"block\"");
    replace(text, "bar_length = \"0 ft\"", "bar_length = \"1 ft\"");
  }
  folder.write("blocks.toml", text);
  (void)talus_output(folder, {"run", "blocks.toml", "--out", "blocks", "--integrator", integrator, "--end", "1 ms"});
  const std::string state = geometry_states(folder, "blocks", "blocks").front().text;
  const std::vector<double> points = data_array(state, "Points"), offsets = data_array(state, "offsets");
  Worst corners;
  // The ground has the first line, the rocks the next ones.
  for (const auto& [line, x, y, half] : {std::tuple{1U, 2.451, -1.3, 1.201}, {2U, 2.55, 1.3, 1.1}}) {
    double reach = 0.0;
    const auto first = static_cast<std::size_t>(offsets.at(line - 1)),
               past = static_cast<std::size_t>(offsets.at(line));
    for (std::size_t point = first; point < past; ++point)
      reach = std::max(reach, std::abs(points.at(3 * point) - x) + std::abs(points.at(3 * point + 1) - y));
    corners.compare(reach, 2.0 * half, half);
  }
  findings.expect("blocks: corners of both rectangles, largest error", corners.error(), 0.0, of_units());
}

/// The first rock in the fence, and one that does not reach it: the energy with which rocks leave, as sweeps give it.
void check_missing_rock(const TemporaryFolder& folder, const std::string& deck, Findings& findings) {
  std::string text = scene_text(deck);
  replace(text, "position = [\"2.55 ft\", \"1.3 ft\"]", "position = [\"6 ft\", \"1.3 ft\"]");
  replace(text, "steps = 3000", "steps = 182");
  folder.write("missing.toml", text);
  folder.write("sweep.toml",
               "base = \"missing.toml\"\noutputs = [\"fence.exit_energy\"]\n"
               "[[axis]]\nfield = \"fence.rock[1].spin\"\nvalues = [\"-20 rad/s\"]\n");
  (void)talus_output(folder, {"run", "missing.toml", "--out", "missing"});
  (void)talus_output(folder, {"sweep", "plan", "sweep.toml"});
  (void)talus_output(folder, {"sweep", "run", "sweep"});
  (void)talus_output(folder, {"sweep", "collect", "sweep"});
  const Csv codes = records::read_csv(folder.path() / "missing/missing.history.csv"),
            swept = records::read_csv(folder.path() / "sweep/results.csv");
  Differences differ;
  compare_sweep(swept, records::Json::parse(records::read_whole(folder.path() / "sweep/results.json")), differ);
  differ.expect_none(findings, "missing rock: numbers of the two files of the sweep that differ",
                     "the same fields, ends and outputs in two units");
  double energy = 0.0;
  for (const char* const part : {"element2.kinetic_translation", "element2.kinetic_rotation",
                                 "element3.kinetic_translation", "element3.kinetic_rotation"})
    energy += column(codes, part).back();
  findings.expect(
      "missing rock: energy with which rocks leave, by a sweep, over that of the history by codes",
      column(swept, "fence.exit_energy").front() / energy, 1.0,
      Tolerance::round_off(1e-13,
                           "the rock that still touches the fence at the end has the energy that it then has, "
                           "and so does the one that never touched it; sums of squares, in 17 digits"));
}

/// A light rock that bounces off the fence, one that never reaches it, and one that flies over it, in pairs: the fence
/// has the verdict of the rock that is worse in this order.
void check_worst_verdict(const TemporaryFolder& folder, const std::string& deck, Findings& findings,
                         const Setup& setup) {
  struct Flight {
    std::string verdict, printed, position, speed, density;
  };
  const std::array flights{Flight{"stopped", "stopped", "2.451 ft", "-65 ft/s", "0.0513 slug/ft^3"},
                           Flight{"undecided", "undecided at the end", "6 ft", "1 ft/s", "5.13 slug/ft^3"},
                           Flight{"passed_over", "passed over", "2.6 ft", "-650 ft/s", "5.13 slug/ft^3"}};
  const std::size_t first = deck.find("[[fence.rock]]"), column = deck.find("[fence.column]");
  const auto rock = [&](const Flight& of) {
    std::string text = deck.substr(first, column - first);
    replace(text, "[\"2.451 ft\", \"0 ft\"]",
            fmt::format("[\"{}\", \"{} ft\"]", of.position, of.verdict == "passed_over" ? 20 : 0));
    replace(text, "-65 ft/s", of.speed), replace(text, "5.13 slug/ft^3", of.density);
    return text;
  };
  Differences differences;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    for (std::size_t j = 0; j < flights.size(); ++j) {
      if (i == j) continue;
      const Flight& worse = flights[setup.has("better_verdict") ? std::min(i, j) : std::max(i, j)];
      folder.write("pair.toml", deck.substr(0, first) + rock(flights[i]) + rock(flights[j]) + deck.substr(column));
      const std::string printed =
          talus_output(folder, {"run", "pair.toml", "--out", "pair", "--integrator", integrator, "--end", "20 ms"});
      const Json verdict = records::read_json(folder.path() / "pair/summary.json").at("verdict");
      const std::string name = flights[i].verdict + ", " + flights[j].verdict;
      differences.compare("first rock: " + name, verdict.at("rocks").at(0).at("verdict"), Json(flights[i].verdict));
      differences.compare("second rock: " + name, verdict.at("rocks").at(1).at("verdict"), Json(flights[j].verdict));
      differences.compare("fence: " + name, verdict.at("fence"), Json(worse.verdict));
      differences.contains("printed: " + name, squeezed(printed), "verdict " + worse.printed + "\n");
    }
  }
  differences.expect_none(findings, "pairs of rocks: verdicts that differ from the paths, or from the worse of both",
                          "a rock that bounces is stopped, one that never reaches the fence undecided, one that "
                          "flies over it worse than both");
}

/// A rock that hits the third column on one side of a full fence, between columns that sleep: cables pull on these from
/// either of their ends. A method that locates events wakes all columns before its first step.
void check_beside(const TemporaryFolder& folder, const std::string& deck, Findings& findings) {
  std::string beside = deck;
  const std::string position = "position = [\"2.451 ft\", \"0 ft\"]";
  replace(beside, position, position + "\nalong = \"5 ft\"");
  const auto has_same_history = [&](const std::string& method) {
    std::vector<std::string> histories;
    for (const std::string sleep : {"exact", "off"}) {
      folder.write("beside.toml", beside + "\n[fence.options]\nsymmetry = \"full\"\nsleep = \"" + sleep + "\"\n");
      (void)talus_output(folder,
                         {"run", "beside.toml", "--integrator", method, "--end", "3 ms", "--out", "beside_" + sleep});
      histories.push_back(folder.read("beside_" + sleep + "/history.csv"));
    }
    return histories[0] == histories[1];
  };
  findings.expect_true("rock beside the middle: the same history with sleeping columns as without",
                       has_same_history("velocity_verlet"),
                       "with sleep exact a column wakes as soon as a pull on it changes by a bit: the same bytes");
  findings.expect_true("rock beside the middle: the same history by stormer_cowell, where no column sleeps",
                       has_same_history("stormer_cowell"),
                       "a step is longer than the time in which a pull reaches the next column: the same bytes");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("rocks");
  const TemporaryFolder folder;
  folder.write("sample2.DAT", records::read_whole(case_file("fence/sample2.DAT")));
  (void)talus_output(folder, {"convert", "sample2.DAT", "sample2.toml"});
  const std::string deck = folder.read("sample2.toml");
  folder.write("fence.toml", scene_text(deck));
  std::vector<std::string> arguments{"run", "fence.toml", "--out", "out", "--integrator", integrator, "--end", end};
  const bool sheet_is_needed = setup.needs("sheet: ");
  if (sheet_is_needed) arguments.emplace_back("--sheet");
  const std::string printed = talus_output(folder, arguments, picture_options::recorded_pictures());
  if (setup.needs("animation")) check_animation_page(folder, findings, setup);
  if (setup.needs("alone")) check_alone(folder, deck, findings, setup);
  if (setup.needs("history by codes")) check_codes(folder, deck, findings), check_loads(folder, deck, findings);
  if (setup.needs("blocks: ")) check_blocks(folder, deck, findings);
  if (setup.needs("missing rock")) check_missing_rock(folder, deck, findings);
  if (setup.needs("beside the middle")) check_beside(folder, deck, findings);
  if (setup.needs("pairs of rocks: ")) check_worst_verdict(folder, deck, findings, setup);
  if (!sheet_is_needed) return;
  const Json sheet_json = records::read_json(folder.path() / "out/sheet.json"),
             summary_json = records::read_json(folder.path() / "out/summary.json");
  const Node sheet{sheet_json, "sheet.json"}, summary{summary_json, "summary.json"};
  findings.count(summary.at("evaluations").count());
  const Csv history = records::read_csv(folder.path() / "out/history.csv"),
            codes = records::read_csv(folder.path() / "out/fence.history.csv");
  check_rocks(sheet, history, codes, findings, setup);
  check_parts(sheet, history, codes, findings);
  check_verdict(sheet, summary, printed, findings);
  check_drawn_sheet(folder, sheet_json, findings);
  const Node repeat = sheet.at("quality").at("repeat");
  const double growth = repeat.at("change_of_largest_cable_force").number() / repeat.at("change_of_speed").number();
  findings.expect_between("sheet: change of the largest cable force over that of the rocks' speed", growth, 0.25, 4.0,
                          "the peak force of a spring is proportional to the speed; slack and gaps increase its "
                          "growth, forces present at rest reduce it. A run with the deck's speeds changed cannot serve "
                          "as reference, because the stiffness of the contacts follows from these speeds");
}

}  // namespace

Case definition() {
  return {.id = "two_rocks",
          .title = "Output files of a fence with two rocks and two layers",
          .requirements = {{"G7", {"rocks"}}},
          .main_checks = {"sheet: velocities and spins of both rocks, largest error",
                          "sheet: largest forces of hangers and segments, largest error",
                          "sheet: change of the largest cable force over that of the rocks' speed",
                          "animation: outlines of the bodies, largest error"},
          .source = "Mustoe & Huttelmaier 1993, sample deck (fence and first rock)",
          .faults = {{"second_rock_alone", "the second rock in place of the first, alone",
                      "first rock alone: listings and members of summary.json that differ"},
                     {"first_rock_alone", "the second rock compared with the history of the first",
                      "sheet: velocities and spins of both rocks, largest error"},
                     {"better_verdict", "the verdict of the better rock of two",
                      "pairs of rocks: verdicts that differ from the paths, or from the worse of both"},
                     {"frame_one_late", "frames compared with the next state",
                      "animation: outlines of the bodies, largest error"}},
          .run = run};
}

}  // namespace talus::verification::problems::two_rocks
