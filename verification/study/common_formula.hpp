#pragma once

#include <string>
#include <utility>

#include "verification/check/table.hpp"

/// What is often used, what it gives, and what is exact: tables that the report gathers in a chapter of their own.
namespace talus::verification::problems {

/// An empty table for that chapter. `name` is unique in the case; rows have five cells: where, what the common formula
/// gives, what is exact, the formula's error, and what the solver gives.
[[nodiscard]] inline Table common_formula(const std::string& name, std::string caption) {
  return {.name = "common_formula_" + name,
          .caption = std::move(caption),
          .columns = {"where", "common formula", "exact", "its error", "solver"}};
}

}  // namespace talus::verification::problems
