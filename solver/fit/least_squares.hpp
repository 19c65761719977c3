#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "solver/base/spacing.hpp"

namespace talus {

/// A parameter that is fitted, between two bounds.
struct FitParameter {
  double lower{}, upper{};
  double start{};                  ///< where the search begins, within the bounds
  Spacing spacing{Spacing::even};  ///< logarithmic: fitted by its logarithm
};

/// Deviations of a model from observations, each over its uncertainty: for the parameters, those of the given rows of
/// data, row by row, as many for each. NaN where the model has no result.
using FitModel =
    std::function<std::vector<double>(const std::vector<double>& parameters, const std::vector<std::size_t>& rows)>;

struct FitRules {
  std::size_t rows{};          ///< number of rows of data, > 0
  std::size_t samples{200};    ///< of the bootstrap; 0: no intervals
  std::int64_t seed{1};        ///< of the bootstrap
  int global_searches{120};    ///< evaluations of the model for each parameter, over the whole range
  int maximum_searches{2000};  ///< at most, of a local search
};

/// A fit by least squares.
struct Fit {
  std::vector<double> values;
  double sum{};                                  ///< of the squared deviations
  std::vector<double> deviations;                ///< at these values, row by row
  std::vector<double> errors;                    ///< standard error of each value, from the linearized model
  std::vector<std::vector<double>> correlation;  ///< of the values, row by row, likewise
  std::vector<bool> at_bound;                    ///< the value is that of a bound
  bool converged{};                              ///< the last step was at most a hundredth of each standard error
  std::vector<bool> undetermined;                ///< its standard error exceeds half of its range
  std::vector<std::vector<double>> samples;      ///< values of each sample of the bootstrap
  std::vector<std::array<double, 2>> intervals;  ///< of 95 %; empty without samples
  std::size_t unconverged{};                     ///< samples whose search reached its limit
  double tail{};                                 ///< cumulative probability of the lower ends of the intervals
  std::size_t evaluations{};                     ///< rows for which the model was evaluated

  /// Number of deviations minus that of the parameters.
  [[nodiscard]] double degrees_of_freedom() const;
};

/// Fits the parameters. A search of the whole range (DIRECT-L, Gablonsky & Kelley 2001) finds where a local search
/// without derivatives begins (Subplex, Rowan 1990; both of NLopt), unless the start is better; Gauss-Newton steps
/// complete it. A minimum that is narrow beside its range can be missed. `is_absolute`: the uncertainties are known, so
/// that standard errors are theirs; else they follow from the scatter of the deviations.
///
/// Intervals are those of a bootstrap over the rows (Efron 1979): percentiles of the values that fit samples of as many
/// rows, drawn with replacement. For few rows they are wider, by Student's distribution (Hesterberg 2015, section 5).
/// Results depend on the rules alone.
///
/// Errors: InputError if there are not more deviations than parameters, or no parameters are found with which all rows
/// have a result.
[[nodiscard]] Fit fit(const std::vector<FitParameter>& parameters, const FitModel& model, const FitRules& rules,
                      bool is_absolute);

}  // namespace talus
