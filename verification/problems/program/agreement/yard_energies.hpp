#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/problems/program/agreement/expected_files.hpp"

/// Energies of the yard (agreeing_scenes.hpp) by its laws, for each row of history.csv.
namespace talus::verification::problems::agreeing_files {

struct YardEnergies {
  std::vector<double> contacts, cables;                   ///< stored
  std::map<std::string, std::vector<double>> dissipated;  ///< by mechanism, since the start
};

/// From positions, velocities and the step alone. Velocity Verlet evaluates the laws at the positions of a row with the
/// velocities of the half step before it, v[n-1/2] = (x[n] - x[n-1])/h, and integrates their power by the trapezoidal
/// rule; energy that a change of mode releases is added at the row of the change.
[[nodiscard]] YardEnergies yard_energies(const Run& run);

}  // namespace talus::verification::problems::agreeing_files
