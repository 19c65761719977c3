#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/app/calibration/impact_calibration.hpp"
#include "solver/app/calibration/latching_calibration.hpp"
#include "solver/app/calibration/law_options.hpp"
#include "solver/app/calibration/oblique_calibration.hpp"
#include "solver/app/calibration/range_calibration.hpp"
#include "solver/app/calibration/scene_calibration.hpp"
#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/command_line/completion.hpp"

namespace talus::app {
namespace {

/// Checks --write-scene before anything is computed. Errors: InputError
void check_written_scene(const CalibrateOptions& options) {
  const std::string& file = options.written_scene;
  if (file.empty()) return;
  if (options.law == LatchingSpring::name || gives_oblique(options) || gives_range(options)) {
    throw InputError{
        "--write-scene: only a single impact along the normal has this scene; latching_spring, oblique impacts and "
        "ranges have none; remove it"};
  }
  if (std::filesystem::path{file}.extension() != ".toml")
    throw InputError{fmt::format("--write-scene: found \"{}\"; it must be a scene file, .toml", file)};
}

/// Calibration without a scene, by the law of --law.
int calibrate_law(const CalibrateOptions& options, const DrawingSink& sink) {
  check_written_scene(options);
  if (options.law == LatchingSpring::name) return calibrate_latching(options);
  if (gives_oblique(options)) {
    for (const std::string& given : options.own_to_range)
      if (given != "--out" && given != "--format")
        throw InputError{fmt::format(
            "{}: it gives a range of pairs, and an oblique impact has one pair; remove one of both", given)};
    return calibrate_oblique(options, sink);
  }
  if (!options.own_to_oblique.empty()) {
    throw InputError{
        fmt::format("{}: only oblique impacts use it; give --angle or --angles", options.own_to_oblique.front())};
  }
  if (gives_range(options)) return calibrate_range(options, sink);
  if (!options.own_to_range.empty()) {
    throw InputError{
        fmt::format("{}: only a table is written to files; give --speeds, --radii, --pairs, --angles or "
                    "an axis of --masses",
                    options.own_to_range.front())};
  }
  return calibrate_impact(options);
}

int run_calibration(const CalibrateOptions& options, const DrawingSink& sink) {
  if (options.restitution && !(*options.restitution > 0.0 && *options.restitution <= 1.0))
    throw InputError{fmt::format("--restitution: found {}; it must be in (0, 1]", *options.restitution)};
  if (!(options.bound > 0.0)) throw InputError{fmt::format("--bound: found {}; it must be > 0", options.bound)};
  if (options.scene.empty()) {
    if (!options.contact.empty()) throw InputError{"--contact: it needs a scene; name its file"};
    return calibrate_law(options, sink);
  }
  if (!options.masses.empty() || !options.pivot.empty() || !options.offset.empty())
    throw InputError{"--masses, --pivot and --offset are given by the scene; remove them"};
  if (!options.own_to_impact.empty()) {
    throw InputError{fmt::format("{}: given by the scene; remove it", fmt::join(options.own_to_impact, ", "))};
  }
  if (!options.own_to_range.empty()) {
    throw InputError{
        fmt::format("{}: a range of pairs has no scene; remove one of both", fmt::join(options.own_to_range, ", "))};
  }
  static_cast<void>(demanded_restitution(options));
  return calibrate_scene(options);
}

}  // namespace

Command add_calibrate(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* app = talus.add_subcommand("calibrate", "Find the damping, or K1/K2, that gives a contact its restitution");
  const auto options = std::make_shared<CalibrateOptions>();
  app->add_option("SCENE", options->scene, "scene file: calibrate its --contact by simulation of the scene");
  app->add_option("--contact", options->contact, "name of the scene's contact");
  app->add_option("--restitution", options->restitution, "restitution wanted, in (0, 1]");
  offer(app->add_option(
            "--law", options->law,
            "linear_spring_dashpot (default), hertz or hunt_crossley; or latching_spring: K1/K2 of two discs that "
            "are stepped by --step"),
        ContactLaws::names());
  app->add_option("--masses", options->masses,
                  "masses of body 1 and body 2; a single mass is that of body 2, and body 1 is fixed; an axis of such "
                  "masses: the first one, the last one and their number")
      ->expected(1, 3);
  const auto parameter = [&](const char* field, const char* meaning) {
    app->add_option(option_name(field), options->parameters.at(field), meaning);
  };
  parameter("stiffness", "stiffness of the contact, e.g. \"1e6 lbf/ft\"");
  parameter("modulus", "of hertz: effective modulus, e.g. \"35 GPa\"");
  parameter("radius", "of hertz: effective radius");
  app->add_option("--poisson-ratio", options->poisson_ratio,
                  "of hertz between spheres of one material: Poisson's ratio, in [0, 0.5], for the Rayleigh time; of "
                  "mindlin it gives the shear modulus");
  parameter("reference_overlap", "of hunt_crossley: overlap at which force over overlap is the stiffness");
  parameter("exponent", "of hunt_crossley: power of the overlap, between 1 and 100");
  parameter("damping",
            "in place of --restitution: the restitution that this dashpot gives is printed; of many pairs beside "
            "--restitution");
  parameter("hysteresis", "the same for hunt_crossley");
  offer(app->add_option("--dashpot", options->dashpot,
                        "of hertz: tsuji (default; the restitution is the same at every speed) or constant"),
        names_of<HertzDashpot>());
  offer(app->add_option("--end-rule", options->end_rule,
                        "clamped (default, as in scenes: never pulls) or attractive (Eq. 21 of 1993)"),
        names_of<EndRule>());
  CLI::Option* pivot = app->add_option("--pivot", options->pivot,
                                       "body 2 turns about a fixed pin: its inertia about the pin, and the arm, the "
                                       "distance of the pin from the line of impact; its mass has no effect")
                           ->expected(2);
  app->add_option("--offset", options->offset,
                  "body 2 is free and hit off centre: its inertia about the centre of mass, and the arm, the distance "
                  "of this centre from the line of impact")
      ->expected(2)
      ->excludes(pivot);
  app->add_option("--speed", options->speed,
                  "speed of approach; default \"1 m/s\". The overlap depends on it; by hunt_crossley, and hertz with a "
                  "constant dashpot, also the restitution");
  app->add_option(
      "--angle", options->angle,
      "oblique impact of round bodies with friction: angle of the velocity from the normal, e.g. \"30 deg\"; the speed "
      "of approach is then --speed times its cosine");
  app->add_option("--angles", options->angles,
                  "a table of such impacts with the same parameters: the first angle, the last "
                  "one and their number, spaced evenly")
      ->expected(3);
  CLI::Option* spheres =
      app->add_option("--spheres", options->spheres,
                      "of hertz in place of --radius, and of oblique impacts: radius of each body of "
                      "--masses, spheres")
          ->expected(1, 2);
  CLI::Option* discs =
      app->add_option("--discs", options->discs, "of oblique impacts: the same for discs")->expected(1, 2);
  discs->excludes(spheres);
  app->add_option("--tangential-restitution", options->tangential_restitution,
                  "wanted at --angle: relative speed of the centres along the plane, after over before. The first of "
                  "--friction, --shear-stiffness (--shear-modulus) and --shear-damping that is not given is found");
  app->add_option("--shear-law", options->shear_law, "linear (default, as in scenes) or, for hertz, mindlin");
  const auto of_friction = [&](const char* field, const char* meaning) {
    app->add_option(option_name(field), options->friction[field], meaning);
  };
  of_friction("friction", "of oblique impacts: coefficient of friction");
  of_friction("shear_stiffness", "of linear: tangential stiffness; default, as in scenes: the normal one");
  of_friction("shear_modulus", "of mindlin: effective shear modulus, e.g. \"13.5 GPa\"");
  of_friction("shear_damping",
              "tangential dashpot; default, as in scenes: c/k of a linear normal law for linear, 0 for mindlin");
  app->add_option("--bound", options->bound,
                  "error of the restitution that the step may cause, in a range that of each pair; default 0.001");
  offer(app->add_option("--integrator", options->integrator, "method for the step; default velocity_verlet"),
        integrator_names());
  app->add_option("--step", options->step, "of a latching_spring: its step, e.g. \"1e-7 s\"; a bare number is in s");
  CLI::Option* speeds =
      app->add_option(
             "--speeds", options->speeds,
             "one dashpot for many pairs: the first speed, the last one and their number, spaced evenly in the "
             "logarithm")
          ->expected(3);
  CLI::Option* radii = app->add_option("--radii", options->radii,
                                       "the same for the radii of two equal spheres; their masses, and of hertz the "
                                       "effective radius, follow from --density")
                           ->expected(3);
  radii->needs(app->add_option("--density", options->density, "of the spheres of --radii")->needs(radii));
  app->add_option(
         "--pairs", options->pairs,
         "one dashpot for the pairs of a CSV file with the columns mass_1, mass_2, speed and parameters of the "
         "law, e.g. \"speed [m/s]\"; columns that are absent are given by their options")
      ->excludes(speeds)
      ->excludes(radii);
  CLI::Option* out = app->add_option("--out", options->picture.folder,
                                     "folder for the table of the pairs, or of the angles, and its drawing");
  add_format_option(*app, options->picture);
  app->get_option("--format")->needs(out);
  app->add_option("--write-scene", options->written_scene,
                  "file for a scene of this impact with the dashpot and the step: run it to see the restitution");
  offer(app->add_option("--units", options->units, "SI or US, for the text; JSON is always SI"), unit_system_names());
  app->add_flag("--json", options->json, "print JSON, in SI units");
  app->footer(
      "Examples:\n"
      "  talus calibrate --restitution 0.5 --masses \"37.23 slug\" \"14.92 slug\" --stiffness \"1e6 lbf/ft\" --units "
      "US\n"
      "  talus calibrate --restitution 0.5 --masses \"37.23 slug\" \"14.92 slug\" --stiffness \"1e6 lbf/ft\" \\\n"
      "        --pivot \"324.14 slug ft^2\" \"4 ft\" --end-rule attractive\n"
      "  talus calibrate --law hertz --restitution 0.7 --masses \"8 g\" --modulus \"35 GPa\" --radius \"1 cm\"\n"
      "  talus calibrate --law hertz --dashpot constant --restitution 0.7 --modulus \"35 GPa\" --speeds \"0.1 m/s\" "
      "\"10 m/s\" 9 \\\n"
      "        --radii \"1 mm\" \"1 cm\" 3 --density \"2500 kg/m^3\" --out range\n"
      "  talus calibrate --law hertz --modulus \"63 GPa\" --masses \"0.26 g\" --spheres \"2.5 mm\" --restitution 0.98 "
      "--speed \"3.9 m/s\" \\\n"
      "        --shear-law mindlin --friction 0.092 --angle \"10 deg\" --tangential-restitution 0.7\n"
      "  talus calibrate cases/pivoted_cylinder.toml --contact impact --restitution 0.5\n"
      "  talus calibrate --law latching_spring --restitution 0.7 --step 1e-7 --integrator euler");
  return {app, [app, options, sink] {
            for (const char* name : {"--law", "--end-rule", "--dashpot", "--poisson-ratio", "--spheres", "--speed",
                                     "--step", "--bound", "--integrator", "--write-scene", "--units"}) {
              if (app->get_option(name)->count() > 0) options->own_to_impact.emplace_back(name);
            }
            for (const char* name : {"--speeds", "--radii", "--density", "--pairs", "--out", "--format"})
              if (app->get_option(name)->count() > 0) options->own_to_range.emplace_back(name);
            for (const char* name : {"--angle", "--angles", "--discs", "--tangential-restitution", "--shear-law",
                                     "--friction", "--shear-stiffness", "--shear-modulus", "--shear-damping"}) {
              if (app->get_option(name)->count() == 0) continue;
              options->own_to_impact.emplace_back(name), options->own_to_oblique.emplace_back(name);
            }
            if (gives_mass_axis(*options)) options->own_to_range.emplace_back("--masses");
            for (const auto& [name, value] : options->parameters)
              if (!value.empty()) options->own_to_impact.push_back(option_name(name));
            return run_calibration(*options, sink);
          }};
}

}  // namespace talus::app
