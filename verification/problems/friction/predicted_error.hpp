#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "verification/check/findings.hpp"

namespace talus::verification::problems {

/// Holds the last of the errors against constant step^order. What its ratio lacks of 1 must have fallen as the next
/// power of the error does, by 2^power from that of the last but one, at twice the step; `floor` is what the prediction
/// itself is integrated to.
inline void expect_constant(Findings& findings, const std::string& name, const Convergence& errors, double constant,
                            int order, int power, double floor) {
  const auto off = [&](std::size_t i) { return errors.errors()[i] / (constant * std::pow(errors.steps()[i], order)); };
  const std::size_t last = errors.size() - 1;
  findings.expect("error over its prediction, " + name, off(last), 1.0,
                  Tolerance::truncation(std::max(std::abs(off(last - 1) - 1.0) / std::pow(2.0, power), floor),
                                        power == 1 ? 1.5 : 2.0,
                                        "what is left at twice the step falls by 2 to the next power of the error: a "
                                        "constant that is another stays. At least what the prediction itself is "
                                        "integrated to"));
}

}  // namespace talus::verification::problems
