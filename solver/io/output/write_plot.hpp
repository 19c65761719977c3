#pragma once

#include <string>

#include "solver/io/output/run_folder.hpp"
#include "solver/io/output/run_record.hpp"

namespace talus {

/// plot.json: the figures of a run (paths, velocities, contact forces, tensions, energies) as descriptions over the
/// columns of `csv_file`, in the schema of verification records, which `talus plot` draws; and the files that
/// histories, snapshots and animations are drawn from (read_run_folder).
[[nodiscard]] std::string plot_json(const RunRecord& record, const std::string& csv_file, const RunFiles& files);

}  // namespace talus
