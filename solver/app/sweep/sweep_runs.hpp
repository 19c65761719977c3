#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/app/sweep/sweep_file.hpp"

namespace talus::app {

/// One run of a sweep: the fields of the base that it changes, in the order of the axes.
struct SweptRun {
  std::string id;  ///< 16 hexadecimal digits that follow from the parameters alone
  std::vector<std::pair<std::string, TomlValue>> parameters;
};

/// The runs of a sweep.
struct SweptRuns {
  std::vector<SweptRun> runs;
  std::size_t left_out{};  ///< number of points that do not satisfy the constraints
};

/// All runs of a sweep, in the order of its design; of a grid the last axis changes first. A run has the same id
/// however many others there are: the second one with the same parameters has another. Errors: InputError if no run
/// satisfies the constraints, or a constraint compares values of different dimensions; with the file.
[[nodiscard]] SweptRuns swept_runs(const SweepFile& sweep);

/// Index of the first constraint that a run breaks. Errors: InputError for values of different dimensions, with the
/// location of the constraint.
[[nodiscard]] std::optional<std::size_t> broken_constraint(const SweptRun& run, const SweepFile& sweep);

/// The base with the fields of a run. Errors: InputError for a field that the base cannot have.
[[nodiscard]] TomlValue with_parameters(TomlValue base, const SweptRun& run);

/// Checks the fields of a run, which are those of all runs of a sweep. Errors: InputError for a field that the base
/// cannot have, or that two of them change by equal or different paths.
void check_fields(TomlValue base, const SweptRun& run);

/// Gives the runs of a sweep their ids. Errors: InputError for two runs with one id.
void set_ids(std::vector<SweptRun>& runs);
/// The id of a run with these parameters of which there is one.
[[nodiscard]] std::string id_of(const SweptRun& run);

/// A run as one line of JSON, and back. Errors: InputError for a line of another form.
[[nodiscard]] std::string manifest_line(const SweptRun& run);
[[nodiscard]] SweptRun run_of_line(const std::string& line);

}  // namespace talus::app
