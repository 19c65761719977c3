#include "verification/problems/program/options/calibration_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/impacts/weighted_impact.hpp"
#include "verification/reference/integration/stepped_latch.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems::calculation_options {
namespace {

using records::Json;

constexpr double foot = 0.3048, pound = 4.4482216152605, slug = pound / foot;

/// A printed number in US units: the text before it, the member of the JSON output, and the unit's size in SI.
struct Line {
  std::string text, member;
  double unit;
};

constexpr double drop_mass = 2.0, drop_radius = 0.5, drop_stiffness = 2e4;

/// The impact of the dropped disc with this damping; where it falls from this height on this stiffness.
reference::WeightedRebound dropped_impact(double damping, reference::EndRule end,
                                          double height = drop.position - drop_radius,
                                          double stiffness = drop_stiffness) {
  return reference::weighted_rebound({drop_mass, stiffness, damping, gravity, std::sqrt(2.0 * gravity * height)}, end);
}

/// The damping that gives the dropped disc this restitution, by bisection.
double dropped_damping(double restitution, reference::EndRule end) {
  double low = 0.0, high = 200.0;
  for (int n = 0; n < 60; ++n) {
    const double c = 0.5 * (low + high);
    (dropped_impact(c, end).restitution > restitution ? low : high) = c;
  }
  return low;
}

/// A disc so slow that the first dashpot of the search lets its weight keep it on the ground: no rebound, but no error.
void check_slow_impact(const Program& program, Findings& findings) {
  constexpr double required = 0.3, height = 0.0125, stiffness = 4e3, step = 1e-4;
  std::string text = drop_text();
  for (const auto& [old, other] : {std::pair{"\"0.6 m\"", "\"0.5125 m\""}, {"\"20000 N/m\"", "\"4000 N/m\""}})
    text.replace(text.find(old), std::string{old}.size(), other);
  program.write("slow_drop.toml", text);
  const ProgramEnd end = program.end({"calibrate", "slow_drop.toml"},
                                     {{"--contact", {"impact"}}, {"--restitution", {"0.3"}}, {"--json", {}}});
  double exact = NAN;
  if (end.exit_code == 0) {
    const double damping = Json::parse(end.output).at("damping").get<double>();
    exact = dropped_impact(damping, reference::EndRule::clamped, height, stiffness).restitution;
  }
  // The dashpot that gives 0.3, and the restitution that it gives a disc without weight.
  constexpr double damping = 24.3, without_weight = 0.675;
  findings.expect(
      "talus calibrate --contact: exact restitution of a slow disc with the damping found", exact, required,
      Tolerance::truncation(
          step * (damping / (2.0 * drop_mass) * without_weight * without_weight / required +
                  gravity / std::sqrt(2.0 * gravity * height) * (1.0 + required)),
          1.0,
          "the first kick with c v is up to half a step early or late, c h/(2 m) of the speed v, and e^2 is R^2, that "
          "without weight, less a part that falls with v^2: R^2/e times as much of e; both speeds are those of a step "
          "before or after the contact, too low by up to g h, so that their ratio errs by g h/v (1 + e)"));
}

}  // namespace

std::string drop_text() {
  return fmt::format(R"(title = "Dropped disc"
units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]
[[body]]
name = "disc"
mobility = "particle"
mass = "{} kg"
shape = {{ kind = "circle", radius = "{} m" }}
position = ["0 m", "{} m"]
[[body]]
name = "ground"
mobility = "fixed"
shape = {{ kind = "half_plane" }}
position = ["0 m", "0 m"]
[[contact]]
name = "impact"
between = ["disc", "ground"]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
damping = "20 N s/m"
[run]
integrator = "velocity_verlet"
step = "0.1 ms"
end = "0.2 s"
)",
                     -gravity, drop_mass, drop_radius, drop.position, drop_stiffness);
}

std::string in_us_units(std::string text) {
  const std::string si = "units = \"SI\"";
  return text.replace(text.find(si), si.size(), "units = \"US\"");
}

void check_calibration(const Program& program, Findings& findings, Differences& differ) {
  constexpr double restitution = 0.6, stiffness = 1e5, mass = 0.75, bound = 0.01, speed = 3.0 * foot;
  const Options options{{"--restitution", {"0.6"}}, {"--masses", {"3 kg", "1 kg"}}, {"--stiffness", {"1e5 N/m"}},
                        {"--speed", {"3 ft/s"}},    {"--bound", {"0.01"}},          {"--integrator", {"rk4"}}};
  Options in_json = options, in_feet = options;
  in_json.push_back({"--json", {}});
  in_feet.push_back({"--units", {"US"}});
  const Json found = program.json({"calibrate"}, in_json);
  const std::string printed = program.run({"calibrate"}, in_feet);
  const double ratio = reference::damping_ratio(restitution, reference::EndRule::clamped);
  const reference::ImpactEvents impact = reference::impact_events(
      {stiffness, 2.0 * ratio * std::sqrt(stiffness * mass), mass, speed}, reference::EndRule::clamped);
  findings.expect("talus calibrate --speed: largest overlap over the exact one, deviation from 1",
                  found.at("largest_overlap").get<double>() / impact.largest_depth - 1.0, 0.0,
                  Tolerance::round_off(3e-15, "closed forms of about ten operations and one root on both sides"));
  findings.expect_between("talus calibrate --bound: error of the advised step over the bound",
                          found.at("restitution_error").get<double>() / bound, 0.1, 1.0,
                          "steps are tried in powers of two, and the error is of first order or higher");
  double worst = 0.0;
  for (const auto& [text, member, unit] :
       {Line{"effective mass ", "effective_mass", slug}, Line{"damping c ", "damping", pound / foot},
        Line{"damping ratio xi ", "damping_ratio", 1.0}, Line{"contact time ", "contact_time", 1.0},
        Line{"speed of approach ", "speed", foot}, Line{"largest overlap at that speed ", "largest_overlap", foot},
        Line{"\n  step ", "step", 1.0}, Line{"restitution simulated with it ", "restitution", 1.0}})
    keep_worst(worst, number_after(printed, text) * unit / found.at(member).get<double>() - 1.0);
  findings.expect("talus calibrate --units US: printed numbers over those of JSON, largest deviation from 1", worst,
                  0.0, Tolerance::model(5.1e-9, "nine digits are printed: half a unit of the last one, and round-off"));
  differ.holds("calibrate: method and bound printed", printed.find("simulated with rk4") != std::string::npos &&
                                                          printed.find("required 0.01") != std::string::npos);

  Options of_latching{{"--law", {"latching_spring"}},
                      {"--restitution", {"0.7"}},
                      {"--step", {"1e-7 s"}},
                      {"--integrator", {"euler"}},
                      {"--json", {}}};
  const Json latching = program.json({"calibrate"}, of_latching);
  of_latching.back() = {"--units", {"US"}};
  const std::string ratios = program.run({"calibrate"}, of_latching);
  for (const auto& [text, member, unit] :
       {Line{"effective mass ", "effective_mass", slug}, Line{"stiffness K1 ", "stiffness", pound / foot},
        Line{"step h ", "step", 1.0}, Line{"w1 h ", "loading_angle", 1.0},
        Line{"steps in a contact ", "steps_in_contact", 1.0}, Line{"K1/K2 by formula ", "ratio_by_formula", 1.0},
        Line{"restitution simulated with it ", "restitution_of_formula", 1.0},
        Line{"K1/K2 by simulation ", "ratio_by_simulation", 1.0},
        Line{"its deviation between phases ", "restitution_deviation", 1.0},
        Line{"restitution of short steps ", "exact_restitution", 1.0},
        Line{"stiffness K2 ", "unloading_stiffness", pound / foot}, Line{"speed of approach ", "speed", foot},
        Line{"largest overlap at that speed ", "largest_overlap", foot}})
    differ.holds("calibrate: printed for a latching spring: " + text,
                 std::abs(number_after(ratios, text) * unit / latching.at(member).get<double>() - 1.0) < 5.1e-9);
  const double angle = 1e-7 * std::sqrt(1.7e4 / 3.6e-7);
  findings.expect(
      "talus calibrate --law latching_spring --step: restitution of its K1/K2, deviation from the required one",
      reference::mean_restitution({latching.at("ratio_by_simulation").get<double>(), angle, reference::StepMap::euler}),
      0.7,
      Tolerance::truncation(4.6e-9, 1.0,
                            "the reference is exact to the third power of z = w2 h = 0.0324; the squares of its terms "
                            "z^2 g/2, whose g^2 has the mean 1/30, are z^4/240"));

  const Options of_contact{{"--contact", {"impact"}}, {"--restitution", {"0.6"}}};
  Options contact_in_json = of_contact;
  contact_in_json.push_back({"--json", {}});
  const Json scene = program.json({"calibrate", "drop.toml"}, contact_in_json);
  const reference::EndRule end =
      program.setup().has("pulling_contact") ? reference::EndRule::attractive : reference::EndRule::clamped;
  const double damping = dropped_damping(0.6, end);
  constexpr double drop_step = 1e-4;
  findings.expect("talus calibrate --contact: damping of a dropped disc over the exact one, deviation from 1",
                  scene.at("damping").get<double>() / damping - 1.0, 0.0,
                  Tolerance::truncation(
                      damping * drop_step / (2.0 * drop_mass) / -std::log(0.6), 1.0,
                      "the first kick with c v is up to half a step early or late: c h/(2 m) of the speed, and "
                      "as e = exp(-const c), this over ln(1/e) of the damping; gravity is in the exact solution"));
  const long contact_steps = scene.at("contact_steps").get<long>();
  const double excess = static_cast<double>(contact_steps) - dropped_impact(damping, end).force_time / drop_step;
  findings.expect_between("talus calibrate --contact: steps of the contact, more than the exact time over the step",
                          excess, 0.0, 2.0,
                          "counted from the last step before the contact to the first one after it: up to a step more "
                          "at each end");
  differ.compare("calibrate: time of the contact over its steps",
                 fmt::format("{:.12g}", scene.at("contact_time").get<double>() / static_cast<double>(contact_steps)),
                 fmt::format("{:.12g}", drop_step));
  // The disc falls freely until it touches; the approach is that of the last step before.
  const double touch = std::sqrt(2.0 * gravity * (drop.position - drop_radius));
  findings.expect_between("talus calibrate --contact: speed of approach less the exact one",
                          scene.at("speed").get<double>() - touch, -gravity * drop_step, 1e-12, "the fall in one step");
  // The second of two contacts; the first has a lighter body, and a law instance at each corner of it.
  std::string two = drop_text();
  two.insert(two.find("[[contact]]"),
             "[[body]]\nname = \"plate\"\nmobility = \"free\"\nmass = \"0.1 kg\"\ninertia = \"1e-3 kg m^2\"\n"
             "position = [\"5 m\", \"3 m\"]\n"
             "shape = { kind = \"rectangle\", half_width = \"0.1 m\", half_height = \"0.1 m\" }\n"
             "[[contact]]\nname = \"first\"\nbetween = [\"plate\", \"ground\"]\nlaw = \"linear_spring_dashpot\"\n"
             "stiffness = \"5e3 N/m\"\ndamping = \"1 N s/m\"\n");
  program.write("two_drop.toml", two);
  const Json second = program.json({"calibrate", "two_drop.toml"}, contact_in_json);
  differ.holds("calibrate: damping of the second contact",
               std::abs(second.at("damping").get<double>() / scene.at("damping").get<double>() - 1.0) < 1e-5);
  differ.holds("calibrate: damping ratio of the second contact",
               std::abs(second.at("damping_ratio").get<double>() /
                            (second.at("damping").get<double>() / (2.0 * std::sqrt(drop_stiffness * drop_mass))) -
                        1.0) < 1e-12);
  // JSON is in SI units also of a scene in others. Each search ends within 1e-6 of e, which is 1e-6/(e ln(1/e)) =
  // 3.3e-6 of the damping.
  program.write("us_drop.toml", in_us_units(program.read("drop.toml")));
  const Json in_us = program.json({"calibrate", "us_drop.toml"}, contact_in_json);
  for (const char* member : {"damping", "speed", "contact_time", "largest_overlap", "step", "restitution"}) {
    differ.holds(fmt::format("calibrate: {} of the scene in US units", member),
                 std::abs(in_us.at(member).get<double>() / scene.at(member).get<double>() - 1.0) < 1e-5);
  }
  // The text is in the scene's units: nine digits, and all of them in the line of the scene.
  const std::string in_feet_text = program.run({"calibrate", "us_drop.toml"}, of_contact);
  for (const auto& [text, member, unit] :
       {Line{"damping c ", "damping", pound / foot}, Line{"damping ratio xi ", "damping_ratio", 1.0},
        Line{"\n  restitution ", "restitution", 1.0}, Line{"speed of approach ", "speed", foot},
        Line{"contact time ", "contact_time", 1.0}, Line{"largest overlap ", "largest_overlap", foot},
        Line{"\n  step ", "step", 1.0}})
    differ.holds("calibrate: printed for a scene in US units: " + text,
                 std::abs(number_after(in_feet_text, text) * unit / in_us.at(member).get<double>() - 1.0) < 5.1e-9);
  differ.holds(
      "calibrate: line for a scene in US units",
      std::abs(number_after(in_feet_text, "\n  damping = \"") * pound / foot / in_us.at("damping").get<double>() -
               1.0) < 1e-14);
  const std::string contact_text = program.run({"calibrate", "drop.toml"}, of_contact);
  differ.contains("calibrate: contact and number of runs printed", contact_text,
                  fmt::format("contact '{}' calibrated by {} runs", scene.at("contact").get<std::string>(),
                              scene.at("runs").get<int>()));
  differ.contains("calibrate: steps of the contact printed", contact_text,
                  fmt::format(" s: {} steps, ", contact_steps));
  check_slow_impact(program, findings);
}

}  // namespace talus::verification::problems::calculation_options
