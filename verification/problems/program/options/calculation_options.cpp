#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/options/advice_options.hpp"
#include "verification/problems/program/options/calibration_options.hpp"
#include "verification/problems/program/options/checked_contacts.hpp"
#include "verification/problems/program/options/study_options.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/motion/constant_force.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calculation_options {
namespace {

using records::Json;

// --- scenes --------------------------------------------------------------------------------------------------------

/// A cell with K1/K2 = 0.45 and the step of 1989, as --historical requires.
std::string cell_text(const std::string& fields, const std::string& method) {
  return fmt::format(R"(title = "Sheared discs"
units = "SI"
[cell]
stiffness = "9 kN/m"
unloading_stiffness = "20 kN/m"
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "9.81 m/s^2"
overburden = "8 kPa"
rows = 4
columns = 5
wall_discs = 6
block_speed = "5 m/s"
{}
[run]
step = "1e-7 s"
every = "0.25 ms"
end = "1 ms"
{}
)",
                     fields, method);
}

// --- run -----------------------------------------------------------------------------------------------------------

/// The rows of the printed table of extremes against summary.json: largest relative error; NaN if a quantity that
/// varies is missing.
double extremes_error(const std::string& printed, const Json& summary) {
  double worst = 0.0;
  for (const Json& extreme : summary.at("extremes")) {
    const auto name = extreme.at("name").get<std::string>();
    const auto low = extreme.at("minimum").get<double>(), high = extreme.at("maximum").get<double>();
    const bool varies = high - low > 1e-6 * std::max(std::abs(low), std::abs(high));
    if (!varies || name.starts_with("balance_error")) continue;
    const std::size_t at = printed.find("\n  " + name + " ");
    if (at == std::string::npos) return std::nan("");
    std::istringstream row{printed.substr(at + 3 + name.size())};
    double found_low{}, low_time{}, found_high{}, high_time{};
    row >> found_low >> low_time >> found_high >> high_time;
    const std::array errors{found_low - low, low_time - extreme.at("minimum_time").get<double>(), found_high - high,
                            high_time - extreme.at("maximum_time").get<double>()};
    const std::array sizes{low, extreme.at("minimum_time").get<double>(), high,
                           extreme.at("maximum_time").get<double>()};
    for (std::size_t i = 0; i < errors.size(); ++i)
      keep_worst(worst, sizes.at(i) == 0.0 ? errors.at(i) : errors.at(i) / sizes.at(i));
  }
  return worst;
}

void check_run(const Program& program, Findings& findings, Differences& differ) {
  program.write("plain.toml", hung_text("integrator = \"velocity_verlet\"\nstep = \"10 ms\"\nend = \"1 s\"\n"));
  program.write("hung.toml",
                hung_text("integrator = \"odeint_dopri5\"\ntolerance = 1e-10\nstep = \"20 ms\"\nend = \"0.8 s\"\n"));
  const std::string printed = program.run({"run", "plain.toml"}, {{"--integrator", {"odeint_dopri5"}},
                                                                  {"--tolerance", {"1e-10"}},
                                                                  {"--step", {"20 ms"}},
                                                                  {"--end", {"0.8 s"}},
                                                                  {"--frames", {"5"}},
                                                                  {"--out", {"options"}},
                                                                  {"--all", {}}});
  (void)program.run({"run", "hung.toml"}, {{"--out", {"fields"}}});
  differ.compare("run: history by options and by fields", program.read("options/history.csv"),
                 program.read("fields/history.csv"));
  const Json summary = program.file("options/summary.json");
  differ.compare("run: summary by options and by fields", summary, program.file("fields/summary.json"));
  differ.compare("run: integrator", summary.at("integrator").get<std::string>(), std::string{"odeint_dopri5"});
  differ.compare("run: step", summary.at("step").get<double>(), 0.02);
  differ.compare("run: end", summary.at("end").get<double>(), 0.8);
  differ.compare("run: steps", summary.at("steps").get<int>(), 40);
  double times = 0.0;
  int states = 0;
  for (const auto& [time, text] : geometry_states(program.folder(), "options", "plain"))
    keep_worst(times, time - 0.16 * states++);
  differ.compare("run: states of the geometry", states, 6);
  findings.expect("talus run --frames: times of the states, largest error", times, 0.0,
                  Tolerance::round_off(1e-15, "multiples of the step, up to 0.8: a unit in the last place and a half"),
                  "s");
  const records::Csv history = program.csv("options/history.csv");
  double error = 0.0;
  for (std::size_t row = 0; row < history.rows(); ++row)
    keep_worst(error, history.number(row, "hung.y [m]") - hung_rest - hung_state(history.number(row, 0)).displacement);
  findings.expect("talus run --tolerance: largest error of y over its largest value", error / hung_y, 0.0,
                  Tolerance::truncation(4e-9, 1.0,
                                        "40 output intervals, in each an error of at most 1e-10 of the largest value. "
                                        "Without a tolerance, each is one step, and the error is 2.7e-8"));
  findings.expect("talus run --all: printed extremes over those of summary.json, largest relative error",
                  extremes_error(printed, summary), 0.0,
                  Tolerance::model(5e-7, "seven digits are printed: half a unit of the last one"));

  // The end is no multiple of the interval: the last row is beyond the last whole interval.
  program.write("uneven.toml", hung_text("integrator = \"velocity_verlet\"\nstep = \"10 ms\"\nend = \"0.95 s\"\n"));
  const std::string promised = program.run({"check", "uneven.toml"});
  (void)program.run({"run", "uneven.toml"}, {{"--out", {"uneven"}}});
  differ.compare("run: rows as expected by check", number_after(promised, "expected output of --out: "),
                 static_cast<double>(program.csv("uneven/history.csv").rows()));
  differ.compare("run: states as expected by check", number_after(promised, " columns, "),
                 static_cast<double>(geometry_states(program.folder(), "uneven", "uneven").size()));
  differ.contains("run: cost as expected by check", promised,
                  "expected cost: 95 steps to 0.95 s, about 1 force evaluations a step, 95 in all; ");
  // Of a method that chooses its steps `check` tries 20,000 evaluations. The motion has 76 periods, in each of
  // which the method takes the same steps; two digits are printed.
  program.write("costly.toml",
                hung_text("integrator = \"odeint_dopri5\"\ntolerance = 1e-10\nstep = \"10 ms\"\nend = \"60 s\"\n"));
  const double all = program.json({"run", "costly.toml"}, {{"--json", {}}}).at("evaluations").get<double>(),
               tried = number_after(program.run({"check", "costly.toml"}),
                                    "more than 20000 force evaluations: these reach ");
  differ.holds("run: part of it that check tries", std::abs(tried - 100.0 * 20000.0 / all) < 3.0);
  // The rope is taut in all states.
  differ.contains("run: parts of a step", program.run({"run", "plain.toml"}, {{"--all", {}}, {"--step", {"0.1 ms"}}}),
                  "cables: 1.0 awake, 1.0 taut");
  // Another method with step control takes the tolerance of the scene.
  std::string other = program.read("hung.toml");
  other.replace(other.find("1e-10"), 5, "1e-4");
  program.write("kept.toml", other);
  const Json kept = program.json({"run", "kept.toml"}, {{"--integrator", {"stormer_cowell"}}, {"--json", {}}});
  other.replace(other.find("odeint_dopri5"), 13, "stormer_cowell");
  program.write("other.toml", other);
  differ.compare("run: bodies by another method with the scene's tolerance", kept.at("bodies"),
                 program.json({"run", "other.toml"}, {{"--json", {}}}).at("bodies"));
  // Steps longer than half the contact: the results are not usable, which the scene may declare no error.
  for (const auto& [name, rule, status] :
       {std::tuple{"poor", "", 7}, std::tuple{"poor_warned", "[run.watch]\nquality = \"warning\"\n", 0}}) {
    const std::string file = fmt::format("{}.toml", name);
    std::string text = drop_text() + rule;
    text.replace(text.find("0.1 ms"), 6, "18 ms");
    program.write(file, text);
    differ.compare(fmt::format("run: exit status of {}", name),
                   program.end({"run", file}, {{"--out", {name}}}).exit_code, status);
    differ.compare(fmt::format("run: exit status of --resume of {}, which has ended", name),
                   program.end({"run"}, {{"--resume", {name}}}).exit_code, status);
  }

  const Json whole = program.json({"run", "plain.toml"}, {{"--json", {}}});
  (void)program.run({"run", "plain.toml"}, {{"--until", {"0.45 s"}}, {"--out", {"half"}}});
  const Json half = program.file("half/summary.json");
  differ.compare("run: outcome of --until", half.at("outcome").at("kind").get<std::string>(), std::string{"stopped"});
  differ.compare("run: steps up to --until", half.at("steps").get<int>(), 45);
  differ.compare("run: rows up to --until", program.csv("half/history.csv").rows(), 6UL);
  const Json resumed = program.json({"run"}, {{"--resume", {"half"}}, {"--json", {}}});
  differ.compare("run: extremes after --resume", resumed.at("extremes"), whole.at("extremes"));
  differ.compare("run: bodies after --resume", resumed.at("bodies"), whole.at("bodies"));
  differ.compare("run: steps after --resume", resumed.at("steps").get<int>(), 100);
}

/// Every integrator of `talus list integrators` moves a falling disc; explicit and semi-implicit Euler by a h t/2 less
/// or more than exactly.
void check_listed_integrators(const Program& program, Findings& findings) {
  constexpr double step = 1e-4, end = 0.1;
  double worst = 0.0, listed = 0.0;
  std::istringstream lines{program.run({"list", "integrators"})};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) continue;
    std::istringstream tokens{line};
    std::string name;
    tokens >> name;
    ++listed;
    const Json summary = program.json({"run", "drop.toml", "--integrator", name, "--step", fmt::format("{} s", step),
                                       "--end", fmt::format("{} s", end)},
                                      {{"--json", {}}});
    const double late = reference::semi_implicit_euler_error(drop, step, std::lround(end / step));
    const double error = name == "euler" ? -late : name == "euler_cromer" ? late : 0.0;
    keep_worst(worst, summary.at("bodies").at(0).at("position").at(1).get<double>() - position_at(drop, end) - error);
  }
  findings.expect("talus list integrators: methods", listed, 16.0, Tolerance::exact("the methods of the reference"));
  findings.expect(
      "listed integrators: position of a falling disc after 1000 steps, largest error", worst, 0.0,
      Tolerance::round_off(1e-13,
                           "closed forms of a constant force; two roundings of 1e-16 in each of 1000 steps, "
                           "of both position and speed; methods with a tolerance are exact for parabolas"),
      "m");
}

// --- cell ----------------------------------------------------------------------------------------------------------

void check_cell(const Program& program, Findings& findings, Differences& differ) {
  struct Choice {
    std::string name;
    Options options;
    std::string fields, method;  ///< the same in the scene
    std::string parameter;       ///< of summary.json
    Json value;
  };
  const std::vector<Choice> choices{
      {"seed", {{"--seed", {"3"}}}, "seed = 3", "", "seed", 3},
      {"integrator", {{"--integrator", {"taylor"}}}, "", "integrator = \"taylor\"", "integrator", "taylor"},
      {"historical", {{"--historical", {}}}, "", "integrator = \"euler\"\nhistorical = \"on\"", "historical", true},
      {"jump", {{"--jump", {}}}, "", "jump = \"on\"", "jump", true},
      {"virtual", {{"--virtual", {}}}, "", "images = \"virtual\"", "images", "virtual"}};
  program.write("cell.toml", cell_text("", ""));
  (void)program.run({"cell", "cell.toml"}, {{"--out", {"cell"}}});
  // Two discs press each other with K1 and part with K2, in a quarter of a period each.
  const std::string checked = squeezed(program.run({"check", "cell.toml"}));
  constexpr double half_a_disc = 0.5 * 7.2e-7;
  const double contact = 0.5 * std::numbers::pi * (std::sqrt(half_a_disc / 9e3) + std::sqrt(half_a_disc / 20e3));
  differ.contains("cell: contact time by check", checked, fmt::format("\n contact time {:.4g} s\n", contact));
  differ.contains("cell: cost by check", checked,
                  "\n expected cost 10000 steps and force evaluations to 0.001 s; 4 outputs\n");
  differ.compare("cell: rows as expected by check", number_after(checked, "\n expected output of --out "),
                 static_cast<double>(program.csv("cell/history.csv").rows()));
  const std::string plain = program.read("cell/RESTART.DAT");
  for (const Choice& choice : choices) {
    const std::string by_options = "cell_" + choice.name, by_fields = "fields_" + choice.name;
    Options options = choice.options;
    options.push_back({"--out", {by_options}});
    options.push_back({"--json", {}});
    const Json summary = program.json({"cell", "cell.toml"}, options);
    program.write("fields.toml", cell_text(choice.fields, choice.method));
    (void)program.run({"cell", "fields.toml"}, {{"--out", {by_fields}}});
    const std::string state = program.read(by_options + "/RESTART.DAT");
    differ.compare("cell: state by --" + choice.name + " and by its field", state,
                   program.read(by_fields + "/RESTART.DAT"));
    differ.compare("cell: state without --" + choice.name, state == plain, false);
    differ.compare("cell: summary by --" + choice.name, summary.at("parameters").at(choice.parameter), choice.value);
    differ.compare("cell: summary printed and written", summary, program.file(by_options + "/summary.json"));
  }
  differ.compare("cell: integrator of --historical",
                 program.file("cell_historical/summary.json").at("parameters").at("integrator"), Json("euler"));
  // Euler's method gains some 7 % of the work with this step, which is known of a historical run. Two rows under a high
  // gravity flow at once.
  std::string flowing = cell_text("", "");
  for (const auto& [from, to] : {std::pair{"9.81 m", "1000 m"}, {"rows = 4", "rows = 2"}, {"\"1 ms\"", "\"6 ms\""}})
    flowing.replace(flowing.find(from), std::string_view{from}.size(), to);
  program.write("flowing.toml", flowing);
  for (const auto& [name, option] :
       {std::pair{"euler", Option{"--integrator", {"euler"}}}, {"historical", {"--historical", {}}}}) {
    const ProgramEnd flow = program.end({"cell", "flowing.toml"}, {option});
    differ.compare(fmt::format("cell: warning about the energy balance: {}", name),
                   flow.messages.find(" of the work is unaccounted for, more than 0.01") != std::string::npos,
                   option.first == "--integrator");
  }
  const std::string ended = program.run({"cell"}, {{"--resume", {"cell"}}});
  differ.contains("cell: --resume of a run that has ended", ended, "finished");
  const auto kinetic = [&](const std::string& folder) {
    return program.file(folder + "/summary.json").at("energy").at("kinetic").get<double>();
  };
  findings.expect("talus cell --virtual: kinetic energy over that with the nearest images, deviation from 1",
                  kinetic("cell_virtual") / kinetic("cell") - 1.0, 0.0,
                  Tolerance::round_off(1e-12,
                                       "the same forces in another order: rounding of 1e-16 relative to a position, in "
                                       "contacts whose overlaps are a thousandth of it, in few contacts of a disc"));
}

// --- export, new, check, list -------------------------------------------------------------------------------

void check_other_commands(const Program& program, Differences& differ) {
  // Outputs of a method that chooses its steps: at least 20 in the shortest contact, and a whole number in each row.
  constexpr double stiff = 2e8, duration = 0.2;
  std::string dropped = drop_text();
  dropped.replace(dropped.find("\"20000 N/m\""), 11, fmt::format("\"{} N/m\"", stiff));
  dropped.replace(dropped.find("\"velocity_verlet\"\nstep = \"0.1 ms\"\n"), 34, "\"stormer_cowell\"\n");
  dropped.replace(dropped.find("damping = \"20 N s/m\""), 20, "damping = \"0 N s/m\"");
  program.write("unstepped.toml", dropped);
  const double contact = std::numbers::pi * std::sqrt(2.0 / stiff), in_row = std::ceil(duration / contact / 50.0);
  differ.holds("outputs that resolve the shortest contact",
               std::abs(program.json({"run", "unstepped.toml"}, {{"--json", {}}}).at("step").get<double>() /
                            (duration / (1000.0 * in_row)) -
                        1.0) < 1e-12);
  // Outputs that the scene gives: a warning is printed if a contact of 31.4 ms has fewer than two of them.
  for (const auto& [step, warns] : {std::pair{"15.6 ms", false}, {"15.8 ms", true}}) {
    std::string seldom = drop_text();
    seldom.replace(seldom.find("velocity_verlet"), 15, "stormer_cowell");
    seldom.replace(seldom.find("0.1 ms"), 6, step);
    seldom.replace(seldom.find("damping = \"20 N s/m\""), 20, "damping = \"0 N s/m\"");
    program.write("seldom.toml", seldom);
    const std::string printed = run_talus(program.folder(), {"check", "seldom.toml"}).messages;
    differ.compare(fmt::format("warning about outputs every {}", step),
                   printed.find("contact 'impact' lasts about 0.0314, 2 steps of the scene: ") != std::string::npos &&
                       printed.find("; a step of 0.00157 gives it 20") != std::string::npos,
                   warns);
  }
  (void)program.run({"export", "lammps", "cell.toml"}, {{"--dashpot", {}}, {"--steps", {"77"}}, {"--out", {"lammps"}}});
  differ.contains("export: steps", program.read("lammps/in.discs"), "\nrun 77\n");
  for (const std::string kind : {"scene", "fence", "cell"}) {
    for (const std::string units : {"SI", "US"}) {
      const std::string text = program.run({"new", kind}, {{"--units", {units}}}), file = "new.toml";
      differ.contains("new: units", text, fmt::format("\nunits = \"{}\"", units));
      program.write(file, text);
      differ.compare("new: " + kind + " is accepted by check", program.end({"check", file}).exit_code, 0);
    }
  }
  // A hundred states also of a fence that ends earlier: one in 5 steps in place of one in 81, to scale one in 5.06.
  program.write("shorter.toml", program.run({"new", "fence"}));
  (void)program.run({"run", "shorter.toml", "--end", "50 ms", "--out", "shorter"});
  const std::size_t states = geometry_states(program.folder(), "shorter", "shorter").size();
  differ.holds("states of a fence that ends earlier", states >= 100 && states <= 106);
  const ProgramEnd version = program.end({}, {{"--version", {}}});
  differ.compare("version: exit status", version.exit_code, 0);
  // talus 0.1.0, revision and build, a line each
  differ.compare("version: lines", static_cast<int>(std::ranges::count(version.output, '\n')), 3);
  differ.holds("version: text", version.output.starts_with("talus ") &&
                                    version.output.find("\nrevision ") != std::string::npos &&
                                    version.output.find("\nbuild ") != std::string::npos);
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string script = run_talus(program.folder(), {"completion", shell}).output;
    for (const std::string word : {"calibrate", "sweep", "collect", "restitution", "' sweep run'", "' sweep collect'"})
      differ.contains("completion by " + shell + ": " + word, script, word);
    differ.compare("completion by " + shell + ": braces", std::ranges::count(script, '{'),
                   std::ranges::count(script, '}'));
  }
  differ.compare("completion by another shell", run_talus(program.folder(), {"completion", "csh"}).exit_code, 2);
  for (const std::string command : {"run", "check", "advise", "calibrate", "cell", "completion", "convert", "export",
                                    "plot", "snapshot", "animate", "study", "list", "new"}) {
    const ProgramEnd help = run_talus(program.folder(), {command, "--help"});
    differ.holds("help of " + command,
                 help.exit_code == 0 && help.output.find("Usage: talus " + command) != std::string::npos);
    differ.compare("unknown option of " + command, run_talus(program.folder(), {command, "--nothing"}).exit_code, 2);
  }
  differ.compare("unknown command", run_talus(program.folder(), {"nothing"}).exit_code, 2);
  std::string discs = "units = \"SI\"\n";
  for (int i = 0; i < 634; ++i)
    discs += fmt::format(
        "[[body]]\nname = \"disc{}\"\nmobility = \"particle\"\nmass = \"1 kg\"\n"
        "shape = {{ kind = \"circle\", radius = \"1 m\" }}\nposition = [\"{} m\", \"0 m\"]\n",
        i, 3 * i);
  program.write("discs.toml", discs + "[run]\nintegrator = \"euler_cromer\"\nstep = \"1 ms\"\nend = \"1 ms\"\n");
  for (const std::string command : {"run", "check"})
    differ.contains("200661 pairs without a contact, more than are checked: " + command,
                    run_talus(program.folder(), {command, "discs.toml"}).messages,
                    "more than 200000 pairs of bodies have no contact between them");
  // Outlines whose farthest point is 0.5 m from the centre: a circle, the corners of a rectangle, the longer axis of an
  // ellipse, and a superellipse of n = 6, whose largest x^2 + y^2 is (a^3 + b^3)^(2/3) by Hoelder's inequality.
  const auto superellipse = [](int exponent, double half_height) {
    return fmt::format("kind = \"superquadric\", half_width = \"0.3 m\", half_height = \"{} m\", exponent = {}",
                       half_height, exponent);
  };
  const std::string round = "kind = \"circle\", radius = \"0.5 m\"",
                    plate = "kind = \"rectangle\", half_width = \"0.3 m\", half_height = \"0.4 m\"",
                    ellipse = superellipse(2, 0.5), rounded = superellipse(6, std::cbrt(0.125 - 0.027));
  for (const auto& [inertia, shape, warns] : {std::tuple{"0.5", round, false},
                                              {"0.51", round, true},
                                              {"0.5", plate, false},
                                              {"0.51", plate, true},
                                              {"0.5", ellipse, false},
                                              {"0.51", ellipse, true},
                                              {"0.5", rounded, false},
                                              {"0.51", rounded, true}}) {
    program.write(
        "hoop.toml",
        fmt::format("units = \"SI\"\n[[body]]\nname = \"hoop\"\nmobility = \"free\"\nmass = \"2 kg\"\n"
                    "inertia = \"{} kg m^2\"\nshape = {{ {} }}\n"
                    "position = [\"0 m\", \"0 m\"]\n[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\nend = \"1 ms\"\n",
                    inertia, shape));
    for (const std::string command : {"run", "check"})
      differ.compare(
          fmt::format("warning about a moment of inertia of {} kg m^2 of {{ {} }}: {}", inertia, shape, command),
          run_talus(program.folder(), {command, "hoop.toml"}).messages.find("more than m R^2 = 0.5 kg m^2") !=
              std::string::npos,
          warns);
  }
  check_worst_named(program, differ);
  check_lighter_corners(program, differ);
  program.write("often.toml", hung_text("integrator = \"velocity_verlet\"\nstep = \"0.2 s\"\nend = \"1 s\"\n"));
  for (const std::string command : {"run", "check"}) {
    const ProgramEnd often = run_talus(program.folder(), {command, "often.toml"});
    differ.ended("interval shorter than the step: " + command, often, 2, "interval: found \"0.1 s\"; ");
  }
  program.write("chosen.toml",
                "units = \"SI\"\n[[body]]\nname = \"free\"\nmobility = \"particle\"\nmass = \"2 kg\"\n"
                "position = [\"0 m\", \"0 m\"]\n[run]\nend = \"1 s\"\ninterval = \"0.5 ms\"\n");
  const Json chosen = Json::parse(talus_output(program.folder(), {"run", "chosen.toml", "--json"}));
  differ.compare("step chosen for a thousandth of the end or the interval", chosen.at("step").get<double>(), 5e-4);
  // Of two pairs that never touch, the nearer one is named.
  std::string apart =
      "units = \"SI\"\n[[body]]\nname = \"ball\"\nmobility = \"particle\"\nmass = \"2 kg\"\n"
      "position = [\"0 m\", \"0 m\"]\nshape = { kind = \"circle\", radius = \"1 m\" }\n";
  for (const auto& [name, x] : {std::pair{"far", -3.5}, {"near", 2.75}, {"farther", 7.0}})
    apart += fmt::format(
        "[[body]]\nname = \"{0}\"\nmobility = \"fixed\"\nposition = [\"{1} m\", \"0 m\"]\n"
        "shape = {{ kind = \"circle\", radius = \"1 m\" }}\n[[contact]]\nname = \"to {0}\"\n"
        "between = [\"ball\", \"{0}\"]\nlaw = \"linear_spring_dashpot\"\nstiffness = \"3 kN/m\"\n"
        "damping = \"0 N s/m\"\n",
        name, x);
  program.write("apart.toml", apart + "[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\nend = \"10 ms\"\n");
  differ.contains("closest of contacts that never touch", talus_output(program.folder(), {"run", "apart.toml"}),
                  "none: nothing touched; closest was to near with a gap of 0.75 m");
  // If it flies against the nearer one, the two others never touch; it was closest to one of them at the start.
  apart.insert(apart.find("position = "), "velocity = [\"100 m/s\", \"0 m/s\"]\n");
  program.write("struck.toml", apart + "[run]\nintegrator = \"rk4\"\nstep = \"1 ms\"\nend = \"10 ms\"\n");
  differ.contains("contacts that never touch beside one that does",
                  run_talus(program.folder(), {"run", "struck.toml"}).output,
                  "; 2 of 3 contacts never touched; closest was to far with a gap of 1.5 m\n");
  for (const std::string command : {"plot", "snapshot", "animate"}) {
    const ProgramEnd nowhere = run_talus(program.folder(), {command, "nowhere"});
    differ.holds("folder that is missing: " + command,
                 nowhere.exit_code == 4 && nowhere.messages.find("talus: nowhere: found no folder") == 0);
  }
  const ProgramEnd in_the_way = run_talus(program.folder(), {"run", "plain.toml", "--out", "plain.toml"});
  differ.holds("folder that is a file",
               in_the_way.exit_code == 4 && in_the_way.messages.find("talus: plain.toml: found a file; ") == 0);
  differ.compare("missing file", run_talus(program.folder(), {"run", "nothing.toml"}).exit_code, 4);
  std::string parts;
  for (const std::string topic : {"integrators", "laws", "shapes", "units"})
    parts += program.run({"list", topic});
  differ.compare("list: all topics", program.run({"list"}), parts);
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("options");
  const Program program{setup};
  program.write("drop.toml", drop_text());
  program.write("plain.toml", hung_text("integrator = \"velocity_verlet\"\nstep = \"10 ms\"\nend = \"1 s\"\n"));
  const std::string of_runs = "results that differ from the options of run, cell and study",
                    of_others = "results that differ from the options of advise, calibrate, export, new and list";
  Differences runs, others;
  if (setup.needs("talus run") || setup.needs(of_runs)) check_run(program, findings, runs);
  if (setup.needs("listed integrators")) check_listed_integrators(program, findings);
  if (setup.needs("talus cell") || setup.needs(of_runs)) check_cell(program, findings, runs);
  if (!setup.coarse) check_study(program, runs);
  runs.expect_none(findings, of_runs, "results by options and by fields of the scene, counts and texts");
  if (setup.needs("talus advise") || setup.needs(of_others)) check_advice(program, findings, others);
  if (setup.needs(of_others)) check_advised_scenes(program, others);
  if (setup.needs("talus calibrate") || setup.needs(of_others)) check_calibration(program, findings, others);
  if (setup.needs(of_others)) {
    program.write("cell.toml", cell_text("", ""));
    check_other_commands(program, others);
  }
  others.expect_none(findings, of_others, "files, texts and exit statuses");
}

}  // namespace

Case definition() {
  const std::string of_runs = "results that differ from the options of run, cell and study",
                    of_others = "results that differ from the options of advise, calibrate, export, new and list";
  return {.id = "calculation_options",
          .title = "Options of the commands that calculate",
          .requirements = {{"G12", {"options"}}},
          .main_checks = {of_runs, of_others},
          .source = "Textbook mechanics; Schwager & Poeschel 2007; Walton & Braun 1986",
          .faults = {{"without_tolerance", "tolerance of a run not given",
                      "talus run --tolerance: largest error of y over its largest value"},
                     {"without_seed", "seed of a cell not given", of_runs},
                     {"without_frames", "number of states not given",
                      "talus run --frames: times of the states, largest error"},
                     {"without_speed", "speed of approach not given",
                      "talus calibrate --speed: largest overlap over the exact one, deviation from 1"},
                     {"pulling_contact", "exact damping of a contact that may pull",
                      "talus calibrate --contact: damping of a dropped disc over the exact one, deviation from 1"},
                     {"without_among", "methods to choose from not given", of_others},
                     {"without_steps", "steps of an exported cell not given", of_others}},
          .seconds = 4.0,
          .run = run};
}

}  // namespace talus::verification::problems::calculation_options
