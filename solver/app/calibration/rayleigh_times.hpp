#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/calibrate/oblique_impact.hpp"
#include "solver/calibrate/rayleigh_time.hpp"
#include "solver/laws/law_list.hpp"

namespace talus::app {

/// A sphere of a contact, in SI units.
struct Sphere {
  double density{};
  double radius{};
};
/// Spheres of these masses and radii.
[[nodiscard]] std::vector<Sphere> spheres_of(std::span<const RoundBody> bodies);

/// Shortest Rayleigh time of spheres of one material, in SI units.
struct RayleighTime {
  std::optional<Material> material;  ///< none: no material has these moduli
  double shortest{};                 ///< if there is a material
};

/// Poisson's ratio of --poisson-ratio, if it is given, for contacts with or without spheres. Errors: InputError if it
/// is not in [0, 0.5], or is given without spheres.
[[nodiscard]] std::optional<double> poisson_ratio_of(const CalibrateOptions& options, bool has_spheres);

/// The Rayleigh time of the spheres of a contact with this law; the material follows from --poisson-ratio, or from the
/// moduli of hertz and mindlin. None without spheres or if Poisson's ratio is unknown. Errors: as poisson_ratio_of().
[[nodiscard]] std::optional<RayleighTime> rayleigh_time(const CalibrateOptions& options, const ContactLaw& law,
                                                        const FrictionLaw& friction, std::span<const Sphere> spheres);

/// Adds `poisson_ratio` and `rayleigh_time` [s], or null for both without a material.
void add_rayleigh_time(nlohmann::ordered_json& json, const std::optional<RayleighTime>& known);

/// Prints lines with Poisson's ratio, the Rayleigh time, and the step [s], if it is known, as a fraction of it.
void print_rayleigh_time(const std::optional<RayleighTime>& known, std::optional<double> step, const ValueLines& line);

/// The error of --pivot or --offset with --spheres.
inline constexpr const char* spheres_are_central =
    "--pivot and --offset: spheres are hit centrally; remove them, or give --radius";

}  // namespace talus::app
