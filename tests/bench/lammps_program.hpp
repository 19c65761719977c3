#pragma once

#include "solver/io/cell/lammps.hpp"
#include "tests/temporary_folder.hpp"

namespace talus::bench {

/// The installed LAMMPS, run in a temporary folder.
class LammpsProgram {
 public:
  LammpsProgram();

  bool there() const { return there_; }
  /// True if it can be run on several cores.
  bool has_mpi() const { return has_mpi_; }
  /// Seconds in its loop over all steps, as LAMMPS reports them: without reading and setup. Processor time on one core,
  /// wall-clock time on several. 0 if the run failed.
  double seconds(const LammpsScene& scene, const LammpsRun& run, int cores = 1) const;
  /// The fastest combination of style, newton on or off, and skin, on one core.
  LammpsRun best_run(const LammpsScene& scene, double step, long steps) const;

 private:
  bool there_, has_mpi_;
  Folder folder_;
};

}  // namespace talus::bench
