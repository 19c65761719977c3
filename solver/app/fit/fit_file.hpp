#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/app/sweep/sweep_file.hpp"
#include "solver/fit/least_squares.hpp"

namespace talus::app {

/// A column of the data that sets a field of the scene.
struct FitInput {
  std::string where;  ///< file, line and table, for errors
  std::string heading, field;
  std::string unit;            ///< of the heading; empty: a pure number
  std::vector<double> values;  ///< of each row, in this unit
};

/// A column of the data that a run is compared with.
struct FitQuantity {
  std::string where;  ///< file, line and table, for errors
  std::string name;
  std::string heading;
  std::string result;                 ///< name of an output of a run
  std::string unit;                   ///< of the heading; empty: a pure number
  std::optional<double> uncertainty;  ///< standard deviation of a measured value, in this unit
  std::vector<double> values;         ///< of each row, in this unit
  std::string divisor_unit;           ///< of the column that results are divided by
  std::vector<double> divisors;       ///< of each row, in this unit; empty: results are not divided
};

/// A field of the scene that is fitted.
struct FittedField {
  std::string where;  ///< file, line and table, for errors
  std::string field;
  std::string unit;        ///< of the bounds; empty: a pure number
  bool has_start{};        ///< the start is given: otherwise the middle of the range
  FitParameter parameter;  ///< in this unit
};

/// Measurements and the parameters of a scene that are fitted to them.
struct FitFile {
  std::filesystem::path file;  ///< named in errors
  std::string title;
  std::filesystem::path scene, data;  ///< relative to the current folder
  std::vector<FitInput> inputs;
  std::vector<FitQuantity> quantities;
  std::vector<FittedField> parameters;
  std::size_t rows{};
  std::size_t samples{200};  ///< of the bootstrap
  std::int64_t seed{1};
  SweepLimits limits;

  /// Whether the uncertainties of the measured values are given.
  [[nodiscard]] bool has_uncertainties() const { return quantities.front().uncertainty.has_value(); }
};

/// Reads such a file, TOML, and its data; `name` is the file named in errors, and files that it names are relative to
/// its folder. Errors: InputError with all errors of the file, each with file, line and key, or with file and line of
/// the data; IoError for data that cannot be read.
[[nodiscard]] FitFile read_fit(std::string_view text, const std::filesystem::path& name);

}  // namespace talus::app
