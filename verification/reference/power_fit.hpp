#pragma once

#include <vector>

namespace talus::verification::reference {

/// A measured point y(x), x > 0, with standard errors > 0 of both together.
struct FitPoint {
  double x{}, x_error{};
  double y{}, y_error{};
};

/// y = limit + factor x^power + linear x, by weighted least squares. Errors in x count as what the fit's slope makes of
/// them in y.
struct PowerFit {
  double limit{}, factor{}, power{}, linear{};
  double limit_error{}, power_error{};  ///< standard errors; of the power 0 where it is given
  double chi_squared{};

  double at(double x) const;
};

/// Without the linear term. The power is sought in [.1, 2] by steps of .001; errors are the furthest that limit and
/// power move while chi^2 grows by 1 at most. Four points or more.
[[nodiscard]] PowerFit fit_power(const std::vector<FitPoint>& points);

/// Without the linear term, of a given power. Three points or more.
[[nodiscard]] PowerFit fit_given_power(const std::vector<FitPoint>& points, double power);

/// With the linear term, of a given power other than 1. Four points or more.
[[nodiscard]] PowerFit fit_corrected_power(const std::vector<FitPoint>& points, double power);

/// What chi^2 of so many degrees of freedom > 0 exceeds with that chance, if points scatter as their errors say.
[[nodiscard]] double rare_chi_squared(int freedom, double chance);

}  // namespace talus::verification::reference
