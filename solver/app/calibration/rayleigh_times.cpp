#include "solver/app/calibration/rayleigh_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "solver/app/calibration/friction_options.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace {

/// A parameter of a law; none if the law does not have it.
std::optional<double> value_of(const std::vector<LawParameter>& parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &LawParameter::name);
  if (found == parameters.end()) return {};
  return found->value;
}

}  // namespace

std::vector<Sphere> spheres_of(std::span<const RoundBody> bodies) {
  std::vector<Sphere> spheres;
  for (const RoundBody& body : bodies) {
    const double volume = 4.0 / 3.0 * std::numbers::pi * body.radius * body.radius * body.radius;
    spheres.push_back({body.mass / volume, body.radius});
  }
  return spheres;
}

std::optional<double> poisson_ratio_of(const CalibrateOptions& options, bool has_spheres) {
  const std::optional<double>& ratio = options.poisson_ratio;
  if (ratio && !(*ratio >= 0.0 && *ratio <= 0.5))
    throw InputError{fmt::format("--poisson-ratio: found {}; it must be in [0, 0.5]", *ratio)};
  if (ratio && !has_spheres) {
    throw InputError{"--poisson-ratio: it needs spheres; give --spheres with --masses, or --radii with --density"};
  }
  return ratio;
}

std::optional<RayleighTime> rayleigh_time(const CalibrateOptions& options, const ContactLaw& law,
                                          const FrictionLaw& friction, std::span<const Sphere> spheres) {
  const std::optional<double> poisson_ratio = poisson_ratio_of(options, !spheres.empty());
  if (spheres.empty()) return {};
  const std::optional<double> modulus = value_of(parameters_of(law), "modulus"),
                              shear_modulus = value_of(parameters_of(friction), "shear_modulus");
  if (!modulus || !(poisson_ratio || shear_modulus)) return {};
  RayleighTime known;
  known.material = poisson_ratio ? material_of(*modulus, *poisson_ratio) : material_of_moduli(*modulus, *shear_modulus);
  if (!known.material) return known;
  known.shortest = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres)
    known.shortest = std::min(known.shortest, talus::rayleigh_time(*known.material, sphere.density, sphere.radius));
  return known;
}

void add_rayleigh_time(nlohmann::ordered_json& json, const std::optional<RayleighTime>& known) {
  if (!known) return;
  json["poisson_ratio"] = nullptr;
  json["rayleigh_time"] = nullptr;
  if (!known->material) return;
  json["poisson_ratio"] = known->material->poisson_ratio;
  json["rayleigh_time"] = known->shortest;
}

void print_rayleigh_time(const std::optional<RayleighTime>& known, std::optional<double> step, const ValueLines& line) {
  if (!known) return;
  if (!known->material) {
    fmt::print("  no Rayleigh time: a material of both bodies has a shear_modulus of 1/6 to 1/4 of the modulus\n");
    return;
  }
  line("Poisson's ratio", known->material->poisson_ratio, dimension::number);
  line("Rayleigh time, of one material", known->shortest, dimension::time);
  if (step) line("step over Rayleigh time", *step / known->shortest, dimension::number);
}

}  // namespace talus::app
