#pragma once

#include <functional>
#include <map>
#include <string>

#include "solver/base/archive.hpp"
#include "verification/check/case.hpp"

/// Runs whose results are recorded bit by bit, for the case `recorded_bits`.
namespace talus::verification::problems {

/// Results of one run.
struct RunResult {
  std::string group;                          ///< group of the case's checks
  std::string name;                           ///< unique within the group
  std::map<std::string, ArchiveItems> parts;  ///< numbers by name
  int not_restored{};                         ///< objects that differ after they are restored from saved items
};

/// Runs all recorded runs and calls `take` with the result of each. Bodies: scenes and fences as users write them, and
/// scenes with every loss mechanism with every integrator; with histories, energy balances, extremes, summaries of
/// fences, and the content of a checkpoint at the end. Discs: cells of every law with every method; packings, and their
/// flow in both engines. With setup.coarse only the yard with velocity Verlet.
void run_all(Findings& findings, const Setup& setup, const std::function<void(const RunResult&)>& take);

}  // namespace talus::verification::problems
