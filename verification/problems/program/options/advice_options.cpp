#include "verification/problems/program/options/advice_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "verification/check/case_file.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calculation_options {
namespace {

using records::Json;
using Names = std::set<std::string>;

/// The number with n significant digits.
double rounded(double value, int digits) { return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr); }

}  // namespace

std::string hung_text(const std::string& method) {
  return fmt::format(R"(title = "Hung body"
units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]
[[body]]
name = "hung"
mobility = "sliding_y"
mass = "{} kg"
position = ["0 m", "{} m"]

[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "hung", point = ["0 m", "0 m"] }}
to = {{ point = ["0 m", "{} m"] }}
stiffness = "{} N/m"
rest_length = "{} m"

[run]
interval = "0.1 s"
{})",
                     -gravity, hung_mass, hung_y, rope_top, hung_stiffness, rope_length, method);
}

reference::OscillatorState hung_state(double t) {
  return reference::state_at({std::sqrt(hung_stiffness / hung_mass), 0.0, hung_y - hung_rest, 0.0}, t);
}

/// The largest height of a ball that falls from 1e-14 m is nothing beside the 5 m that it falls.
void check_vanishing(const Program& program, Differences& differ) {
  program.write("falls.toml",
                "units = \"SI\"\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n[[body]]\nname = \"ball\"\n"
                "mobility = \"particle\"\nmass = \"1 kg\"\nposition = [\"0 m\", \"1e-14 m\"]\n"
                "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"1 s\"\n");
  const ProgramEnd end = program.end({"advise", "falls.toml"}, {{"--accuracy", {"1e-3"}}, {"--of", {"ball.y.max"}}});
  differ.holds(
      "advise: refusal of a quantity that vanishes",
      end.exit_code == 5 && end.output.find("no advice (vanishing): ball.y.max is 1e-14") != std::string::npos);
}

void check_advice(const Program& program, Findings& findings, Differences& differ) {
  check_vanishing(program, differ);
  constexpr double accuracy = 1e-4, end = 1.0;
  const Names among{"rk4", "blanes_moan4"};
  const Options options{{"--accuracy", {"1e-4"}},
                        {"--of", {"hung.vy.end"}},
                        {"--among", {"rk4,blanes_moan4"}},
                        {"--out", {"advised.toml"}}};
  Options in_json = options, few = options;
  in_json.push_back({"--json", {}});
  few.push_back({"--evaluations", {"100"}}), few[3].second = {"few.toml"};
  const Json advice = program.json({"advise", "plain.toml"}, in_json);
  const std::string printed = program.run({"advise", "plain.toml"}, options);
  const Json& best = advice.at("advice");
  Names tried;
  for (const Json& method : advice.at("tried"))
    tried.insert(method.at("integrator").get<std::string>());
  differ.compare("advise: methods of --among", tried, among);
  const std::string expected = fmt::format("with {} force evaluations", best.at("evaluations").get<long>());
  differ.contains("advise: evaluations printed and in JSON", printed, expected);
  differ.holds("advise: request", advice.at("quantity") == "hung.vy.end" && advice.at("accuracy") == accuracy);
  differ.compare("advise: value printed", number_after(printed, "value "),
                 rounded(advice.at("value").get<double>(), 10));
  differ.compare("advise: pilots printed", number_after(printed, "pilots: "),
                 advice.at("evaluations_of_pilots").get<double>());
  const Json& growth = advice.at("growth");
  differ.contains("advise: growth printed", printed,
                  fmt::format("differences of {:.0e} in the start grow to {:.0e}", growth.at("start").get<double>(),
                              growth.at("result").get<double>()));
  // The velocity number i at the start changes by 1e-6 of the accuracy and of the largest speed A w, times a factor of
  // at most 1 that the direction d gives, 1 or 2: 2 frac(d i (sqrt(5) - 1)/2) - 1. It is largest with d i = 2, in the
  // second direction for the first velocity, and in the first one for the second. The rope stays taut.
  std::string second = program.read("plain.toml");
  second.insert(second.find("[[body]]"),
                "[[body]]\nname = \"other\"\nmobility = \"sliding_x\"\nmass = \"1 kg\"\n"
                "position = [\"5 m\", \"0 m\"]\n");
  program.write("second.toml", second);
  Options of_second = in_json;
  of_second[3].second = {"second_advised.toml"};
  const Json grown_second = program.json({"advise", "second.toml"}, of_second).at("growth");
  const double frequency = std::sqrt(hung_stiffness / hung_mass), factor = std::abs(2.0 * (std::sqrt(5.0) - 2.0) - 1.0);
  const double change = 1e-6 * accuracy * factor * std::abs(hung_y - hung_rest) * frequency;
  const double grown = change * reference::state_at({frequency, 0.0, 0.0, 1.0}, end).velocity;
  double worst = 0.0;
  for (const Json& found : {growth, grown_second})
    keep_worst(worst, found.at("result").get<double>() / std::abs(grown / hung_state(end).velocity) - 1.0);
  findings.expect(
      "talus advise: growth of differences over that of the free oscillation, deviation from 1", worst, 0.0,
      Tolerance::model(0.5,
                       "both runs choose their steps, so that a difference of 2e-12 m/s is known to some "
                       "tenths; a start that does not scale with the speed changes it by a factor of 2.9, the "
                       "last growth in place of the largest by 0.1"));
  differ.compare("advise: units", advice.value("units", "SI"), std::string("SI"));
  bool is_tried = false;
  for (const Json& method : advice.at("tried")) {
    if (!method.contains("evaluations")) {  // not run; only without --among
      differ.compare("advise: " + method.at("integrator").get<std::string>() + " not run", true, false);
      continue;
    }
    const std::string error =
        method.contains("error") ? fmt::format("{:.1e}", method.at("error").get<double>()) : "failed";
    const std::string row =
        fmt::format("{} - {:.6g} {} {} {}", method.at("integrator").get<std::string>(), method.at("step").get<double>(),
                    error, method.at("evaluations").get<long>(), method.at("verdict").get<std::string>());
    differ.contains("advise: row " + row, squeezed(printed), row);
    is_tried = is_tried || (method.at("step") == best.at("step") && method.value("error", -1.0) == best.at("error") &&
                            method.at("evaluations") == best.at("evaluations"));
  }
  differ.holds("advise: the advised method among those tried", is_tried);
  differ.holds("advise: file of --out", program.has("advised.toml"));
  if (!program.has("advised.toml")) return;
  const Json summary = program.json({"run", "advised.toml"}, {{"--json", {}}});
  differ.compare("advise: integrator of the advised scene", summary.at("integrator"), best.at("integrator"));
  differ.compare("advise: evaluations of the advised run", summary.at("evaluations"), best.at("evaluations"));
  findings.expect("talus advise: speed at the end with the advised method over the exact one, deviation from 1",
                  summary.at("bodies").at(0).at("velocity").at(1).get<double>() / hung_state(end).velocity - 1.0, 0.0,
                  Tolerance::truncation(accuracy, 1.0, "the required accuracy"));
  // JSON is in SI units also of a scene in others, whose runs of some thousand steps differ by round-off.
  program.write("us.toml", in_us_units(program.read("plain.toml")));
  const double in_si = program.json({"advise", "us.toml"}, in_json).at("value").get<double>();
  differ.holds("advise: value of the scene in US units",
               std::abs(in_si / advice.at("value").get<double>() - 1.0) < 1e-11);
  const ProgramEnd refused = program.end({"advise", "plain.toml"}, few);
  differ.compare("advise: exit status with 100 evaluations", refused.exit_code, 5);
  differ.compare("advise: file with 100 evaluations", program.has("few.toml"), false);

  const Options loose{
      {"--accuracy", {"0.2"}}, {"--of", {"disc.vy.end"}}, {"--among", {"velocity_verlet"}}, {"--json", {}}};
  Options warned = loose;
  warned.push_back({"--allow-warnings", {}});
  const auto evaluations = [&](const Options& chosen) {
    return program.json({"advise", "drop.toml"}, chosen).at("advice").at("evaluations").get<double>();
  };
  const double careful = evaluations(loose), careless = evaluations(warned);
  findings.expect_between("talus advise --allow-warnings: evaluations over those without it", careless / careful, 0.01,
                          0.5,
                          "the contact lasts 30 ms of 200 ms: ten steps in it are 67 evaluations, an accuracy of 0.2 "
                          "needs three");
}

void check_advised_scenes(const Program& program, Differences& differ) {
  // The half kick of 1993 depends on the step: it is 2e-4 of the rock's speed here, more than the reported error.
  std::string deck = records::read_whole(case_file("fence/table_2.toml"));
  for (const auto& [key, value] : {std::pair{"steps", 200}, {"print_every", 100}, {"history_every", 50}}) {
    const std::size_t from = deck.find(fmt::format("\n{} = ", key)) + 1;
    deck.replace(from, deck.find('\n', from) - from, fmt::format("{} = {}", key, value));
  }
  program.write("kicked.toml", deck);
  const Json advice = program.json({"advise", "kicked.toml", "--accuracy", "1e-2", "--of", "rock.vx.end", "--among",
                                    "rk4", "--out", "unkicked.toml", "--json"});
  const Json advised = program.json({"run", "unkicked.toml", "--json"});
  constexpr double foot = 0.3048;
  for (const Json& body : advised.at("bodies")) {
    if (body.at("name") != "rock") continue;
    const double error = foot * body.at("velocity").at(0).get<double>() / advice.at("value").get<double>() - 1.0;
    // Both errors are some 1e-4, from numbers that are converted with 1e-16.
    differ.holds("advise: error of an advised fence at most the reported one",
                 std::abs(error) <= advice.at("advice").at("error").get<double>() + 1e-12);
  }
  const std::string text = program.read("unkicked.toml");
  const double steps = number_after(text, "\nsteps = ");
  differ.holds("advise: rows of an advised fence at the same times",
               number_after(text, "\nhistory_every = ") == std::round(steps / 4.0));
  differ.holds("advise: states of an advised fence at the same times",
               number_after(text, "\nprint_every = ") == std::round(steps / 2.0));
  // A method with step control: the advised scene of a fence has the tolerance of the advice, and costs what it says.
  const Json controlled = program.json({"advise", "kicked.toml", "--accuracy", "1e-3", "--of", "rock.vx.end", "--among",
                                        "stormer_cowell", "--out", "controlled.toml", "--json"});
  differ.compare("advise: evaluations of an advised fence with step control",
                 program.json({"run", "controlled.toml", "--json"}).at("evaluations"),
                 controlled.at("advice").at("evaluations"));
  for (const Json& of : {controlled.at("advice"), controlled.at("tried").at(0)})
    differ.compare("advise: tolerance of the written fence", of.at("tolerance").get<double>(),
                   number_after(program.read("controlled.toml"), "\ntolerance = "));
  // A run that ends when its rock has passed: trials end there, too.
  program.write("exit.toml", deck + "\n[fence.options]\nend = \"exit\"\nexit_x = \"2.19 ft\"\n");
  const auto evaluations = [&](const char* file, const char* out) {
    const Json found = program.json(
        {"advise", file, "--accuracy", "1e-3", "--of", "energy.kinetic.max", "--among", "rk4", "--out", out, "--json"});
    const Json run = program.json({"run", out, "--json"});
    differ.compare(fmt::format("advise: evaluations of the advised scene of {}", file), run.at("evaluations"),
                   found.at("advice").at("evaluations"));
    return run.at("evaluations").get<long>();
  };
  differ.holds("advise: the rock passes before the last step",
               evaluations("exit.toml", "exited.toml") < evaluations("kicked.toml", "ended.toml"));
  // The lowest velocity is -A omega, once in the run; outputs need only resolve it.
  const ProgramEnd minimum = program.end({"advise", "plain.toml", "--accuracy", "1e-2", "--of", "hung.vy.min",
                                          "--among", "stormer_cowell", "--out", "lowest.toml", "--json"});
  differ.compare("advise: exit status of a method with step control for a minimum", minimum.exit_code, 0);
  if (minimum.exit_code != 0) return;
  // The reference value may have 0.35 of the required error.
  const double lowest = (hung_y - hung_rest) * std::sqrt(hung_stiffness / hung_mass);
  differ.holds("advise: lowest velocity",
               std::abs(Json::parse(minimum.output).at("value").get<double>() / lowest - 1.0) < 3.5e-3);
}

}  // namespace talus::verification::problems::calculation_options
