#pragma once

#include <cstddef>
#include <limits>
#include <vector>

/// Runs of one method on one scene, from coarse to fine, and the cost of an accuracy.
namespace talus::verification::problems {

/// Error and cost of one run; an error of NaN if it failed.
struct WorkPoint {
  double error{};
  double evaluations{};
  long events{};  ///< number of located events
};

/// Evaluations of the cheapest run that reaches the error together with all finer runs; infinite if there is none.
inline double evaluations_to_reach(const std::vector<WorkPoint>& points, double error) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = points.size(); i-- > 0 && points[i].error <= error;)
    minimum = points[i].evaluations;
  return minimum;
}

}  // namespace talus::verification::problems
