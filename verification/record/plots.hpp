/// The figures that a run describes in its `plot.json`, over the CSV files beside it.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/record/figure.hpp"

namespace talus::records {

/// Reads the figures of a plot.json (schema 1), without their points: see read_points(). FileError if the file cannot
/// be read; RecordError (file and path) if it is not what the schema says or holds no figure. Keys that hold a default
/// may be absent.
[[nodiscard]] std::vector<Figure> read_plots(const std::filesystem::path& file);

}  // namespace talus::records
