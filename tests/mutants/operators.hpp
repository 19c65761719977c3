#pragma once

#include <string>
#include <vector>

#include "tests/mutants/mutant.hpp"
#include "tests/mutants/syntax.hpp"

namespace talus::mutants {

/// A mutation operator.
struct Operation {
  std::string name;
  std::string description;  ///< what it makes wrong
};
/// All mutation operators, in the order of the report.
[[nodiscard]] const std::vector<Operation>& operations();

/// All mutants of a source, in the order of their positions. Omitted are: code that the compiler evaluates (constants,
/// static_assert, template arguments), messages of errors, numbers below 1e-6 (thresholds of round-off), and calls that
/// change no result (reserve, shrink_to_fit). Some may not compile: types of templates are not known here.
[[nodiscard]] std::vector<Mutant> mutants_of(const Source& source, const std::string& file);

}  // namespace talus::mutants
