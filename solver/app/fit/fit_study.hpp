#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/app/fit/fit_file.hpp"
#include "solver/app/sweep/sweep_base.hpp"
#include "solver/fit/least_squares.hpp"

namespace talus::app {

/// Runs of the scene with the inputs of the rows of data, whose results are compared with the measured values.
class FitStudy {
 public:
  /// Errors: InputError for a scene that is wrong, fields or results that it does not have, or units that do not fit;
  /// IoError.
  FitStudy(const FitFile& file, unsigned threads);

  /// An interruption ended the fit.
  struct Interrupted {};

  /// The fit. Throws Interrupted once `interrupted` is true; `progress` gets the number of runs. Errors: InputError if
  /// no parameters are found with which all rows have a result.
  [[nodiscard]] Fit fitted(const std::function<bool()>& interrupted, const std::function<void(std::size_t)>& progress);

  /// Results of all rows' runs, row by row, for each quantity in the unit of its column; NaN without a result. After
  /// fitted().
  [[nodiscard]] std::vector<double> results(const std::vector<double>& parameters);
  /// Number of runs.
  std::size_t runs() const { return runs_; }

 private:
  /// How a quantity follows from an output of the base.
  struct Source {
    std::size_t output{};
    double factor{1.0};  ///< from the unit of the output, over that of a divisor, to that of the column
  };

  /// Finds wrong fields before anything is run. Errors: InputError with the place of the field.
  void check_first_row() const;
  SweptRun run(const std::vector<double>& parameters, std::size_t row) const;
  /// As results(), of some rows.
  std::vector<double> results(const std::vector<double>& parameters, const std::vector<std::size_t>& rows);

  const FitFile* file_;
  unsigned threads_;
  SweepBase base_;
  std::vector<Source> sources_;
  std::function<bool()> interrupted_;
  std::function<void(std::size_t)> progress_;
  std::size_t runs_{};
  std::string failure_;  ///< why a run of the last evaluation with failures has no result
};

}  // namespace talus::app
