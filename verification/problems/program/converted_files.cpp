#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/expectations.hpp"
#include "verification/study/program_run.hpp"

namespace talus::verification::problems::converted_files {
namespace {

using records::Json;
using records::Node;

/// All numbers of a text that follow a blank, quote, bracket, comma, tab, line end or `=`.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> found;
  for (std::size_t at = 0; at < text.size();) {
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    const bool begins = at == 0 || std::string_view{" \"[,\t\n="}.find(text[at - 1]) != std::string_view::npos;
    if (failure == std::errc{} && begins) {
      found.push_back(value);
      at = static_cast<std::size_t>(end - text.data());
    } else {
      ++at;
    }
  }
  return found;
}

/// Number of `values` that do not occur in the text with all their bits.
double missing(const std::vector<double>& values, const std::string& text) {
  const std::vector<double> there = numbers_in(text);
  return static_cast<double>(
      std::ranges::count_if(values, [&](double value) { return std::ranges::count(there, value) == 0; }));
}

/// The numbers that follow the first occurrence of `words` in a text, on the same line.
std::vector<double> numbers_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) throw std::runtime_error("'" + words + "' is expected in a file");
  const std::size_t from = at + words.size();
  return numbers_in(std::string_view{text}.substr(from, text.find('\n', from) - from));
}

/// The scene of Table 2 with numbers that need all digits of a double and occur once each.
struct LongScene {
  std::string text = records::read_whole(TALUS_CASES "/fence/table_2.toml");
  std::vector<double> values;
};
LongScene long_scene() {
  LongScene scene;
  std::mt19937_64 random{5};
  for (const auto& [name, number, unit] :
       {std::tuple{"gravity = \"", 32.18, " ft/s^2\""}, std::tuple{"span = \"", 55.0, " ft\""},
        std::tuple{"sag = \"", 5.5, " ft\""}, std::tuple{"y_top = \"", 6.5, " ft\""},
        std::tuple{"y_bottom = \"", -4.0, " ft\""}, std::tuple{"slack = \"", 0.5, " ft\""},
        std::tuple{"b = \"", 0.953951, " ft\""}, std::tuple{"density = \"", 5.127408, " slug/ft^3\""},
        std::tuple{"spin = \"", 34.0, " rad/s\""}, std::tuple{"position = [\"", 2.203951, " ft\", \"0 ft\"]"},
        std::tuple{"velocity = [\"", -65.0, " ft/s\", \"0 ft/s\"]"}, std::tuple{"restitution = ", 0.4, ""},
        std::tuple{"step_factor = ", 0.03418558, ""}, std::tuple{"density = \"", 0.38, " slug/ft^3\""}}) {
    const std::string old = fmt::format("{}{}{}", name, number, unit);
    const std::size_t at = scene.text.find(old);
    if (at == std::string::npos) throw std::runtime_error("table_2.toml: '" + old + "' is expected in it");
    const double value = number * (1.0 + 1e-3 * (static_cast<double>(random() >> 11U) * 0x1p-53));
    scene.text.replace(at, old.size(), fmt::format("{}{:.17g}{}", name, value, unit));
    scene.values.push_back(value);
  }
  return scene;
}

/// Converts a scene to a deck of 1993, and this deck back to a scene.
void check_deck(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const LongScene scene = long_scene();
  folder.write("fence.toml", scene.text);
  (void)talus_output(folder, {"convert", "fence.toml", "deck.DAT"});
  (void)talus_output(folder, {"convert", "deck.DAT", "back.toml"});
  std::vector<double> values = scene.values;
  if (setup.has("sixteen_digits"))
    for (double& value : values)
      value = std::stod(fmt::format("{:.16g}", value));
  findings.expect("numbers of the scene missing in the deck", missing(values, folder.read("deck.DAT")), 0.0,
                  Tolerance::exact("17 digits restore the same double"));
  findings.expect("numbers of the scene missing in the scene converted back from the deck",
                  missing(values, folder.read("back.toml")), 0.0,
                  Tolerance::exact("17 digits restore the same double"));
  for (const char* const file : {"fence.toml", "deck.DAT"})
    (void)talus_output(folder, {"run", file, "--end", "0.2 ms", "--out", file == std::string{"deck.DAT"} ? "b" : "a"});
  findings.expect_true("byte-identical history.csv of the scene and of its deck",
                       folder.read("a/history.csv") == folder.read("b/history.csv"),
                       "the deck contains all numbers that the run depends on, in their units");
}

/// The fence after one rock, and after two, that plastically elongated its cables.
void check_after(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  std::string deck = records::read_whole(TALUS_CASES "/fence/sample2.DAT");
  const std::string limits = "1e8 1e8";
  deck.replace(deck.find(limits), limits.size(), "20000. 1e8");
  folder.write("yields.DAT", deck);
  // The run need not be a usable simulation: any final state with plastic elongation serves.
  (void)talus_output(folder, {"run", "yields.DAT", "--end", "0.1 s", "--out", "first"});
  (void)talus_output(folder, {"convert", "yields.DAT", "second.toml", "--after", "first"});
  (void)talus_output(folder, {"convert", "second.toml", "third.toml", "--after", "first"});
  const Json state = records::read_json(folder.path() / "first/final_state.json");
  const std::string second = folder.read("second.toml"), third = folder.read("third.toml");
  double once = 0.0, twice = 0.0, count = 0.0;
  for (const Node& cable : Node{state, "final_state.json"}.at("cables").list()) {
    const double stretch = cable.at("plastic_stretch").number();
    if (!(stretch > 0.0)) continue;
    ++count;
    const std::string words = fmt::format("cable = \"{}\"\nstretch = \"", cable.at("name").text());
    keep_worst(once, numbers_after(second, words).at(0) / stretch - 1.0);
    keep_worst(twice,
               numbers_after(third, words).at(0) / ((setup.has("first_rock_alone") ? 1.0 : 2.0) * stretch) - 1.0);
  }
  findings.expect_between("plastically elongated cables after the first rock", count, 3.0, 14.0,
                          "the weak top cable has seven segments in each of two layers");
  findings.expect("plastic elongation of the cables for the second rock, largest relative error", once, 0.0,
                  Tolerance::round_off(1e-15, "the numbers of final_state.json in the same unit"));
  findings.expect("plastic elongation of the cables for the third rock, largest relative error", twice, 0.0,
                  Tolerance::round_off(1e-15, "the sum of two equal numbers"));
}

/// xi of a clamped contact with this restitution: ln(1/e) = 2 xi arccos(xi)/sqrt(1 - xi^2), by bisection.
double damping_ratio(double restitution) {
  double low = 0.0, high = 0.999;
  for (int n = 0; n < 60; ++n) {
    const double xi = 0.5 * (low + high);
    (2.0 * xi * std::acos(xi) / std::sqrt(1.0 - xi * xi) < -std::log(restitution) ? low : high) = xi;
  }
  return low;
}

/// A cell as read by LAMMPS: masses by the volumes of spheres, walls, law, step, and the area of the stresses.
void check_lammps(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double diameter = 1e-3, mass = 7.2e-7, gravity = 9.81, overburden = 8e3, speed = 5.0;
  constexpr int rows = 8, columns = 10, wall = 11, free = rows * columns;
  constexpr double step = 2e-7, width = wall * diameter, area = width * diameter,
                   block_mass = overburden * area / gravity;
  constexpr double stiffness = 20305.0, shear_stiffness = 14214.0, friction = 0.5;
  const double ratio = damping_ratio(setup.has("other_restitution") ? 0.7 + 1e-9 : 0.7);
  const auto damping = [&](double k) { return 2.0 * ratio * std::sqrt(k * 0.5 * mass); };
  // The cell with latching springs, which --dashpot replaces by springs with dashpots.
  constexpr double latching_stiffness = 1.7e4;
  folder.write("ice.toml", records::read_whole(TALUS_CASES "/cell/ice.toml"));
  (void)talus_output(folder, {"export", "lammps", "ice.toml", "--dashpot", "--out", "ice"});
  const std::vector<double> replaced = numbers_after(folder.read("ice/in.discs"), "pair_coeff * * hooke");
  folder.write("rough.toml", records::read_whole(TALUS_CASES "/cell/rough.toml"));
  (void)talus_output(folder, {"export", "lammps", "rough.toml", "--out", "lammps"});
  const std::string input = folder.read("lammps/in.discs"), data = folder.read("lammps/discs.data");
  const Tolerance round_off =
      Tolerance::round_off(5e-15, "about ten roundings on either side, 1.1e-16 each, in 17 digits; twice that");
  double law = 0.0, run = 0.0;
  const auto compare = [&](double& worst, const std::string& words, const std::vector<double>& exact) {
    const std::vector<double> found = numbers_after(input, words);
    keep_worst(worst, static_cast<double>(found.size()) - static_cast<double>(exact.size()));
    for (std::size_t k = 0; k < std::min(found.size(), exact.size()); ++k)
      keep_worst(worst, exact[k] != 0.0 ? found[k] / exact[k] - 1.0 : found[k]);
  };
  compare(law, "pair_coeff * * hooke", {stiffness, damping(stiffness), shear_stiffness, 0.0, friction});
  keep_worst(law, replaced.at(0) / latching_stiffness - 1.0);
  keep_worst(law, replaced.at(1) / damping(latching_stiffness) - 1.0);
  findings.expect("in.discs: coefficients of the contacts, largest relative error", law, 0.0, round_off);
  compare(run, "timestep", {step}), compare(run, "\nrun 0\nundump forces\nrun", {0.1 / step});
  compare(run, "fix fall2 wall2 gravity", {gravity, 0.0, -1.0, 0.0});
  compare(run, "variable shear equal -f_guide2[1]/", {area}),
      compare(run, "variable normal equal f_guide2[2]/", {area});
  compare(run, "print \"means after step", {0.25 * 0.1 / step});
  findings.expect("in.discs: step, steps, weight of the block and area of the stresses, largest relative error", run,
                  0.0, round_off);

  // Atoms: number, type, diameter, density, x, y, z. The mass of a sphere is density pi d^3/6.
  std::istringstream atoms{data.substr(data.find("Atoms # sphere") + 14)};
  double masses = 0.0, places = 0.0, block = 0.0;
  const double row = std::max(width / columns, 1.05 * diameter), top = row * (rows + 1);
  for (int i = 0; i < free + 2 * wall; ++i) {
    double number = 0.0, type = 0.0, across = 0.0, density = 0.0, x = 0.0, y = 0.0, z = 0.0;
    atoms >> number >> type >> across >> density >> x >> y >> z;
    const int of_wall = i < free ? 0 : 1 + (i - free) / wall;
    const double of_sphere = density * std::numbers::pi / 6.0 * across * across * across;
    keep_worst(places, number - (i + 1)), keep_worst(places, type - (of_wall + 1));
    keep_worst(places, across / diameter - 1.0);
    if (of_wall == 0) keep_worst(masses, of_sphere / mass - 1.0);
    if (of_wall == 2) block += of_sphere;
    const double column = of_wall == 0 ? (i % columns + 0.5) / columns : ((i - free) % wall + 0.5) / wall;
    keep_worst(places, (x - width * (column - 0.5)) / diameter);
    keep_worst(places, (y - (of_wall == 0 ? row * (i / columns + 1) : of_wall == 1 ? 0.0 : top)) / diameter);
  }
  findings.expect("discs.data: masses of the free discs, largest relative error", masses, 0.0, round_off);
  findings.expect("discs.data: total mass of the block's discs over that of the block", block / block_mass, 1.0,
                  round_off);
  findings.expect("discs.data: numbers, types, diameters and positions, largest error", places, 0.0, round_off);
  // Velocities: number, three components along the axes, three of the spin.
  std::istringstream velocities{data.substr(data.find("Velocities") + 10)};
  double along = 0.0;
  for (int i = 0; i < free + 2 * wall; ++i) {
    std::array<double, 7> of{};
    for (double& value : of)
      velocities >> value;
    const double height = i < free ? row * (i / columns + 1) : i < free + wall ? 0.0 : top;
    keep_worst(along, (of[1] - speed * height / top) / speed);
  }
  findings.expect("discs.data: velocities along x, largest error", along, 0.0, round_off);
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("converted");
  const TemporaryFolder folder;
  if (setup.needs("of the scene")) check_deck(folder, findings, setup);
  if (setup.needs("rock")) check_after(folder, findings, setup);
  if (setup.needs("discs")) check_lammps(folder, findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "converted_files",
          .title = "Exported and converted files",
          .requirements = {{"G6", {"converted"}}},
          .main_checks = {"numbers of the scene missing in the deck",
                          "plastic elongation of the cables for the third rock, largest relative error",
                          "in.discs: coefficients of the contacts, largest relative error",
                          "discs.data: total mass of the block's discs over that of the block"},
          .source =
              "Mustoe & Huttelmaier 1993, Table 2 and sample deck (scenes); Schwager & Poeschel 2007 (clamped contact)",
          .faults = {{"sixteen_digits", "numbers compared after rounding to 16 digits",
                      "numbers of the scene missing in the deck"},
                     {"first_rock_alone", "a third rock on cables elongated by the first rock only",
                      "plastic elongation of the cables for the third rock, largest relative error"},
                     {"other_restitution", "a restitution of the reference too large by 1e-9",
                      "in.discs: coefficients of the contacts, largest relative error"}},
          .run = run};
}

}  // namespace talus::verification::problems::converted_files
