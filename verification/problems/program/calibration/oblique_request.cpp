#include "verification/problems/program/calibration/oblique_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/record/json_node.hpp"
#include "verification/reference/friction/mindlin_impact.hpp"
#include "verification/reference/friction/oblique_impact.hpp"
#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems::oblique_calibrations {
namespace {

/// Time that the phases spend sticking.
template <class Phases>
double sticking_time(const Phases& phases, double end) {
  double time = 0.0;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double until = i + 1 < phases.size() ? phases[i + 1].begin : end;
    if (phases[i].slips == 0) time += until - phases[i].begin;
  }
  return time;
}

void set_tangential(ExactRebound& exact, const ObliqueRequest& request, double slip_rate, double lost) {
  const double before = request.slip_speed(), after = before - lost;
  exact.tangential = after / before;
  exact.rotational = -slip_rate / before;
  exact.angle = std::atan2(after, exact.restitution * request.approach_speed());
  const double inertia = (request.discs ? 0.5 : 0.4) * request.masses.back() * std::pow(request.radii.back(), 2);
  exact.spin = request.effective_mass() * lost * request.radii.back() / inertia;
}

ExactRebound exact_of_springs(const ObliqueRequest& request) {
  const double m = request.effective_mass(), k = request.stiffness, v = request.approach_speed();
  ExactRebound exact;
  exact.damping = 2.0 * reference::damping_ratio(request.restitution, request.rule) * std::sqrt(k * m);
  const reference::Impact normal{k, exact.damping, m, v};
  const reference::ImpactEvents events = reference::impact_events(normal, request.rule);
  const double pushes = reference::impact_events(normal, EndRule::clamped).contact_time;
  const reference::ObliqueRebound found = reference::rebound(
      {normal, request.shear_stiffness, request.friction, request.mobility(), request.slip_speed()}, request.rule);
  exact.restitution = found.separation / v;
  exact.contact_time = events.contact_time, exact.overlap = events.largest_depth;
  exact.undamped_time = std::numbers::pi * std::sqrt(m / k);
  exact.sticking = sticking_time(found.phases, pushes) / exact.contact_time;
  set_tangential(exact, request, found.slip_rate, found.speed_lost);
  return exact;
}

ExactRebound exact_of_mindlin(const ObliqueRequest& request) {
  const double m = request.effective_mass(), v = request.approach_speed(), radius = request.effective_radius();
  const double factor = 4.0 / 3.0 * request.stiffness * std::sqrt(radius);
  const double length = std::pow(m * v * v / factor, 0.4),
               xi = reference::damping_ratio(request.restitution, request.rule);
  const reference::MindlinRebound found = reference::rebound(
      {6.0 * request.shear_stiffness / request.stiffness, request.friction, request.mobility(), std::sqrt(5.0) * xi,
       request.slip_speed() / v, request.shear_damping * std::pow(length / radius, 0.25) * length / (m * v)});
  const auto events = reference::hertz_events({factor, xi, m, v}, request.rule);
  ExactRebound exact;
  exact.damping = xi * std::sqrt(20.0 / 3.0 * request.stiffness * radius * m);
  exact.restitution = found.separation;
  exact.contact_time = events.contact_time, exact.overlap = events.largest_depth;
  exact.undamped_time = reference::hertz_events({factor, 0.0, m, v}, request.rule).contact_time;
  exact.sticking = sticking_time(found.phases, found.contact_time) / found.contact_time;
  set_tangential(exact, request, found.slip_rate * v, found.speed_lost * v);
  return exact;
}

/// Whether the tangential restitution depends on the parameter, so that it has a calibration; not where the reference
/// finds stick and slip that alternate without end.
bool depends_on(const ObliqueRequest& request, const std::string& name) {
  const double value = request.parameter(name);
  try {
    const double change =
        exact_of(request.with(name, 1.02 * value)).tangential - exact_of(request.with(name, 0.98 * value)).tangential;
    return std::abs(change) > 2e-3;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

double ObliqueRequest::effective_mass() const {
  return masses.size() == 1 ? masses[0] : masses[0] * masses[1] / (masses[0] + masses[1]);
}

double ObliqueRequest::effective_radius() const {
  return radii.size() == 1 ? radii[0] : radii[0] * radii[1] / (radii[0] + radii[1]);
}

double ObliqueRequest::approach_speed() const { return speed * std::cos(angle); }

double ObliqueRequest::slip_speed() const { return speed * std::sin(angle); }

double ObliqueRequest::parameter(const std::string& name) const {
  return name == "friction" ? friction : name == "shear_damping" ? shear_damping : shear_stiffness;
}

ObliqueRequest ObliqueRequest::with(const std::string& name, double value) const {
  ObliqueRequest changed = *this;
  (name == "friction"        ? changed.friction
   : name == "shear_damping" ? changed.shear_damping
                             : changed.shear_stiffness) = value;
  return changed;
}

ExactRebound exact_of(const ObliqueRequest& request) {
  return request.mindlin ? exact_of_mindlin(request) : exact_of_springs(request);
}

ObliqueRequest drawn_request(ImpactDraw& draw, std::size_t number, double depth) {
  ObliqueRequest made;
  made.mindlin = number % 2 == 1;
  const std::size_t sought = number / 2 % 3;
  for (;;) {
    made.rule = !made.mindlin && draw.between(0.0, 1.0) < 0.5 ? EndRule::attractive : EndRule::clamped;
    made.restitution = draw.between(0.5, 0.98), made.speed = draw.decades(0.05, 20.0);
    // The reference has no friction with a dashpot that sticks again after slip: such contacts slip at their end only.
    const bool has_dashpot = made.mindlin && sought == 2;
    made.angle = draw.between(3.0, has_dashpot ? 25.0 : 70.0) * std::numbers::pi / 180.0;
    made.discs = draw.between(0.0, 1.0) < 0.5;
    made.masses = {draw.decades(1e-6, 1e2)}, made.radii = {draw.decades(1e-3, 1.0)};
    if (draw.between(0.0, 1.0) < 0.5)
      made.masses.push_back(draw.decades(1e-6, 1e2)), made.radii.push_back(draw.decades(1e-3, 1.0));
    const double radius = made.effective_radius(), m = made.effective_mass(), v = made.approach_speed();
    made.stiffness = made.mindlin ? 0.75 * m * v * v / (radius * radius * radius * std::pow(depth, 2.5))
                                  : m * v * v / std::pow(depth * radius, 2);
    made.friction = has_dashpot ? draw.between(1.0, 2.0) : draw.between(0.05, 0.6);
    made.shear_stiffness = made.stiffness * (made.mindlin ? draw.between(0.1, 0.4) : draw.between(0.1, 1.2));
    const double length = depth * radius;
    made.shear_damping = has_dashpot ? draw.between(0.05, 0.5) * m * v / length * std::pow(depth, -0.25) : 0.0;
    made.sought = sought == 0 ? "friction" : sought == 1 || !made.mindlin ? made.stiffness_name() : "shear_damping";
    if (depends_on(made, made.sought)) return made;
  }
}

Options options_of(const ObliqueRequest& request, const std::vector<std::string>& absent) {
  Options options{{"--law", {request.mindlin ? "hertz" : "linear_spring_dashpot"}},
                  {"--shear-law", {request.mindlin ? "mindlin" : "linear"}},
                  {request.mindlin ? "--modulus" : "--stiffness",
                   {fmt::format("{} {}", request.stiffness, request.mindlin ? "Pa" : "N/m")}},
                  {"--end-rule", {calibrated_laws::name_of(request.rule)}},
                  {"--restitution", {fmt::format("{}", request.restitution)}},
                  {"--speed", {fmt::format("{} m/s", request.speed)}}};
  Option masses{"--masses", {}}, radii{request.discs ? "--discs" : "--spheres", {}};
  for (std::size_t i = 0; i < request.masses.size(); ++i) {
    masses.second.push_back(fmt::format("{} kg", request.masses[i]));
    radii.second.push_back(fmt::format("{} m", request.radii[i]));
  }
  options.insert(options.end(), {masses, radii});
  const auto add = [&](const std::string& name, const std::string& option, const std::string& value) {
    if (std::ranges::find(absent, name) == absent.end()) options.push_back({option, {value}});
  };
  add("angle", "--angle", fmt::format("{} rad", request.angle));
  add("friction", "--friction", fmt::format("{}", request.friction));
  add(request.stiffness_name(), request.mindlin ? "--shear-modulus" : "--shear-stiffness",
      fmt::format("{} {}", request.shear_stiffness, request.mindlin ? "Pa" : "N/m"));
  add("shear_damping", "--shear-damping", fmt::format("{} N s/m", request.shear_damping));
  return options;
}

RunRebound run_rebound(const Program& program, const ObliqueRequest& request, const std::string& lines, double step,
                       double contact_time) {
  const double lead = 3.3 * step, v = request.approach_speed(), u = request.slip_speed();
  const auto body = [&](const char* name, std::size_t i, double x, double y, double vx, double vy) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"free\"\nmass = \"{} kg\"\ninertia = \"{} kg m^2\"\nshape = {{ kind = "
        "\"circle\", radius = \"{} m\" }}\nposition = [\"{} m\", \"{} m\"]\nvelocity = [\"{} m/s\", \"{} m/s\"]\n",
        name, request.masses[i], (request.discs ? 0.5 : 0.4) * request.masses[i] * std::pow(request.radii[i], 2),
        request.radii[i], x, y, vx, vy);
  };
  std::string scene = "units = \"SI\"\n";
  scene += request.masses.size() > 1 ? body("one", 0, 0.0, -request.radii[0], 0.0, 0.0)
                                     : "[[body]]\nname = \"one\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 "
                                       "m\"]\nshape = { kind = \"half_plane\" }\n";
  scene += body("two", request.masses.size() - 1, -lead * u, request.radii.back() + lead * v, u, -v);
  scene += "[[contact]]\nname = \"hit\"\nbetween = [\"one\", \"two\"]\n";
  scene += lines + fmt::format(
                       "[run]\nintegrator = \"velocity_verlet\"\nstep = \"{0} s\"\nend = \"{1} s\"\ninterval = "
                       "\"{1} s\"\nwatch = \"off\"\n",
                       step, 1.1 * contact_time + 8.0 * step);
  program.write("pasted.toml", scene);
  const records::Json bodies = program.json({"run", "pasted.toml"}, {{"--json", {}}}).at("bodies");
  const auto velocity = [&](std::size_t which, std::size_t axis) {
    return bodies.at(which).at("velocity").at(axis).get<double>();
  };
  const bool is_pair = request.masses.size() > 1;
  const std::size_t two = 1;
  return {(velocity(two, 1) - (is_pair ? velocity(0, 1) : 0.0)) / v,
          (velocity(two, 0) - (is_pair ? velocity(0, 0) : 0.0)) / u, bodies.at(two).at("spin").get<double>()};
}

}  // namespace talus::verification::problems::oblique_calibrations
