#pragma once

#include <string>
#include <vector>

#include "solver/study/shear_study.hpp"

namespace talus {

/// A study of so many seeds a point as text: means with standard errors, then the verdicts. Marked are points of which
/// a run failed, or had discs too deep in each other (CellRun::deepest).
[[nodiscard]] std::string study_text(const std::vector<StudyMean>& study, const std::vector<Verdict>& verdicts,
                                     int seeds);

/// Every run of a study as tidy CSV: series, overburden [Pa], speed [d/s], stiffness, number of the run, then what was
/// measured.
[[nodiscard]] std::string study_csv(const std::vector<StudyMean>& study);

}  // namespace talus
