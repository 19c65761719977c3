#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/files/exported_cells.hpp"
#include "verification/problems/program/files/vtkhdf_states.hpp"
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

/// Number of `values` that do not occur in the text with all their bits.
double missing(const std::vector<double>& values, const std::string& text) {
  const std::vector<double> there = numbers_in(text);
  return static_cast<double>(
      std::ranges::count_if(values, [&](double value) { return std::ranges::count(there, value) == 0; }));
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

/// Values that follow from others: mass, gravity and duration, and options that rules = "1993" takes.
void check_derived(const TemporaryFolder& folder, Findings& findings) {
  std::string text = records::read_whole(case_file("fence/table_2.toml"));
  constexpr double ground_mass = 40.5, rock_mass = 18.5, column_mass = 16.5, duration = 0.02;
  replace(text, "steps = 100000", fmt::format("duration = \"{} s\"", duration));
  replace(text, "density = \"0.1 slug/ft^3\"", fmt::format("mass = \"{} slug\"", ground_mass));
  replace(text, "density = \"5.127408 slug/ft^3\"", fmt::format("mass = \"{} slug\"", rock_mass));
  replace(text, "density = \"0.38 slug/ft^3\"", fmt::format("mass = \"{} slug\"", column_mass));
  replace(text, "gravity = \"32.18 ft/s^2\"\n", "");
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
  findings.expect("gravity that follows from the units if none is given, over standard gravity",
                  number("fence.gravity") / (9.80665 / 0.3048), 1.0,
                  Tolerance::round_off(1e-15, "a foot is 0.3048 m by definition; a quotient on either side"));
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
    keep_worst(once, numbers_on_line_after(second, before).at(0) / stretch - 1.0);
    keep_worst(
        twice,
        numbers_on_line_after(third, before).at(0) / ((setup.has("first_rock_alone") ? 1.0 : 2.0) * stretch) - 1.0);
  }
  findings.expect_between("plastically elongated cables after the first rock", count, 3.0, 14.0,
                          "the weak top cable has seven segments in each of two layers");
  findings.expect("plastic elongation of the cables for the second rock, largest relative error", once, 0.0,
                  Tolerance::round_off(1e-15, "the numbers of final_state.json in the same unit"));
  findings.expect("plastic elongation of the cables for the third rock, largest relative error", twice, 0.0,
                  Tolerance::round_off(1e-15, "the sum of two equal numbers"));
}

/// Values beyond those of a record are not read, nor what is left of a repeat: the next record begins a line.
void check_repeats(const TemporaryFolder& folder, Findings& findings) {
  std::string deck = records::read_whole(case_file("fence/sample2.DAT"));
  folder.write("plain.DAT", deck);
  replace(deck, "51 52 48 6 7 8 35 36 0", "51 52 48 6 7 8 35 4*36");
  folder.write("repeats.DAT", deck);
  for (const std::string name : {"plain", "repeats"})
    (void)talus_output(folder, {"convert", name + ".DAT", name + ".toml"});
  findings.expect_true("deck with repeats beyond the end of a record: the same scene",
                       folder.read("plain.toml") == folder.read("repeats.toml"),
                       "FORTRAN 77, list-directed READ: each READ begins a new record");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("converted");
  const TemporaryFolder folder;
  if (setup.needs("of the scene")) check_deck(folder, findings, setup);
  if (setup.needs("values")) check_fields(folder, findings, setup);
  if (setup.needs("repeats")) check_repeats(folder, findings);
  if (setup.needs("title")) check_title(folder, findings);
  if (setup.needs("cannot express")) check_refused_decks(folder, findings);
  if (setup.needs("follow from")) check_derived(folder, findings);
  if (setup.needs("rock")) check_after(folder, findings, setup), check_after_break(folder, findings);
  check_exported_cells(folder, findings, setup);
  if (setup.needs("VTKHDF")) check_vtkhdf_states(folder, findings, setup);
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
                          "discs.data: total mass of the block's discs over that of the block",
                          "states as VTKHDF: numbers, types and texts that differ"},
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
                     {"next_state", "each step compared with the state after it",
                      "states as VTKHDF: numbers, types and texts that differ"},
                     {"other_shear_modulus", "a shear modulus larger by 1e-6",
                      "in.discs of spheres: moduli and friction, largest relative error"}},
          .run = run};
}

}  // namespace talus::verification::problems::converted_files
