#pragma once

#include <string>
#include <vector>

#include "solver/app/capacity/capacity_study.hpp"
#include "solver/capacity/proportion.hpp"
#include "verification/record/figure.hpp"

namespace talus::app {

/// The speeds up to which rocks of one mass are stopped.
struct CapacityBoundary {
  double mass{};    ///< [kg]
  Interval speed;   ///< stopped at all up to the first (0: at none), at none from the second on (infinite: none) [m/s]
  Interval energy;  ///< kinetic energy of these [J]
  /// Trials at these two speeds; null: none in the map, or none were executed there.
  const RockTrials *stopped{}, *passed{};
};

/// The boundaries at every `stride`-th mass of a map's grid; without stride at those of its first cells.
[[nodiscard]] std::vector<CapacityBoundary> boundaries_of(const CapacityStudy& study, const RockMap& map,
                                                          int stride = 0);

/// How much one energy for all masses is wrong: the largest energy up to which rocks of a mass are stopped, over the
/// smallest from which those of another mass are not (failed and undecided runs count as not stopped); 1 if they are
/// equal within their intervals.
[[nodiscard]] double energy_factor(const std::vector<CapacityBoundary>& boundaries);

/// Every node with trials as a line of CSV: height, spin, position, mass, speed, kinetic energy, trials by their end,
/// probability of being stopped with its interval, state, and of each output the median and the 95th percentile; in SI
/// units, or ft, lb, s and lbf for a base in US units.
[[nodiscard]] std::string capacity_csv(const CapacityStudy& study);

/// Rules, boundaries, audits and the hazard as JSON, in SI units.
[[nodiscard]] std::string capacity_json(const CapacityStudy& study, const RockRuns& rocks);

/// The results as text for a terminal, in m, kg, kN and kJ, or ft, lb, kip and kip ft for a base in US units.
[[nodiscard]] std::string capacity_text(const CapacityStudy& study);

/// Of each map: its nodes with lines of equal kinetic energy; the largest cable force over the kinetic energy; and
/// along the boundary the forces of the fastest rocks that are stopped and the energies of the slowest that are not. In
/// the units of the text.
[[nodiscard]] std::vector<records::Figure> capacity_figures(const CapacityStudy& study);

}  // namespace talus::app
