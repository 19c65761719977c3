#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/hertz_impact.hpp"
#include "verification/reference/power_law_impact.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/expectations.hpp"
#include "verification/study/program_options.hpp"
#include "verification/study/program_run.hpp"

namespace talus::verification::problems::calibrated_laws {
namespace {

using records::Json;
using reference::EndRule;

constexpr double bound = 1e-3;
constexpr std::array laws{"linear_spring_dashpot", "hertz", "constant hertz", "hunt_crossley"};

/// A request to `talus calibrate`, drawn at random; SI units.
struct Request {
  std::string law;
  bool constant{};  ///< the dashpot of hertz
  EndRule rule{};
  double restitution{}, speed{};
  std::vector<double> masses;
  double stiffness{};           ///< or modulus
  double radius{}, exponent{};  ///< or reference overlap

  [[nodiscard]] bool is_hertz() const { return law == "hertz"; }
  [[nodiscard]] bool is_hunt_crossley() const { return law == "hunt_crossley"; }
  [[nodiscard]] bool varies() const { return constant || is_hunt_crossley(); }
  [[nodiscard]] double effective_mass() const {
    return masses.size() == 1 ? masses[0] : masses[0] * masses[1] / (masses[0] + masses[1]);
  }
  /// K of the force K x^n, and n.
  [[nodiscard]] std::pair<double, double> spring() const {
    if (is_hertz()) return {4.0 / 3.0 * stiffness * std::sqrt(radius), 1.5};
    if (is_hunt_crossley()) return {stiffness * std::pow(radius, 1.0 - exponent), exponent};
    return {stiffness, 1.0};
  }
};

/// Requests from a fixed seed. The numbers of a standard engine are the same everywhere; those of its distributions are
/// not, so that the bits are scaled here.
class Draw {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  double decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  Request request(std::size_t number) {
    Request made;
    made.law = laws.at(number % laws.size());
    made.constant = made.law == "constant hertz";
    if (made.constant) made.law = "hertz";
    made.rule = between(0.0, 1.0) < 0.5 ? EndRule::clamped : EndRule::attractive;
    made.restitution = between(0.2, 0.95), made.speed = decades(0.05, 20.0);
    made.masses = {decades(1e-3, 1e3)};
    if (between(0.0, 1.0) < 0.5) made.masses.push_back(decades(1e-3, 1e3));
    made.radius = decades(1e-3, 1.0);
    made.stiffness = made.is_hertz() ? decades(1e6, 1e11) : decades(1e3, 1e8);
    made.exponent = std::array{1.0, 1.5, 2.0}.at(static_cast<std::size_t>(between(0.0, 3.0)));
    return made;
  }

 private:
  std::mt19937_64 engine_{20261126};
};

std::string name(EndRule rule) { return rule == EndRule::clamped ? "clamped" : "attractive"; }

/// The options of a request without its restitution.
Options options_of(const Request& request) {
  Options options{{"--law", {request.law}},
                  {"--speed", {fmt::format("{} m/s", request.speed)}},
                  {"--bound", {fmt::format("{}", bound)}}};
  std::vector<std::string> masses;
  for (const double mass : request.masses)
    masses.push_back(fmt::format("{} kg", mass));
  options.push_back({"--masses", masses});
  if (request.is_hertz()) {
    options.push_back({"--modulus", {fmt::format("{} Pa", request.stiffness)}});
    options.push_back({"--radius", {fmt::format("{} m", request.radius)}});
    options.push_back({"--dashpot", {request.constant ? "constant" : "tsuji"}});
  } else {
    options.push_back({"--stiffness", {fmt::format("{} N/m", request.stiffness)}});
  }
  if (request.is_hunt_crossley()) {
    options.push_back({"--reference-overlap", {fmt::format("{} m", request.radius)}});
    options.push_back({"--exponent", {fmt::format("{}", request.exponent)}});
  } else {
    options.push_back({"--end-rule", {name(request.rule)}});
  }
  return options;
}

/// The dashpot for a restitution, contact time and largest overlap, by the references.
struct Exact {
  double damping{}, time{}, overlap{};
};
Exact exact_of(const Request& request) {
  const double m = request.effective_mass(), v = request.speed, e = request.restitution;
  const auto [factor, n] = request.spring();
  const double length = std::pow(m * v * v / factor, 1.0 / (n + 1.0));
  if (request.is_hunt_crossley()) {
    const double a = reference::hunt_crossley_number(e);
    const auto events = reference::hunt_crossley_events(a, n);
    return {a / v, events.contact_time * length / v, events.largest_depth * length};
  }
  const double xi = reference::damping_ratio(e, request.rule);
  if (!request.is_hertz()) {
    const double c = 2.0 * xi * std::sqrt(factor * m);
    const auto events = reference::impact_events({factor, c, m, v}, request.rule);
    return {c, events.contact_time, events.largest_depth};
  }
  if (!request.constant) {
    const auto events = reference::hertz_events({factor, xi, m, v}, request.rule);
    return {xi * std::sqrt(20.0 / 3.0 * request.stiffness * request.radius * m), events.contact_time,
            events.largest_depth};
  }
  // Bisection: e falls with g, for contacts that may pull to 0 at g = 1.13.
  double low = 0.0, high = request.rule == EndRule::clamped ? 8.0 : 1.2;
  for (int pass = 0; pass < 50; ++pass) {
    const double g = 0.5 * (low + high);
    bool is_above = false;
    try {
      is_above = reference::constant_dashpot_events(g, request.rule).restitution > e;
    } catch (const std::invalid_argument&) {  // the contact does not end
    }
    (is_above ? low : high) = g;
  }
  const auto events = reference::constant_dashpot_events(low, request.rule);
  return {low * m * v / length, events.contact_time * length / v, events.largest_depth * length};
}

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

/// Restitution of a run of two bodies, or of one and a wall, with these lines.
double restitution_of_run(const Program& program, const Request& request, const std::string& lines, double step,
                          const Exact& exact) {
  const double radius = 300.0 * exact.overlap, gap = 3.3 * step * request.speed;
  const auto body = [&](const char* which, double mass, double x, double speed) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"{} kg\"\nshape = {{ kind = \"circle\", radius = "
        "\"{} m\" }}\nposition = [\"{} m\", \"0 m\"]\nvelocity = [\"{} m/s\", \"0 m/s\"]\n",
        which, mass, radius, x, speed);
  };
  std::string scene = "units = \"SI\"\n" + body("a", request.masses[0], -radius - gap, request.speed);
  scene += request.masses.size() > 1
               ? body("b", request.masses[1], radius, 0.0)
               : "[[body]]\nname = \"b\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle "
                 "= \"90 deg\"\nshape = { kind = \"half_plane\" }\n";
  scene += "[[contact]]\nname = \"hit\"\nbetween = [\"a\", \"b\"]\n";
  if (lines.find("law = ") == std::string::npos) scene += "law = \"linear_spring_dashpot\"\n";
  scene += lines + fmt::format(
                       "[run]\nintegrator = \"velocity_verlet\"\nstep = \"{0} s\"\nend = \"{1} s\"\ninterval = "
                       "\"{1} s\"\nwatch = \"off\"\n",
                       step, 1.3 * exact.time + 8.0 * step);
  program.write("pasted.toml", scene);
  const Json state = program.json({"run", "pasted.toml"}, {{"--json", {}}});
  const auto velocity = [&](std::size_t which) {
    return state.at("bodies").at(which).at("velocity").at(0).get<double>();
  };
  return ((request.masses.size() > 1 ? velocity(1) : 0.0) - velocity(0)) / request.speed;
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("calibration");
  const Program program{setup};
  Differences differ;
  Draw draw;
  double damping = 0.0, time = 0.0, overlap = 0.0, reverse = 0.0, pasted = 0.0;
  const std::size_t count = setup.tier == Tier::full ? 200 : setup.coarse ? 8 : 20;
  for (std::size_t number = 0; number < count; ++number) {
    const Request request = draw.request(number);
    const Exact exact = exact_of(request);
    const std::string parameter = request.is_hunt_crossley() ? "hysteresis" : "damping";
    const Options common = options_of(request);
    const auto with = [&common](Options more) {
      more.insert(more.end(), common.begin(), common.end());
      return more;
    };
    const Option wanted{"--restitution", {fmt::format("{}", request.restitution)}};
    const Json found = program.json({"calibrate"}, with({wanted, {"--json", {}}}));
    keep_worst(damping, found.at(parameter).get<double>() / exact.damping - 1.0);
    keep_worst(time, found.at("contact_time").get<double>() / exact.time - 1.0);
    keep_worst(overlap, found.at("largest_overlap").get<double>() / exact.overlap - 1.0);

    const std::string unit = request.is_hunt_crossley() ? "s/m" : "N s/m";
    const Json back = program.json(
        {"calibrate"}, with({{"--" + parameter, {fmt::format("{} {}", exact.damping, unit)}}, {"--json", {}}}));
    keep_worst(reverse, back.at("exact_restitution").get<double>() - request.restitution);

    const std::string printed = program.run({"calibrate"}, with({wanted}));
    const std::string lines = lines_of(printed, parameter, number % 8 > 3);
    keep_worst(pasted, restitution_of_run(program, request, lines, found.at("step").get<double>(), exact) -
                           request.restitution);

    differ.compare("law", found.at("law").get<std::string>(), request.law);
    differ.compare("speed", found.at("speed").get<double>(), request.speed);
    differ.compare("exact_restitution", found.at("exact_restitution").get<double>(), request.restitution);
    differ.compare("units", found.at("units").get<std::string>(), std::string{"SI"});
    differ.compare("effective_mass",
                   std::abs(found.at("effective_mass").get<double>() / request.effective_mass() - 1.0) < 1e-15, true);
    differ.compare(
        "simulated restitution and its error",
        std::abs(found.at("restitution").get<double>() - request.restitution) <= found.at("restitution_error") &&
            found.at("restitution_error") <= bound,
        true);
    std::size_t members = 11;
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
      differ.compare("end_rule", found.at("end_rule").get<std::string>(), name(request.rule));
      members += 2;  // and the damping ratio
      if (!request.constant)
        differ.compare("damping_ratio",
                       std::abs(found.at("damping_ratio").get<double>() /
                                    reference::damping_ratio(request.restitution, request.rule) -
                                1.0) < 1e-12,
                       true);
    }
    differ.compare("number of members", found.size(), members);
  }
  const Tolerance integrated = Tolerance::model(1e-13, "both sides integrate to 1e-14");
  findings.expect(
      "damping over the exact one, largest deviation from 1", damping, 0.0,
      Tolerance::model(4e-13, "1e-14 in e on both sides, of which a weak dashpot takes 1/ln(1/e) = 20 times"));
  findings.expect("contact time over the exact one, largest deviation from 1", time, 0.0, integrated);
  findings.expect("largest overlap over the exact one, largest deviation from 1", overlap, 0.0, integrated);
  findings.expect("restitution of a given damping, largest error", reverse, 0.0, integrated);
  findings.expect("restitution of runs with the printed lines, largest error", pasted, 0.0,
                  Tolerance::truncation(bound, 1.0, "the requested error with the advised step"));
  differ.expect_none(findings, "members of the output that differ from the request", "numbers and texts");
}

}  // namespace

Case definition() {
  const std::string pasted = "restitution of runs with the printed lines, largest error",
                    damping = "damping over the exact one, largest deviation from 1",
                    members = "members of the output that differ from the request";
  return {.id = "calibrated_laws",
          .title = "Damping of Hertz and Hunt-Crossley contacts by the program",
          .requirements = {{"G3", {"calibration"}}},
          .main_checks = {pasted, damping, members},
          .source = "Hunt & Crossley 1975; Tsuji, Tanaka & Ishida 1992; Schwager & Poeschel 2007",
          .faults = {{"without_speed", "speed of approach not given", damping},
                     {"without_dashpot", "dashpot not given", damping},
                     {"without_end_rule", "end rule not given", damping}},
          .seconds = 6.0,
          .full_seconds = 30.0,
          .run = run};
}

}  // namespace talus::verification::problems::calibrated_laws
