#pragma once

#include <string>
#include <vector>

#include "verification/problems/program/agreement/expected_files.hpp"

/// Contacts of the fence (agreeing_scenes.hpp) by their law, for each row of history.csv.
namespace talus::verification::problems::agreeing_files {

/// A spring and dashpot between two outlines: of two rocks, of a rock and the face of a column, or of one end of the
/// faces of two columns, of which the corner nearer to the middle is below the other face.
struct FenceSpring {
  std::string contact;
  double stiffness{};  ///< reduced mass times the square of the fastest rock's speed over the overlap of the scene
  double damping{};    ///< from the force in the first row in which it acts
  double damping_ratio{},
      ratio_bound{};                  ///< c/(2 sqrt(k m)) with the effective mass m at the touch, and its error bound
  double start_mass{};                ///< effective mass in the position of the start
  std::vector<double> overlap, rate;  ///< by geometry; the overlap is negative if the outlines are apart

  [[nodiscard]] double sum(std::size_t row) const { return stiffness * overlap[row] + damping * rate[row]; }
  /// It never pulls.
  [[nodiscard]] bool acts(std::size_t row) const { return damping > 0.0 && overlap[row] >= 0.0 && sum(row) > 0.0; }
  [[nodiscard]] double force(std::size_t row) const { return acts(row) ? sum(row) : 0.0; }
  [[nodiscard]] double stored(std::size_t row) const {
    return acts(row) ? 0.5 * stiffness * overlap[row] * overlap[row] : 0.0;
  }
};

/// The springs of the contacts that act in the run.
[[nodiscard]] std::vector<FenceSpring> fence_springs(const Run& run);

/// Energy dissipated by the dashpots up to each row, from every row or every other: the integral of c d'^2 over the
/// intervals in which they act, whose ends between two rows are those where overlap or force is zero by interpolation.
/// For `every` = 2 rows between hold the last sum.
[[nodiscard]] std::vector<double> damped_energy(const Run& run, const std::vector<FenceSpring>& springs,
                                                std::size_t every);

/// Energy of the springs that stop acting before their outlines part, up to each row; by interpolation to the zero of
/// the force.
struct Released {
  std::vector<double> energy;
  double bound{};  ///< largest change of a released energy between the rows before and after the release
};
[[nodiscard]] Released released_energy(const Run& run, const std::vector<FenceSpring>& springs);

/// Stored energy in the rows in which only the first rock touches and slips: both springs, the second stretched to mu
/// N. It slips from the row on in which friction spring and dashpot, which are those of the normal direction, would
/// carry more than mu N, until the slip changes its sign. NaN in the other rows.
[[nodiscard]] std::vector<double> slipping_energy(const Run& run, const std::vector<FenceSpring>& springs);

}  // namespace talus::verification::problems::agreeing_files
