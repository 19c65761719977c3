#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/cells/cell_results.hpp"
#include "verification/problems/program/cells/contacting_cells.hpp"
#include "verification/problems/program/cells/interrupted_cell.hpp"
#include "verification/problems/program/cells/last_rows.hpp"
#include "verification/problems/program/cells/reference_cell.hpp"
#include "verification/problems/program/cells/written_cells.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/curves.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::cell_files {
namespace {

using records::Csv;
using records::Json;
using records::Node;

void check_history(const TemporaryFolder& folder, const Expected& expected, Findings& findings) {
  const Csv history = records::read_csv(folder.path() / "out/history.csv");
  const std::vector<std::string> header{
      "time [s]",         "top_shear [N/m^2]", "top_normal [N/m^2]", "bottom_shear [N/m^2]", "bottom_normal [N/m^2]",
      "depth [m]",        "solid_fraction",    "touching",           "coordination",         "stress_ratio",
      "multiple_fraction"};
  findings.expect_true("history.csv: names, units and order of its columns", history.header() == header,
                       "SI, as given by the option");
  findings.expect("history.csv: rows", static_cast<double>(history.rows()), static_cast<double>(expected.loops.size()),
                  Tolerance::exact("one for each LOOP, the last of which is incomplete"));
  double worst = 0.0, times = 0.0;
  Values scale{};
  for (const Mean& mean : expected.loops)
    for (std::size_t k = 0; k < count; ++k)
      scale[k] = std::max(scale[k], std::abs(mean.sum[k] / mean.weight));
  for (std::size_t row = 0; row < std::min(history.rows(), expected.loops.size()); ++row) {
    const Mean& mean = expected.loops[row];
    keep_worst(times, history.number(row, 0) - (elapsed + std::min(static_cast<double>(row + 1) * loop, end)));
    for (std::size_t k = top_shear; k <= coordination; ++k)
      keep_worst(worst, (history.number(row, k + 1) - mean.sum[k] / mean.weight) / scale[k]);
    keep_worst(worst, history.number(row, 9) - (mean(top_normal) != 0.0 ? mean(top_shear) / mean(top_normal) : 0.0));
    keep_worst(worst, history.number(row, 10) - (mean(contacts) != 0.0 ? mean(multiple) / mean(contacts) : 0.0));
  }
  findings.expect("history.csv: times of the rows, largest error", times, 0.0,
                  Tolerance::round_off(1e-16, "the elapsed time of RESTART.DAT plus the time at the end of each LOOP"),
                  "s");
  findings.expect("history.csv: means over each LOOP, largest error", worst, 0.0, of_paths());
}

/// Area of a disc of radius 1 between two heights relative to its centre: the integral of 2 cos^2.
double area_between(double low, double high) {
  const auto integral = [](double height) {
    const double angle = std::asin(std::clamp(height, -1.0, 1.0));
    return angle + 0.5 * std::sin(2.0 * angle);
  };
  return integral(high) - integral(low);
}

/// Velocity, temperature and solid fraction of a layer, omitting the looks in tenth `without` of the time (10: none).
std::array<double, 3> layer_of(const Expected& expected, double low, double high, std::size_t without) {
  constexpr double radius = 0.5 * diameter;
  const auto each = [&](auto&& visit) {
    for (const Seen& disc : expected.seen) {
      if (part(disc.time - start_up, end - start_up, 10) == without) continue;
      const double inside = area_between((low - disc.y) / radius, (high - disc.y) / radius);
      visit(disc, disc.weight * radius * radius * inside);
    }
  };
  double whole = 0.0, velocity = 0.0, temperature = 0.0, time = 0.0;
  each([&](const Seen& disc, double ratio) { whole += ratio, velocity += ratio * disc.vx; });
  if (whole > 0.0) velocity /= whole;
  each([&](const Seen& disc, double ratio) {
    temperature += ratio * 0.5 * mass * ((disc.vx - velocity) * (disc.vx - velocity) + disc.vy * disc.vy);
  });
  for (std::size_t tenth = 0; tenth < 10; ++tenth)
    time += tenth == without ? 0.0 : expected.weights[tenth];
  return {velocity, whole > 0.0 ? temperature / whole : 0.0, whole / (time * width * (high - low))};
}

void check_profile(const TemporaryFolder& folder, const Expected& expected, Findings& findings, const Setup& setup) {
  const Csv profile = records::read_csv(folder.path() / "out/profile.csv");
  const std::vector<std::string> header{
      "y [m]",          "velocity [m/s]",      "velocity_error [m/s]", "temperature [N m]", "temperature_error [N m]",
      "solid_fraction", "solid_fraction_error"};
  findings.expect_true("profile.csv: names, units and order of its columns", profile.header() == header,
                       "SI, as given by the option");
  const double thickness = 0.5 * diameter, shift = setup.has("layers_shifted") ? 0.01 * thickness : 0.0;
  double positions = 0.0, means = 0.0, errors = 0.0, discs = 0.0;
  const std::array scale{block_speed, 0.5 * mass, 1.0};
  std::vector<double> lows;  // lower bounds of the layers that contained discs
  for (int layer = 0; layer < 4 * rows; ++layer)
    if (layer_of(expected, layer * thickness, (layer + 1) * thickness, 10)[2] > 0.0) lows.push_back(layer * thickness);
  findings.expect("profile.csv: rows", static_cast<double>(profile.rows()), static_cast<double>(lows.size()),
                  Tolerance::exact("layers that contained discs"));
  for (std::size_t row = 0; row < std::min(profile.rows(), lows.size()); ++row) {
    const double low = lows[row] + shift;
    keep_worst(positions, profile.number(row, 0) - (low + 0.5 * thickness - shift));
    const std::array all = layer_of(expected, low, low + thickness, 10);
    discs += profile.number(row, 5) * width * thickness;
    std::vector<std::array<double, 3>> parts;
    for (std::size_t tenth = 0; tenth < 10; ++tenth)  // one tenth contains no look
      if (expected.weights[tenth] > 0.0) parts.push_back(layer_of(expected, low, low + thickness, tenth));
    const auto kept = static_cast<double>(parts.size());
    const bool always = std::ranges::all_of(parts, [](const auto& of) { return of[2] > 0.0; });
    for (std::size_t k = 0; k < all.size(); ++k) {
      keep_worst(means, (profile.number(row, 1 + 2 * k) - all[k]) / scale[k]);
      double mean = 0.0, squares = 0.0;
      for (const auto& of : parts)
        mean += of[k] / kept;
      for (const auto& of : parts)
        squares += (of[k] - mean) * (of[k] - mean);
      if (always)
        keep_worst(errors, (profile.number(row, 2 + 2 * k) - std::sqrt((kept - 1.0) / kept * squares)) / scale[k]);
    }
  }
  findings.expect(
      "profile.csv: heights of its layers, largest error", positions, 0.0,
      Tolerance::round_off(1e-17, "centres of layers of half a diameter, from the base's centre line upwards"), "m");
  findings.expect("profile.csv: velocity, temperature and solid fraction, largest error", means, 0.0, of_paths());
  findings.expect("profile.csv: jackknife errors, largest error", errors, 0.0, of_paths());
  findings.expect("profile.csv: area of the discs in all layers over the area of all discs",
                  discs / (0.25 * std::numbers::pi * diameter * diameter * free_discs), 1.0,
                  Tolerance::round_off(1e-12, "the layers contain the whole area of each disc"));
}

/// Compares a state of cell.pvd: discs and those images that contacts reach, contacts as lines.
struct StateErrors {
  double discs{}, contacts{};
};
void compare_state(const std::string& text, const State& state, StateErrors& worst) {
  const std::vector<double> points = data_array(text, "Points"), velocity = data_array(text, "velocity"),
                            id = data_array(text, "id"), radius = data_array(text, "radius"),
                            wall = data_array(text, "wall"), force = data_array(text, "force"),
                            multiple_of = data_array(text, "multiple");
  const VirtualDiscs& discs = state.discs;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto disc = static_cast<std::size_t>(std::abs(id[i])) - 1;
    const double along = points.at(3 * i) - discs.x.at(disc);
    keep_worst(worst.discs, wrapped(along) / diameter);
    keep_worst(worst.discs, (points.at(3 * i + 1) - discs.y[disc]) / diameter);
    keep_worst(worst.discs, (velocity.at(3 * i) - discs.vx[disc]) / block_speed);
    keep_worst(worst.discs, (velocity.at(3 * i + 1) - discs.vy[disc]) / block_speed);
    keep_worst(worst.discs, radius.at(i) / diameter - 0.5);
    keep_worst(worst.discs, wall.at(i) - (disc < free_discs ? 0.0 : disc < free_discs + wall_discs ? 1.0 : 2.0));
    if (i < all_discs) keep_worst(worst.discs, id[i] - static_cast<double>(i + 1));
  }
  // The file's cells are a vertex for each disc, then the lines; the connectivity in <Lines> is that of the lines.
  const std::vector<double> ends = data_array(text.substr(text.find("<Lines>")), "connectivity");
  const std::vector<double> line_ends = data_array(text.substr(text.find("<Lines>")), "offsets"),
                            vertices = data_array(text.substr(text.find("<Verts>")), "connectivity"),
                            vertex_ends = data_array(text.substr(text.find("<Verts>")), "offsets");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    keep_worst(worst.discs, vertices[i] - static_cast<double>(i));
    keep_worst(worst.discs, vertex_ends.at(i) - static_cast<double>(i + 1));
  }
  for (const double point : ends)
    keep_worst(worst.contacts, point - std::floor(point));
  for (std::size_t line = 0; line < line_ends.size(); ++line)
    keep_worst(worst.contacts, line_ends[line] - 2.0 * static_cast<double>(line + 1));
  keep_worst(worst.contacts, static_cast<double>(ends.size()) / 2.0 - static_cast<double>(discs.contacts.size()));
  std::vector<bool> found(discs.contacts.size());
  for (std::size_t line = 0; line < ends.size() / 2; ++line) {
    const auto a = static_cast<std::size_t>(ends[2 * line]), b = static_cast<std::size_t>(ends[2 * line + 1]);
    const auto disc_a = static_cast<std::size_t>(std::abs(id.at(a))) - 1,
               disc_b = static_cast<std::size_t>(std::abs(id.at(b))) - 1;
    const auto same = std::ranges::find_if(discs.contacts, [&](const VirtualDiscs::Contact& contact) {
      return std::minmax(contact.a, contact.b) == std::minmax(disc_a, disc_b);
    });
    if (same == discs.contacts.end()) {
      keep_worst(worst.contacts, 1.0);
      continue;
    }
    const auto c = static_cast<std::size_t>(same - discs.contacts.begin());
    if (found[c]) keep_worst(worst.contacts, 1.0);  // drawn twice, in place of another
    found[c] = true;
    const double sign = same->a == disc_a ? 1.0 : -1.0, cell = force.at(all_discs + line);
    keep_worst(worst.contacts, (cell - same->force) / (k1 * diameter));
    keep_worst(worst.contacts, multiple_of.at(all_discs + line) - (state.multiple[c] ? 1.0 : 0.0));
    keep_worst(worst.contacts, (points.at(3 * b) - points.at(3 * a) - sign * same->dx) / diameter);
    keep_worst(worst.contacts, (points.at(3 * b + 1) - points.at(3 * a + 1) - sign * same->dy) / diameter);
  }
}

void check_states(const TemporaryFolder& folder, const Expected& expected, Findings& findings, const Setup& setup) {
  const std::vector<GeometryState> files = geometry_states(folder, "out", "cell");
  findings.expect("cell.pvd: states", static_cast<double>(files.size()), static_cast<double>(expected.states.size()),
                  Tolerance::exact("one at the end of each LOOP"));
  double times = 0.0;
  StateErrors worst;
  std::size_t contacts_seen = 0;
  for (std::size_t k = 0; k < std::min(files.size(), expected.states.size()); ++k) {
    keep_worst(times, files[k].time - (elapsed + std::min(static_cast<double>(k + 1) * loop, end)));
    const std::size_t of = setup.has("state_one_late") && k + 1 < expected.states.size() ? k + 1 : k;
    compare_state(files[k].text, expected.states[of], worst);
    contacts_seen += expected.states[k].multiple.size();
  }
  findings.expect("cell.pvd: times of the states, largest error", times, 0.0,
                  Tolerance::round_off(2e-15, "a sum of 2010 steps of 3e-7 s, each rounded by at most 9e-19 s"), "s");
  findings.expect("cell.pvd: positions, velocities, radii and walls of discs, largest error", worst.discs, 0.0,
                  of_paths());
  findings.expect("cell.pvd: ends, forces and kinds of contacts, largest error", worst.contacts, 0.0, of_paths());
  findings.expect_between("cell.pvd: contacts compared", static_cast<double>(contacts_seen), 60.0, 600.0,
                          "without contacts nothing is compared; in a plane a disc has four contacts on average where "
                          "the flow jams");
}

/// The animation of the cell: positions in whole quanta, speeds and forces in whole thousandths of the largest.
void check_player(const TemporaryFolder& folder, const Expected& expected, Findings& findings) {
  (void)talus_output(folder, {"animate", "out"});
  const std::string page = folder.read("out/plots/animation.html"), begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  const Json data = Json::parse(page.substr(from, page.find("</script>", from) - from));
  const Node player{data, "animation.html"};
  const double quantum = player.at("discs").at("quantum").number();
  double largest_speed = 0.0, largest_force = 0.0;
  for (const State& state : expected.states) {
    for (std::size_t i = 0; i < free_discs; ++i)
      largest_speed = std::max(largest_speed, std::hypot(state.discs.vx[i], state.discs.vy[i]));
    for (const VirtualDiscs::Contact& contact : state.discs.contacts)
      largest_force = std::max(largest_force, contact.force);
  }
  const std::vector<Node> frames = player.at("frames").list();
  double positions = 0.0, thousandths = 0.0;
  for (std::size_t f = 0; f < std::min(frames.size(), expected.states.size()); ++f) {
    const VirtualDiscs& discs = expected.states[f].discs;
    const std::vector<Node> at = frames[f].at("positions").list(), speeds = frames[f].at("speeds").list(),
                            contacts_of = frames[f].at("contacts").list();
    for (std::size_t i = 0; i < free_discs; ++i) {
      keep_worst(positions, wrapped(quantum * at.at(2 * i).number() - discs.x[i]) / quantum);
      keep_worst(positions, std::max(0.0, std::abs(at[2 * i].number()) - half / quantum));  // outside the field
      keep_worst(positions, at.at(2 * i + 1).number() - discs.y[i] / quantum);
      keep_worst(thousandths, speeds.at(i).number() - 1e3 * std::hypot(discs.vx[i], discs.vy[i]) / largest_speed);
    }
    double forces = 0.0, exact = 0.0;
    for (std::size_t c = 2; c < contacts_of.size(); c += 3)
      forces += contacts_of[c].number() / 1e3;
    for (const VirtualDiscs::Contact& contact : discs.contacts)
      exact += contact.force / largest_force;
    const double count_of = std::max(1.0, static_cast<double>(discs.contacts.size()));
    keep_worst(thousandths, 1e3 * (forces - exact) / count_of);
  }
  findings.expect("animation: frames", static_cast<double>(frames.size()), static_cast<double>(expected.states.size()),
                  Tolerance::exact("one for each state"));
  const Tolerance rounded = Tolerance::model(0.5 + 1e-6, "rounded to whole numbers");
  findings.expect("animation: positions of the discs, largest error in quanta", positions, 0.0, rounded);
  findings.expect("animation: speeds and mean forces, largest error in thousandths", thousandths, 0.0, rounded);
}

std::vector<std::array<double, 4>> numbers_of(const std::string& text, std::size_t in_line) {
  std::vector<std::array<double, 4>> lines;
  std::istringstream input{text};
  for (std::array<double, 4> line{}; input >> line[0];) {
    for (std::size_t k = 1; k < in_line; ++k)
      input >> line[k];
    lines.push_back(line);
  }
  return lines;
}

/// Output files of 1989: RESTART.DAT and PIC.DAT of the last LOOP.
void check_decks(const TemporaryFolder& folder, const Expected& expected, Findings& findings) {
  const VirtualDiscs& discs = expected.states.back().discs;
  const std::string restart = folder.read("out/RESTART.DAT");
  const std::size_t first = restart.find('\n') + 1;
  const std::array head = numbers_of(restart.substr(0, first), 2).at(0);
  findings.expect("RESTART.DAT: elapsed time", head[0], elapsed + end,
                  Tolerance::round_off(2e-15, "a sum of 2010 steps of 3e-7 s, each rounded by at most 9e-19 s"), "s");
  findings.expect("RESTART.DAT: cycles", head[1], static_cast<double>(cycles + steps),
                  Tolerance::exact("those of the file from which the run started plus those of the run"));
  double worst = 0.0;
  const auto records = numbers_of(restart.substr(first), 4);
  for (std::size_t i = 0; i < records.size(); ++i) {
    keep_worst(worst, wrapped(records[i][0] - discs.x.at(i)) / diameter);
    keep_worst(worst, (records[i][1] - discs.y[i]) / diameter);
    keep_worst(worst, (records[i][2] - discs.vx[i]) / block_speed);
    keep_worst(worst, (records[i][3] - discs.vy[i]) / block_speed);
  }
  findings.expect("RESTART.DAT: discs", static_cast<double>(records.size()), free_discs,
                  Tolerance::exact("the free discs"));
  findings.expect("RESTART.DAT: positions and velocities, largest error", worst, 0.0, of_paths());
  // All discs, and their images that are within the field or overlap its border.
  std::vector<std::array<double, 3>> pictures;
  for (std::size_t i = 0; i < all_discs; ++i) {
    for (const double box : {-1.0, 0.0, 1.0}) {
      const double x = wrapped(discs.x[i]) + box * width, number = static_cast<double>(i + 1);
      if (std::abs(x) < half + 0.5 * diameter) pictures.push_back({box == 0.0 ? number : -number, x, discs.y[i]});
    }
  }
  const auto drawn = numbers_of(folder.read("out/PIC.DAT"), 3);
  double away = static_cast<double>(drawn.size()) - static_cast<double>(pictures.size());
  for (const auto& picture : pictures) {
    double nearest = 1.0;
    for (const auto& row : drawn)
      if (row[0] == picture[0]) nearest = std::min(nearest, std::hypot(row[1] - picture[1], row[2] - picture[2]));
    keep_worst(away, nearest / diameter);
  }
  findings.expect("PIC.DAT: discs and virtual discs, number and largest distance", away, 0.0, of_paths());
}

/// Tests both sides of the limits of a cell's step: 10 steps per contact for a leapfrog, and for Euler a restitution
/// e exp[(w1 + w2) pi h/4] with an error of at most 0.05.
void check_limits(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const double w1 = std::sqrt(2.0 * k1 / mass), w2 = std::sqrt(2.0 * k2 / mass);
  const double contact = 0.5 * std::numbers::pi * (1.0 / w1 + 1.0 / w2);
  const double euler = std::log(0.75 / 0.7) / (0.25 * std::numbers::pi * (w1 + w2));
  double wrong = 0.0;
  for (const auto& [method, limit] : {std::pair{"euler_cromer", contact / 10.0}, std::pair{"euler", euler}}) {
    for (const double ratio : {0.999, 1.001}) {
      const double h = ratio * limit * (setup.has("limit_doubled") ? 2.0 : 1.0);
      folder.write("LIMIT.DAT",
                   fmt::format("0 0\n{} {} {} {} {} {}\n{} {} {} {}\n{} {} {}\n", k1, k2, diameter, mass, gravity,
                               block_mass, rows, columns, wall_discs, block_speed, h, 2.0 * h, 4.0 * h));
      const ProgramEnd ended = run_talus(folder, {"cell", "LIMIT.DAT", "--integrator", method});
      wrong += ended.exit_code == (ratio < 1.0 ? 0 : 2) ? 0.0 : 1.0;
    }
  }
  findings.expect(
      "steps accepted or rejected on the wrong side of their limit", wrong, 0.0,
      Tolerance::exact("exit status 0 for 0.999 of the limit, and 2, wrong input, for 1.001, for two methods"));
}

/// The same cell in a mirror, its block to the left: all results of the summary are those of the cell itself.
void check_mirrored(const TemporaryFolder& folder, const VirtualDiscs& before, const Node& results, Findings& findings,
                    const Setup& setup) {
  VirtualDiscs mirrored = before;
  for (std::size_t i = 0; i < free_discs; ++i)
    mirrored.x[i] = -mirrored.x[i], mirrored.vx[i] = -mirrored.vx[i];
  std::string control = control_text(setup);
  const std::string drive = fmt::format("{} {} {} ", rows, columns, wall_discs);
  control.insert(control.find(drive) + drive.size(), "-");
  folder.write("MIRRORED.DAT", control);
  folder.write("RESTART.DAT", restart_text(mirrored, setup));
  (void)talus_output(folder,
                     {"cell", "MIRRORED.DAT", "--units", "SI", "--integrator", "euler_cromer", "--out", "mirrored"});
  const Json summary = records::read_json(folder.path() / "mirrored/summary.json");
  const Node found = Node{summary, "summary.json"}.at("results");
  double worst = 0.0;
  for (const auto& [name, result] : results.members()) {
    const double value = result.at("value").number(), in_mirror = found.at(name.c_str()).at("value").number();
    keep_worst(worst, (in_mirror - value) / std::max(std::abs(value), result.has("unit") ? diameter : 1.0));
  }
  findings.expect("mirrored cell, block to the left: results, largest difference from those of the cell", worst, 0.0,
                  of_paths());
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("cell");
  const TemporaryFolder folder;
  const VirtualDiscs before = start();
  folder.write("CNTRL.DAT", control_text(setup));
  folder.write("RESTART.DAT", restart_text(before, setup));
  const ProgramEnd ended =
      run_talus(folder, {"cell", "CNTRL.DAT", "--units", "SI", "--integrator", "euler_cromer", "--out", "out"});
  if (ended.exit_code != 0) throw std::runtime_error("talus cell: " + ended.messages);
  const Expected expected = expected_of(before, setup);
  findings.count(steps);
  check_history(folder, expected, findings);
  check_profile(folder, expected, findings, setup);
  check_states(folder, expected, findings, setup);
  check_decks(folder, expected, findings);
  if (setup.needs("wrong side of their limit")) check_limits(folder, findings, setup);
  if (setup.needs("animation")) check_player(folder, expected, findings);
  const Json summary = records::read_json(folder.path() / "out/summary.json");
  check_summary(Node{summary, "summary.json"}, expected, before, ended, findings, setup);
  if (setup.needs("of cells")) check_written_cells(folder, findings, setup);
  if (setup.needs("last rows")) check_last_rows(folder, findings, setup);
  if (setup.needs("resumed")) check_interrupted(folder, findings, setup);
  if (setup.needs("whose discs touch")) check_contacting_cells(folder, findings, setup);
  if (setup.needs("mirrored"))
    check_mirrored(folder, before, Node{summary, "summary.json"}.at("results"), findings, setup);
  if (setup.coarse) return;
  const Csv profile = records::read_csv(folder.path() / "out/profile.csv");
  std::vector<double> heights, velocities;
  for (std::size_t row = 0; row < profile.rows(); ++row)
    heights.push_back(profile.number(row, 0) / diameter), velocities.push_back(profile.number(row, 1) / block_speed);
  Series exact{.label = "reference", .style = Style::lines};
  for (double y = 0.25; y < heights.back(); y += 0.05)
    exact.add(layer_of(expected, (y - 0.25) * diameter, (y + 0.25) * diameter, 10)[0] / block_speed, y);
  findings.figure({.name = "profile",
                   .title = "Velocity profile in profile.csv",
                   .caption = "Mean velocity along x of discs in layers of half a diameter: rows of the file (points) "
                              "and the reference's motion in layers at any height (line).",
                   .x = {.label = "velocity over that of the block"},
                   .y = {.label = "height over D"},
                   .series = {exact, points("profile.csv", velocities, heights)}});
}

}  // namespace

Case definition() {
  return {.id = "cell_files",
          .title = "Output files of a sheared cell",
          .requirements = {{"G5", {"cell"}}},
          .main_checks = {"history.csv: means over each LOOP, largest error",
                          "profile.csv: velocity, temperature and solid fraction, largest error",
                          "cell.pvd: positions, velocities, radii and walls of discs, largest error",
                          "summary.json: results, largest error"},
          .source =
              "Lacy 1989, Data Input and Parameters (files, stresses), Virtual Elements and Periodic Boundaries "
              "(reference)",
          .faults = {{"whole_loops", "a cell that ends with a whole LOOP, compared with one that ends a step later",
                      "last rows and steadiness of cells: values that differ"},
                     {"resumed_cell_of_another_seed", "a cell with another seed in place of the resumed one",
                      "cell with choices of the command line, resumed: files that differ from those in one run"},
                     {"faster_block", "a block too fast by a factor of 1 + 1e-7",
                      "history.csv: means over each LOOP, largest error"},
                     {"started_later", "an elapsed time in RESTART.DAT too long by 1e-9 s",
                      "cell.pvd: positions, velocities, radii and walls of discs, largest error"},
                     {"samples_one_loop_late", "samples assigned to the previous LOOP",
                      "history.csv: means over each LOOP, largest error"},
                     {"layers_shifted", "layers compared with those higher by a hundredth of their thickness",
                      "profile.csv: velocity, temperature and solid fraction, largest error"},
                     {"error_without_factor", "standard errors too small by a tenth",
                      "summary.json: standard errors, largest difference to a bootstrap"},
                     {"another_seed", "parameters compared with those of another seed",
                      "parameters of cells that differ from their scenes"},
                     {"more_growth", "a growth of the unloading stiffness too large by 0.1 %",
                      "cells whose discs touch: forces of latching springs from positions, largest error"},
                     {"stiffer_spheres", "a shear modulus of spheres larger by 1e-4",
                      "cells whose discs touch: accelerations by Hertz's law and friction of spheres, largest error"},
                     {"rougher_discs", "a friction coefficient of 0.501 in place of 0.5",
                      "cells whose discs touch: accelerations by normal and friction forces, largest error"},
                     {"stiffer_shear", "a shear stiffness of 20.01 N/m in place of 20 N/m",
                      "cells whose discs touch: accelerations by normal and friction forces, largest error"},
                     {"clamped_discs", "dashpots that do not pull",
                      "cells whose discs touch: forces of dashpots from positions and velocities, largest error"},
                     {"limit_doubled", "steps about twice their limits",
                      "steps accepted or rejected on the wrong side of their limit"},
                     {"state_one_late", "states compared with those of the next LOOP",
                      "cell.pvd: ends, forces and kinds of contacts, largest error"}},
          .seconds = 4.0,
          .run = run};
}

}  // namespace talus::verification::problems::cell_files
