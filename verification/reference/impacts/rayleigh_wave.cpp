#include "verification/reference/impacts/rayleigh_wave.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {

double surface_wave_speed(double poisson_ratio) {
  if (!(poisson_ratio >= 0.0 && poisson_ratio <= 0.5))
    throw std::invalid_argument{"surface_wave_speed: Poisson's ratio is not in [0, 0.5]"};
  const double b = (1.0 - 2.0 * poisson_ratio) / (2.0 * (1.0 - poisson_ratio));
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double q = 0.5 * (low + high);
    const double left = ((q - 8.0) * q + 24.0 - 16.0 * b) * q - 16.0 * (1.0 - b);
    (left < 0.0 ? low : high) = q;
  }
  return std::sqrt(0.5 * (low + high));
}

double ElasticMaterial::shear_modulus() const { return young_modulus / (2.0 * (1.0 + poisson_ratio)); }

double ElasticMaterial::contact_modulus() const {
  const double compliance = (1.0 - poisson_ratio * poisson_ratio) / young_modulus;
  return 1.0 / (compliance + compliance);
}

double ElasticMaterial::contact_shear_modulus() const {
  const double compliance = (2.0 - poisson_ratio) / shear_modulus();
  return 1.0 / (compliance + compliance);
}

double ElasticMaterial::wave_time(double density, double radius) const {
  return std::numbers::pi * radius / (surface_wave_speed(poisson_ratio) * std::sqrt(shear_modulus() / density));
}

}  // namespace talus::verification::reference
