/// The long tables at the end of the report. All results are Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// Each requirement with the checks that cover it, group by group; requirements without a case are marked.
[[nodiscard]] std::string traceability(const Results& results);

/// Number of checks, by the kind of their bounds, that would fail if their reference were wrong by 1.5 bounds: in
/// either direction, or in one.
[[nodiscard]] std::string perturbed_references(const Results& results);

/// Processor and number of cores of the run, as plain text.
[[nodiscard]] std::string machine(const records::Provenance& provenance);

/// Revision, compiler, machine and libraries of the run.
[[nodiscard]] std::string provenance(const Results& results);

}  // namespace talus::reports
