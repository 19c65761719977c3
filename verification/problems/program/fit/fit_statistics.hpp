#pragma once

#include "verification/check/case.hpp"

/// Fits of a model in closed form, without runs; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

/// Counts how often intervals of 95 % contain the parameters with which the data were made.
void check_coverage(Findings& findings, const Setup& setup);

/// Values at bounds, of the deeper of two minima, and of the samples of a bootstrap, beside their closed forms.
void check_search(Findings& findings);

}  // namespace talus::verification::problems::fitted_parameters
