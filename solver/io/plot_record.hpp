#pragma once

#include <string>

#include "solver/io/run_record.hpp"

namespace talus {

/// plot.json: the figures of a run (paths, velocities, contact forces, tensions, energies) as descriptions over the
/// columns of `csv_file`, in the schema of verification records; talus_report draws them.
[[nodiscard]] std::string plot_json(const RunRecord& record, const std::string& csv_file);

}  // namespace talus
