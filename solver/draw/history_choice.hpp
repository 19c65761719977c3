#pragma once

#include <string>
#include <vector>

#include "solver/io/output/read_history.hpp"
#include "solver/io/output/run_folder.hpp"

namespace talus::app {

/// A run folder with its histories.
struct SavedRun {
  RunFolder run;
  std::vector<KeptHistory> histories;
};

/// Reads a run folder and its histories. Errors: as read_run_folder and read_history.
[[nodiscard]] SavedRun read_saved_run(const std::string& folder);

/// One quantity as the abscissa or ordinate of a curve.
struct ChosenColumn {
  std::string description;  ///< description of the quantity: "tension in top cable", "vx"
  std::string subject;      ///< element or body: "element 3", "rock"; empty for time
  std::string unit;
  std::vector<double> values;
};

/// One curve.
struct SelectedCurve {
  ChosenColumn x;
  ChosenColumn y;
};

/// Query for curves: a history is a number or title of the 1993 code (48, "TENSION IN TOP CABLE"), a quantity
/// (top_tension, vx) or a whole column (rock.vx, energy.kinetic); an element is its number or name (3, rock, upper).
struct CurveQuery {
  std::string history;
  std::vector<std::string> elements;  ///< empty: all elements that have the history
  std::string abscissa{"time"};       ///< quantity of the same element if it has one of this name, else a whole column
};

/// Subjects of an element's columns: for a number "element3" and the name of that body, else the name itself.
[[nodiscard]] std::vector<std::string> subjects_of(const SavedRun& run, const std::string& element);

/// The curves of a run that match the query, in the order of the query's elements. Errors: InputError naming the file
/// or folder of the run, the saved histories and the nearest name.
[[nodiscard]] std::vector<SelectedCurve> selected_curves(const SavedRun& run, const CurveQuery& query);

/// The saved histories of a run, listed like the menus of HPLOT: for each file the quantities with their numbers in the
/// 1993 code, units, titles and elements.
[[nodiscard]] std::string menu(const SavedRun& run);

}  // namespace talus::app
