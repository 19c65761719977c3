#pragma once

#include <vector>

namespace talus::verification::reference {

/// Discs in the open plane with spring-dashpot contacts that cannot pull. Each step tests all pairs.
struct AllPairs {
  double stiffness{};                        ///< [F/L]
  double damping{};                          ///< [F T/L]
  std::vector<double> radius, inverse_mass;  ///< [L], [1/M]
  std::vector<double> x, y, vx, vy;          ///< [L], [L/T]
  bool backwards{};                          ///< process the pairs in the opposite order

  /// Kick and drift over h; forces use the velocities before the kick.
  void step(double h);
};

}  // namespace talus::verification::reference
