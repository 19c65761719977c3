#pragma once

#include <string>

#include "solver/io/output/run_folder.hpp"
#include "solver/io/output/run_record.hpp"

namespace talus {

/// plot.json: descriptions of the figures of a run (paths, velocities, contact forces, tensions, energies), which
/// `talus plot` draws from the columns of `csv_file`, in the schema of verification records; and the files from which
/// histories, snapshots and animations are drawn (see read_run_folder).
[[nodiscard]] std::string plot_json(const RunRecord& record, const std::string& csv_file, const RunFiles& files);

}  // namespace talus
