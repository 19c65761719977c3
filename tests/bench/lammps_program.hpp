#pragma once

#include <filesystem>

#include "solver/io/cell/lammps.hpp"

namespace talus::bench {

/// LAMMPS as it is installed, in a folder of its own.
class LammpsProgram {
 public:
  LammpsProgram();
  ~LammpsProgram();
  LammpsProgram(const LammpsProgram&) = delete;
  LammpsProgram& operator=(const LammpsProgram&) = delete;

  bool there() const { return there_; }
  /// Whether it can be run on several cores.
  bool has_mpi() const { return has_mpi_; }
  /// Seconds in its loop over all steps, as it says itself: without reading and setting up. On one core those of the
  /// processor, on several those of the clock. 0 if it failed.
  double seconds(const LammpsScene& scene, const LammpsRun& run, int cores = 1) const;
  /// The fastest of its styles, of newton on and off, and of several skins, on one core.
  LammpsRun best_run(const LammpsScene& scene, double step, long steps) const;

 private:
  bool there_, has_mpi_;
  std::filesystem::path folder_;
};

}  // namespace talus::bench
