#pragma once

#include <array>
#include <vector>

/// Discs that stay pressed on each other by linear contacts: a column under its own weight, and two discs between
/// walls.
namespace talus::verification::reference {

/// Overlaps of a column of n equal discs at rest, from the ground up: contact i = 1 ... n carries the n - i + 1 discs
/// above it, delta_i = (n - i + 1) m g/k [L].
[[nodiscard]] std::vector<double> column_overlaps(int discs, double mass, double gravity, double stiffness);

/// Lowest frequency of that column: w_j = 2 sqrt(k/m) sin((2j - 1) pi/(2 (2n + 1))), j = 1 (chain with one fixed end:
/// the shapes sin((2j - 1) pi i/(2n + 1)) satisfy m w^2 u_i = k (2u_i - u_{i-1} - u_{i+1}) and u_{n+1} = u_n).
[[nodiscard]] double column_frequency(int discs, double mass, double stiffness);

/// Two discs between a floor and a ceiling, all three contacts closed, of one stiffness k and one dashpot c = b k.
///
/// With y the heights above the equilibrium positions of the discs, M y'' = -K (y + b y'),  K = k [2 -1; -1 2],
/// M = diag(m_1, m_2). The mode shapes p of K p = w^2 M p decouple it, because the damping is proportional to K:
///   q'' + b w^2 q' + w^2 q = 0,   q = exp(-xi w t) (q_0 cos(s w t) + (q'_0/w + xi q_0) sin(s w t)/s),  xi = b w/2.
/// det(K - w^2 M) = 0: m_1 m_2 w^4 - 2k (m_1 + m_2) w^2 + 3 k^2 = 0; equal masses: w^2 = k/m, 3k/m. Equilibrium under
/// gravity: k [2 -1; -1 2] y_rest = -g (m_1, m_2), measured from where the forces of all three contacts are equal.
struct PressedPair {
  double mass_below{};  ///< m_1 [M] > 0
  double mass_above{};  ///< m_2 [M] > 0
  double stiffness{};   ///< k [F/L] > 0
  double lag{};         ///< b = c/k [T] >= 0; both modes below critical
  double gravity{};     ///< downwards [L/T^2]
};

/// Heights relative to those of equal contact forces without gravity [L], and their rates.
struct PressedPairState {
  std::array<double, 2> height{};
  std::array<double, 2> rate{};
};

/// w_1 < w_2 [rad/T].
[[nodiscard]] std::array<double, 2> pair_frequencies(const PressedPair& pair);
/// Heights at rest under gravity.
[[nodiscard]] std::array<double, 2> pair_at_rest(const PressedPair& pair);
/// State at time t from `start`; std::invalid_argument for a mode that is not below critical damping.
[[nodiscard]] PressedPairState pair_at(const PressedPair& pair, const PressedPairState& start, double t);

}  // namespace talus::verification::reference
