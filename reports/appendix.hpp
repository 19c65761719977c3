/// The long tables at the report's end. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// Each requirement and the checks that touch it, group by group; those without a case are named.
[[nodiscard]] std::string traceability(const Results& results);

/// Revision, compiler, machine and libraries of the run.
[[nodiscard]] std::string provenance(const Results& results);

}  // namespace talus::reports
