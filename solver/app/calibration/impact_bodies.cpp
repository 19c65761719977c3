#include "solver/app/calibration/impact_bodies.hpp"

#include <fmt/format.h>

#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace {

/// Effective mass of one body that hits a fixed one: twice that against its own mirror image.
double against_a_fixed_body(const ContactSide& side) { return 2.0 * effective_mass(side, side); }

}  // namespace

ImpactBodies bodies_of(const CalibrateOptions& options) {
  const auto mass = [&](const std::string& text) {
    return ContactSide{option_quantity("--masses", text, dimension::mass, si), {}, 0.0, false};
  };
  ImpactBodies bodies{.first = {}, .second = mass(options.masses.back())};
  if (options.masses.size() == 2) bodies.first = mass(options.masses.front());
  const bool pinned = !options.pivot.empty();
  const std::vector<std::string>& turning = pinned ? options.pivot : options.offset;
  if (!turning.empty()) {
    const std::string option = pinned ? "--pivot" : "--offset";
    bodies.second.inertia = option_quantity(option, turning[0], dimension::inertia, si);
    bodies.second.arm = option_quantity(option, turning[1], dimension::length, si);
    bodies.second.pinned = pinned;
  }
  return bodies;
}

double effective_mass_of(const CalibrateOptions& options) {
  const ImpactBodies bodies = bodies_of(options);
  return bodies.first ? effective_mass(*bodies.first, bodies.second) : against_a_fixed_body(bodies.second);
}

std::string bodies_text(const CalibrateOptions& options, const UnitSystem& units) {
  const ImpactBodies bodies = bodies_of(options);
  const auto line = [&units](std::string_view body, const ContactSide& side, std::string_view formula) {
    const double mass = against_a_fixed_body(side) / si_size(units, dimension::mass);
    return fmt::format("{}: {}\n", value_line(32, body, mass, symbol(units, dimension::mass)), formula);
  };
  const std::string_view central = "its mass";
  std::string text = bodies.first ? line("body 1, free, hit centrally", *bodies.first, central) : "  body 1, fixed\n";
  if (bodies.second.pinned)
    return text + line("body 2, on a fixed pin", bodies.second, "inertia/arm^2, whatever its mass");
  if (bodies.second.inertia)
    return text + line("body 2, free, hit off centre", bodies.second, "1/(1/mass + arm^2/inertia)");
  return text + line("body 2, free, hit centrally", bodies.second, central);
}

bool gives_round_bodies(const CalibrateOptions& options) { return !options.spheres.empty() || !options.discs.empty(); }

std::vector<RoundBody> round_bodies(const CalibrateOptions& options) {
  const bool are_discs = !options.discs.empty();
  const std::string option = are_discs ? "--discs" : "--spheres";
  const std::vector<std::string>& radii = are_discs ? options.discs : options.spheres;
  if (radii.empty()) {
    throw InputError{"--spheres: it is missing; give the radius of each body, e.g. --spheres \"1 cm\", or --discs"};
  }
  demand_masses(options);
  if (radii.size() != options.masses.size()) {
    throw InputError{fmt::format("{}: found {} radi{} for {} mass{}; give one for each", option, radii.size(),
                                 radii.size() == 1 ? "us" : "i", options.masses.size(),
                                 options.masses.size() == 1 ? "" : "es")};
  }
  std::vector<RoundBody> bodies;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    RoundBody body{.mass = option_quantity("--masses", options.masses[i], dimension::mass, si),
                   .radius = option_quantity(option, radii[i], dimension::length, si)};
    body.inertia = (are_discs ? 0.5 : 0.4) * body.mass * body.radius * body.radius;
    bodies.push_back(body);
  }
  return bodies;
}

double effective_radius(std::span<const RoundBody> bodies) {
  double curvature = 0.0;
  for (auto body = bodies.rbegin(); body != bodies.rend(); ++body)
    curvature += 1.0 / body->radius;
  return 1.0 / curvature;
}

}  // namespace talus::app
