#pragma once

#include <vector>

/// Masses in a row between two walls, on springs under permanent tension: x_i = i-th displacement along the row,
///   m x_i'' = k (x_{i+1} - 2 x_i + x_{i-1}),  i = 1 ... n,  x_0 = x_{n+1} = 0.
/// The shapes sin(i j pi/(n+1)) of mode j = 1 ... n decouple it: x_{i+1} + x_{i-1} = 2 cos(j pi/(n+1)) x_i, so that
///   w_j^2 = 2 (k/m) (1 - cos(j pi/(n+1))),   w_j = 2 sqrt(k/m) sin(j pi/(2 (n+1))).
/// With steps of length h, leapfrog methods (velocity Verlet) solve the difference equation
///   q(t+h) - 2 q(t) + q(t-h) = -(w h)^2 q(t):   q = cos(W t),   2 - 2 cos(W h) = (w h)^2,   sin(W h/2) = w h/2
/// exactly, for w h < 2. For c = w h/2 > 1, q = (-1)^s g^(+-s) after s steps, g = (c + sqrt(c^2 - 1))^2: the roots of
/// g + 1/g = (w h)^2 - 2.
namespace talus::verification::reference {

struct StretchedChain {
  int masses{};        ///< n >= 1
  double mass{};       ///< m of each [M] > 0
  double stiffness{};  ///< k of each of the n + 1 springs [F/L] > 0
};

/// w_1 < ... < w_n [rad/T].
[[nodiscard]] std::vector<double> chain_frequencies(const StretchedChain& chain);

/// Shape of mode j = 1 ... n, sin(i j pi/(n+1)) for i = 1 ... n; two shapes are orthogonal, and the sum of squares of
/// one is (n + 1)/2.
[[nodiscard]] std::vector<double> chain_shape(const StretchedChain& chain, int mode);

/// W of an oscillation of frequency w [rad/T] with steps of length h [T]; std::invalid_argument unless 0 < w h <= 2.
[[nodiscard]] double leapfrog_frequency(double frequency, double step);

/// g, growth per step beyond the stability limit; std::invalid_argument unless w h >= 2.
[[nodiscard]] double leapfrog_growth(double frequency, double step);

}  // namespace talus::verification::reference
