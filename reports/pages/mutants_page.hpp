/// The report's chapter on mutants: which small bugs the cases detect.
#pragma once

#include <string>
#include <vector>

#include "reports/base/record.hpp"
#include "verification/record/mutants.hpp"

namespace talus::reports {

/// Its figures: the matrix of mutants and cases, the score against the number of cases, and against the tolerance; the
/// last two only for a whole matrix. They are drawn as figures/mutants-NAME.
[[nodiscard]] std::vector<Figure> mutants_figures(const records::Mutants& mutants);

/// The chapter as Markdown, without its heading; with its figures if `pictures`.
[[nodiscard]] std::string mutants_text(const records::Mutants& mutants, const Results& results, bool pictures);

/// The written bugs with which a case was red, and the number of generated mutants; empty if there are none.
[[nodiscard]] std::string bugs_text(const records::Mutants& mutants, const std::string& case_id);

/// Score and survivors of the small sample that the full tier runs.
[[nodiscard]] std::string gate_text(const records::Mutants& mutants);

}  // namespace talus::reports
