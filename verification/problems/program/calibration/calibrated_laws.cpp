#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/calibration/calibrated_ranges.hpp"
#include "verification/problems/program/calibration/impact_request.hpp"
#include "verification/problems/program/calibration/rayleigh_times.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::calibrated_laws {
namespace {

using records::Json;

constexpr double bound = 1e-3;

/// The lines of a contact that the program prints for a scene; with `every`, those for all impacts in place of the
/// dashpot.
std::string lines_of(const std::string& printed, const std::string& parameter, bool every) {
  const std::size_t from = printed.find('\n', printed.find("in a scene")) + 1, to = printed.find("for every impact");
  std::string lines = printed.substr(from, to - from);
  if (!every) return lines;
  const std::size_t at = lines.find("  " + parameter + " = ");
  lines.erase(at, lines.find('\n', at) + 1 - at);
  const std::size_t rest = printed.find("restitution = ", to), end = printed.find(" in place of", rest);
  std::string restitution = printed.substr(rest, end - rest);
  if (const std::size_t comma = restitution.find(", "); comma != std::string::npos) restitution.replace(comma, 2, "\n");
  return lines + restitution + "\n";
}

/// Largest errors of runs of the scenes that the program writes.
struct WrittenScenes {
  double restitution{};  ///< of the velocities at the end
  double listed{};       ///< relative, of the list of impacts, which has the velocities at the point of contact
};

/// Runs the scene that the program writes for an impact by the command that it prints.
void run_written_scene(const Program& program, const Setup& setup, const ImpactRequest& request, Options options,
                       WrittenScenes& worst, Differences& differ) {
  options.push_back({"--write-scene", {"impact.toml"}});
  const std::string printed = program.run({"calibrate"}, options);
  const std::string last = "to check it by a run: talus run impact.toml --impacts --out impact\n";
  differ.holds("command for the written scene", printed.ends_with(last));
  const double arm = request.lever == Lever::none ? 0.0 : request.arm() * (setup.has("other_arm") ? 1.05 : 1.0);
  const double restitution =
      separation_of_run(program, "impact.toml", arm, {{"--impacts", {}}, {"--out", {"impact"}}}) / request.speed;
  const records::Csv impacts = program.csv("impact/impacts.csv");
  differ.compare("number of listed impacts", impacts.rows(), std::size_t{1});
  keep_worst(worst.restitution, restitution - request.restitution);
  keep_worst(worst.listed, impacts.number(0, "restitution") / restitution - 1.0);
}

/// Calibrations of one pair.
void check_pairs(const Program& program, Findings& findings, const Setup& setup) {
  Differences differ;
  ImpactDraw draw;
  double damping = 0.0, time = 0.0, undamped = 0.0, overlap = 0.0, reverse = 0.0, pasted = 0.0, for_every = 0.0,
         fraction = 0.0;
  WrittenScenes written;
  const std::size_t count = setup.tier == Tier::full ? 100 : setup.coarse ? 8 : 20;
  for (std::size_t number = 0; number < count; ++number) {
    const ImpactRequest request = with_lever(draw.request(number), number);
    const ExactImpact exact = exact_of(request);
    const std::string parameter = request.is_hunt_crossley() ? "hysteresis" : "damping";
    const Options common = options_of(request, bound);
    const auto with = [&common](Options more) {
      more.insert(more.end(), common.begin(), common.end());
      return more;
    };
    const Option wanted{"--restitution", {fmt::format("{}", request.restitution)}};
    const Json found = program.json({"calibrate"}, with({wanted, {"--json", {}}}));
    keep_worst(damping, found.at(parameter).get<double>() / exact.damping - 1.0);
    keep_worst(time, found.at("contact_time").get<double>() / exact.time - 1.0);
    keep_worst(overlap, found.at("largest_overlap").get<double>() / exact.overlap - 1.0);
    keep_worst(undamped, found.at("undamped_contact_time").get<double>() / undamped_time(request) - 1.0);

    if (setup.needs("given damping")) {
      const std::string unit = request.is_hunt_crossley() ? "s/m" : "N s/m";
      const Json back = program.json(
          {"calibrate"}, with({{"--" + parameter, {fmt::format("{} {}", exact.damping, unit)}}, {"--json", {}}}));
      keep_worst(reverse, back.at("exact_restitution").get<double>() - request.restitution);
    }
    if (setup.needs("printed")) {
      const std::string printed = program.run({"calibrate"}, with({wanted}));
      keep_worst(fraction, number_after(printed, "step over undamped contact time ") * undamped_time(request) /
                                   found.at("step").get<double>() -
                               1.0);
      const bool every = number % 8 > 3;
      const auto of_run = [&](bool lines_for_every) {
        return restitution_of_run(program, request, lines_of(printed, parameter, lines_for_every),
                                  found.at("step").get<double>(), exact);
      };
      const double restitution = of_run(every);
      keep_worst(pasted, restitution - request.restitution);
      if (every) keep_worst(for_every, restitution - of_run(false));
    }
    if (setup.needs("written scenes")) {
      run_written_scene(program, setup, request, with({wanted}), written, differ);
      if (request.lever != Lever::none) {
        // The same body 2 against a fixed body 1.
        ImpactRequest alone = request;
        alone.masses.erase(alone.masses.begin());
        Options options = options_of(alone, bound);
        options.push_back(wanted);
        run_written_scene(program, setup, alone, options, written, differ);
      }
    }

    differ.compare("law", found.at("law").get<std::string>(), request.law);
    differ.compare("speed", found.at("speed").get<double>(), request.speed);
    differ.compare("exact_restitution", found.at("exact_restitution").get<double>(), request.restitution);
    differ.compare("units", found.at("units").get<std::string>(), std::string{"SI"});
    differ.holds("effective_mass",
                 std::abs(found.at("effective_mass").get<double>() / request.effective_mass() - 1.0) < 2e-15);
    differ.holds(
        "simulated restitution and its error",
        std::abs(found.at("restitution").get<double>() - request.restitution) <= found.at("restitution_error") &&
            found.at("restitution_error") <= bound);
    std::size_t members = 12;
    if (request.is_hertz()) {
      differ.compare("modulus", found.at("modulus").get<double>(), request.stiffness);
      differ.compare("radius", found.at("radius").get<double>(), request.radius);
      differ.compare("dashpot", found.at("dashpot").get<std::string>(),
                     std::string{request.constant ? "constant" : "tsuji"});
      members += 3;
    } else {
      differ.compare("stiffness", found.at("stiffness").get<double>(), request.stiffness);
      members += 1;
    }
    if (request.is_hunt_crossley()) {
      differ.compare("reference_overlap", found.at("reference_overlap").get<double>(), request.radius);
      differ.compare("exponent", found.at("exponent").get<double>(), request.exponent);
      members += 2;
    } else {
      differ.compare("end_rule", found.at("end_rule").get<std::string>(), name_of(request.rule));
      members += 2;  // and the damping ratio
      if (!request.constant)
        differ.holds("damping_ratio", std::abs(found.at("damping_ratio").get<double>() /
                                                   reference::damping_ratio(request.restitution, request.rule) -
                                               1.0) < 1e-12);
    }
    differ.compare("number of members", found.size(), members);
  }
  const Tolerance integrated = Tolerance::model(1e-13, "both sides integrate to 1e-14");
  findings.expect(
      "damping over the exact one, largest deviation from 1", damping, 0.0,
      Tolerance::model(4e-13, "1e-14 in e on both sides, of which a weak dashpot takes 1/ln(1/e) = 20 times"));
  findings.expect("contact time over the exact one, largest deviation from 1", time, 0.0, integrated);
  findings.expect("undamped contact time over the exact one, largest deviation from 1", undamped, 0.0, integrated);
  findings.expect("printed fraction of the undamped contact time over the exact one, largest deviation from 1",
                  fraction, 0.0,
                  Tolerance::model(5.1e-9, "nine digits are printed: half a unit of the last one, and round-off"));
  findings.expect("largest overlap over the exact one, largest deviation from 1", overlap, 0.0, integrated);
  findings.expect("restitution of a given damping, largest error", reverse, 0.0, integrated);
  findings.expect("restitution of runs with the printed lines, largest error", pasted, 0.0,
                  Tolerance::truncation(bound, 1.0, "the requested error with the advised step"));
  findings.expect("restitution of runs with the lines for every impact less that with the dashpot, largest difference",
                  for_every, 0.0,
                  Tolerance::model(1.5e-9,
                                   "nine digits of the dashpot, of the speed and of the restitution are printed, half "
                                   "a unit of the last one each; e changes by at most 1 for each unit of ln(c)"));
  findings.expect("restitution of runs of the written scenes, largest error", written.restitution, 0.0,
                  Tolerance::truncation(bound, 1.0, "as with the printed lines"));
  findings.expect(
      "listed restitution of the written scenes over that of the velocities, largest deviation from 1", written.listed,
      0.0,
      Tolerance::model(4e-7,
                       "with an arm of 1e5 lengths of the impact the surface is at most 30 x 1.14 of them, "
                       "w = 3.4e-4 arms, beside the line through the centre; until the outlines part (8.5 "
                       "lengths over speeds up to 1.2 v) the body turns by theta = 1e-4. This changes the arm "
                       "by w theta and tilts the speed w of the surface by theta: 2 w theta 1.2 v, over a "
                       "speed of separation of 0.2 v"));
  differ.expect_none(findings, "members of the output that differ from the request", "numbers and texts");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("calibration");
  const Program program{setup};
  const bool is_of_pair =
      std::ranges::any_of(setup.needed, [](const auto& name) { return name.find(": ") == std::string::npos; });
  if (setup.needed.empty() || is_of_pair) check_pairs(program, findings, setup);
  if (setup.needs("ranges: ")) check_ranges(program, findings);
  if (setup.needs("spheres: ")) check_rayleigh_times(program, findings);
}

}  // namespace

Case definition() {
  const std::string pasted = "restitution of runs with the printed lines, largest error",
                    damping = "damping over the exact one, largest deviation from 1",
                    members = "members of the output that differ from the request",
                    of_pairs = "ranges: dashpots of the pairs over the exact ones, largest deviation from 1",
                    wave = "spheres: Rayleigh time over that of the exact surface wave, largest deviation from 1",
                    minimax = "ranges: largest deviation with the minimax dashpot less that by a search",
                    wrong_ranges = "ranges: outputs that differ from the request";
  return {.id = "calibrated_laws",
          .title = "Damping of Hertz and Hunt-Crossley contacts by the program",
          .requirements = {{"G3", {"calibration"}}},
          .main_checks = {pasted, damping, members, of_pairs, minimax, wave},
          .source = "Hunt & Crossley 1975; Tsuji, Tanaka & Ishida 1992; Schwager & Poeschel 2007; Rayleigh 1885",
          .faults = {{"without_speed", "speed of approach not given", damping},
                     {"without_dashpot", "dashpot not given", damping},
                     {"without_end_rule", "end rule not given", damping},
                     {"other_arm", "arm of body 2 in the written scenes 5 % longer",
                      "restitution of runs of the written scenes, largest error"},
                     {"without_units", "units of the table not given", wrong_ranges},
                     {"other_mass", "effective mass of a sphere against a wall in place of two spheres", of_pairs},
                     {"heavy_first", "masses of an axis in the reverse order",
                      "ranges: effective masses over the exact ones, largest deviation from 1"},
                     {"slow_sphere", "the slower of both surface waves", wave},
                     {"rigid_plane", "half of Young's modulus, as of a sphere that hits a rigid body", wave},
                     {"mean_dashpot", "mean of the exact dashpots in place of the minimax one", minimax}},
          .seconds = 20.0,
          .full_seconds = 45.0,
          .run = run};
}

}  // namespace talus::verification::problems::calibrated_laws
