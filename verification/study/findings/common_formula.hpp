#pragma once

#include <string>
#include <utility>

#include "verification/check/table.hpp"

/// Comparison of commonly used formulas with exact results: tables that the report collects in a separate chapter.
namespace talus::verification::problems {

/// An empty table for that chapter. `name` is unique in the case; rows have five cells: where, result of the common
/// formula, exact result, error of the formula, and result of the solver.
[[nodiscard]] inline Table common_formula(const std::string& name, std::string caption) {
  return {.name = "common_formula_" + name,
          .caption = std::move(caption),
          .columns = {"where", "common formula", "exact", "its error", "solver"}};
}

}  // namespace talus::verification::problems
