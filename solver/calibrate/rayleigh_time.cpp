#include "solver/calibrate/rayleigh_time.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

double Material::effective_shear_modulus() const { return shear_modulus / (2.0 * (2.0 - poisson_ratio)); }

Material material_of(double effective_modulus, double poisson_ratio) {
  return {(1.0 - poisson_ratio) * effective_modulus, poisson_ratio};
}

std::optional<Material> material_of_moduli(double effective_modulus, double effective_shear_modulus) {
  const double ratio = effective_shear_modulus / effective_modulus;
  const double poisson_ratio = (1.0 - 4.0 * ratio) / (1.0 - 2.0 * ratio);
  // Moduli that are printed for nu = 0 or 0.5 miss it by their rounding.
  constexpr double rounding = 1e-5;
  if (!(ratio < 0.5 && poisson_ratio >= -rounding && poisson_ratio <= 0.5 + rounding)) return {};
  return material_of(effective_modulus, std::clamp(poisson_ratio, 0.0, 0.5));
}

double rayleigh_time(const Material& material, double density, double radius) {
  const double speed = (0.8766 + 0.1631 * material.poisson_ratio) * std::sqrt(material.shear_modulus / density);
  return std::numbers::pi * radius / speed;
}

}  // namespace talus
