#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/impacts/weighted_impact.hpp"
#include "verification/reference/integration/stepped_latch.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calibrated_contact {
namespace {

using records::Json;
using reference::EndRule;
using reference::StepMap;

constexpr double struck_mass = 1.0, striker_mass = 3.0, stiffness = 1e5, bound = 1e-3, approach = 1.3;

/// Role of the struck body, as options of the program, and the effective mass of the impact.
struct Geometry {
  std::vector<std::string> options;
  double effective_mass{};
  std::string role;    ///< printed for body 2
  double role_mass{};  ///< effective mass of body 2 alone
};

std::vector<Geometry> geometries(const Setup& setup) {
  const double inertia = 0.2, arm = 0.3;
  const double turning = setup.has("arm_forgotten") ? 0.0 : arm * arm / inertia;
  const std::string one = fmt::format("{} kg", striker_mass), other = fmt::format("{} kg", struck_mass);
  const std::string about = fmt::format("{} kg m^2", inertia), beside = fmt::format("{} m", arm);
  const double off_centre = 1.0 / (1.0 / struck_mass + turning), on_pin = 1.0 / turning;
  const auto both = [](double mass) { return 1.0 / (1.0 / striker_mass + 1.0 / mass); };
  return {{{"--masses", one}, striker_mass, "body 2, free, hit centrally", striker_mass},
          {{"--masses", one, other}, both(struck_mass), "body 2, free, hit centrally", struck_mass},
          {{"--masses", one, other, "--offset", about, beside},
           both(off_centre),
           "body 2, free, hit off centre",
           off_centre},
          {{"--masses", one, other, "--pivot", about, beside}, both(on_pin), "body 2, on a fixed pin", on_pin}};
}

std::string name(EndRule rule) { return rule == EndRule::clamped ? "clamped" : "attractive"; }

Json calibrated(const TemporaryFolder& folder, double restitution, EndRule rule, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"calibrate",
                                     "--restitution",
                                     fmt::format("{}", restitution),
                                     "--stiffness",
                                     fmt::format("{} N/m", stiffness),
                                     "--end-rule",
                                     name(rule),
                                     "--bound",
                                     fmt::format("{}", bound),
                                     "--speed",
                                     fmt::format("{} m/s", approach),
                                     "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return Json::parse(talus_output(folder, arguments));
}

/// Restitution of one impact of velocity Verlet at unit speed: the force has the overlap of the step and the velocity
/// half a step earlier. `phase`: the fraction of a step at which the surfaces meet. NaN if they do not part.
double stepped(const reference::Impact& impact, EndRule rule, double step, double phase) {
  double overlap = -phase * step, velocity = 1.0;
  bool touched = false;
  for (int n = 0; n < 10000; ++n) {
    if (overlap > 0.0) {
      const double force = impact.stiffness * overlap + impact.damping * velocity;
      if (rule == EndRule::clamped && force <= 0.0) return -velocity;
      touched = true, velocity -= step * force / impact.effective_mass;
    } else if (touched) {
      return -velocity;
    }
    overlap += step * velocity;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Step, restitution and its largest error, as the program defines them: a step of T/(2^n + 0.381966), 64 phases of
/// touch, for the error each with a step that ends the contact at another phase, by the golden section.
struct Stepped {
  double fraction{};  ///< 2^n from the printed step, over the nearest power of two
  double restitution{}, error{};
};
Stepped stepped_of(const reference::Impact& impact, EndRule rule, double e, double time, double step) {
  constexpr int phases = 64;
  const double steps = time / step - 0.381966, power = std::exp2(std::round(std::log2(steps)));
  Stepped found{.fraction = steps / power};
  for (int i = 0; i < phases; ++i) {
    const double phase = (i + 0.5) / phases, part = (std::numbers::phi - 1.0) * (i + 0.5);
    found.restitution += stepped(impact, rule, step, phase) / phases;
    const double other = time / (power + part - std::floor(part));
    keep_largest(found.error, stepped(impact, rule, other, phase) - e);
  }
  return found;
}

/// Worst deviation from 1 of the effective masses that the program prints for each body over the exact ones; NaN if a
/// role is not printed.
double worst_printed_role(const TemporaryFolder& folder, const std::vector<Geometry>& geometries) {
  double worst = 0.0;
  for (const Geometry& geometry : geometries) {
    std::vector<std::string> arguments{"calibrate", "--restitution", "0.6", "--stiffness",
                                       fmt::format("{} N/m", stiffness)};
    arguments.insert(arguments.end(), geometry.options.begin(), geometry.options.end());
    const std::string text = talus_output(folder, arguments);
    const auto printed = [&text](const std::string& role) {
      const std::size_t at = text.find("  " + role + " ");
      return at == std::string::npos ? std::numeric_limits<double>::quiet_NaN()
                                     : std::strtod(text.c_str() + at + 2 + role.size(), nullptr);
    };
    keep_worst(worst, printed(geometry.role) / geometry.role_mass - 1.0);
    if (geometry.options.size() > 2)
      keep_worst(worst, printed("body 1, free, hit centrally") / striker_mass - 1.0);
    else if (text.find("  body 1, fixed\n") == std::string::npos)
      worst = std::numeric_limits<double>::quiet_NaN();
  }
  return worst;
}

/// Compares the numbers that the program prints with closed forms.
void check_numbers(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  double damping = 0.0, mass = 0.0, time = 0.0, overlap = 0.0, powers = 0.0, simulated = 0.0, texts = 0.0;
  std::size_t members = 0;
  const std::vector<double> restitutions = setup.coarse ? std::vector{0.6} : std::vector{0.9, 0.6, 0.2};
  for (const Geometry& geometry : geometries(setup)) {
    for (const EndRule rule : {EndRule::clamped, EndRule::attractive}) {
      for (const double e : restitutions) {
        const Json printed = calibrated(folder, e, rule, geometry.options);
        const double m = geometry.effective_mass;
        const double c = setup.has("pulling_formula")
                             ? reference::eq_21_damping(e, stiffness, m)
                             : 2.0 * reference::damping_ratio(e, rule) * std::sqrt(stiffness * m);
        const reference::ImpactEvents impact = reference::impact_events({stiffness, c, m, approach}, rule);
        keep_worst(mass, printed.at("effective_mass").get<double>() / m - 1.0);
        keep_worst(damping, printed.at("damping").get<double>() / c - 1.0);
        keep_worst(time, printed.at("contact_time").get<double>() / impact.contact_time - 1.0);
        keep_worst(
            time,
            printed.at("undamped_contact_time").get<double>() / (std::numbers::pi * std::sqrt(m / stiffness)) - 1.0);
        keep_worst(overlap, printed.at("largest_overlap").get<double>() / impact.largest_depth - 1.0);
        keep_worst(damping, printed.at("damping_ratio").get<double>() / (c / (2.0 * std::sqrt(stiffness * m))) - 1.0);
        texts += printed.at("end_rule") == name(rule) && printed.at("units") == "SI" ? 0.0 : 1.0;
        texts += printed.at("speed") == approach && printed.at("stiffness") == stiffness ? 0.0 : 1.0;
        texts += printed.at("law") == "linear_spring_dashpot" && printed.at("exact_restitution") == e ? 0.0 : 1.0;
        const Stepped own = stepped_of({stiffness, c, m, 1.0}, rule, e, impact.contact_time,
                                       printed.at("step").get<double>() / (setup.has("half_the_step") ? 2.0 : 1.0));
        keep_worst(powers, own.fraction - 1.0);
        keep_worst(simulated, printed.at("restitution").get<double>() - own.restitution);
        // The program states 1.25 times the error of 64 phases.
        keep_worst(simulated, 0.8 * printed.at("restitution_error").get<double>() - own.error);
        members = printed.size();
      }
    }
  }
  const Tolerance round_off = Tolerance::round_off(
      3e-15, "closed forms of about ten operations and one root on both sides, 1.1e-16 each, printed with 17 digits");
  findings.expect("effective mass, over the exact one: largest deviation from 1", mass, 0.0, round_off);
  findings.expect(
      "printed effective masses of the bodies in their roles, over the exact ones: largest deviation from 1",
      worst_printed_role(folder, geometries(setup)), 0.0,
      Tolerance::model(5.1e-9, "nine digits are printed: half a unit of the last one, and round-off"));
  findings.expect("members that are not compared", static_cast<double>(members) - 15.0, 0.0,
                  Tolerance::exact("each number, the law, the end rule, the units"));
  findings.expect("end rules, units and speeds that are not those requested", texts, 0.0,
                  Tolerance::exact("texts, and a number with 17 digits"));
  findings.expect(
      "steps over the exact ones: largest deviation from 1", powers, 0.0,
      Tolerance::round_off(3e-14, "a contact time of some 100 to 2000 steps, to 3e-15 as above, less 0.38"));
  findings.expect("restitution and its deviation over phases, by a second program: largest difference", simulated, 0.0,
                  Tolerance::round_off(5e-12,
                                       "the program's disc has a radius of 1000 overlaps, each rounded to 1.1e-13 of "
                                       "itself in up to 2048 steps that add up as a random walk"));
  findings.expect("damping, over the exact one: largest deviation from 1", damping, 0.0, round_off);
  findings.expect("contact time, over the exact one: largest deviation from 1", time, 0.0, round_off);
  findings.expect("largest overlap, over the exact one: largest deviation from 1", overlap, 0.0, round_off);
}

/// Restitution of two discs in a run of the program. They touch after three steps and the fraction `phase` of a step.
double simulated(const TemporaryFolder& folder, const std::string& law, double time, double step, double phase) {
  const double gap = (3.0 + phase) * step;
  folder.write("impact.toml", fmt::format(R"(units = "SI"
[[body]]
name = "striker"
mobility = "particle"
mass = "{} kg"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["{} m", "0 m"]
velocity = ["1 m/s", "0 m/s"]

[[body]]
name = "struck"
mobility = "particle"
mass = "{} kg"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["1 m", "0 m"]

[[contact]]
name = "impact"
between = ["striker", "struck"]
{}
[run]
integrator = "velocity_verlet"
step = "{} s"
end = "{} s"
interval = "1 s"
watch = "off"
)",
                                          striker_mass, -gap, struck_mass, law, step, 1.2 * time + 6.0 * step));
  const Json state = Json::parse(talus_output(folder, {"run", "impact.toml", "--json"}));
  const auto velocity = [&](std::size_t body) {
    return state.at("bodies").at(body).at("velocity").at(0).get<double>();
  };
  return velocity(1) - velocity(0);
}

/// The lines that the program prints for a scene, with the stiffness multiplied by `factor` at the same damping ratio:
/// this changes the contact time and thereby the phase at which the discs part.
std::string printed_law(const TemporaryFolder& folder, double restitution, EndRule rule, double factor) {
  std::vector<std::string> arguments{"calibrate",
                                     "--restitution",
                                     fmt::format("{}", restitution),
                                     "--stiffness",
                                     fmt::format("{} N/m", factor * stiffness),
                                     "--end-rule",
                                     name(rule),
                                     "--masses",
                                     fmt::format("{} kg", striker_mass),
                                     fmt::format("{} kg", struck_mass)};
  const std::string text = talus_output(folder, arguments);
  const std::size_t from = text.find("  law = "), to = text.find("for every impact", from);
  return text.substr(from, to - from);
}

/// Tests the advised step by brute force over the phases of touch and separation.
void check_step(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const int phases = setup.coarse ? 3 : 6;
  double largest = 0.0, above_claim = 0.0;
  std::vector<std::vector<std::string>> rows;
  for (const EndRule rule : {EndRule::clamped, EndRule::attractive}) {
    const double e = 0.6;
    const Json printed = calibrated(folder, e, rule, geometries(setup)[1].options);
    const double step = (setup.has("twice_the_step") ? 2.0 : 1.0) * printed.at("step").get<double>();
    const double time = printed.at("contact_time").get<double>();
    double worst = 0.0;
    for (int part = 0; part < phases; ++part) {
      // Shortens the contact time by equal fractions of one step.
      const double factor = std::pow(1.0 + step / time * part / phases, 2);
      const std::string law = printed_law(folder, e, rule, factor);
      for (int meet = 0; meet < phases; ++meet)
        keep_worst(worst, simulated(folder, law, time, step, (meet + 0.5) / phases) - e);
    }
    const double said = printed.at("restitution_error").get<double>();
    keep_worst(largest, worst);
    keep_worst(above_claim, std::abs(worst) / said);
    rows.push_back(
        {name(rule), fmt::format("{:.6g}", step), fmt::format("{:.3g}", said), fmt::format("{:.3g}", worst)});
  }
  findings.expect("restitution with the advised step: largest error over phases", largest, 0.0,
                  Tolerance::truncation(bound, 1.0, "the requested error"));
  findings.expect_between("restitution error over the error that the program reports: largest ratio", above_claim, 0.7,
                          1.0,
                          "the program reports 1.25 times the error of 64 pairs of phases, since other phases may err "
                          "more; these phases are near those");
  findings.expect_between("restitution error with the advised step over the bound", std::abs(largest) / bound, 0.1, 1.0,
                          "steps are tried in powers of two, and the error is at least of first order in the step: the "
                          "step is not needlessly short");
  findings.table({.name = "steps",
                  .caption = "The advised step for an error of 1e-3 at a restitution of 0.6, and the errors of runs.",
                  .columns = {"end rule", "step [s]", "reported error", "largest error of runs"},
                  .rows = rows});
}

/// All members of the JSON output for a latching spring, beside the request and the restitution of a stepped one.
void check_latching(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double k1 = 2e4, disc = 1e-6, step_of = 1e-7, e = 0.7, speed_of = 2.0;
  const Json found = Json::parse(talus_output(
      folder,
      {"calibrate", "--law", "latching_spring", "--restitution", fmt::format("{}", e), "--masses",
       fmt::format("{} kg", disc), fmt::format("{} kg", disc), "--stiffness", fmt::format("{} N/m", k1), "--speed",
       fmt::format("{} m/s", speed_of), "--step", fmt::format("{} s", step_of), "--integrator", "euler", "--json"}));
  const auto number = [&](const char* name) { return found.at(name).get<double>(); };
  const double mass = 0.5 * disc, w1 = std::sqrt(k1 / mass), z1 = w1 * step_of;
  const double ratio = number("ratio_by_simulation"), z2 = z1 / std::sqrt(ratio);
  const auto latch = [&](double of) {
    return reference::SteppedLatch{of, z1, setup.has("taylor_steps") ? StepMap::taylor : StepMap::euler};
  };
  double worst = 0.0;
  for (const auto& [name, exact] :
       {std::pair{"effective_mass", mass}, std::pair{"stiffness", k1}, std::pair{"unloading_stiffness", k1 / ratio},
        std::pair{"step", step_of}, std::pair{"loading_angle", z1},
        std::pair{"steps_in_contact", 0.5 * std::numbers::pi * (1.0 / z1 + 1.0 / z2)},
        std::pair{"exact_restitution", std::sqrt(ratio)}, std::pair{"speed", speed_of},
        std::pair{"largest_overlap", speed_of / w1}})
    keep_worst(worst, number(name) / exact - 1.0);
  keep_worst(worst, reference::leading_restitution(latch(number("ratio_by_formula"))) / e - 1.0);
  findings.expect("latching spring: numbers with closed forms, largest relative error", worst, 0.0,
                  Tolerance::round_off(3e-15, "about ten operations and roots on both sides, 1.1e-16 each"));
  double mean = 0.0;
  keep_worst(mean, reference::mean_restitution(latch(ratio)) - e);
  keep_worst(mean, number("restitution") - e);
  keep_worst(mean, number("restitution_of_formula") - reference::mean_restitution(latch(number("ratio_by_formula"))));
  findings.expect("latching spring: restitutions, largest difference from the mean over phases", mean, 0.0,
                  Tolerance::truncation(z2 * z2 * z2 * z2 / 240.0, 1.0,
                                        "the reference is exact to the third power of z2; the squares of its terms "
                                        "z2^2 g/2, whose g^2 has the mean 1/30, are z2^4/240"));
  // g = u (1 - u) has the variance 1/180 over a fraction u of a step.
  const double a = z1 * z1, b = z2 * z2;
  findings.expect_between(
      "latching spring: deviation over phases over that of three independent fractions of a step",
      number("restitution_deviation") / (e * std::sqrt((a * a + b * b + (b - a) * (b - a)) / 720.0)), 0.5,
      std::sqrt(3.0),
      "touch, turning point and end are at fractions of a step that depend on one phase: equal ones add up to at most "
      "sqrt(3) times as much");
  const bool texts = found.at("law") == "latching_spring" && found.at("integrator") == "euler" &&
                     found.at("default_discs") == false && found.at("units") == "SI" && found.at("phases") == 200;
  findings.expect_true("latching spring: texts, and no member more", texts && found.size() == 19,
                       "as requested; 200 phases as the printed table says");
}

/// The minimum restitution that a method with growth can give at a step, as the refusal of a smaller one states it: the
/// minimum over K1/K2 of the leading-order restitution, in which the growth of loading and of unloading both count.
void check_minimum_restitution(const TemporaryFolder& folder, Findings& findings) {
  constexpr double k1 = 2e4, disc = 1e-6, step_of = 1e-6;
  const double z1 = step_of * std::sqrt(k1 / (0.5 * disc));  // 0.2
  double worst = 0.0;
  for (const auto& [name, map] : {std::pair{"euler", StepMap::euler}, std::pair{"taylor", StepMap::taylor}}) {
    const ProgramEnd end =
        run_talus(folder, {"calibrate", "--law", "latching_spring", "--restitution", "0.1", "--masses",
                           fmt::format("{} kg", disc), fmt::format("{} kg", disc), "--stiffness",
                           fmt::format("{} N/m", k1), "--step", fmt::format("{} s", step_of), "--integrator", name});
    // With r the root of K1/K2, r exp[c pi z1 (1 + 1/r)] falls, then rises: the interval around its minimum shrinks.
    const auto restitution = [&, of = map](double r) {
      return reference::leading_restitution(reference::SteppedLatch{r * r, z1, of});
    };
    double low = 0.01, high = 1.0;
    for (int n = 0; n < 100; ++n) {
      const double a = (2.0 * low + high) / 3.0, b = (low + 2.0 * high) / 3.0;
      if (restitution(a) < restitution(b)) {
        high = b;
      } else {
        low = a;
      }
    }
    const double printed =
        end.exit_code == 2 ? number_after(end.messages, "w1 h = 0.2: ") : std::numeric_limits<double>::quiet_NaN();
    keep_worst(worst, printed - restitution(0.5 * (low + high)));
  }
  findings.expect("latching spring: minimum restitution in the refusal of a smaller one, largest error", worst, 0.0,
                  Tolerance::model(5.1e-5,
                                   "four digits are printed: half a unit of the last one. Without the growth of "
                                   "loading, the limit would be lower by 15 % (Euler) and 8 % (Taylor)"));
}

/// A contact of a scene with weight, calibrated by runs of it: the rebound is that of the surfaces, as a run lists it.
void check_weight(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  constexpr double m = 400.0, k = 2e6, g = 9.81, v0 = 6.0, gap = 0.01, step = 1e-5;
  const auto scene = [&](double damping, const char* method = "") {
    return fmt::format(R"(units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]
body = [
  {{ name = "rock", mobility = "particle", mass = "{} kg", shape = {{ kind = "circle", radius = "0.35 m" }}, position = ["0 m", "{} m"], velocity = ["0 m/s", "{} m/s"] }},
  {{ name = "ground", mobility = "fixed", shape = {{ kind = "half_plane" }}, position = ["0 m", "0 m"] }},
]
contact = [
  {{ name = "bounce", between = ["rock", "ground"], law = "linear_spring_dashpot", stiffness = "{} N/m", damping = "{} N s/m", end_rule = "clamped"{} }},
]
run = {{ step = "{} s", end = "0.1 s" }}
)",
                       -g, m, 0.35 + gap, -std::sqrt(v0 * v0 - 2.0 * g * gap), k, damping, method, step);
  };
  double closed = 0.0, listed = 0.0, by_nodes = 0.0;
  for (const double e : {0.8, 0.45}) {
    folder.write("falling.toml", scene(1.0));
    const Json found = Json::parse(talus_output(
        folder, {"calibrate", "falling.toml", "--contact", "bounce", "--restitution", fmt::format("{}", e), "--json"}));
    const double damping = found.at("damping").get<double>();
    // Of eight nodes one is the lowest; those beside it are 0.1 m higher.
    folder.write("falling.toml", scene(1.0, ", method = \"nodes\", nodes = 8"));
    const Json of_nodes = Json::parse(talus_output(
        folder, {"calibrate", "falling.toml", "--contact", "bounce", "--restitution", fmt::format("{}", e), "--json"}));
    for (const char* const name : {"damping", "largest_overlap", "speed"})
      keep_worst(by_nodes, of_nodes.at(name).get<double>() / found.at(name).get<double>() - 1.0);
    const reference::WeightedRebound exact = reference::weighted_rebound({m, k, damping, g, v0}, EndRule::clamped);
    keep_worst(closed, (setup.has("speed_at_the_end_of_force") ? exact.release_speed / v0 : exact.restitution) - e);
    folder.write("falling.toml", scene(damping));
    talus_output(folder, {"run", "falling.toml", "--impacts", "--out", "fallen"});
    const records::Csv impacts = records::read_csv(folder.path() / "fallen/impacts.csv");
    keep_worst(listed, impacts.number(0, "restitution") - e);
  }
  findings.expect(
      "falling rock: restitution of the calibrated damping in closed form, largest difference", closed, 0.0,
      Tolerance::truncation(2.0 * g * step / v0, 1.0,
                            "speeds are those of the states before and after the contact, each up to a step "
                            "of weight away"));
  findings.expect(
      "falling rock: damping, overlap and speed by the lowest of eight nodes over those of one force, largest "
      "deviation from 1",
      by_nodes, 0.0,
      Tolerance::model(
          2e-10,
          "both searches try the same dampings; round-off of 4,000 steps, 1.1e-16 each, changes a "
          "restitution by 4.4e-13 and a damping by 1/(e ln(1/e)) = 5.6 times that, twice by a secant; each "
          "of the other runs, of six in all, begins with the dampings before: 2^6 x 5.6 x 4.4e-13"));
  findings.expect("falling rock: restitution that a run with it lists, largest difference", listed, 0.0,
                  Tolerance::truncation(1e-6, 1.0, "the search ends within 1e-6, and both take the same states"));
  // The rock overlaps the ground at the start and rises: no approach, and no restitution, can be measured.
  std::string rising = scene(1.0);
  const std::string height = fmt::format("\"{} m\"]", 0.35 + gap);
  rising.replace(rising.find(height), height.size(), "\"0.34999 m\"]");
  const std::string down = "velocity = [\"0 m/s\", \"-";
  rising.erase(rising.find(down) + down.size() - 1, 1);
  folder.write("rising.toml", rising);
  const ProgramEnd refused =
      run_talus(folder, {"calibrate", "rising.toml", "--contact", "bounce", "--restitution", "0.5"});
  findings.expect_true("falling rock: refusal where it touches the ground at the start and rises",
                       refused.exit_code == 2 && refused.messages.find("do not approach each other; they touch at the "
                                                                       "start") != std::string::npos,
                       "exit status 2 and this reason; at any damping no restitution is that of an impact");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("calibration");
  const TemporaryFolder folder;
  if (setup.needs("over the exact one") || setup.needs("second program")) check_numbers(folder, findings, setup);
  if (setup.needs("latching")) {
    check_latching(folder, findings, setup);
    check_minimum_restitution(folder, findings);
  }
  if (setup.needs("falling")) check_weight(folder, findings, setup);
  if (setup.needs("error")) check_step(folder, findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "calibrated_contact",
      .title = "Calibration by `talus calibrate`",
      .requirements = {{"G3", {"calibration"}}},
      .main_checks = {"damping, over the exact one: largest deviation from 1",
                      "restitution with the advised step: largest error over phases"},
      .source =
          "Mustoe & Huttelmaier 1993, Eq. 21, and its counterpart for contacts that are not attractive (Schwager & "
          "Poeschel 2007)",
      .faults = {{"pulling_formula", "Eq. 21, the formula for attractive contacts, also for clamped ones",
                  "damping, over the exact one: largest deviation from 1"},
                 {"arm_forgotten", "rotation of the struck body neglected",
                  "effective mass, over the exact one: largest deviation from 1"},
                 {"half_the_step", "the members compared with those of a step half as long",
                  "restitution and its deviation over phases, by a second program: largest difference"},
                 {"taylor_steps", "restitution of a latching spring stepped by the Taylor map",
                  "latching spring: restitutions, largest difference from the mean over phases"},
                 {"speed_at_the_end_of_force", "the speed when the force ends taken for that when the surfaces part",
                  "falling rock: restitution of the calibrated damping in closed form, largest difference"},
                 {"twice_the_step", "twice the advised step",
                  "restitution with the advised step: largest error over phases"}},
      .seconds = 6.0,
      .run = run};
}

}  // namespace talus::verification::problems::calibrated_contact
