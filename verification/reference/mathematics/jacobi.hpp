#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// Complete elliptic integrals and Jacobi's elliptic functions by the arithmetic-geometric mean, for any real type.
///
/// AGM: a_0 = 1, b_0 = k', c_0 = k; a_{n+1} = (a_n + b_n)/2, b_{n+1} = sqrt(a_n b_n), c_{n+1} = (a_n - b_n)/2. Then
///   K = pi/(2 a_N),   E = K (1 - sum_n 2^{n-1} c_n^2),   phi_N = 2^N a_N u,
///   sin(2 phi_{n-1} - phi_n) = (c_n/a_n) sin phi_n,   am(u) = phi_0
/// (Abramowitz and Stegun, 16.4, 17.6; the third line is Landen's descending transformation). Both the modulus k and
/// the complementary k' are given, so that no digits are lost near k = 1; dn^2 = k'^2 + k^2 cn^2 is a sum without
/// cancellation.
namespace talus::verification::reference {

/// Modulus with its complement, k^2 + k'^2 = 1, 0 <= k < 1, 0 < k' <= 1.
template <class Real>
struct Modulus {
  Real k{};
  Real complement{};
};

/// am(u) (continuous: it grows by pi in 2 K), sn, cn, dn.
template <class Real>
struct Jacobi {
  Real amplitude{};
  Real sn{};
  Real cn{};
  Real dn{};
};

/// K and E of the modulus.
template <class Real>
struct CompleteIntegrals {
  Real first{};
  Real second{};
};

template <class Real>
class ArithmeticGeometricMean {
 public:
  explicit ArithmeticGeometricMean(const Modulus<Real>& modulus) : modulus_(modulus) {
    using std::abs;
    using std::sqrt;
    Real b = modulus.complement;
    a_[0] = Real(1);
    c_[0] = modulus.k;
    // c converges quadratically: c_{n+1} is about c_n^2/(4 a), so once c^2 is below eps the list ends after one more.
    while (count_ + 1 < levels && abs(c_[count_]) > std::numeric_limits<Real>::epsilon() * a_[count_]) {
      const Real a = a_[count_];
      ++count_;
      a_[count_] = (a + b) / 2;
      c_[count_] = (a - b) / 2;
      b = sqrt(a * b);
    }
  }

  [[nodiscard]] CompleteIntegrals<Real> complete() const {
    using std::acos;
    const Real first = acos(Real(0)) / a_[count_];
    Real sum(0);
    Real power = Real(1) / 2;
    for (std::size_t n = 0; n <= count_; ++n, power *= 2)
      sum += power * c_[n] * c_[n];
    return {first, first * (1 - sum)};
  }

  [[nodiscard]] Jacobi<Real> at(const Real& u) const {
    using std::asin;
    using std::cos;
    using std::sin;
    using std::sqrt;
    Real phi = u * a_[count_];
    for (std::size_t n = 0; n < count_; ++n)
      phi *= 2;
    for (std::size_t n = count_; n > 0; --n)
      phi = (phi + asin(c_[n] / a_[n] * sin(phi))) / 2;
    const Real cn = cos(phi);
    const Real dn = sqrt(modulus_.complement * modulus_.complement + modulus_.k * modulus_.k * cn * cn);
    return {phi, sin(phi), cn, dn};
  }

 private:
  static constexpr std::size_t levels = 32;
  Modulus<Real> modulus_;
  std::array<Real, levels> a_{};
  std::array<Real, levels> c_{};
  std::size_t count_{0};
};

}  // namespace talus::verification::reference
