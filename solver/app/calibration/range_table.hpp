#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/spacing.hpp"
#include "solver/base/units.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/io/file/quantity_table.hpp"

namespace talus::app {

/// The numbers of an axis, in SI units: the first one, the last one (both > 0) and their number, from 2 to 100. Errors:
/// InputError naming the option.
[[nodiscard]] std::vector<double> axis_of(const std::string& option, const std::vector<std::string>& texts,
                                          Dimension dimension, Spacing spacing);

/// Prints a table with names and units of its columns.
void print_table(const std::vector<QuantityColumn>& table, const UnitSystem& units);

/// An array with an object for each row, in SI units.
[[nodiscard]] nlohmann::ordered_json rows_of(const std::vector<QuantityColumn>& table);

/// Writes `calibration.csv` into the folder of the options, and sends the drawing to the sink. The names of files are
/// printed, unless the output is JSON. Errors: IoError.
void write_table(const std::vector<QuantityColumn>& table, const CalibrateOptions& options, const UnitSystem& units,
                 DrawingRequest drawing, const DrawingSink& sink);

/// Calibrates, and prints the result as JSON or as a text in the units of the options by its own print_json and
/// print_text. With a folder in the options, its write_files writes its table. Returns the exit status. Errors:
/// InputError for unknown units, before the calibration, and those of the calibration; IoError.
template <class Calibrate>
[[nodiscard]] int report(const Calibrate& calibrate, const CalibrateOptions& options, const DrawingSink& sink) {
  const UnitSystem units = unit_system(options.units);
  const auto found = calibrate(options);
  if (options.json) {
    print_json(found, options);
  } else {
    print_text(found, options, units);
  }
  if (!options.picture.folder.empty()) write_files(found, options, units, sink);
  return ok;
}

}  // namespace talus::app
