#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/scenes/fence.hpp"

/// Tables 2 and 3 of the 1993 report: the printed numbers, and the fence that a row describes.
namespace talus::verification::problems {

/// A printed number.
struct PrintedNumber {
  double value{};
  double half{};  ///< half a unit in the last digit
};

/// The printed numbers of one cable model in a row of Table 2 or 3, in feet, pounds and seconds.
struct PrintedRow {
  int table{};
  double rock{};    ///< weight [lb]
  double slack{};   ///< of the bottom cable [ft]; 0 if there is none
  double height{};  ///< yc: height of the impact above the column's centroid [ft]
  bool bottom_cable{};
  bool plastic{};                       ///< elastic, perfectly plastic cables (printed in parentheses)
  PrintedNumber joint;                  ///< force in the top joint [lb]
  PrintedNumber top;                    ///< force in the top cable [lb]
  std::optional<PrintedNumber> bottom;  ///< force in the bottom cable [lb]
  PrintedNumber speed;                  ///< x velocity of the rock after the impact [ft/s]
};

/// All rows, from cases/published/fence_tables_2_3.csv. Throws std::runtime_error with the line if one is malformed.
[[nodiscard]] std::vector<PrintedRow> printed_rows();

/// Short unique name such as "T2 slack 0.5 -1.5 plastic".
[[nodiscard]] std::string name_of(const PrintedRow& row);

/// Reads the deck cases/fence/NAME.
[[nodiscard]] scenes::Fence published_fence(const std::string& name);

/// Fence of a row: cases/fence/table_2.DAT or table_3.DAT with the row's height, cables and yield forces.
[[nodiscard]] scenes::Fence fence_of(const PrintedRow& row);

}  // namespace talus::verification::problems
