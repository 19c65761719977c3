#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/calibration/oblique_request.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/friction/oblique_impact.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::oblique_calibrations {
namespace {

using records::Json;

constexpr double bound = 1e-3, degree = std::numbers::pi / 180.0;
/// Overlap over the effective radius: small, so that the references hold, or as of soft spheres.
constexpr double shallow = 1e-6;

/// Worst errors over all requests.
struct Worst {
  double found{}, reached{}, restitution{}, tangential{}, rotational{}, angle{}, spin{}, sticking{}, time{}, damping{},
      overlap{}, undamped{}, ratio{}, mobility{}, mass{};
  double run_tangential{}, run_normal{}, run_spin{};
  double table{}, sliding{}, printed{}, csv{}, drawn{};
  int sliding_rows{};  ///< number of rows that are compared with sliding throughout
};

Options joined(Options options, const Options& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

std::string lines_of(const std::string& printed) {
  return printed.substr(printed.find('\n', printed.find("in a scene")) + 1);
}

Option wanted_option(double tangential) { return {"--tangential-restitution", {fmt::format("{:.17g}", tangential)}}; }

/// Spin of a setup with the fault: as a body that rolls backwards.
double signed_spin(const Setup& setup, double spin) { return setup.has("spin_reversed") ? -spin : spin; }

/// Compares a rebound of the JSON output, or a row of its table, with the reference.
void compare_rebound(const Json& json, const ExactRebound& exact, const ObliqueRequest& request, const Setup& setup,
                     Worst& worst) {
  const auto member = [&](const char* name) { return json.at(name).get<double>(); };
  keep_worst(worst.restitution, member("restitution") - exact.restitution);
  keep_worst(worst.tangential, member("tangential_restitution") - exact.tangential);
  keep_worst(worst.rotational, member("rotational_restitution") - exact.rotational);
  keep_worst(worst.angle, member("rebound_angle") - exact.angle);
  // As a rim speed: a spin that is nearly zero has no relative error.
  keep_worst(worst.spin, (member("spin") - signed_spin(setup, exact.spin)) * request.radii.back() *
                             request.masses.back() / (request.effective_mass() * request.slip_speed()));
  keep_worst(worst.sticking, member("sticking") - exact.sticking);
  keep_worst(worst.time, member("contact_time") / exact.contact_time - 1.0);
}

/// The parameter of the friction that gives a tangential restitution, and a run with the printed lines.
void compare_calibration(const Program& program, const ObliqueRequest& request, bool is_shallow, Worst& worst,
                         Differences& differ, Table& table) {
  const Setup& setup = program.setup();
  const ExactRebound drawn = exact_of(request);
  const Options options = joined(options_of(request, {request.sought}), {wanted_option(drawn.tangential)});
  const Json json = program.json({"calibrate"}, joined(options, {{"--json", {}}}));
  const double value = json.at(request.sought).get<double>();
  if (is_shallow) {
    const ObliqueRequest found = request.with(request.sought, setup.has("other_parameter") ? 1.1 * value : value);
    const ExactRebound exact = exact_of(found);
    keep_worst(worst.found, exact.tangential - drawn.tangential);
    compare_rebound(json, exact, found, setup, worst);
    keep_worst(worst.damping, json.at("damping").get<double>() / exact.damping - 1.0);
    keep_worst(worst.overlap, json.at("largest_overlap").get<double>() / exact.overlap - 1.0);
    keep_worst(worst.undamped, json.at("shortest_undamped_contact_time").get<double>() / exact.undamped_time - 1.0);
    const double ratio = found.shear_stiffness / found.stiffness * (found.mindlin ? 4.0 : 1.0);
    keep_worst(worst.ratio, json.at("stiffness_ratio").get<double>() / ratio - 1.0);
  }
  // The smallest value is found: not more than the one that the restitution was computed with.
  differ.holds("smallest " + request.sought, value <= request.parameter(request.sought) * (1.0 + 0.01));
  keep_worst(worst.reached, json.at("tangential_restitution").get<double>() - drawn.tangential);
  keep_worst(worst.mass, json.at("effective_mass").get<double>() / request.effective_mass() - 1.0);
  keep_worst(worst.mobility, json.at("mobility").get<double>() / request.mobility() - 1.0);
  differ.compare("found", json.at("found").get<std::string>(), request.sought);
  differ.compare("law", json.at("law").get<std::string>(),
                 std::string{request.mindlin ? "hertz" : "linear_spring_dashpot"});
  differ.compare("shear_law", json.at("shear_law").get<std::string>(),
                 std::string{request.mindlin ? "mindlin" : "linear"});
  differ.compare("end_rule", json.at("end_rule").get<std::string>(), calibrated_laws::name_of(request.rule));
  differ.compare("speed", json.at("speed").get<double>(), request.speed);
  differ.holds("angle", std::abs(json.at("angle").get<double>() - request.angle) < 1e-15);
  differ.holds("approach_speed",
               std::abs(json.at("approach_speed").get<double>() / request.approach_speed() - 1.0) < 1e-15);
  for (const std::string& name : {std::string{"friction"}, request.stiffness_name(), std::string{"shear_damping"}})
    if (name != request.sought) differ.compare(name, json.at(name).get<double>(), request.parameter(name));
  differ.compare("units", json.at("units").get<std::string>(), std::string{"SI"});
  differ.holds("error of the step",
               json.at("restitution_error").get<double>() > 0.0 && json.at("restitution_error").get<double>() <= bound);
  // Of spheres with both moduli, Poisson's ratio and the Rayleigh time (case calibrated_laws).
  differ.compare("number of members", json.size(), !request.mindlin ? 27UL : request.discs ? 29UL : 31UL);

  if (!setup.needs("runs") && !setup.needs("printed numbers")) return;
  const std::string printed = program.run({"calibrate"}, options);
  const RunRebound run = run_rebound(program, request, lines_of(printed), json.at("step").get<double>(),
                                     json.at("contact_time").get<double>());
  keep_worst(worst.run_tangential, run.tangential - drawn.tangential);
  keep_worst(worst.run_normal, run.restitution - request.restitution);
  keep_worst(worst.run_spin, (run.spin + signed_spin(setup, json.at("spin").get<double>())) * request.radii.back() *
                                 request.masses.back() / (request.effective_mass() * request.slip_speed()));
  for (const auto& [text, member] : {std::pair{"\n  tangential restitution ", "tangential_restitution"},
                                     {"rotational restitution ", "rotational_restitution"},
                                     {"\n  step ", "step"},
                                     {"\n  effective mass ", "effective_mass"},
                                     {"mobility of the contact ", "mobility"},
                                     {"\n  speed ", "speed"},
                                     {"speed of approach ", "approach_speed"},
                                     {"\n  contact time ", "contact_time"},
                                     {"largest overlap ", "largest_overlap"},
                                     {"tangential over normal stiffness ", "stiffness_ratio"},
                                     {"\n  restitution ", "restitution"},
                                     {"shortest undamped contact time ", "shortest_undamped_contact_time"},
                                     {"spin of body 2 ", "spin"},
                                     {"sticking fraction of the contact time ", "sticking"}}) {
    const double number = json.at(member).get<double>();
    if (number != 0.0) keep_worst(worst.printed, number_after(printed, text) / number - 1.0);
  }
  keep_worst(worst.printed,
             number_after(printed, "angle of the rebound ") * degree / json.at("rebound_angle").get<double>() - 1.0);
  keep_worst(worst.printed, number_after(printed, "step over undamped contact time ") *
                                    json.at("shortest_undamped_contact_time").get<double>() /
                                    json.at("step").get<double>() -
                                1.0);
  for (std::size_t i = 0; i < request.radii.size(); ++i) {
    const std::size_t body = 3 - request.radii.size() + i;  // one alone is body 2
    const std::string text = fmt::format("radius of body {}, {} ", body, request.discs ? "disc" : "sphere");
    keep_worst(worst.printed, number_after(printed, text) / request.radii[i] - 1.0);
  }
  table.rows.push_back({request.mindlin ? "hertz, mindlin" : "linear", request.masses.size() > 1 ? "two" : "wall",
                        request.discs ? "discs" : "spheres", fmt::format("{:.1f}", request.angle / degree),
                        request.sought, fmt::format("{:.5g}", value), fmt::format("{:.4f}", drawn.tangential),
                        fmt::format("{:.6f}", json.at("tangential_restitution").get<double>()),
                        fmt::format("{:.4f}", run.tangential)});
}

/// The rebounds at several angles with given parameters.
void compare_table(const Program& program, const ObliqueRequest& request, Worst& worst, Differences& differ) {
  const Setup& setup = program.setup();
  constexpr std::size_t count = 7;
  constexpr double first = 8.0, last = 71.0;
  const Environment recorded = picture_options::recorded_pictures();
  const Options options =
      joined(options_of(request, {"angle"}),
             {{"--angles", {fmt::format("{} deg", first), fmt::format("{} deg", last), fmt::format("{}", count)}},
              {"--out", {"angles"}},
              {"--format", {"svg"}}});
  const Json json = Json::parse(
      talus_output(program.folder(), with_options({"calibrate"}, joined(options, {{"--json", {}}}), setup), recorded));
  const Json& rows = json.at("angles");
  differ.compare("number of angles", rows.size(), count);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(rows.size(), count); ++i) {
    // The fault takes the last angle for the one before it.
    const std::size_t index = setup.has("last_angle_lost") ? std::min(i, count - 2) : i;
    ObliqueRequest at = request;
    at.angle = (first + (last - first) * static_cast<double>(index) / (count - 1.0)) * degree;
    const ExactRebound exact = exact_of(at);
    keep_worst(worst.table, rows.at(i).at("angle").get<double>() - at.angle);
    keep_worst(worst.table, rows.at(i).at("approach_speed").get<double>() / at.approach_speed() - 1.0);
    compare_rebound(rows.at(i), exact, at, setup, worst);
    shortest = std::min(shortest, exact.undamped_time);
    if (exact.sticking < 0.01) {
      ++worst.sliding_rows;
      const double lost =
          reference::speed_lost_by_gross_sliding(at.friction, at.restitution, at.approach_speed()) / at.slip_speed();
      keep_worst(worst.sliding, (rows.at(i).at("tangential_restitution").get<double>() - (1.0 - lost)) /
                                    (exact.sticking * lost + 3e-5));
    }
  }
  keep_worst(worst.undamped, json.at("shortest_undamped_contact_time").get<double>() / shortest - 1.0);
  const std::string printed = talus_output(program.folder(), with_options({"calibrate"}, options, setup), recorded);
  differ.contains("names of files", printed, "angles/calibration.csv\nangles/calibration.svg\n");
  const records::Csv csv = program.csv("angles/calibration.csv");
  const std::vector<std::string> heads{"angle [deg]",
                                       "approach_speed [m/s]",
                                       "contact_time [s]",
                                       "restitution [1]",
                                       "tangential_restitution [1]",
                                       "rotational_restitution [1]",
                                       "rebound_angle [deg]",
                                       "spin [rad/s]",
                                       "sticking [1]"};
  differ.compare("heads of the table", csv.header(), heads);
  differ.compare("rows of the table", csv.rows(), rows.size());
  if (csv.header() != heads || csv.rows() != rows.size()) return;
  std::vector<std::string> names;
  for (const std::string& head : heads)
    names.push_back(head.substr(0, head.find(' ')));
  const auto unit_of = [&](std::size_t column) { return heads[column].ends_with("[deg]") ? degree : 1.0; };
  const auto value_of = [&](std::size_t row, std::size_t column) {
    return rows.at(row).at(names[column]).get<double>();
  };
  const auto deviation = [](double found, double exact) { return found == exact ? 0.0 : found / exact - 1.0; };
  // The rows of the printed table follow the line of its units.
  std::size_t from = printed.find('\n', printed.find("sticking\n") + 9) + 1;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const char* text = printed.c_str() + from;
    for (std::size_t column = 0; column < heads.size(); ++column) {
      const double value = value_of(row, column);
      keep_worst(worst.csv, deviation(csv.number(row, column) * unit_of(column), value));
      char* end = nullptr;
      keep_worst(worst.printed, 1e-3 * deviation(std::strtod(text, &end) * unit_of(column), value));
      text = end;
    }
    from = printed.find('\n', from) + 1;
  }
  const picture_options::Picture picture = picture_options::read_picture(program.read("angles/calibration.svg"));
  const std::vector<std::size_t> drawn{4, 5, 6, 7};
  differ.compare("drawn panels", picture.panels.size(), drawn.size());
  for (std::size_t i = 0; i < std::min(picture.panels.size(), drawn.size()); ++i) {
    std::string label = names[drawn[i]];
    std::ranges::replace(label, '_', ' ');
    differ.contains("drawn ordinate", picture.panels[i].y_label, label);
    std::size_t row = 0;
    for (const picture_options::Curve& curve : picture.panels[i].curves)
      for (const auto& part : curve.lines)
        for (const picture_options::Point& point : part) {
          if (row == rows.size()) break;
          keep_worst(worst.drawn, deviation(point[0] * degree, value_of(row, 0)));
          keep_worst(worst.drawn, deviation(point[1] * unit_of(drawn[i]), value_of(row, drawn[i])));
          ++row;
        }
    differ.compare("drawn points", row, rows.size());
  }
}

/// A tangential restitution that is not reachable: the limits that the message names. At 70 degrees stiffness does not
/// matter once it is so large that the contact slides throughout.
void compare_reachable(const Program& program, Findings& findings, Differences& differ) {
  const double friction = 0.1, e = 1.0, angle = 70.0;
  const Options options{{"--masses", {"1 g"}},
                        {"--spheres", {"1 cm"}},
                        {"--stiffness", {"1e9 N/m"}},
                        {"--restitution", {fmt::format("{}", e)}},
                        {"--friction", {fmt::format("{}", friction)}},
                        {"--shear-damping", {"0 N s/m"}},
                        {"--angle", {fmt::format("{} deg", angle)}},
                        {"--tangential-restitution", {"0.5"}}};
  const ProgramEnd end = program.end({"calibrate"}, options);
  differ.ended("refusal of a restitution that is not reachable", end, 2, "0.5 is not reachable by shear_stiffness");
  findings.expect("smallest reachable tangential restitution, sliding throughout",
                  number_after(end.messages, "at this angle it must be "),
                  1.0 - friction * (1.0 + e) / std::tan(angle * degree),
                  Tolerance::model(1e-5, "six digits are printed, and the overlap shortens the arm by 2e-5"));
  ObliqueRequest soft;
  soft.rule = EndRule::clamped, soft.restitution = e, soft.masses = {1e-3}, soft.radii = {0.01};
  soft.speed = 1.0, soft.angle = angle * degree, soft.stiffness = 1e9, soft.friction = friction;
  soft.shear_stiffness = 1e-3 * soft.stiffness;
  findings.expect("largest reachable tangential restitution, with a thousandth of the normal stiffness",
                  number_after(end.messages, " to "), exact_of(soft).tangential,
                  Tolerance::model(1e-5, "six digits are printed, and the overlap shortens the arm by 2e-5"));
}

/// Wrong requests, each with a part of its message.
void compare_refusals(const Program& program, Differences& differ) {
  const Options base{{"--masses", {"1 g"}}, {"--stiffness", {"1e6 N/m"}}, {"--restitution", {"0.8"}}};
  const Option sphere{"--spheres", {"1 cm"}}, angle{"--angle", {"10 deg"}}, friction{"--friction", {"0.1"}},
      wanted{"--tangential-restitution", {"0.8"}};
  struct Wrong {
    Options options;
    std::string message;
  };
  const std::vector<Wrong> all{
      {{sphere, friction}, "only oblique impacts use it; give --angle or --angles"},
      {{angle, friction}, "--spheres: it is missing"},
      {{angle, friction, {"--spheres", {"1 cm", "2 cm"}}}, "--spheres: found 2 radii for 1 mass; give one for each"},
      {{angle, friction, {"--discs", {"0 cm"}}}, "--discs: found \"0 cm\"; it must be > 0"},
      {{sphere, friction, {"--angle", {"90 deg"}}}, "--angle: found 90 deg; it must be in (0, 90) deg"},
      {{sphere, friction, {"--angles", {"10 deg", "95 deg", "3"}}},
       "--angles: found 95 deg; it must be in (0, 90) deg"},
      {{sphere, friction, {"--angles", {"10 deg", "5 deg", "3"}}},
       "--angles: found \"10 deg\" and \"5 deg\"; the first"},
      {{sphere, angle}, "--friction: it is missing; give e.g. --friction 0.3"},
      {{sphere, angle, {"--friction", {"-1"}}}, "--friction: found \"-1\"; it must be a number >= 0"},
      {{sphere, angle, friction, {"--shear-stiffness", {"-1 N/m"}}},
       "--shear-stiffness: found \"-1 N/m\"; it must be > 0"},
      {{sphere, angle, friction, {"--shear-modulus", {"1 Pa"}}},
       "--shear-modulus: the friction law 'linear' does not use this option"},
      {{sphere, angle, friction, {"--shear-law", {"mindlin"}}},
       "--shear-law: friction of linear_spring_dashpot 'mindlin' is not known"},
      {{sphere, friction, wanted, {"--angles", {"10 deg", "20 deg", "3"}}}, "--angle: it is missing"},
      {{sphere, angle, friction, {"--tangential-restitution", {"1"}}}, "found 1; it must be in (-1, 1)"},
      {{sphere, angle, friction, wanted, {"--shear-stiffness", {"1 N/m"}}, {"--shear-damping", {"1 N s/m"}}},
       "--shear-damping: found with --tangential-restitution and all other parameters of the friction"},
      {{sphere, angle, friction, {"--out", {"never"}}}, "--out: only the table of several angles is written to files"},
      {{sphere, angle, friction, {"--speeds", {"1 m/s", "2 m/s", "2"}}},
       "--speeds: it gives a range of pairs, and an oblique impact has one pair"},
      {{sphere, angle, friction, {"--offset", {"1 kg m^2", "1 m"}}},
       "--pivot and --offset: the bodies of an oblique impact are free"}};
  for (const Wrong& wrong : all) {
    const ProgramEnd end = program.end({"calibrate"}, joined(base, wrong.options));
    differ.ended("refusal: " + wrong.message, end, 2, wrong.message);
  }
  // A small sphere on a large one, and the large one on it: the overlap of the elastic impact, v sqrt(m/k), is 0.6 of
  // the smaller radius.
  constexpr double mass = 0.01 / 1.01, stiffness = 1e4, radius = 0.01;
  const double speed = 0.6 * radius * std::sqrt(stiffness / mass) / std::cos(std::numbers::pi / 18.0);
  std::vector<std::string> masses{"1 kg", "0.01 kg"}, spheres{"10 cm", fmt::format("{} m", radius)};
  for (const char* const which : {"second", "first"}) {
    const ProgramEnd deep = program.end({"calibrate"}, {{"--masses", masses},
                                                        {"--stiffness", {fmt::format("{} N/m", stiffness)}},
                                                        {"--restitution", {"1"}},
                                                        {"--spheres", spheres},
                                                        {"--speed", {fmt::format("{} m/s", speed)}},
                                                        angle,
                                                        friction});
    differ.ended(fmt::format("refusal: overlap of the smaller sphere, the {} one", which), deep, 2,
                 "the largest overlap would be 0.6 times the radius; it must be at most 0.5");
    std::ranges::reverse(masses), std::ranges::reverse(spheres);
  }
}

void expect_all(Findings& findings, const Worst& worst) {
  const Tolerance model = Tolerance::model(
      1e-4,
      "slip that sticks again is found at the end of a step of the program's simulation, an error of its square; "
      "the overlap shortens the arm by 1e-6");
  const Tolerance again =
      Tolerance::model(4e-4, "3e-4 of the approach speed in impacts that stick again (case mindlin)");
  const Tolerance closed = Tolerance::model(1e-12, "both sides integrate, or evaluate closed forms, to 1e-13");
  findings.expect("tangential restitution by the reference with the found parameter, less the wanted one, largest",
                  worst.found, 0.0, model);
  findings.expect("tangential restitution that the program reaches, less the wanted one, largest", worst.reached, 0.0,
                  Tolerance::truncation(1e-4, 1.0, "the program reports larger jumps as an error"));
  findings.expect("normal restitution, largest error", worst.restitution, 0.0,
                  Tolerance::truncation(1e-5, 1.0, "local errors of 1e-10, and the turn of the normal by 1e-5"));
  findings.expect("tangential restitution, largest error", worst.tangential, 0.0, again);
  findings.expect("rotational restitution, largest error", worst.rotational, 0.0,
                  Tolerance::model(1.4e-3, "as the tangential one, times the mobility"));
  findings.expect("angle of the rebound, largest error", worst.angle, 0.0,
                  Tolerance::model(8e-4, "as the tangential restitution, times at most 1/e"), "rad");
  findings.expect("rim speed of the spin over the slip speed, largest error", worst.spin, 0.0,
                  Tolerance::model(1e-3, "as the tangential restitution, times m r^2/I"));
  findings.expect("sticking fraction of the contact time, largest error", worst.sticking, 0.0,
                  Tolerance::model(0.02,
                                   "the contact is observed at 400 times; near its end, where the force stays near "
                                   "the limit, stick and slip differ by less than the local errors"));
  findings.expect("contact time, largest overlap, dashpot over the exact ones, largest deviation from 1",
                  worst_of({worst.time, worst.overlap, worst.damping, worst.undamped}), 0.0, closed);
  findings.expect("effective mass and mobility over the exact ones, largest deviation from 1",
                  worst_of({worst.mass, worst.mobility}), 0.0, Tolerance::round_off(3e-15, "some ten operations"));
  findings.expect("tangential over normal stiffness, over the exact ratio, largest deviation from 1", worst.ratio, 0.0,
                  Tolerance::model(1e-9, "a difference quotient with 1e-6 of the overlap"));
  findings.expect("tangential restitution of runs with the printed lines, less the wanted one, largest",
                  worst.run_tangential, 0.0, Tolerance::truncation(bound, 1.0, "the requested error"));
  findings.expect("normal restitution of these runs, less the wanted one, largest", worst.run_normal, 0.0,
                  Tolerance::model(0.01, "soft pairs turn their normal by up to a hundredth of a radian"));
  findings.expect("rim speed of the spin of these runs over the slip speed, largest error", worst.run_spin, 0.0,
                  Tolerance::truncation(2.5e-3, 1.0, "the requested error, times m r^2/I"));
  findings.expect("table: angles and speeds, largest deviation", worst.table, 0.0,
                  Tolerance::round_off(1e-14, "a few operations"));
  findings.expect(
      "tangential restitution where the contact sticks for a fraction s < 0.01 of the contact time, less "
      "1 - mu (1 + e)/tan(angle), over that fraction of the loss, largest",
      worst.sliding, 0.0,
      Tolerance::model(1.0,
                       "while it sticks, at the start, the force is between 0 and mu N, and N less than its mean: "
                       "the impulse lacks at most s of itself; and 3e-5 for the overlap"));
  findings.expect("printed numbers over those of JSON, largest deviation from 1", worst.printed, 0.0,
                  Tolerance::model(5.1e-9, "nine digits are printed, six in tables (a thousandth of their deviation)"));
  findings.expect("numbers of calibration.csv over those of JSON, largest deviation from 1", worst.csv, 0.0,
                  Tolerance::round_off(2e-15, "one division and one product"));
  findings.expect("drawn points over those of JSON, largest deviation from 1", worst.drawn, 0.0,
                  Tolerance::model(5.1e-9, "nine digits are written"));
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("calibration");
  const Program program{setup};
  Worst worst;
  Differences differ;
  ImpactDraw draw;
  Table table{
      .name = "calibrations",
      .caption =
          "Parameter that gives a tangential restitution, and the one reached: by the program with a "
          "method that locates events, and by a run of the printed lines with the advised step.",
      .columns = {"contact", "bodies", "shape", "angle [degrees]", "found", "value [SI]", "wanted", "reached", "run"}};
  const std::size_t count = setup.tier == Tier::full ? 48 : setup.coarse ? 6 : 18;
  for (std::size_t number = 0; number < count; ++number) {
    const bool is_shallow = number % 5 != 4;
    const ObliqueRequest request = drawn_request(draw, number, is_shallow ? shallow : draw.decades(1e-5, 2e-3));
    compare_calibration(program, request, is_shallow, worst, differ, table);
    if (setup.needs("table") && is_shallow && number < 12 && request.sought != "shear_damping")
      compare_table(program, request, worst, differ);
  }
  if (setup.needs("reachable")) compare_reachable(program, findings, differ);
  if (setup.needs("outputs that differ")) compare_refusals(program, differ);
  if (!setup.coarse) differ.holds("table rows of contacts that slide nearly throughout", worst.sliding_rows > 0);
  expect_all(findings, worst);
  differ.expect_none(findings, "outputs that differ from the request", "numbers, texts, files and refusals");
  if (!setup.coarse) findings.table(table);
}

}  // namespace

Case definition() {
  const std::string
      found = "tangential restitution by the reference with the found parameter, less the wanted one, largest",
      pasted = "tangential restitution of runs with the printed lines, less the wanted one, largest",
      spin = "rim speed of the spin over the slip speed, largest error",
      sliding =
          "tangential restitution where the contact sticks for a fraction s < 0.01 of the contact time, less "
          "1 - mu (1 + e)/tan(angle), over that fraction of the loss, largest";
  return {.id = "oblique_calibrations",
          .title = "Friction for a tangential restitution, by the program",
          .requirements = {{"G14", {"calibration"}}},
          .main_checks = {found, pasted, spin, sliding},
          .source = "Walton & Braun 1986; Mindlin 1949; Thornton, Cummins & Cleary 2011",
          .faults = {{"other_parameter", "a tenth more of the parameter that is found", found},
                     {"without_end_rule", "end rule not given",
                      "contact time, largest overlap, dashpot over the exact ones, largest deviation from 1"},
                     {"spin_reversed", "spin of a body that rolls backwards", spin},
                     {"last_angle_lost", "the last angle of a table is the one before it",
                      "table: angles and speeds, largest deviation"}},
          .seconds = 25.0,
          .full_seconds = 50.0,
          .run = run};
}

}  // namespace talus::verification::problems::oblique_calibrations
