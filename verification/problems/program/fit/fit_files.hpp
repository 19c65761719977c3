#pragma once

#include <string>

#include "verification/study/program/program_options.hpp"

/// The files of a fit; part of the case `fitted_parameters`.
namespace talus::verification::problems::fitted_parameters {

/// Compares fit.csv of a folder with the data, differences with the fitted and measured values, and the root mean
/// squares of fit.json with the differences.
void compare_fit_files(const Program& program, const std::string& folder, const std::string& data_file,
                       Differences& differ);

}  // namespace talus::verification::problems::fitted_parameters
