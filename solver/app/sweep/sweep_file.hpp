#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/fields.hpp"
#include "solver/base/spacing.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/scene/scene_table.hpp"

namespace talus::app {

/// A number with its unit as written; pure numbers have none.
struct WrittenNumber {
  double value{};
  std::string unit;
};

/// Values between numbers, or according to the quantiles of a distribution.
struct Continuous {
  std::string unit;
  bool whole{};  ///< whole numbers only
  Spacing spacing{Spacing::even};
  /// Cumulative probabilities from 0 to 1 and their values; between them the distribution is even, or even in the
  /// logarithm. A range has two.
  std::vector<std::pair<double, double>> quantiles;
  bool is_range{};
  std::int64_t count{};  ///< number of its points in a grid; 0: not given

  /// The value at a cumulative probability in [0, 1].
  [[nodiscard]] double at(double probability) const;
  /// The value as it is written in a scene, with its unit.
  [[nodiscard]] TomlValue written(double probability) const;
};

/// What is varied: one field, or several together.
struct SweepAxis {
  int line{};                       ///< of the file, counted from 1
  std::vector<std::string> fields;  ///< paths to fields of the base
  /// Values of these fields, one row for each point; empty for a continuous axis.
  std::vector<std::vector<TomlValue>> rows;
  std::optional<Continuous> continuous;
};

/// How points of several axes are combined.
enum class DesignKind {
  grid,             ///< every combination of the axes' points
  sobol,            ///< points of a Sobol sequence with a random digital shift
  latin_hypercube,  ///< each axis is divided into as many equal parts as there are runs, each with one point
  random,           ///< independent points
};
struct Design {
  DesignKind kind{DesignKind::grid};
  std::int64_t runs{};  ///< not of a grid
  std::int64_t seed{1};
};

/// A condition that points must satisfy: a field is at most, or at least, a factor times another field or a value.
struct SweepConstraint {
  std::string field;
  bool is_upper{};  ///< at most, else at least
  double factor{1.0};
  std::string other;  ///< path of a field that is varied; empty: the value
  TomlValue value;
  int line{};  ///< of the file, counted from 1
};

/// Limits of each run; 0: none.
struct SweepLimits {
  double time{};               ///< of the clock on the wall [s]
  std::int64_t evaluations{};  ///< force evaluations
};

/// A sweep as its file describes it.
struct SweepFile {
  std::string file;  ///< as named in messages
  int base_line{}, outputs_line{};
  std::string title;
  std::filesystem::path base;  ///< scene or deck, relative to the current folder
  std::vector<std::string> outputs;
  std::vector<SweepAxis> axes;
  Design design;
  std::vector<SweepConstraint> constraints;
  SweepLimits limits;

  /// "rock.toml:7: axis 1", at the beginning of messages.
  [[nodiscard]] std::string axis_location(std::size_t axis) const;
  /// "rock.toml:12: constraint 1".
  [[nodiscard]] std::string constraint_location(std::size_t constraint) const;
  /// "rock.toml:3: outputs".
  [[nodiscard]] std::string outputs_location() const;
  [[nodiscard]] std::string base_location() const;
};

/// Reads a sweep, TOML; `name` is the file named in errors, and files that it names are relative to its folder. Errors:
/// InputError with all errors, each with file, line and key; IoError for a table that cannot be read.
[[nodiscard]] SweepFile read_sweep(std::string_view text, const std::filesystem::path& name);

/// The limits of each run in a table with `time` and `evaluations`. Errors: InputError.
[[nodiscard]] SweepLimits read_limits(SceneTable table);
/// The same with `evaluations` alone, where results must not depend on the machine.
[[nodiscard]] SweepLimits read_evaluation_limit(SceneTable table);

/// Calls `action`; an InputError of it gets the name of the file that it concerns.
template <class Action>
auto of_file(const std::filesystem::path& file, Action&& action) {
  try {
    return action();
  } catch (const InputError& error) {
    throw InputError{file.string() + ": " + error.what()};
  }
}

/// A number with its unit, of a TOML number or a text such as "600 lb". Errors: InputError.
[[nodiscard]] WrittenNumber written_number(const TomlValue& value);
/// A number as it is written in a scene, with its unit; whole ones stay whole, as some fields need.
[[nodiscard]] TomlValue value_in(double number, const std::string& unit);

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::DesignKind> {
  static constexpr std::array<std::string_view, 4> list{"grid", "sobol", "latin_hypercube", "random"};
};
}  // namespace talus
