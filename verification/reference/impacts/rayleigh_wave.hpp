#pragma once

/// Surface waves of an elastic half-space (Rayleigh 1885) and the materials of two bodies that touch.
namespace talus::verification::reference {

/// Speed of the surface wave over that of shear waves for Poisson's ratio nu in [0, 0.5]: sqrt(q), with the root q in
/// (0, 1) of
///
///   q^3 - 8 q^2 + (24 - 16 b) q - 16 (1 - b) = 0,     b = (1 - 2 nu)/(2 (1 - nu)).
///
/// By bisection: at 0 the left side is -16 (1 - b) < 0, at 1 it is 1. Throws std::invalid_argument outside the range.
[[nodiscard]] double surface_wave_speed(double poisson_ratio);

/// A material by its Young's modulus E [F/L^2] and Poisson's ratio.
struct ElasticMaterial {
  double young_modulus{};
  double poisson_ratio{};

  /// G = E/(2 (1 + nu)).
  [[nodiscard]] double shear_modulus() const;
  /// E' of two such bodies: 1/E' = (1 - nu^2)/E + (1 - nu^2)/E.
  [[nodiscard]] double contact_modulus() const;
  /// G' of two such bodies: 1/G' = (2 - nu)/G + (2 - nu)/G.
  [[nodiscard]] double contact_shear_modulus() const;
  /// Time of the surface wave along half a great circle of a sphere [T].
  [[nodiscard]] double wave_time(double density, double radius) const;
};

}  // namespace talus::verification::reference
