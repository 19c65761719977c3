#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace talus {

/// Linear piece of a motion: how the accelerations of a state, and the rates of its memory, change with its coordinates
/// and velocities while no mode changes,
///
///   a = a0 - sum stiffness (q - q0) - sum damping (v - v0) - sum pull (z - z0),   dz/dt = dz0/dt + sum slope (v - v0).
///
/// Terms of the same row and column add up. No terms: free flight. Archive that follows the motion, as the stretch of
/// friction, is in the stiffness too, as if it had no memory: the solver's z - z0 is what it misses beyond that.
struct AffinePiece {
  struct Term {
    std::size_t row{};     ///< of the acceleration
    std::size_t column{};  ///< of the coordinate and its velocity
    double stiffness{};    ///< [1/T^2 of row/column]
    double damping{};      ///< [1/T of row/column]
  };
  struct MemoryTerm {
    std::size_t row{};     ///< of the memory rate
    std::size_t column{};  ///< of the velocity
    double slope{};        ///< [row/column]
  };
  struct MemoryPull {
    std::size_t row{};     ///< of the acceleration
    std::size_t column{};  ///< of the memory
    double pull{};         ///< [1/T^2 of row/column]
  };
  std::vector<Term> terms;
  std::vector<MemoryTerm> memory;
  std::vector<MemoryPull> pulls;
};

/// Upper bound of the rates at which motions of the piece oscillate or decay [1/T]: by the largest row sums. `lengths`:
/// the length by which one unit of each coordinate moves its body [L].
[[nodiscard]] double fastest_rate(const AffinePiece& piece, std::span<const double> lengths);

/// Solves (I + b C + b^2 K) x = r for the stiffness K and damping C of a piece: by groups of coordinates that its terms
/// couple, each with a dense LU factorisation with partial pivoting. Same input, same bits.
class AffineSolver {
 public:
  /// Largest group of coupled coordinates: factorising costs the cube of its size.
  static constexpr std::size_t largest_group = 150;

  /// Finds the groups. False if one is too large.
  [[nodiscard]] bool group(const AffinePiece& piece, std::size_t coordinates);
  /// Factorises for b [T], with the groups of the same piece. False if a group is singular.
  [[nodiscard]] bool factorise(const AffinePiece& piece, double b);
  /// In place.
  void solve(std::vector<double>& x) const;

 private:
  struct Group {
    std::vector<std::size_t> coordinates;
    std::vector<double> lu;           ///< by rows
    std::vector<std::size_t> pivots;  ///< of each column, the row that was exchanged with it
  };
  struct Place {
    std::size_t group{};
    std::size_t index{};
  };
  static bool factorise(Group& group);

  std::vector<Group> groups_;
  std::vector<Place> places_;  ///< of each coordinate; of one without terms none
  mutable std::vector<double> gathered_;
};

}  // namespace talus
