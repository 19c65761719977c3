#pragma once

#include <array>
#include <cmath>
#include <complex>

/// Error of the 8-step Adams-Bashforth predictor with the 8-value Adams-Moulton corrector (predict, evaluate, correct,
/// evaluate) on a small oscillation: x' = i w x, one step x -> rho x.
///
/// With the backward difference u = 1 - 1/rho, z = w h, gamma_j and gamma*_j the coefficients of Adams-Bashforth and
/// Adams-Moulton (Henrici 1962, 5.1; sum_k gamma_{j-k}/(k+1) = 1, the same sum of gamma* = 0 for j > 0), and
/// beta_0 = sum gamma*_j = 5257/17280:
///   p = 1 + i z sum_{j<8} gamma_j u^j,   rho = 1 + i z [rho sum_{j<8} gamma*_j u^j + beta_0 (p - rho)].
/// The error per step is -gamma*_8 (i z)^9 [1 + beta_0 (gamma_8/gamma*_8) i z + ...]: order 8. But gamma_8 = 0.2949 is
/// 31 times gamma*_8 = -0.00936, so that the second term is 9.6 z times the first: steps that are not much shorter than
/// 1/10 of a radian show an order between 8 and 9.
namespace talus::verification::problems {

/// Relative error after n steps, |rho^n/e^{i n z} - 1|.
inline double adams_swing_error(double z, long n) {
  using Complex = std::complex<long double>;
  std::array<long double, 8> bashforth{};
  std::array<long double, 8> moulton{};
  long double beta = 0.0L;
  for (std::size_t j = 0; j < 8; ++j) {
    bashforth[j] = 1.0L;
    moulton[j] = j == 0 ? 1.0L : 0.0L;
    for (std::size_t k = 1; k <= j; ++k) {
      bashforth[j] -= bashforth[j - k] / static_cast<long double>(k + 1);
      moulton[j] -= moulton[j - k] / static_cast<long double>(k + 1);
    }
    beta += moulton[j];
  }
  const Complex w{0.0L, z};
  const auto excess = [&](const Complex& root) {
    Complex predicted{};
    Complex corrected{};
    Complex power = 1.0L;
    for (std::size_t j = 0; j < 8; ++j) {
      predicted += bashforth[j] * power;
      corrected += moulton[j] * power;
      power *= 1.0L - 1.0L / root;
    }
    return 1.0L + w * (root * corrected + beta * (1.0L + w * predicted - root)) - root;
  };
  const Complex exact = std::exp(w);
  Complex shift{};  // rho - e^{iz}: the iteration contracts by about z each time
  for (int i = 0; i < 30; ++i)
    shift += excess(exact + shift);
  const Complex turns = static_cast<long double>(n) * std::log(1.0L + shift / exact);
  return static_cast<double>(std::abs(std::exp(turns) - 1.0L));
}

}  // namespace talus::verification::problems
