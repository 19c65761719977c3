#pragma once

#include "verification/study/program/program_options.hpp"

/// Warnings and refusals of fits; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

/// Checks the warnings of fits: parameters that cannot be distinguished, one at its bound, a wrong model.
void check_warnings(const Program& program, Differences& differ);

/// Wrong files of a fit: messages with line and key, and nothing written.
void check_refusals(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::fitted_parameters
