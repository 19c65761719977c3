#pragma once

#include "verification/problems/speed_accuracy/work_curves.hpp"
#include "verification/study/toolkit.hpp"

/// Curves of error against work as one file of tidy data, the figures drawn from this file alone, and tables of the
/// cost of an accuracy.
namespace talus::verification::problems {

/// A scene and the curves of all methods on it, in the order of work_methods.
struct SceneCurves {
  const WorkScene* scene{};
  std::vector<WorkCurve> curves;
};

/// The errors for which costs are interpolated.
inline constexpr double read_off_errors[] = {1e-2, 1e-4, 1e-6, 1e-9};

/// One row for each point and quantity.
[[nodiscard]] DataFile work_data(const std::vector<SceneCurves>& all);

/// A chart for each scene and quantity of the data.
[[nodiscard]] std::vector<Figure> work_figures(const DataFile& data);

/// For each accuracy, a table of the evaluations of each method on each scene.
[[nodiscard]] std::vector<Table> cost_tables(const std::vector<SceneCurves>& all);

/// The method that reaches an error for the fewest evaluations, and their number; empty and infinite if none does.
struct Cheapest {
  std::string method;
  double evaluations{};
};
[[nodiscard]] Cheapest cheapest(const SceneCurves& curves, std::size_t quantity, double error);

/// Table of the cheapest method and its evaluations for each scene, quantity and accuracy.
[[nodiscard]] Table cheapest_table(const std::vector<SceneCurves>& all);

/// A number of evaluations as text for tables; "-" if infinite.
[[nodiscard]] std::string evaluations_text(double evaluations);

}  // namespace talus::verification::problems
