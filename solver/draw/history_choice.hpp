#pragma once

#include <string>
#include <vector>

#include "solver/io/output/read_history.hpp"
#include "solver/io/output/run_folder.hpp"

namespace talus::app {

/// The histories that a run left.
struct SavedRun {
  RunFolder run;
  std::vector<KeptHistory> histories;
};

/// Reads them. Errors: as read_run_folder and read_history.
[[nodiscard]] SavedRun read_saved_run(const std::string& folder);

/// One quantity as the abscissa or ordinate of a curve.
struct ChosenColumn {
  std::string words;    ///< what it is: "tension in top cable", "vx"
  std::string subject;  ///< what it is of: "element 3", "rock"; empty for time
  std::string unit;
  std::vector<double> values;
};

/// One curve.
struct SelectedCurve {
  ChosenColumn x;
  ChosenColumn y;
};

/// What a user asks for in words: a history is a number or title of 1993 (48, "TENSION IN TOP CABLE"), a quantity
/// (top_tension, vx) or a whole column (rock.vx, energy.kinetic); an element is its number or a name (3, rock, upper).
struct CurveQuery {
  std::string history;
  std::vector<std::string> elements;  ///< empty: all that have it
  std::string abscissa{"time"};       ///< of the same element if it has such a quantity, else a whole column
};

/// Names of what an element's histories are kept of: "element3" and the body of that number, or the name itself.
[[nodiscard]] std::vector<std::string> subjects_of(const SavedRun& run, const std::string& element);

/// The curves of a run that fit, in the order of elements. Errors: InputError naming the run's folder, what it kept and
/// the nearest name.
[[nodiscard]] std::vector<SelectedCurve> selected_curves(const SavedRun& run, const CurveQuery& query);

/// What a run kept, as the menus of HPLOT told it: for each file the quantities with their numbers of 1993, units, and
/// what they are kept of.
[[nodiscard]] std::string menu(const SavedRun& run);

}  // namespace talus::app
