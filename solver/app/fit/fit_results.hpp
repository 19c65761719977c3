#pragma once

#include <string>
#include <vector>

#include "solver/app/fit/fit_file.hpp"
#include "solver/fit/least_squares.hpp"
#include "verification/record/figure.hpp"

namespace talus::app {

/// What a reader of a fit must know: parameters that the data do not determine or cannot distinguish, values at a
/// bound, a model that does not describe the data.
[[nodiscard]] std::vector<std::string> fit_warnings(const FitFile& file, const Fit& fit);

/// The fit as text for a terminal. `results`: those of the fitted values, row by row.
[[nodiscard]] std::string fit_text(const FitFile& file, const Fit& fit);

/// The fit as JSON.
[[nodiscard]] std::string fit_json(const FitFile& file, const Fit& fit, const std::vector<double>& results);

/// Each row of data as a line of CSV: inputs, and of each quantity the measured value, the fitted one and their
/// difference.
[[nodiscard]] std::string fit_csv(const FitFile& file, const std::vector<double>& results);

/// The values of each sample of the bootstrap as a line of CSV.
[[nodiscard]] std::string bootstrap_csv(const FitFile& file, const Fit& fit);

/// Of each quantity the measured and the fitted values over the first input, or over the number of the row; of each
/// pair of parameters the samples of the bootstrap.
[[nodiscard]] std::vector<records::Figure> fit_figures(const FitFile& file, const Fit& fit,
                                                       const std::vector<double>& results);

}  // namespace talus::app
