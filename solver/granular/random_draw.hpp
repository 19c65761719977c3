#pragma once

#include <cmath>
#include <random>

namespace talus {

/// Uniform in [-1, 1), computed from the generator's bits: std:: distributions differ between standard libraries.
inline double symmetric(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0; }

}  // namespace talus
