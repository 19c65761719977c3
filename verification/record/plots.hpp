/// The figures that a run describes in its `plot.json`, with data in the CSV files beside it.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/record/figure.hpp"

namespace talus::records {

/// Reads the figures of a plot.json (schema 1), without their points: see read_points(). FileError if the file cannot
/// be read; RecordError (file and path) if it violates the schema or contains no figure. Keys with a default may be
/// absent.
[[nodiscard]] std::vector<Figure> read_plots(const std::filesystem::path& file);

}  // namespace talus::records
