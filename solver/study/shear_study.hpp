#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/cell/block_means.hpp"
#include "solver/cell/cell_plan.hpp"

namespace talus {

/// What a study measures of each run.
enum class StudyQuantity : std::size_t {
  stress_ratio,           ///< S/N on the block
  depth,                  ///< over a diameter
  touching,               ///< share of time with contacts
  multiple_share,         ///< share of contact time in multiple contacts
  multiple_shear_share,   ///< M/S, read as their share of the shear of contacts
  multiple_stress_ratio,  ///< S/N of multiple contacts
  binary_stress_ratio,    ///< of binary ones
  order,                  ///< six-fold, mean over the outputs
  inertial_number,
  largest_overlap,  ///< over a diameter
  count,
};
inline constexpr std::size_t study_quantities = static_cast<std::size_t>(StudyQuantity::count);
/// Their names in files, in order.
inline constexpr std::array<std::string_view, study_quantities> study_names{"stress_ratio",
                                                                            "depth",
                                                                            "touching",
                                                                            "multiple_share",
                                                                            "multiple_shear_share",
                                                                            "multiple_stress_ratio",
                                                                            "binary_stress_ratio",
                                                                            "order",
                                                                            "inertial_number",
                                                                            "largest_overlap"};

/// One cell of a study: Talus's discs of ice with this load, drive and stiffness.
struct StudyPoint {
  std::string series;     ///< points that belong together
  double overburden{};    ///< [Pa]
  double speed{};         ///< of the block [D/s]
  double stiffness{1.0};  ///< over that of ice
};

/// What the seeds of a point gave: mean and standard error of the mean over seeds. A run that failed has no part in
/// them.
struct StudyMean {
  struct Run {
    std::uint64_t seed{};
    std::array<double, study_quantities> numbers{};
  };
  StudyPoint point;
  int seeds{};  ///< that did not fail
  std::vector<Run> runs;
  std::array<Estimate, study_quantities> mean{};
  Estimate of(StudyQuantity quantity) const { return mean[static_cast<std::size_t>(quantity)]; }
};

/// How far a study has come.
struct StudyProgress {
  std::size_t runs{}, all_runs{};  ///< that have ended, of how many
  double fraction{};               ///< of the steps of all runs, in (0, 1]
};

struct StudyPlan {
  double time{0.8};  ///< of each run [s]
  int seeds{5};      ///< from 1
  unsigned threads{1};
  std::function<void(const StudyProgress&)> progress{};  ///< at each output of a run, from any of the threads
};

/// The cell of a point: ice_cell(), softer or stiffer.
[[nodiscard]] ShearCell study_cell(const StudyPoint& point, std::uint64_t seed);

/// The points of the study of the thesis's hypothesis: overburden at 5000 and 1000 d/s, speed at 2, 15 and 32 kPa,
/// stiffness at 15 kPa and 5000 d/s. `coarse` has fewer of each.
[[nodiscard]] std::vector<StudyPoint> shear_study_points(bool coarse);

/// Runs all; the same numbers for any number of threads. Errors: InputError for what no cell can be run with; what the
/// first run that threw has thrown.
[[nodiscard]] std::vector<StudyMean> shear_study(const std::vector<StudyPoint>& points, const StudyPlan& plan);

/// What a study says of a prediction: a difference is one that chance makes once in a hundred times at most.
enum class Outturn {
  holds,      ///< a difference of the predicted sign
  opposed,    ///< one of the other sign
  not_shown,  ///< none
};
[[nodiscard]] std::string_view words(Outturn outturn);

/// A prediction of the hypothesis (Dent 1986, as Lacy 1989 tells it, "The Problem") and what the study says of it.
struct Verdict {
  std::string prediction;
  std::string measured;   ///< in words, with numbers
  double significance{};  ///< Student's t of the difference it rests on (Welch 1947)
  double chance{};        ///< of so large a difference, of either sign, where there is none
  Outturn outturn{Outturn::not_shown};
};
/// By the points of the series "5000 d/s" between 2 and 32 kPa: compression, formation of multiple contacts, their
/// lower ratio, whether the ratio as a whole falls; then the same of the whole at 1000 d/s, and, if the stiffness is
/// varied, whether the ratio falls with it where load and drive are kept: the inertial number, then, is the same but
/// for the depth. Errors: InputError if a series of loads has fewer than two points that ran.
[[nodiscard]] std::vector<Verdict> verdicts(const std::vector<StudyMean>& study);

}  // namespace talus
