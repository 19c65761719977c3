#include "solver/app/calibration/impact_bodies.hpp"

#include <fmt/format.h>

#include <optional>

#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {
namespace {

/// The bodies of an impact, in SI units. Body 1 is fixed if it is empty.
struct ImpactBodies {
  std::optional<ContactSide> first;
  ContactSide second;
};

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

/// Effective mass of one body that hits a fixed one: twice that against its own mirror image.
double against_a_fixed_body(const ContactSide& side) { return 2.0 * effective_mass(side, side); }

}  // namespace

double effective_mass_of(const CalibrateOptions& options) {
  const ImpactBodies bodies = bodies_of(options);
  return bodies.first ? effective_mass(*bodies.first, bodies.second) : against_a_fixed_body(bodies.second);
}

std::string bodies_text(const CalibrateOptions& options, const UnitSystem& units) {
  const ImpactBodies bodies = bodies_of(options);
  const auto line = [&units](std::string_view body, const ContactSide& side, std::string_view formula) {
    return fmt::format("  {:<32}{:>16.9g} {}: {}\n", body, against_a_fixed_body(side) / si_size(units, dimension::mass),
                       symbol(units, dimension::mass), formula);
  };
  const std::string_view central = "its mass";
  std::string text = bodies.first ? line("body 1, free, hit centrally", *bodies.first, central) : "  body 1, fixed\n";
  if (bodies.second.pinned)
    return text + line("body 2, on a fixed pin", bodies.second, "inertia/arm^2, whatever its mass");
  if (bodies.second.inertia)
    return text + line("body 2, free, hit off centre", bodies.second, "1/(1/mass + arm^2/inertia)");
  return text + line("body 2, free, hit centrally", bodies.second, central);
}

}  // namespace talus::app
