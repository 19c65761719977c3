#pragma once

#include <cstdint>
#include <vector>

#include "solver/app/sweep/sweep_file.hpp"

namespace talus::app {

/// The first 53 of 64 random bits as a number in [0, 1). Standard distributions differ between libraries.
[[nodiscard]] double unit_number(std::uint64_t bits);

/// Points of a design that is no grid: for each run a number in [0, 1) for each axis. The same design gives the same
/// points everywhere. A Sobol sequence (Sobol 1967, direction numbers of Joe & Kuo 2008) has a random digital shift:
/// its first 2^k points have one point in each of 2^k equal parts of every axis. Errors: InputError if there are more
/// axes than the sequence has dimensions.
[[nodiscard]] std::vector<std::vector<double>> design_points(const Design& design, std::size_t axes);

}  // namespace talus::app
