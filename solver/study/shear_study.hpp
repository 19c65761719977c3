#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/cell/block_means.hpp"
#include "solver/cell/cell_plan.hpp"

namespace talus {

/// Quantities that a study measures in each run.
enum class StudyQuantity : std::size_t {
  stress_ratio,             ///< S/N on the block
  depth,                    ///< in diameters
  touching,                 ///< fraction of time with contacts
  multiple_fraction,        ///< fraction of contact time in multiple contacts
  multiple_shear_fraction,  ///< M/S, taken as their fraction of the shear of contacts
  multiple_stress_ratio,    ///< S/N of multiple contacts
  binary_stress_ratio,      ///< S/N of binary contacts
  order,                    ///< six-fold order, mean over the outputs
  inertial_number,
  largest_overlap,  ///< in diameters
};
template <>
struct Names<StudyQuantity> {
  static constexpr std::array<std::string_view, 10> list{"stress_ratio",
                                                         "depth",
                                                         "touching",
                                                         "multiple_fraction",
                                                         "multiple_shear_fraction",
                                                         "multiple_stress_ratio",
                                                         "binary_stress_ratio",
                                                         "order",
                                                         "inertial_number",
                                                         "largest_overlap"};
};
inline constexpr std::size_t study_quantities = Names<StudyQuantity>::list.size();

/// One cell of a study: Talus's ice discs (ice_cell()) with this load, drive and stiffness.
struct StudyPoint {
  std::string series;     ///< name shared by points that belong together
  double overburden{};    ///< [Pa]
  double speed{};         ///< of the block [D/s]
  double stiffness{1.0};  ///< relative to ice
};

/// Results of a point: mean and standard error of the mean over its seeds. Runs that failed are excluded.
struct StudyMean {
  struct Run {
    std::uint64_t seed{};
    std::array<double, study_quantities> numbers{};
  };
  StudyPoint point;
  int seeds{};  ///< number of runs that did not fail
  std::vector<Run> runs;
  std::array<Estimate, study_quantities> mean{};
  Estimate of(StudyQuantity quantity) const { return mean[static_cast<std::size_t>(quantity)]; }
};

/// Progress of a study.
struct StudyProgress {
  std::size_t runs{}, all_runs{};  ///< number of runs that have ended, and of all
  double fraction{};               ///< completed part of the steps of all runs, in (0, 1]
};

struct StudyPlan {
  double time{0.8};  ///< of each run [s]
  int seeds{5};      ///< number of seeds, from seed 1 on
  unsigned threads{1};
  std::function<void(const StudyProgress&)> progress{};  ///< called at each output of a run, from any of the threads
};

/// The cell of a point: ice_cell(), softer or stiffer.
[[nodiscard]] ShearCell study_cell(const StudyPoint& point, std::uint64_t seed);

/// The points of the study of the thesis's hypothesis: overburden at 5000 and 1000 d/s, speed at 2, 15 and 32 kPa,
/// stiffness at 15 kPa and 5000 d/s. `coarse` has fewer of each.
[[nodiscard]] std::vector<StudyPoint> shear_study_points(bool coarse);

/// Runs all points; the numbers do not depend on the number of threads. Errors: InputError for a cell that cannot be
/// run; rethrows the exception of the first run that threw.
[[nodiscard]] std::vector<StudyMean> shear_study(const std::vector<StudyPoint>& points, const StudyPlan& plan);

/// Outcome of a prediction. A difference counts if chance causes it with a probability of at most 1 %.
enum class Outturn {
  holds,      ///< significant difference of the predicted sign
  opposed,    ///< significant difference of the opposite sign
  not_shown,  ///< no significant difference
};
[[nodiscard]] std::string_view text_of(Outturn outturn);

/// A prediction of the hypothesis (Dent 1986, as reported by Lacy 1989, "The Problem") and the study's result on it.
struct Verdict {
  std::string prediction;
  std::string measured;   ///< text with numbers
  double significance{};  ///< Student's t of the difference that decides (Welch 1947)
  double chance{};        ///< probability of so large a difference, of either sign, if there is none
  Outturn outturn{Outturn::not_shown};
};
/// Verdicts from the points of the series "5000 d/s" between 2 and 32 kPa: compression, formation of multiple contacts,
/// their lower ratio, and the decrease of the ratio as a whole; then the last of these at 1000 d/s; and, if the
/// stiffness is varied, the decrease of the ratio with it at equal load and drive, where the inertial number is equal
/// except for the depth. Errors: InputError if a series of loads has fewer than two points that ran.
[[nodiscard]] std::vector<Verdict> verdicts(const std::vector<StudyMean>& study);

}  // namespace talus
