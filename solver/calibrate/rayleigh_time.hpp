#pragma once

#include <optional>

namespace talus {

/// Elastic, isotropic material of both bodies of a contact.
struct Material {
  double shear_modulus{};  ///< G [F/L^2]
  double poisson_ratio{};  ///< nu, in [0, 0.5]

  /// Effective shear modulus G' of `mindlin` [F/L^2], 1/G' = 2 (2 - nu)/G.
  double effective_shear_modulus() const;
};

/// The material of both bodies, from the effective modulus E' of `hertz` [F/L^2] and Poisson's ratio:
///
///   1/E' = 2 (1 - nu^2)/E,   E = 2 (1 + nu) G   ->   G = (1 - nu) E'
[[nodiscard]] Material material_of(double effective_modulus, double poisson_ratio);

/// The material of both bodies, from both effective moduli [F/L^2]; none if no material with a Poisson's ratio in
/// [0, 0.5] has them: then G'/E' = (1 - nu)/(2 (2 - nu)) is not in [1/6, 1/4].
[[nodiscard]] std::optional<Material> material_of_moduli(double effective_modulus, double effective_shear_modulus);

/// Rayleigh time of a sphere [T]: the time of a surface wave from pole to pole, pi r/c. The speed of the wave is
/// c = (0.8766 + 0.1631 nu) sqrt(G/rho), within 0.4 % of the root of Rayleigh's equation. `density` [M/L^3], `radius`
/// [L]. Other codes state steps as fractions of it (Altair EDEM, LIGGGHTS).
[[nodiscard]] double rayleigh_time(const Material& material, double density, double radius);

}  // namespace talus
