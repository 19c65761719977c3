#pragma once

#include <vector>

namespace talus::verification::reference {

/// Discs in the open plane that push each other by a spring and a dashpot that cannot pull. Each step tries all pairs.
struct AllPairs {
  double stiffness{};                        ///< [F/L]
  double damping{};                          ///< [F T/L]
  std::vector<double> radius, inverse_mass;  ///< [L], [1/M]
  std::vector<double> x, y, vx, vy;          ///< [L], [L/T]
  bool backwards{};                          ///< the pairs in the opposite order

  /// A kick and a drift over h; forces see the velocities of before the kick.
  void step(double h);
};

}  // namespace talus::verification::reference
