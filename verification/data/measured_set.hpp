#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/integrate/integrator_list.hpp"

namespace talus::verification {

/// A number for each row of a set.
using RowNumbers = std::vector<double>;

/// A condition of the measurements that differs from row to row.
struct MeasuredInput {
  std::string column;      ///< Heading, with the unit in brackets.
  std::string unit;        ///< "1" for a pure number.
  std::string field;       ///< Of the scene: "body.disc.velocity[0]".
  RowNumbers values;       ///< [unit]
  RowNumbers uncertainty;  ///< Standard uncertainty [unit]; 0 where it is not known.
};

/// The column against which the quantities are drawn.
struct MeasuredAxis {
  std::string label;  ///< Heading without its unit.
  std::string unit;
  RowNumbers values;
};

/// A measured quantity and the result of a run that it is compared with.
struct MeasuredQuantity {
  std::string name;
  std::string column;
  std::string unit;
  std::string result;      ///< "final.disc.vx", or a quotient of two such: see RunResults.
  RowNumbers values;       ///< [unit]
  RowNumbers uncertainty;  ///< Standard uncertainty, > 0 [unit].
  double model_error{};    ///< Standard deviation that is granted to the model [unit].
  std::string at{};        ///< "FILE:LINE: quantity 'NAME': result", for messages.
};

/// A wrong scene that the comparison must reject.
struct MeasuredControl {
  std::string name;
  std::string what;
  std::string field;
  std::string value;      ///< As TOML: "0.3", "\"5 m/s\"".
  std::string turns_red;  ///< Name of a quantity.
};

/// Measurements that a user compares with runs of one scene: a file NAME.measured.toml, and the CSV file and the scene
/// that it names.
struct MeasuredSet {
  std::filesystem::path file;
  std::string id;  ///< NAME.
  std::string title, source;
  std::string what;        ///< Description of the measurements.
  std::string conclusion;  ///< May be empty.
  std::string not_shown;   ///< What must not be concluded.
  std::string scene;       ///< Text of the scene file.
  Integrator integrator;   ///< Of the scene.
  std::size_t rows{};
  MeasuredAxis axis;
  std::vector<MeasuredInput> inputs;
  std::vector<MeasuredQuantity> quantities;
  std::vector<MeasuredControl> controls;
};

/// Reads a set. Errors: InputError with file, line and field; IoError for a file that cannot be read.
[[nodiscard]] MeasuredSet read_measured_set(const std::filesystem::path& file);

/// The files NAME.measured.toml of a folder, by name. Errors: InputError if there is none; IoError if the folder cannot
/// be read.
[[nodiscard]] std::vector<std::filesystem::path> measured_files(const std::filesystem::path& folder);

}  // namespace talus::verification
