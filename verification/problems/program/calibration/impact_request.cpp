#include "verification/problems/program/calibration/impact_request.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/reference/impacts/power_law_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems::calibrated_laws {
namespace {

using reference::EndRule;

constexpr std::array laws{"linear_spring_dashpot", "hertz", "constant hertz", "hunt_crossley"};

/// A dashpot with which contacts that may pull do not end; e falls to 0 at g = 1.13.
constexpr double never_ends = 1.2;

/// Restitution of Hertz's law with the constant dashpot; 0 if the contact does not end.
double constant_dashpot_restitution(double g, EndRule rule) {
  if (rule == EndRule::attractive && g > never_ends) return 0.0;  // the reference would integrate for long
  try {
    return reference::constant_dashpot_events(g, rule).restitution;
  } catch (const std::invalid_argument&) {
    return 0.0;
  }
}

}  // namespace

double ImpactRequest::effective_mass() const {
  if (masses.size() == 1) return masses[0];
  // An impulse J at the arm a gives a free body the speed J/m + a (a J/I) there, one on a pin a (a J/I).
  const double second = lever == Lever::none     ? masses[1]
                        : lever == Lever::offset ? masses[1] / (1.0 + 1.0 / inertia_ratio)
                                                 : masses[1] * inertia_ratio;
  return masses[0] * second / (masses[0] + second);
}

std::pair<double, double> ImpactRequest::spring() const {
  if (is_hertz()) return {4.0 / 3.0 * stiffness * std::sqrt(radius), 1.5};
  if (is_hunt_crossley()) return {stiffness * std::pow(radius, 1.0 - exponent), exponent};
  return {stiffness, 1.0};
}

double ImpactRequest::length() const {
  const auto [factor, n] = spring();
  return std::pow(effective_mass() * speed * speed / factor, 1.0 / (n + 1.0));
}

double ImpactDraw::between(double low, double high) {
  return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
}

double ImpactDraw::decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

ImpactRequest ImpactDraw::request(std::size_t number) {
  ImpactRequest made;
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

ImpactRequest with_lever(ImpactRequest request, std::size_t number) {
  if (request.masses.size() == 1 || number % 3 == 0) return request;
  request.lever = number % 3 == 1 ? Lever::offset : Lever::pin;
  request.inertia_ratio = 0.3 + 0.4 * static_cast<double>(number % 7);
  return request;
}

std::string name_of(EndRule rule) { return rule == EndRule::clamped ? "clamped" : "attractive"; }

Options law_options(const ImpactRequest& request) {
  Options options{{"--law", {request.law}}};
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
    options.push_back({"--end-rule", {name_of(request.rule)}});
  }
  return options;
}

Options options_of(const ImpactRequest& request, double bound) {
  Options options = law_options(request);
  options.push_back({"--speed", {fmt::format("{} m/s", request.speed)}});
  options.push_back({"--bound", {fmt::format("{}", bound)}});
  std::vector<std::string> masses;
  for (const double mass : request.masses)
    masses.push_back(fmt::format("{} kg", mass));
  options.push_back({"--masses", masses});
  if (request.lever != Lever::none)
    options.push_back({request.lever == Lever::pin ? "--pivot" : "--offset",
                       {fmt::format("{} kg m^2", request.inertia()), fmt::format("{} m", request.arm())}});
  return options;
}

ExactImpact exact_of(const ImpactRequest& request) {
  const double m = request.effective_mass(), v = request.speed, e = request.restitution;
  const auto [factor, n] = request.spring();
  const double length = request.length();
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
  // Bisection: e falls with g.
  double low = 0.0, high = request.rule == EndRule::clamped ? 8.0 : never_ends;
  for (int pass = 0; pass < 50; ++pass) {
    const double g = 0.5 * (low + high);
    (constant_dashpot_restitution(g, request.rule) > e ? low : high) = g;
  }
  const auto events = reference::constant_dashpot_events(low, request.rule);
  return {low * m * v / length, events.contact_time * length / v, events.largest_depth * length};
}

double undamped_time(const ImpactRequest& request) {
  const double m = request.effective_mass(), v = request.speed;
  const auto [factor, n] = request.spring();
  if (request.is_hunt_crossley()) return reference::hunt_crossley_events(0.0, n).contact_time * request.length() / v;
  if (request.is_hertz()) return reference::hertz_events({factor, 0.0, m, v}, request.rule).contact_time;
  return reference::impact_events({factor, 0.0, m, v}, request.rule).contact_time;
}

double restitution_with(const ImpactRequest& request, double damping) {
  const double m = request.effective_mass(), v = request.speed, c = damping;
  if (request.is_hunt_crossley()) return reference::hunt_crossley_restitution(c * v);
  if (request.constant) return constant_dashpot_restitution(c * request.length() / (m * v), request.rule);
  const double critical = request.is_hertz() ? std::sqrt(20.0 / 3.0 * request.stiffness * request.radius * m)
                                             : 2.0 * std::sqrt(request.stiffness * m);
  return reference::restitution(c / critical, request.rule);
}

double separation_of_run(const Program& program, const std::string& file, double arm, Options options) {
  options.push_back({"--json", {}});
  const records::Json state = program.json({"run", file}, options);
  // Velocity of a body along the line of impact; body 2 turns about a point below it.
  const auto velocity = [&](std::size_t which) {
    const records::Json& body = state.at("bodies").at(which);
    return body.at("velocity").at(0).get<double>() - (which == 1 ? body.at("spin").get<double>() * arm : 0.0);
  };
  return velocity(1) - velocity(0);
}

double restitution_of_run(const Program& program, const ImpactRequest& request, const std::string& lines, double step,
                          const ExactImpact& exact) {
  const double radius = 300.0 * exact.overlap, gap = 3.3 * step * request.speed;
  const auto body = [&](const char* which, double mass, double x, double speed) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"{} kg\"\nshape = {{ kind = \"circle\", radius = "
        "\"{} m\" }}\nposition = [\"{} m\", \"0 m\"]\nvelocity = [\"{} m/s\", \"0 m/s\"]\n",
        which, mass, radius, x, speed);
  };
  // A thin plate of which the left side is hit above the centre.
  const double thickness = radius;
  const auto plate = [&] {
    const bool is_pinned = request.lever == Lever::pin;
    return fmt::format(
        "[[body]]\nname = \"b\"\nmobility = \"{}\"\nmass = \"{} kg\"\ninertia = \"{} kg m^2\"\nshape = {{ kind = "
        "\"rectangle\", half_width = \"{} m\", half_height = \"{} m\" }}\nposition = [\"{} m\", \"{} m\"]\n{}",
        is_pinned ? "pinned" : "free", request.masses[1], request.inertia(), thickness, 2.0 * request.arm(), thickness,
        -request.arm(), is_pinned ? "pin = [\"0 m\", \"0 m\"]\n" : "");
  };
  std::string scene = "units = \"SI\"\n" + body("a", request.masses[0], -radius - gap, request.speed);
  scene += request.lever != Lever::none ? plate()
           : request.masses.size() > 1
               ? body("b", request.masses[1], radius, 0.0)
               : "[[body]]\nname = \"b\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle "
                 "= \"90 deg\"\nshape = { kind = \"half_plane\" }\n";
  scene += "[[contact]]\nname = \"hit\"\nbetween = [\"a\", \"b\"]\n";
  scene += lines + fmt::format(
                       "[run]\nintegrator = \"velocity_verlet\"\nstep = \"{0} s\"\nend = \"{1} s\"\ninterval = "
                       "\"{1} s\"\nwatch = \"off\"\n",
                       step, 1.3 * exact.time + 8.0 * step);
  program.write("pasted.toml", scene);
  return separation_of_run(program, "pasted.toml", request.lever == Lever::none ? 0.0 : request.arm()) / request.speed;
}

}  // namespace talus::verification::problems::calibrated_laws
