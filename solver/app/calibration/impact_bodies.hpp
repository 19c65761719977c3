#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/base/units.hpp"
#include "solver/calibrate/oblique_impact.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {

/// The bodies of an impact, in SI units. Body 1 is fixed if it is empty.
struct ImpactBodies {
  std::optional<ContactSide> first;
  ContactSide second;
};

/// The bodies of --masses, --pivot and --offset, of which there is at least one mass. Errors: InputError naming the
/// option.
[[nodiscard]] ImpactBodies bodies_of(const CalibrateOptions& options);

/// Effective mass of an impact of two bodies along the line of impact [kg], from --masses, --pivot and --offset.
/// Body 2 is the last of --masses, to which --pivot or --offset applies; with one mass it is the only moving one, and
/// body 1 is fixed. Errors: InputError naming the option.
[[nodiscard]] double effective_mass_of(const CalibrateOptions& options);

/// Lines of text that give each body its role in the impact and its effective mass, in these units. Errors: as above.
[[nodiscard]] std::string bodies_text(const CalibrateOptions& options, const UnitSystem& units);

/// Whether the options give radii of the bodies: --spheres or --discs.
[[nodiscard]] bool gives_round_bodies(const CalibrateOptions& options);

/// The bodies of --masses with the radii of --spheres or --discs, in SI units. Errors: InputError naming the option:
/// radii or masses are missing, or their numbers differ.
[[nodiscard]] std::vector<RoundBody> round_bodies(const CalibrateOptions& options);

/// R [L] of two bodies, or of one and a plane: 1/R is the sum of their curvatures.
[[nodiscard]] double effective_radius(std::span<const RoundBody> bodies);

}  // namespace talus::app
