#pragma once

#include <cstddef>
#include <limits>
#include <vector>

/// Runs of one method on one scene, from coarse to fine, and what an accuracy costs.
namespace talus::verification::problems {

/// Error and cost of one run; an error of NaN if it failed.
struct WorkPoint {
  double error{};
  double evaluations{};
  long events{};  ///< located
};

/// Evaluations of the cheapest run from which on all finer ones are as good; infinite for none.
inline double evaluations_to_reach(const std::vector<WorkPoint>& points, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = points.size(); i-- > 0 && points[i].error <= error;)
    least = points[i].evaluations;
  return least;
}

}  // namespace talus::verification::problems
