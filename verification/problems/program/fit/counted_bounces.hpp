#pragma once

#include "verification/check/case.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"

/// Heights and times of single bounces of one run; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

/// Compares the maxima and impacts of a bouncing ball with its closed form, as numbers of a sweep and of a fit.
void check_counted_bounces(const Program& program, Findings& findings, Differences& differ);

}  // namespace talus::verification::problems::fitted_parameters
