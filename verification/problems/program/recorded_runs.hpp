#pragma once

#include <functional>
#include <map>
#include <string>

#include "solver/base/archive.hpp"
#include "verification/check/case.hpp"

/// Runs whose results are recorded bit by bit, for the case `recorded_bits`.
namespace talus::verification::problems {

/// What a run leaves.
struct RunResult {
  std::string group;                          ///< of the case's checks
  std::string name;                           ///< unlike those of the group's other runs
  std::map<std::string, ArchiveItems> parts;  ///< numbers by name
  int not_restored{};                         ///< objects that differ once they are put back from what was saved
};

/// Bodies: scenes and fences as users write them, and scenes with every mechanism of loss by every integrator; with
/// histories, energy balances, extremes, summaries of fences, and what a checkpoint holds at the end. Discs: cells of
/// every law by every method; packings, and their flow in both engines. Calls `take` with one run after the other; with
/// setup.coarse the yard by velocity Verlet alone.
void run_all(Findings& findings, const Setup& setup, const std::function<void(const RunResult&)>& take);

}  // namespace talus::verification::problems
