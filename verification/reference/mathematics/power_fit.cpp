#include "verification/reference/mathematics/power_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {

namespace {

constexpr int first_power = 100, last_power = 2000;  ///< thousandths
constexpr int rounds = 30;                           ///< iterations of the slope that converts errors in x

/// Errors in y, including the errors in x times the slope of the fit.
std::vector<double> errors_of(const std::vector<FitPoint>& points, const PowerFit& fit) {
  std::vector<double> errors;
  for (const FitPoint& point : points) {
    const double slope = fit.factor * fit.power * std::pow(point.x, fit.power - 1.0) + fit.linear;
    errors.push_back(std::hypot(point.y_error, slope * point.x_error));
  }
  return errors;
}

PowerFit solve(const std::vector<FitPoint>& points, const std::vector<double>& errors, double power, bool corrected) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd terms{rows, corrected ? 3 : 2};
  Eigen::VectorXd y{rows};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const FitPoint& point = points[static_cast<std::size_t>(i)];
    const double weight = 1.0 / errors[static_cast<std::size_t>(i)];
    terms(i, 0) = weight, terms(i, 1) = weight * std::pow(point.x, power);
    if (corrected) terms(i, 2) = weight * point.x;
    y(i) = weight * point.y;
  }
  const Eigen::VectorXd found = terms.colPivHouseholderQr().solve(y);
  PowerFit fit{.limit = found(0), .factor = found(1), .power = power};
  if (corrected) fit.linear = found(2);
  fit.chi_squared = (y - terms * found).squaredNorm();
  const Eigen::MatrixXd covariance = (terms.transpose() * terms).inverse();
  fit.limit_error = std::sqrt(covariance(0, 0));
  return fit;
}

/// Chord from the first to the last point: the initial slope.
PowerFit chord(const std::vector<FitPoint>& points) {
  PowerFit fit{.power = 1.0};
  fit.factor = (points.back().y - points.front().y) / (points.back().x - points.front().x);
  return fit;
}

void demand(const std::vector<FitPoint>& points, std::size_t minimum) {
  if (points.size() < minimum) throw std::invalid_argument{"a fit needs more points than coefficients"};
}

PowerFit fit_of(const std::vector<FitPoint>& points, double power, bool corrected) {
  PowerFit fit = chord(points);
  for (int round = 0; round < rounds; ++round)
    fit = solve(points, errors_of(points, fit), power, corrected);
  return fit;
}

}  // namespace

double PowerFit::at(double x) const { return limit + factor * std::pow(x, power) + linear * x; }

PowerFit fit_power(const std::vector<FitPoint>& points) {
  demand(points, 4);
  PowerFit best = chord(points);
  std::vector<PowerFit> tried;
  for (int round = 0; round < rounds; ++round) {
    const auto errors = errors_of(points, best);
    tried.clear();
    for (int thousandths = first_power; thousandths <= last_power; ++thousandths)
      tried.push_back(solve(points, errors, 1e-3 * thousandths, false));
    best = *std::min_element(tried.begin(), tried.end(),
                             [](const PowerFit& a, const PowerFit& b) { return a.chi_squared < b.chi_squared; });
  }
  for (const PowerFit& one : tried) {
    if (one.chi_squared > best.chi_squared + 1.0) continue;
    best.power_error = std::max(best.power_error, std::abs(one.power - best.power));
    best.limit_error = std::max(best.limit_error, std::abs(one.limit - best.limit));
  }
  return best;
}

PowerFit fit_given_power(const std::vector<FitPoint>& points, double power) {
  demand(points, 3);
  return fit_of(points, power, false);
}

PowerFit fit_corrected_power(const std::vector<FitPoint>& points, double power) {
  demand(points, 4);
  return fit_of(points, power, true);
}

double rare_chi_squared(int freedom, double chance) {
  return quantile(complement(boost::math::chi_squared{static_cast<double>(freedom)}, chance));
}

}  // namespace talus::verification::reference
