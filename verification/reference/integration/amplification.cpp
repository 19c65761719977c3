#include "verification/reference/integration/amplification.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

using Complex = std::complex<double>;

/// Rows of a Butcher tableau below its diagonal, and the weights.
struct Tableau {
  std::vector<std::vector<double>> rows;
  std::vector<double> weights;
};

Tableau tableau(Scheme scheme) {
  switch (scheme) {
    case Scheme::euler:
      return {{{}}, {1.0}};
    case Scheme::rk4:
      return {{{}, {1.0 / 2}, {0, 1.0 / 2}, {0, 0, 1}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};
    case Scheme::dopri5:
      return {{{},
               {1.0 / 5},
               {3.0 / 40, 9.0 / 40},
               {44.0 / 45, -56.0 / 15, 32.0 / 9},
               {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
               {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
              {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    case Scheme::cash_karp54:
      return {{{},
               {1.0 / 5},
               {3.0 / 40, 9.0 / 40},
               {3.0 / 10, -9.0 / 10, 6.0 / 5},
               {-11.0 / 54, 5.0 / 2, -70.0 / 27, 35.0 / 27},
               {1631.0 / 55296, 175.0 / 512, 575.0 / 13824, 44275.0 / 110592, 253.0 / 4096}},
              {37.0 / 378, 0, 250.0 / 621, 125.0 / 594, 0, 512.0 / 1771}};
    case Scheme::fehlberg78:
      return {{{},
               {2.0 / 27},
               {1.0 / 36, 1.0 / 12},
               {1.0 / 24, 0, 1.0 / 8},
               {5.0 / 12, 0, -25.0 / 16, 25.0 / 16},
               {1.0 / 20, 0, 0, 1.0 / 4, 1.0 / 5},
               {-25.0 / 108, 0, 0, 125.0 / 108, -65.0 / 27, 125.0 / 54},
               {31.0 / 300, 0, 0, 0, 61.0 / 225, -2.0 / 9, 13.0 / 900},
               {2, 0, 0, -53.0 / 6, 704.0 / 45, -107.0 / 9, 67.0 / 90, 3},
               {-91.0 / 108, 0, 0, 23.0 / 108, -976.0 / 135, 311.0 / 54, -19.0 / 60, 17.0 / 6, -1.0 / 12},
               {2383.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -301.0 / 82, 2133.0 / 4100, 45.0 / 82, 45.0 / 164,
                18.0 / 41},
               {3.0 / 205, 0, 0, 0, 0, -6.0 / 41, -3.0 / 205, -3.0 / 41, 3.0 / 41, 6.0 / 41, 0},
               {-1777.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -289.0 / 82, 2193.0 / 4100, 51.0 / 82, 33.0 / 164,
                12.0 / 41, 0, 1}},
              {0, 0, 0, 0, 0, 34.0 / 105, 9.0 / 35, 9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840, 41.0 / 840}};
    default:
      throw std::invalid_argument("stability_polynomial: not a Runge-Kutta scheme");
  }
}

bool is_runge_kutta(Scheme scheme) {
  return scheme == Scheme::euler || scheme == Scheme::rk4 || scheme == Scheme::dopri5 ||
         scheme == Scheme::cash_karp54 || scheme == Scheme::fehlberg78;
}

/// ln of the spectral radius of a linear map, given as a function of a vector.
double ln_radius(int size, const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& map) {
  Eigen::MatrixXd matrix(size, size);
  for (int i = 0; i < size; ++i)
    matrix.col(i) = map(Eigen::VectorXd::Unit(size, i));
  return std::log(matrix.eigenvalues().cwiseAbs().maxCoeff());
}

/// One step of SRKN_6^b (Blanes & Moan 2002, Table 3) in q, u = h v and h^2 a of the last kick: six drifts, each
/// followed by a kick, whose dashpot uses the velocity before the kick; the first kick uses the acceleration of the
/// previous step.
Eigen::Vector3d composed(double q, double u, double a, double k, double d) {
  constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - a1 - a2;
  constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  constexpr std::array drifts{a1, a2, a3, a3, a2, a1}, kicks{b2, b3, 1.0 - 2.0 * (b1 + b2 + b3), b3, b2, b1};
  u += b1 * a;
  for (std::size_t i = 0; i < drifts.size(); ++i) {
    q += drifts[i] * u;
    a = -k * q - d * u;
    u += kicks[i] * a;
  }
  return {q, u, a};
}

/// Leapfrogs, velocity Verlet, Taylor and compositions in q, u = h v and a third stored variable: an old u or h^2 a.
/// `d` = 2 xi eta.
double ln_staggered(Scheme scheme, double eta, double xi) {
  const double k = eta * eta, d = 2.0 * xi * eta;
  using Vector = Eigen::VectorXd;
  return ln_radius(3, [&](const Vector& s) {
    const double q = s[0], u = s[1], kept = s[2];
    Vector next = Vector::Zero(3);
    const auto leap = [&](double new_u, double new_kept) { next << q + new_u, new_u, new_kept; };
    const auto verlet = [&](double seen) {
      const double new_q = q + u + 0.5 * kept, a = -k * new_q - d * seen;
      next << new_q, u + 0.5 * (kept + a), a;
    };
    switch (scheme) {
      case Scheme::half_step:
        leap((1.0 - d) * u - k * q, 0.0);
        break;
      case Scheme::average:
        leap(((1.0 - 0.5 * d) * u - k * q) / (1.0 + 0.5 * d), 0.0);
        break;
      case Scheme::implicit:
        leap((u - k * q) / (1.0 + d), 0.0);
        break;
      case Scheme::late:
        leap(u - k * q - d * kept, u);
        break;
      case Scheme::verlet_old:
        verlet(u);
        break;
      case Scheme::taylor:
        next << q + u + 0.5 * (-k * q - d * u), u - k * q - d * u, 0.0;
        break;
      case Scheme::blanes_moan4:
        next = composed(q, u, kept, k, d);
        break;
      default:
        verlet(u + kept);
    }
    return next;
  });
}

/// Integrals over (0, 1) of the eight Lagrange polynomials through the times `first`, first - 1, ..., first - 7: the
/// weights of Adams' formulas, Bashforth's with first = 0 and Moulton's with first = 1.
std::array<double, 8> adams_weights(int first) {
  std::array<double, 8> weights{};
  for (int j = 0; j < 8; ++j) {
    std::vector<double> polynomial{1.0};  // ascending powers of the time
    for (int i = 0; i < 8; ++i) {
      if (i == j) continue;
      const double node = first - i, width = i - j;  // (s - node_i)/(node_j - node_i)
      std::vector<double> product(polynomial.size() + 1, 0.0);
      for (std::size_t p = 0; p < polynomial.size(); ++p) {
        product[p] -= node * polynomial[p] / width;
        product[p + 1] += polynomial[p] / width;
      }
      polynomial = product;
    }
    for (std::size_t p = 0; p < polynomial.size(); ++p)
      weights[static_cast<std::size_t>(j)] += polynomial[p] / static_cast<double>(p + 1);
  }
  return weights;
}

/// Largest modulus for y(n+1) = y(n) + z (m_0 p + sum m_j y(n+1-j)), p = y(n) + z sum b_j y(n-j): the companion matrix
/// of y(n), .., y(n-7).
double ln_adams(Complex z) {
  static const std::array<double, 8> bashforth = adams_weights(0), moulton = adams_weights(1);
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(8, 8);
  for (int j = 0; j < 8; ++j) {
    const auto i = static_cast<std::size_t>(j);
    companion(0, j) = z * (moulton[0] * z * bashforth[i] + (j < 7 ? moulton[i + 1] : 0.0));
    if (j > 0) companion(j, j - 1) = 1.0;
  }
  companion(0, 0) += 1.0 + z * moulton[0];
  return std::log(companion.eigenvalues().cwiseAbs().maxCoeff());
}

}  // namespace

std::vector<double> stability_polynomial(Scheme scheme) {
  const Tableau table = tableau(scheme);
  std::vector<double> coefficients{1.0};
  // Coefficient of z^n: weights times the n-th vector; the first vector is all ones, each next one is A times the last.
  std::vector<double> vector(table.rows.size(), 1.0);
  for (std::size_t n = 0; n < table.rows.size(); ++n) {
    double sum = 0.0;
    std::vector<double> next(vector.size(), 0.0);
    for (std::size_t i = 0; i < vector.size(); ++i) {
      sum += table.weights[i] * vector[i];
      for (std::size_t j = 0; j < table.rows[i].size(); ++j)
        next[i] += table.rows[i][j] * vector[j];
    }
    coefficients.push_back(sum);
    vector = next;
  }
  return coefficients;
}

double ln_growth(Scheme scheme, double eta, double xi) {
  if (scheme != Scheme::abm8 && !is_runge_kutta(scheme)) return ln_staggered(scheme, eta, xi);
  const std::vector<double> polynomial = scheme == Scheme::abm8 ? std::vector<double>{} : stability_polynomial(scheme);
  const Complex root = std::sqrt(Complex{xi * xi - 1.0, 0.0});
  double largest = -std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0.0 && xi <= 1.0) break;  // conjugate root: same moduli
    const Complex z = eta * (-xi + sign * root);
    if (scheme == Scheme::abm8) {
      largest = std::max(largest, ln_adams(z));
      continue;
    }
    Complex factor = 0.0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c)
      factor = factor * z + *c;
    largest = std::max(largest, std::log(std::abs(factor)));
  }
  return largest;
}

std::vector<double> limits(Scheme scheme, double xi, double maximum, int parts) {
  const auto grows = [&](double eta) { return ln_growth(scheme, eta, xi) > 1e-10; };
  std::vector<double> found;
  double low = maximum / parts;
  bool before = grows(low);
  for (int i = 2; i < parts; ++i) {
    double high = maximum * i / parts;
    const double next = high;
    const bool after = grows(high);
    if (after != before) {
      for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (grows(middle) == before ? low : high) = middle;
      }
      found.push_back(0.5 * (low + high));
    }
    low = next;
    before = after;
  }
  return found;
}

double ln_multiplier(std::span<const Motion> runs, int dimension, double noise) {
  const int lags = (dimension + 1) / 2;  // each state has two numbers
  Eigen::Index columns = 0;
  for (const Motion& states : runs)
    columns += std::max<Eigen::Index>(0, static_cast<Eigen::Index>(states.size()) - lags);
  if (columns < dimension) return std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd now(2 * lags, columns), next(2 * lags, columns);
  double minimum = std::numeric_limits<double>::infinity();
  Eigen::Index c = 0;
  for (const Motion& states : runs) {
    for (auto first = states.begin(); states.end() - first > lags; ++first, ++c) {
      for (Eigen::Index l = 0; l < lags; ++l) {
        now.col(c).segment<2>(2 * l) << first[l][0], first[l][1];
        next.col(c).segment<2>(2 * l) << first[l + 1][0], first[l + 1][1];
      }
      const double size = now.col(c).norm();
      if (!(size > 0.0)) return std::numeric_limits<double>::quiet_NaN();
      minimum = std::min(minimum, size);
      now.col(c) /= size;
      next.col(c) /= size;
    }
  }
  // Map on the space spanned by the states: next = A now, by least squares in that space.
  const Eigen::JacobiSVD<Eigen::MatrixXd> split{now, Eigen::ComputeThinU | Eigen::ComputeThinV};
  const Eigen::VectorXd sizes = split.singularValues();
  Eigen::Index rank = 0;
  while (rank < std::min<Eigen::Index>(dimension, sizes.size()) && sizes[rank] > noise / minimum * sizes[0])
    ++rank;
  if (rank == 0) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXd basis = split.matrixU().leftCols(rank);
  const Eigen::MatrixXd map =
      basis.transpose() * next * split.matrixV().leftCols(rank) * sizes.head(rank).cwiseInverse().asDiagonal();
  return std::log(map.eigenvalues().cwiseAbs().maxCoeff());
}

}  // namespace talus::verification::reference
