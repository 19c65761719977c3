#include "solver/integrate/internal_steps.hpp"

#include <fmt/format.h>

namespace talus {

std::string internal_steps_failure(double t) {
  return fmt::format(
      "more than {} steps of the method's step control in one time step, at t = {:.6g}; a shorter time step, a larger "
      "tolerance, or a method of fixed step, may do",
      maximum_internal_steps, t);
}

std::string short_step_failure(double tolerance, double t) {
  return fmt::format(
      "no step is short enough for the tolerance {:g} at t = {:.6g}; a larger tolerance, or a method of fixed step, "
      "may do",
      tolerance, t);
}

}  // namespace talus
