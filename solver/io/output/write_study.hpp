#pragma once

#include <string>
#include <vector>

#include "solver/study/shear_study.hpp"

namespace talus {

/// Text of a study with `seeds` runs per point: means with standard errors, then the verdicts. Points are marked if a
/// run had overlaps beyond CellRun::deepest, or failed.
[[nodiscard]] std::string study_text(const std::vector<StudyMean>& study, const std::vector<Verdict>& verdicts,
                                     int seeds);

/// Every run of a study as tidy CSV: series, overburden [Pa], speed [diameters/s], stiffness, seed, then the measured
/// quantities.
[[nodiscard]] std::string study_csv(const std::vector<StudyMean>& study);

}  // namespace talus
