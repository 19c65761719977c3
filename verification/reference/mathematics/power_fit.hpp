#pragma once

#include <vector>

namespace talus::verification::reference {

/// A measured point y(x), x > 0; at least one of its standard errors must be > 0.
struct FitPoint {
  double x{}, x_error{};
  double y{}, y_error{};
};

/// y = limit + factor x^power + linear x, by weighted least squares. Errors in x are converted to errors in y by the
/// slope of the fit.
struct PowerFit {
  double limit{}, factor{}, power{}, linear{};
  double limit_error{}, power_error{};  ///< standard errors; that of the power is 0 if the power is given
  double chi_squared{};

  double at(double x) const;
};

/// Fit without the linear term. The power is searched in [0.1, 2] in steps of 0.001; errors are the largest deviations
/// of limit and power while chi^2 increases by at most 1. At least four points.
[[nodiscard]] PowerFit fit_power(const std::vector<FitPoint>& points);

/// Fit without the linear term, for a given power. At least three points.
[[nodiscard]] PowerFit fit_given_power(const std::vector<FitPoint>& points, double power);

/// Fit with the linear term, for a given power other than 1. At least four points.
[[nodiscard]] PowerFit fit_corrected_power(const std::vector<FitPoint>& points, double power);

/// Value that chi^2 with `freedom` > 0 degrees of freedom exceeds with probability `chance`, if the points scatter
/// according to their errors.
[[nodiscard]] double rare_chi_squared(int freedom, double chance);

}  // namespace talus::verification::reference
