#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace talus {

/// Linear motion within a mode: accelerations and memory rates as linear functions of the change of coordinates,
/// velocities and memory, as long as no mode changes,
///
///   a = a0 - sum stiffness (q - q0) - sum damping (v - v0) - sum pull (z - z0),   dz/dt = dz0/dt + sum slope (v - v0).
///
/// Terms of the same row and column add up. No terms: free flight. Memory that follows the motion, such as the stretch
/// of friction, also acts through the stiffness, as if it were no memory; the solver's z - z0 is only the part that
/// this misses.
struct LinearSegment {
  struct Term {
    std::size_t row{};     ///< index of the acceleration
    std::size_t column{};  ///< index of the coordinate and its velocity
    double stiffness{};    ///< [1/T^2 of row/column]
    double damping{};      ///< [1/T of row/column]
  };
  struct MemoryTerm {
    std::size_t row{};     ///< index of the memory rate
    std::size_t column{};  ///< index of the velocity
    double slope{};        ///< [row/column]
  };
  struct MemoryPull {
    std::size_t row{};     ///< index of the acceleration
    std::size_t column{};  ///< index of the memory
    double pull{};         ///< [1/T^2 of row/column]
  };
  std::vector<Term> terms;
  std::vector<MemoryTerm> memory;
  std::vector<MemoryPull> pulls;
};

/// Upper bound of the oscillation and decay rates of a linear motion [1/T], from its largest row sums. `lengths`: the
/// distance by which one unit of each coordinate moves its body [L].
[[nodiscard]] double fastest_rate(const LinearSegment& piece, std::span<const double> lengths);

/// Solves (I + b C + b^2 K) x = r for the stiffness K and damping C of a linear motion. Coordinates are divided into
/// groups that are coupled by terms; each group has a dense LU factorisation with partial pivoting. Equal input gives
/// bit-identical results.
class AffineSolver {
 public:
  /// Largest group of coupled coordinates allowed: the cost of a factorisation grows with the cube of its size.
  static constexpr std::size_t largest_group = 150;

  /// Finds the groups of coupled coordinates. Returns false if one is too large.
  [[nodiscard]] bool group(const LinearSegment& piece, std::size_t coordinates);
  /// Factorises for b [T]; group() must have been called for the same piece. Returns false if a group is singular.
  [[nodiscard]] bool factorise(const LinearSegment& piece, double b);
  /// Solves in place: x is r on entry and the solution on return.
  void solve(std::vector<double>& x) const;

 private:
  struct Group {
    std::vector<std::size_t> coordinates;
    std::vector<double> lu;           ///< row-major
    std::vector<std::size_t> pivots;  ///< per column, the row that was exchanged with it
  };
  struct GroupIndex {
    std::size_t group{};
    std::size_t index{};
  };
  static bool factorise(Group& group);

  std::vector<Group> groups_;
  std::vector<GroupIndex> indices_;  ///< per coordinate; no group for one without terms
  mutable std::vector<double> gathered_;
};

}  // namespace talus
