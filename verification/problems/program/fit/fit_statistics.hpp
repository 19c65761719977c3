#pragma once

#include <array>
#include <vector>

#include "verification/check/case.hpp"

/// Fits of a model in closed form, without runs; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

/// The 256 ratios of sums over a sample of four rows, drawn with replacement: of `products` over `squares` of the rows.
[[nodiscard]] std::vector<double> ratios_of_samples(const std::array<double, 4>& products,
                                                    const std::array<double, 4>& squares);

/// Counts how often intervals of 95 % contain the parameters with which the data were made.
void check_coverage(Findings& findings, const Setup& setup);

/// Values at bounds, of the deeper of two minima, and of the samples of a bootstrap, beside their closed forms.
void check_search(Findings& findings);

}  // namespace talus::verification::problems::fitted_parameters
