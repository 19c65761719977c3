#include "verification/problems/program/calibration/rayleigh_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "verification/problems/program/calibration/impact_request.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/rayleigh_wave.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calibrated_laws {
namespace {

using records::Json;

constexpr double degree = std::numbers::pi / 180.0;

/// One or two spheres of one material; with one, the other body is a plane.
struct Spheres {
  reference::ElasticMaterial material;
  std::vector<double> densities, radii;

  double mass(std::size_t i) const { return densities[i] * 4.0 / 3.0 * std::numbers::pi * std::pow(radii[i], 3.0); }
  double effective_radius() const { return radii.size() == 1 ? radii[0] : radii[0] * radii[1] / (radii[0] + radii[1]); }
  /// The faults take the slowest wave, or the material that touches a rigid body with the same modulus.
  double shortest_time(const Setup& setup) const {
    reference::ElasticMaterial of = material;
    if (setup.has("rigid_plane")) of.young_modulus *= 0.5;
    std::vector<double> times;
    for (std::size_t i = 0; i < radii.size(); ++i)
      times.push_back(of.wave_time(densities[i], radii[i]));
    return setup.has("slow_sphere") ? std::ranges::max(times) : std::ranges::min(times);
  }
};

/// Spheres that differ more in their times than the approximation of the wave speed deviates.
Spheres drawn_spheres(ImpactDraw& draw, double poisson_ratio) {
  Spheres made{{draw.decades(1e7, 1e11), poisson_ratio}, {draw.between(900.0, 8000.0)}, {draw.decades(1e-3, 0.1)}};
  if (draw.between(0.0, 1.0) < 0.5) {
    made.densities.push_back(draw.between(900.0, 8000.0));
    made.radii.push_back(made.radii[0] * draw.between(3.5, 6.0));
    if (draw.between(0.0, 1.0) < 0.5) std::swap(made.radii[0], made.radii[1]);
  }
  return made;
}

/// Worst errors over all requests.
struct Worst {
  double wave{}, formula{}, ratio{}, modulus{}, printed{};
};

Options hertz_options(const Spheres& spheres, bool by_spheres, double speed) {
  Option masses{"--masses", {}}, radii{"--spheres", {}};
  for (std::size_t i = 0; i < spheres.radii.size(); ++i) {
    masses.second.push_back(fmt::format("{} kg", spheres.mass(i)));
    radii.second.push_back(fmt::format("{} m", spheres.radii[i]));
  }
  return {{"--law", {"hertz"}},
          {"--restitution", {"0.7"}},
          {"--modulus", {fmt::format("{} Pa", spheres.material.contact_modulus())}},
          {"--speed", {fmt::format("{} m/s", speed)}},
          masses,
          by_spheres ? radii : Option{"--radius", {fmt::format("{} m", spheres.effective_radius())}}};
}

Options with(Options options, const Options& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

Option ratio_option(double poisson_ratio) { return {"--poisson-ratio", {fmt::format("{}", poisson_ratio)}}; }

/// The Rayleigh time of the output, beside the exact wave and the formula.
void compare_time(const Json& json, const Spheres& spheres, const Setup& setup, Worst& worst) {
  const double time = json.at("rayleigh_time").get<double>(), nu = spheres.material.poisson_ratio;
  const double exact = spheres.shortest_time(setup);
  keep_worst(worst.wave, time / exact - 1.0);
  // c = (0.8766 + 0.1631 nu) sqrt(G/rho), as EDEM and LIGGGHTS state it.
  const double formula = exact * reference::surface_wave_speed(nu) / (0.8766 + 0.1631 * nu);
  keep_worst(worst.formula, time / formula - 1.0);
}

/// Three printed lines.
void compare_text(const std::string& printed, const Json& json, Worst& worst) {
  const double time = json.at("rayleigh_time").get<double>(), nu = json.at("poisson_ratio").get<double>();
  keep_worst(worst.printed, number_after(printed, "Poisson's ratio ") - nu);
  keep_worst(worst.printed, number_after(printed, "Rayleigh time, of one material ") / time - 1.0);
  keep_worst(worst.printed,
             number_after(printed, "step over Rayleigh time ") * time / json.at("step").get<double>() - 1.0);
}

/// An impact along the normal: --spheres in place of --radius changes nothing else.
void compare_normal(const Program& program, const Spheres& spheres, double speed, Worst& worst, Differences& differ) {
  const Options by_radius = hertz_options(spheres, false, speed),
                by_spheres = with(hertz_options(spheres, true, speed), {ratio_option(spheres.material.poisson_ratio)});
  const Json found = program.json({"calibrate"}, with(by_spheres, {{"--json", {}}})),
             plain = program.json({"calibrate"}, with(by_radius, {{"--json", {}}}));
  compare_time(found, spheres, program.setup(), worst);
  keep_worst(worst.ratio, found.at("poisson_ratio").get<double>() - spheres.material.poisson_ratio);
  for (const auto& [name, value] : plain.items()) {
    if (name == "law" || name == "dashpot" || name == "end_rule" || name == "units") {
      differ.compare(name, found.at(name).get<std::string>(), value.get<std::string>());
    } else {
      differ.holds(name, std::abs(found.at(name).get<double>() / value.get<double>() - 1.0) < 1e-9);
    }
  }
  differ.compare("members of an impact", found.size(), plain.size() + 2);
  compare_text(program.run({"calibrate"}, by_spheres), found, worst);
}

/// An oblique impact: Poisson's ratio gives the shear modulus, and the shear modulus Poisson's ratio.
void compare_oblique(const Program& program, const Spheres& spheres, double speed, bool with_others, Worst& worst,
                     Differences& differ) {
  const Options common = with(hertz_options(spheres, true, speed), {{"--shear-law", {"mindlin"}},
                                                                    {"--friction", {"0.3"}},
                                                                    {"--angle", {fmt::format("{} rad", 20.0 * degree)}},
                                                                    {"--bound", {"0.05"}}});
  const reference::ElasticMaterial& material = spheres.material;
  const Options by_ratio = with(common, {ratio_option(material.poisson_ratio)});
  const Json found = program.json({"calibrate"}, with(by_ratio, {{"--json", {}}}));
  compare_time(found, spheres, program.setup(), worst);
  keep_worst(worst.modulus, found.at("shear_modulus").get<double>() / material.contact_shear_modulus() - 1.0);
  const Json back = program.json(
      {"calibrate"},
      with(common, {{"--shear-modulus", {fmt::format("{} Pa", material.contact_shear_modulus())}}, {"--json", {}}}));
  compare_time(back, spheres, program.setup(), worst);
  keep_worst(worst.ratio, back.at("poisson_ratio").get<double>() - material.poisson_ratio);
  compare_text(program.run({"calibrate"}, by_ratio), found, worst);

  if (!with_others) return;
  // No material has half of this modulus, or twice.
  for (const double factor : {0.5, 2.0}) {
    const Options other =
        with(common, {{"--shear-modulus", {fmt::format("{} Pa", factor * material.contact_shear_modulus())}}});
    const Json none = program.json({"calibrate"}, with(other, {{"--json", {}}}));
    differ.holds("no material", none.at("rayleigh_time").is_null() && none.at("poisson_ratio").is_null());
    const std::string printed = program.run({"calibrate"}, other);
    differ.contains("no Rayleigh time", printed, "  no Rayleigh time: a material of both");
    differ.holds("no fraction of it", printed.find("step over Rayleigh time") == std::string::npos);
  }
}

/// Ranges: of radii with one density, and of speeds of the same spheres.
void compare_ranges(const Program& program, const Spheres& spheres, double speed, Worst& worst, Differences& differ) {
  const Option ratio = ratio_option(spheres.material.poisson_ratio), bound{"--bound", {"0.05"}};
  const double small = std::ranges::min(spheres.radii);
  const Options sizes{{"--law", {"hertz"}},
                      {"--restitution", {"0.7"}},
                      {"--modulus", {fmt::format("{} Pa", spheres.material.contact_modulus())}},
                      {"--speed", {fmt::format("{} m/s", speed)}},
                      {"--radii", {fmt::format("{} m", small), fmt::format("{} m", 4.0 * small), "3"}},
                      {"--density", {fmt::format("{} kg/m^3", spheres.densities[0])}},
                      ratio,
                      bound};
  const double density = spheres.densities[0];
  const Spheres equal{spheres.material, {density, density}, {small, 4.0 * small}};
  Options speeds = with(hertz_options(spheres, true, speed), {ratio, bound});
  for (Option& option : speeds) {
    if (option.first == "--speed")
      option = {"--speeds", {fmt::format("{} m/s", speed), fmt::format("{} m/s", 2.0 * speed), "2"}};
  }
  for (const auto& [options, of] : {std::pair{sizes, equal}, std::pair{speeds, spheres}}) {
    const Json found = program.json({"calibrate"}, with(options, {{"--json", {}}}));
    compare_time(found, of, program.setup(), worst);
    keep_worst(worst.ratio, found.at("poisson_ratio").get<double>() - of.material.poisson_ratio);
    compare_text(program.run({"calibrate"}, options), found, worst);
  }
  const Json found = program.json({"calibrate"}, with(speeds, {{"--json", {}}}));
  differ.holds("radius of a range of speeds",
               std::abs(found.at("radius").get<double>() / spheres.effective_radius() - 1.0) < 1e-14);
}

/// Pairs of different moduli that share their spheres, and impacts that do not end.
void compare_other_ranges(const Program& program, const Spheres& spheres, Worst& worst, Differences& differ) {
  const reference::ElasticMaterial soft{0.01 * spheres.material.young_modulus, spheres.material.poisson_ratio};
  const std::array moduli{soft.contact_modulus(), spheres.material.contact_modulus(), soft.contact_modulus()};
  program.write("moduli.csv",
                fmt::format("modulus [Pa],speed [m/s]\n{},0.1\n{},0.1\n{},0.1\n", moduli[0], moduli[1], moduli[2]));
  Options options = hertz_options(spheres, true, 1.0);
  std::erase_if(options, [](const Option& option) { return option.first == "--modulus" || option.first == "--speed"; });
  options = with(options, {{"--pairs", {"moduli.csv"}}, {"--bound", {"0.05"}}, ratio_option(soft.poisson_ratio)});
  const Json of_moduli = program.json({"calibrate"}, with(options, {{"--json", {}}}));
  compare_time(of_moduli, spheres, program.setup(), worst);
  for (std::size_t i = 0; i < moduli.size(); ++i)
    differ.compare("modulus of a pair", of_moduli.at("pairs").at(i).at("modulus").get<double>(), moduli[i]);

  const Options endless{{"--law", {"hertz"}},
                        {"--restitution", {"0.5"}},
                        {"--damping", {"1e9 N s/m"}},
                        {"--end-rule", {"attractive"}},
                        {"--modulus", {fmt::format("{} Pa", spheres.material.contact_modulus())}},
                        {"--radii", {"1 mm", "1 cm", "2"}},
                        {"--density", {"2500 kg/m^3"}},
                        ratio_option(spheres.material.poisson_ratio)};
  const Json json = program.json({"calibrate"}, with(endless, {{"--json", {}}}));
  const std::string printed = program.run({"calibrate"}, endless);
  differ.holds("no step for impacts that do not end", json.at("step").is_null());
  keep_worst(worst.printed,
             number_after(printed, "Rayleigh time, of one material ") / json.at("rayleigh_time").get<double>() - 1.0);
  differ.holds("no fraction without a step", printed.find("step over Rayleigh time") == std::string::npos);
}

/// Wrong requests, each with a part of its message.
void compare_refusals(const Program& program, Differences& differ) {
  const Options hertz{{"--law", {"hertz"}}, {"--restitution", {"0.7"}}, {"--modulus", {"1 GPa"}}},
      linear{{"--stiffness", {"1 N/m"}}, {"--restitution", {"0.7"}}};
  const Option mass{"--masses", {"1 g"}}, sphere{"--spheres", {"1 cm"}}, radius{"--radius", {"1 cm"}},
      ratio{"--poisson-ratio", {"0.3"}}, axis{"--masses", {"1 g", "2 g", "3"}}, radii{"--radii", {"1 mm", "2 mm", "3"}},
      density{"--density", {"2500 kg/m^3"}}, angle{"--angle", {"10 deg"}}, friction{"--friction", {"0.1"}},
      mindlin{"--shear-law", {"mindlin"}};
  struct Wrong {
    Options options;
    std::string message;
  };
  const std::vector<Wrong> all{
      {with(hertz, {mass, radius, ratio}), "--poisson-ratio: it needs spheres; give --spheres with --masses, or"},
      {with(hertz, {axis, radius, ratio}), "--poisson-ratio: it needs spheres; give --spheres with --masses, or"},
      {with(hertz, {mass, {"--discs", {"1 cm"}}, angle, friction, mindlin, ratio}),
       "--poisson-ratio: it needs spheres"},
      {with(hertz, {mass, sphere, {"--poisson-ratio", {"0.51"}}}),
       "--poisson-ratio: found 0.51; it must be in [0, 0.5]"},
      {with(hertz, {mass, sphere, {"--poisson-ratio", {"-0.1"}}}), "--poisson-ratio: found -0.1; it must be in"},
      {with(linear, {mass, ratio}), "--poisson-ratio: the law 'linear_spring_dashpot' does not use this option"},
      {with(linear, {mass, sphere}), "--spheres: the law 'linear_spring_dashpot' does not use this option"},
      {with(hertz, {mass, sphere, radius}), "--radius: it follows from --spheres or --discs; remove it"},
      {with(hertz, {mass, {"--spheres", {"1 cm", "2 cm"}}}), "--spheres: found 2 radii for 1 mass; give one for each"},
      {with(hertz, {mass, sphere, {"--offset", {"1 kg m^2", "1 m"}}}),
       "--pivot and --offset: spheres are hit centrally; remove them, or give --radius"},
      {with(hertz, {mass, sphere, {"--speeds", {"1 m/s", "2 m/s", "2"}}, {"--pivot", {"1 kg m^2", "1 m"}}}),
       "--pivot and --offset: spheres are hit centrally; remove them, or give --radius"},
      {with(hertz, {mass, radius, {"--integrator", {"exact"}}}),
       "integrator 'exact': the motion between events must be linear, but contact 'impact': the law hertz is not "
       "linear"},
      {with(hertz, {mass, radius, {"--bound", {"nan"}}}), "--bound: found nan; it must be > 0"},
      {with(hertz, {axis, sphere}), "--spheres: each pair gives its own bodies; remove it"},
      {with(hertz, {radii, density, sphere}), "--spheres: each pair gives its own bodies; remove it"},
      {with(hertz, {mass, sphere, angle, friction, mindlin, ratio, {"--shear-modulus", {"1 GPa"}}}),
       "--shear-modulus: it follows from --poisson-ratio; give one of the two"},
      {{{"--law", {"latching_spring"}}, {"--restitution", {"0.7"}}, {"--step", {"1e-7 s"}}, ratio},
       "--poisson-ratio: the law 'latching_spring' does not use this option"}};
  for (const Wrong& wrong : all) {
    const ProgramEnd end = program.end({"calibrate"}, wrong.options);
    differ.ended("refusal: " + wrong.message, end, 2, wrong.message);
  }
}

}  // namespace

void check_rayleigh_times(const Program& program, Findings& findings) {
  const Setup& setup = program.setup();
  Differences differ;
  Worst worst;
  ImpactDraw draw;
  const std::array<double, 6> ratios{0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
  const std::size_t count = setup.tier == Tier::full ? 24 : setup.coarse ? 2 : 6;
  for (std::size_t number = 0; number < count; ++number) {
    Spheres spheres = drawn_spheres(draw, ratios[number % ratios.size()]);
    const double speed = draw.decades(0.05, 1.0);
    compare_normal(program, spheres, speed, worst, differ);
    if (number % 2 == 0) compare_ranges(program, spheres, speed, worst, differ);
    // Overlaps of a stiff pair: the program refuses those of more than half the radius.
    spheres.material.young_modulus = std::max(spheres.material.young_modulus, 1e9);
    if (number % 3 == 0) compare_oblique(program, spheres, speed, number == 0, worst, differ);
  }
  compare_other_ranges(program, drawn_spheres(draw, 0.3), worst, differ);
  if (setup.needs("outputs that differ")) compare_refusals(program, differ);
  findings.expect("spheres: Rayleigh time over that of the exact surface wave, largest deviation from 1", worst.wave,
                  0.0,
                  Tolerance::model(0.004,
                                   "0.8766 + 0.1631 nu is 0.3 % above the root of Rayleigh's equation at both "
                                   "ends of [0, 0.5]"));
  findings.expect("spheres: Rayleigh time over that of the formula, largest deviation from 1", worst.formula, 0.0,
                  Tolerance::round_off(2e-14,
                                       "some twenty operations on both sides, and radii spaced by powers; nu of "
                                       "both moduli has an error of some 1e-15"));
  findings.expect("spheres: Poisson's ratio less that of the material, largest error", worst.ratio, 0.0,
                  Tolerance::round_off(1e-14,
                                       "from both moduli: (1 - 4 q)/(1 - 2 q) has a derivative of -2/(1 - 2 q)^2, "
                                       "at most 8 for q up to 1/4"));
  findings.expect("spheres: shear modulus over that of the material, largest deviation from 1", worst.modulus, 0.0,
                  Tolerance::round_off(2e-15, "some ten operations"));
  findings.expect("spheres: printed numbers over those of JSON, largest deviation from 1", worst.printed, 0.0,
                  Tolerance::model(5.1e-9, "nine digits are printed: half a unit of the last one"));
  differ.expect_none(findings, "spheres: outputs that differ from the request", "numbers, texts and refusals");
}

}  // namespace talus::verification::problems::calibrated_laws
