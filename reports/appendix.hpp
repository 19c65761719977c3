/// The long tables at the report's end. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// Each requirement and the checks that touch it, group by group; those without a case are named.
[[nodiscard]] std::string traceability(const Results& results);

/// How many checks, by the kind of their bounds, would turn red if their reference were wrong by 1.5 bounds: in either
/// direction, or in one.
[[nodiscard]] std::string perturbed_references(const Results& results);

/// Revision, compiler, machine and libraries of the run.
[[nodiscard]] std::string provenance(const Results& results);

}  // namespace talus::reports
