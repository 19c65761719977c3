#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/scenes/toml_values.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

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

/// The numbers that follow the first occurrence of `before` in a text, on the same line.
std::vector<double> numbers_after(const std::string& text, const std::string& before) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) throw std::runtime_error("'" + before + "' is expected in a file");
  const std::size_t from = at + before.size();
  return numbers_in(std::string_view{text}.substr(from, text.find('\n', from) - from));
}

/// The scene of Table 2 with numbers that need all digits of a double and occur once each.
struct LongScene {
  std::string text = records::read_whole(case_file("fence/table_2.toml"));
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

/// The text with each decimal fraction multiplied by a random factor between 1 and 1.001, in 17 digits.
std::string with_long_numbers(const std::string& text) {
  static const std::regex fraction("[0-9]+\\.[0-9]+");
  std::mt19937_64 random{7};
  std::string result;
  auto from = text.begin();
  for (std::sregex_iterator it(text.begin(), text.end(), fraction), none; it != none; ++it) {
    const double value = std::stod(it->str()) * (1.0 + 1e-3 * (static_cast<double>(random() >> 11U) * 0x1p-53));
    result.append(from, (*it)[0].first);
    result += fmt::format("{:.17g}", value);
    from = (*it)[0].second;
  }
  return result.append(from, text.end());
}

/// Numbers of a whole fence, each different from its default.
const std::string fence_numbers = R"(title = "A fence with every field"
units = "US"
[fence]
steps = 1000
print_every = 70
history_every = 30
gravity_sign = -1
columns = 13
layers = 1
step_factor = 0.5
penetration = 0.05
gravity = "32.25 ft/s^2"
span = "55.5 ft"
sag = "5.5 ft"
spacing = "2.5 ft"
young = "20000000.5 psi"
y_top = "6.5 ft"
y_bottom = "-4.5 ft"
restitution = 0.4
area_top = "1.076 in^2"
area_bottom = "0.25 in^2"
friction = 0.31
slack = "0.55 ft"
limit_top = "20000.5 lbf"
limit_bottom = "30000.5 lbf"
layer_spacing = "2.6 ft"
rock_overlap = "0.06 ft"
layer_overlap = "0.07 ft"
history_elements = [2, 3, 4, 5, 6]
history_codes = [51, 52, 48, 6, 7, 8, 35, 36]
)";

/// An element of the fence; `more`: position, outline, solid, motion.
std::string element(const std::string& head, const std::string& more) {
  return "\n" + head + R"(
points = 3
b = "0.75 ft"
density = "5.25 slug/ft^3"
bar_length = "0.55 ft"
angle = "0.11 rad"
moment = "1.5 lbf ft"
force = ["1.5 lbf", "-2.5 lbf"]
fixed_point = ["0.15 ft", "0.35 ft"]
)" + more;
}

const std::string still = "velocity = [\"0 ft/s\", \"0 ft/s\"]\n", no_spin = "spin = \"0 rad/s\"\n";
const std::string moving = "velocity = [\"-65.5 ft/s\", \"-3.5 ft/s\"]\n", turning = "spin = \"3.5 rad/s\"\n",
                  ground_solid =
                      "a = \"10.5 ft\"\nsolid = \"ellipsoid\"\nposition = [\"0.25 ft\", \"-5.5 ft\"]\n"
                      "held = [\"x\", \"y\", \"rotation\"]\n",
                  column_solid = "a = \"1.25 ft\"\nsolid = \"cylinder\"\nheld = [\"rotation\"]\n",
                  rock_solid = "a = \"1.5 ft\"\nsolid = \"block\"\nposition = [\"2.25 ft\", \"0.5 ft\"]\n",
                  second_solid = "a = \"1.5 ft\"\nsolid = \"ellipsoid\"\nposition = [\"8.25 ft\", \"0.5 ft\"]\n";

/// A scene that sets every field that a deck has.
std::string scene_of_deck() {
  const std::string power = "power = 0.35\n";
  std::string text = fence_numbers;
  text.insert(text.find("steps"), "rules = \"1993\"\nconnections = 1\n");
  return text + element("[fence.ground]", power + ground_solid + still + no_spin) +
         element("[[fence.rock]]", power + rock_solid + moving + turning) +
         element("[[fence.rock]]", power + second_solid + moving + no_spin + "held = [\"rotation\"]\n") +
         element("[fence.column]", power + column_solid + moving + no_spin + "position = [\"0.5 ft\", \"0.35 ft\"]\n");
}

/// A scene that sets every field that a deck lacks, to other choices than the defaults; the last: of the cables.
std::string scene_with_options(const std::string& last) {
  return fence_numbers +
         "connections = 1\nground_profile = [[\"-90.5 ft\", \"-6.5 ft\"], [\"90.5 ft\", \"-6.25 ft\"]]\n" +
         element("[fence.ground]", ground_solid + still + no_spin + "shape = \"superquadric\"\nexponent = 4.5\n") +
         element("[[fence.rock]]",
                 rock_solid + moving + turning + "shape = \"superquadric\"\nexponent = 3.5\nalong = \"0.65 ft\"\n") +
         element("[[fence.rock]]", second_solid + moving + turning + "along = \"-0.75 ft\"\nshape = \"rectangle\"\n") +
         element("[fence.column]", column_solid + still + no_spin +
                                       "shape = \"superquadric\"\nexponent = 5.5\nposition = [\"0 ft\", \"0 ft\"]\n") +
         R"(
[[fence.changed_column]]
number = 3
a = "0.75 ft"
b = "4.15 ft"
density = "0.45 slug/ft^3"
y_top = "6.25 ft"
y_bottom = "-4.25 ft"
[[fence.stretched_cable]]
cable = "top1"
stretch = "0.015 ft"
[fence.options]
symmetry = "full"
even_centre = "doubled"
contact = "smoother"
calibration = "particles"
end_rule = "attractive"
start = "half_kick"
bottom_end = "anchored"
column_ground = "contact"
end = "exit"
sleep = "on"
integrator = "velocity_verlet"
tolerance = 0.00015
shear_ratio = 0.85
hanger_strength = "20500.5 lbf"
strength_top = "60500.5 lbf"
strength_bottom = "70500.5 lbf"
rupture = 0.35
exit_x = "-3.5 ft"
watch = { instability = "warning", tunnelling = "off", accuracy = "error", missing_contacts = "off", quality = "warning" }
)" + last;
}

/// Differences of the values of two scenes.
struct Changes {
  double wrong{}, rescaled{};       ///< values that differ; largest relative error of those in another unit
  std::vector<std::string> keys{};  ///< of the wrong ones
};

/// Finds each value of the first text in the second: numbers with all bits, units and texts.
void compare_values(const std::string& first, const std::string& second, Changes& changes) {
  static const std::map<std::string, double> consistent{
      {"psi", 144.0}, {"in^2", 1.0 / 144.0}, {"lbf/ft^2", 1.0}, {"ft^2", 1.0}};
  std::map<std::string, TomlValue> there;
  for (const TomlValue& value : toml_values(second))
    there.emplace(value.key, value);
  for (const TomlValue& value : toml_values(first)) {
    const auto found = there.find(value.key);
    const bool scaled = consistent.contains(value.text);
    if (found != there.end() && scaled && consistent.contains(found->second.text)) {
      keep_worst(changes.rescaled, *found->second.number * consistent.at(found->second.text) /
                                           (*value.number * consistent.at(value.text)) -
                                       1.0);
    } else if (found == there.end() || found->second.number != value.number || found->second.text != value.text) {
      changes.wrong += 1.0, changes.keys.push_back(value.key);
    }
    if (found != there.end()) there.erase(found);
  }
  // Values without which the first scene would not be complete.
  changes.wrong += static_cast<double>(there.size());
  for (const auto& [key, value] : there)
    changes.keys.push_back(key);
}

/// The title of a deck, with the signs that TOML escapes.
void check_title(const TemporaryFolder& folder, Findings& findings) {
  const std::string title = R"(slope \N of "Mile 9", rock 'B')";
  std::string deck = records::read_whole(case_file("fence/table_2.DAT"));
  folder.write("title.DAT", deck.replace(0, deck.find('\n'), title));
  (void)talus_output(folder, {"convert", "title.DAT", "title.toml"});
  const Json summary = Json::parse(talus_output(folder, {"run", "title.toml", "--end", "0.1 ms", "--json"}));
  findings.expect_true("title of a deck with quotes and a backslash", summary.at("title").get<std::string>() == title,
                       "the title of the converted scene, as read from it");
}

/// Fences that a deck cannot express are refused, and no deck is written.
void check_refused_decks(const TemporaryFolder& folder, Findings& findings) {
  const std::string text = records::read_whole(case_file("fence/table_2.toml")) + "[fence.options]\n",
                    ground = "[fence.ground]\n", power = "b = \"0.953951 ft\"\npower = 0.0\n",
                    options = "[fence.options]\n";
  struct Beyond {
    std::string replaced, by, message;
  };
  const std::vector<Beyond> fences{
      {options, "[[fence.changed_column]]\nnumber = 3\ndensity = \"0.45 slug/ft^3\"\n", "found a changed_column"},
      {ground, "ground_profile = [[\"-90 ft\", \"-6 ft\"], [\"90 ft\", \"-7 ft\"]]\n" + ground,
       "found a ground_profile"},
      {options, "[[fence.stretched_cable]]\ncable = \"top1\"\nstretch = \"0.01 ft\"\n", "found a stretched_cable"},
      {power, "b = \"0.953951 ft\"\nshape = \"rectangle\"\n", "found shape or exponent"},
      {power, "b = \"0.953951 ft\"\nshape = \"superquadric\"\nexponent = 3.5\n", "found shape or exponent"},
      {options, options + "sleep = \"on\"\n", "found sleep = \"on\""}};
  Differences refusals;
  for (const auto& [replaced, by, message] : fences) {
    std::string beyond = text;
    beyond.replace(beyond.find(replaced), replaced.size(), by);
    folder.write("beyond.toml", beyond);
    std::filesystem::remove(folder.path() / "beyond.DAT");
    refusals.ended(message, run_talus(folder, {"convert", "beyond.toml", "beyond.DAT"}), 2, message);
    refusals.holds(message + ": no deck", !std::filesystem::exists(folder.path() / "beyond.DAT"));
  }
  refusals.expect_none(findings, "fences that a deck cannot express and that are not refused",
                       "exit status 2, the field in the message, and no file");
}

/// Values that follow from others: mass and duration, and options that rules = "1993" takes.
void check_derived(const TemporaryFolder& folder, Findings& findings) {
  std::string text = records::read_whole(case_file("fence/table_2.toml"));
  const auto replace = [&](const std::string& old, const std::string& other) {
    const std::size_t at = text.find(old);
    if (at == std::string::npos) throw std::runtime_error("table_2.toml: '" + old + "' is expected in it");
    text.replace(at, old.size(), other);
  };
  constexpr double ground_mass = 40.5, rock_mass = 18.5, column_mass = 16.5, duration = 0.02;
  replace("steps = 100000", fmt::format("duration = \"{} s\"", duration));
  replace("density = \"0.1 slug/ft^3\"", fmt::format("mass = \"{} slug\"", ground_mass));
  replace("density = \"5.127408 slug/ft^3\"", fmt::format("mass = \"{} slug\"", rock_mass));
  replace("density = \"0.38 slug/ft^3\"", fmt::format("mass = \"{} slug\"", column_mass));
  text += "[fence.options]\nintegrator = \"velocity_verlet\"\n";
  folder.write("masses.toml", text);
  (void)talus_output(folder, {"convert", "masses.toml", "densities.toml"});
  std::map<std::string, TomlValue> found;
  for (const TomlValue& value : toml_values(folder.read("densities.toml")))
    found.emplace(value.key, value);
  const auto number = [&](const std::string& key) { return found.at(key).number.value(); };
  double mass = 0.0;
  for (const auto& [name, slugs, factor] : {std::tuple{"fence.ground", ground_mass, 8.0},
                                            std::tuple{"fence.rock[0]", rock_mass, 4.0 / 3.0 * std::numbers::pi},
                                            std::tuple{"fence.column", column_mass, 2.0 * std::numbers::pi}}) {
    const double a = number(fmt::format("{}.a", name)), b = number(fmt::format("{}.b", name));
    keep_worst(mass, number(fmt::format("{}.density", name)) * factor * a * a * b / slugs - 1.0);
  }
  findings.expect("densities that follow from masses, largest relative error", mass, 0.0,
                  Tolerance::round_off(2e-15, "five products and a quotient on either side, 1.1e-16 each"));
  const std::vector<std::pair<std::string, std::string>> of_1993{
      {"even_centre", "doubled"}, {"contact", "nodes"},   {"calibration", "particles"},
      {"end_rule", "attractive"}, {"start", "half_kick"}, {"integrator", "velocity_verlet"},
      {"symmetry", "half"},       {"bottom_end", "free"}, {"column_ground", "none"},
      {"end", "steps"},           {"sleep", "exact"}};
  double other = 0.0;
  for (const auto& [name, choice] : of_1993)
    other += found.at("fence.options." + name).text == choice ? 0.0 : 1.0;
  findings.expect("choices other than those of the 1993 program", other, 0.0,
                  Tolerance::exact("rules = \"1993\" takes them for all options that are not given"));
  const Json printed = Json::parse(talus_output(folder, {"run", "masses.toml", "--json", "--out", "masses"})),
             summary = records::read_json(folder.path() / "masses/summary.json");
  findings.expect_true("summary of the fence on standard output", printed == summary, "the document of summary.json");
  const double steps = number("fence.steps");
  findings.expect_between("time at the end of a run over its duration",
                          Node{summary, "summary"}.at("outcome").at("time").number() / duration, 1.0 - 1.0 / steps,
                          1.0 + 1.0 / steps, "the duration is rounded to whole steps");
}

/// Converts scenes that set every field, and compares key by key.
void check_fields(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  Changes changes;
  const auto convert = [&](std::string text, bool by_deck) {
    text = with_long_numbers(text);
    folder.write("complete.toml", text);
    if (by_deck) (void)talus_output(folder, {"convert", "complete.toml", "complete.DAT"});
    (void)talus_output(folder, {"convert", by_deck ? "complete.DAT" : "complete.toml", "returned.toml"});
    if (setup.has("another_choice")) text.replace(text.find("\"superquadric\""), 14, "\"rectangle\"");
    compare_values(text, folder.read("returned.toml"), changes);
  };
  if (!setup.has("another_choice")) convert(scene_of_deck(), true);
  convert(scene_with_options("hardening = 0.12\n"), false);
  convert(scene_with_options("hardening = 0.0\ntable = [[0.015, 1.25], [0.35, 1.45]]\n"), false);
  findings.expect("values of a complete scene that differ after conversion", changes.wrong, 0.0,
                  Tolerance::exact("each number with 17 digits in the same unit, each text, in the same position"));
  findings.expect("values in psi and square inches after conversion, largest relative error", changes.rescaled, 0.0,
                  Tolerance::round_off(6e-16, "a conversion of units and its inverse, 1.1e-16 each, twice"));
  if (!changes.keys.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& key : changes.keys)
      rows.push_back({key});
    findings.table(
        {.name = "differing", .caption = "Values that differ after conversion.", .columns = {"key"}, .rows = rows});
  }
}

/// Broken parts are not carried over to the next rock.
void check_after_break(const TemporaryFolder& folder, Findings& findings) {
  folder.write("weak.toml", records::read_whole(case_file("fence/table_2.toml")) +
                                "\n[fence.options]\nhanger_strength = \"10000 lbf\"\n");
  (void)talus_output(folder, {"run", "weak.toml", "--end", "10 ms", "--out", "broken"});
  const ProgramEnd end = run_talus(folder, {"convert", "weak.toml", "next.toml", "--after", "broken"});
  const std::string reason = "final_state.json: hanger 'hanger1': found it broken; broken parts cannot be carried over";
  findings.expect_true("a fence with a broken hanger is refused for the second rock",
                       end.exit_code == 2 && end.messages.find(reason) != std::string::npos,
                       "exit status 2, the file and the hanger");
}

/// The fence after one rock, and after two, that plastically elongated its cables.
void check_after(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  std::string deck = records::read_whole(case_file("fence/sample2.DAT"));
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
    const std::string before = fmt::format("cable = \"{}\"\nstretch = \"", cable.at("name").text());
    keep_worst(once, numbers_after(second, before).at(0) / stretch - 1.0);
    keep_worst(twice,
               numbers_after(third, before).at(0) / ((setup.has("first_rock_alone") ? 1.0 : 2.0) * stretch) - 1.0);
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
  folder.write("ice.toml", records::read_whole(case_file("cell/ice.toml")));
  (void)talus_output(folder, {"export", "lammps", "ice.toml", "--dashpot", "--out", "ice"});
  const std::vector<double> replaced = numbers_after(folder.read("ice/in.discs"), "pair_coeff * * hooke");
  folder.write("rough.toml", records::read_whole(case_file("cell/rough.toml")));
  (void)talus_output(folder, {"export", "lammps", "rough.toml", "--out", "lammps"});
  const std::string input = folder.read("lammps/in.discs"), data = folder.read("lammps/discs.data");
  const Tolerance round_off =
      Tolerance::round_off(5e-15, "about ten roundings on either side, 1.1e-16 each, in 17 digits; twice that");
  double law = 0.0, run = 0.0;
  const auto compare = [&](double& worst, const std::string& before, const std::vector<double>& exact) {
    const std::vector<double> found = numbers_after(input, before);
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
  // A line each 5 ms, as in the history of the cell; contacts are sampled each 100 steps, first after the start-up.
  constexpr double line = 5e-3 / step, sampled = 100.0;
  compare(run, "fix stress all ave/time", {1.0, line, line}), compare(run, "\nthermo ", {line});
  compare(run, "fix contact all ave/time", {sampled, line / sampled, line});
  const double first = 0.25 * 0.1 / step + sampled;
  compare(run, "fix mean_stress all ave/time", {1.0, 1.0, 1.0, first});
  compare(run, "fix mean_contact all ave/time", {sampled, 1.0, sampled, first});
  findings.expect("in.discs: step, steps, weight of the block and area of the stresses, largest relative error", run,
                  0.0, round_off);

  // A prime number of steps, so that contacts are sampled at each.
  (void)talus_output(folder, {"export", "lammps", "rough.toml", "--steps", "4003", "--out", "prime"});
  const std::string shorter = folder.read("prime/in.discs");
  findings.expect("in.discs of 4003 steps: first step of the means",
                  numbers_after(shorter, "print \"means after step").at(0), 1000.0,
                  Tolerance::exact("they leave out the first quarter of the given steps, not of the scene's"));
  findings.expect("in.discs of 4003 steps: steps between two samples of the contacts",
                  numbers_after(shorter, "fix mean_contact all ave/time").at(0), 1.0,
                  Tolerance::exact("it divides the number of steps, which is prime"));
  double pushing = 0.0;
  for (const char* const types : {"2 2", "2 3", "3 3"})
    pushing += input.find(fmt::format("\nneigh_modify exclude type {}\n", types)) == std::string::npos ? 1.0 : 0.0;
  findings.expect("in.discs: pairs of walls whose discs would push each other", pushing, 0.0,
                  Tolerance::exact("base and block, types 2 and 3: each with itself and with the other"));

  // Atoms: number, type, diameter, density, x, y, z. The mass of a sphere is density pi d^3/6.
  std::istringstream atoms{data.substr(data.find("Atoms # sphere") + 14)};
  double masses = 0.0, positions = 0.0, block = 0.0;
  const double row = std::max(width / columns, 1.05 * diameter), top = row * (rows + 1);
  for (int i = 0; i < free + 2 * wall; ++i) {
    double number = 0.0, type = 0.0, across = 0.0, density = 0.0, x = 0.0, y = 0.0, z = 0.0;
    atoms >> number >> type >> across >> density >> x >> y >> z;
    const int of_wall = i < free ? 0 : 1 + (i - free) / wall;
    const double of_sphere = density * std::numbers::pi / 6.0 * across * across * across;
    keep_worst(positions, number - (i + 1)), keep_worst(positions, type - (of_wall + 1));
    keep_worst(positions, across / diameter - 1.0);
    if (of_wall == 0) keep_worst(masses, of_sphere / mass - 1.0);
    if (of_wall == 2) block += of_sphere;
    const double column = of_wall == 0 ? (i % columns + 0.5) / columns : ((i - free) % wall + 0.5) / wall;
    keep_worst(positions, (x - width * (column - 0.5)) / diameter);
    keep_worst(positions, (y - (of_wall == 0 ? row * (i / columns + 1) : of_wall == 1 ? 0.0 : top)) / diameter);
  }
  findings.expect("discs.data: masses of the free discs, largest relative error", masses, 0.0, round_off);
  findings.expect("discs.data: total mass of the block's discs over that of the block", block / block_mass, 1.0,
                  round_off);
  findings.expect("discs.data: numbers, types, diameters and positions, largest error", positions, 0.0, round_off);
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

/// Two cells of spheres as read by LAMMPS: Hertz's law and Mindlin's friction by the effective radius of the pair, a
/// quarter of the diameter. Forces are proportional to the root of the radius, which in the second cell is 1 mm, four
/// times that of LAMMPS.
void check_spheres(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double modulus = 700e6, shear_modulus = 144e6, friction = 0.5;
  std::string text = records::read_whole(case_file("cell/spheres.toml"));
  const std::string modulus_of_file = "144 MPa";
  if (setup.has("other_shear_modulus"))
    text.replace(text.find(modulus_of_file), modulus_of_file.size(), "144.0001 MPa");
  std::string blunt = text, input;
  const std::string quarter = "\"0.25 mm\"";
  blunt.replace(blunt.find(quarter), quarter.size(), "\"1 mm\"");
  double worst = 0.0;
  for (const auto& [scene, root] : {std::pair{blunt, 2.0}, std::pair{text, 1.0}}) {
    folder.write("spheres.toml", scene);
    (void)talus_output(folder, {"export", "lammps", "spheres.toml", "--out", "spheres"});
    input = folder.read("spheres/in.discs");
    const std::vector<double> normal = numbers_after(input, "pair_coeff * * hertz");
    const std::vector<double> found = numbers_after(input, "tangential mindlin_rescale/force");
    if (found.size() != 3 || normal.size() < 2) {
      worst = NAN;
      continue;
    }
    keep_worst(worst, normal[0] / (4.0 / 3.0 * modulus * root) - 1.0);
    keep_worst(worst, found[0] / (8.0 * shear_modulus * root) - 1.0), keep_worst(worst, found[1]);
    keep_worst(worst, found[2] - friction);
  }
  findings.expect("in.discs of spheres: moduli and friction, largest relative error", worst, 0.0,
                  Tolerance::round_off(5e-15,
                                       "about ten roundings on either side, 1.1e-16 each, in 17 digits; twice "
                                       "that"));
  findings.expect_true("in.discs of spheres: contacts that do not pull",
                       input.find(" damping velocity limit_damping\n") != std::string::npos,
                       "the end rule of the cell is clamped, which LAMMPS calls limit_damping");
}

/// `limit_damping` is in the commands exactly if the dashpot acts and contacts do not pull.
void check_end_rules(const TemporaryFolder& folder, Findings& findings) {
  const std::string text = records::read_whole(case_file("cell/rough.toml")), clamped = "end_rule = \"clamped\"",
                    damped = "restitution = 0.7";
  Differences rules;
  for (const std::string rule : {"clamped", "attractive"}) {
    for (const std::string dashpot : {"damping = \"0.05 N s/m\"", "damping = \"0 N s/m\""}) {
      std::string cell = text;
      cell.replace(cell.find(clamped), clamped.size(), "end_rule = \"" + rule + "\"");
      cell.replace(cell.find(damped), damped.size(), dashpot);
      folder.write("rule.toml", cell);
      (void)talus_output(folder, {"export", "lammps", "rule.toml", "--out", "rule"});
      const std::string input = folder.read("rule/in.discs");
      rules.contains("dashpot of LAMMPS", input, " damping velocity");
      rules.compare(rule + ", " + dashpot, input.find(" limit_damping") != std::string::npos,
                    rule == "clamped" && dashpot.find("\"0 N") == std::string::npos);
    }
  }
  rules.expect_none(
      findings, "in.discs: end rules other than those of the discs",
      "LAMMPS calls a contact that does not pull limit_damping, and contacts without dashpot do not pull");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("converted");
  const TemporaryFolder folder;
  if (setup.needs("of the scene")) check_deck(folder, findings, setup);
  if (setup.needs("values")) check_fields(folder, findings, setup);
  if (setup.needs("title")) check_title(folder, findings);
  if (setup.needs("cannot express")) check_refused_decks(folder, findings);
  if (setup.needs("follow from")) check_derived(folder, findings);
  if (setup.needs("rock")) check_after(folder, findings, setup), check_after_break(folder, findings);
  if (setup.needs("discs")) check_lammps(folder, findings, setup);
  if (setup.needs("end rules")) check_end_rules(folder, findings);
  if (setup.needs("spheres")) check_spheres(folder, findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "converted_files",
          .title = "Exported and converted files",
          .requirements = {{"G6", {"converted"}}},
          .main_checks = {"numbers of the scene missing in the deck",
                          "values of a complete scene that differ after conversion",
                          "plastic elongation of the cables for the third rock, largest relative error",
                          "in.discs: coefficients of the contacts, largest relative error",
                          "discs.data: total mass of the block's discs over that of the block"},
          .source =
              "Mustoe & Huttelmaier 1993, Table 2 and sample deck (scenes); Schwager & Poeschel 2007 (clamped contact)",
          .faults = {{"sixteen_digits", "numbers compared after rounding to 16 digits",
                      "numbers of the scene missing in the deck"},
                     {"another_choice", "an outline compared with a rectangle",
                      "values of a complete scene that differ after conversion"},
                     {"first_rock_alone", "a third rock on cables elongated by the first rock only",
                      "plastic elongation of the cables for the third rock, largest relative error"},
                     {"other_restitution", "a restitution of the reference too large by 1e-9",
                      "in.discs: coefficients of the contacts, largest relative error"},
                     {"other_shear_modulus", "a shear modulus larger by 1e-6",
                      "in.discs of spheres: moduli and friction, largest relative error"}},
          .run = run};
}

}  // namespace talus::verification::problems::converted_files
