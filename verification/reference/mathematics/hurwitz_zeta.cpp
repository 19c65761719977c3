#include "verification/reference/mathematics/hurwitz_zeta.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {

double hurwitz_zeta_of_minus(double p, double u) {
  if (!(p > -1.0 && p <= 4.0 && u > 0.0 && u <= 1.0))
    throw std::invalid_argument("hurwitz_zeta: needs -1 < p <= 4 and 0 < u <= 1");
  constexpr int terms = 30;
  // Summed in long double, because the sum cancels against the integral.
  const long double s = -static_cast<long double>(p), a = u, end = a + terms;
  long double sum = 0.0L;
  for (int j = 0; j < terms; ++j)
    sum += std::pow(a + j, -s);
  sum += std::pow(end, 1.0L - s) / (s - 1.0L) + 0.5L * std::pow(end, -s);
  // B_2k/(2k)! s (s + 1) ... (s + 2k - 2) end^(1 - s - 2k).
  constexpr std::array<long double, 6> weights{1.0L / 12.0L,       -1.0L / 720.0L,     1.0L / 30240.0L,
                                               -1.0L / 1209600.0L, 1.0L / 47900160.0L, -691.0L / 1307674368000.0L};
  long double product = s;
  for (std::size_t k = 1; k <= weights.size(); ++k) {
    const long double twice = 2.0L * static_cast<long double>(k);
    sum += weights[k - 1] * product * std::pow(end, 1.0L - s - twice);
    product *= (s + twice - 1.0L) * (s + twice);
  }
  return static_cast<double>(sum);
}

}  // namespace talus::verification::reference
