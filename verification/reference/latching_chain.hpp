#pragma once

#include <span>
#include <vector>

/// Equal discs on a line that push each other by springs that latch (Walton & Braun, J. Rheology 30 (1986) 949).
///
/// With d the overlap of two neighbours and M the largest since they met, a contact is on one of four lines:
///
///   open       F = 0                       until d = 0, then loading with M = 0
///   loading    F = K1 d                    until d' = 0, then unloading with M = d
///   unloading  F = K1 M - K2 (M - d)       until d = M, then loading; or F = 0 at d0 = M (1 - K1/K2), then slack
///   slack      F = 0                       until d = d0, then unloading; or d = 0, then open: M is forgotten
///
/// On any set of lines the motion is that of linear springs. It is integrated tightly (Trajectory: odeint in long
/// double) from change to change; each change is located to round-off, and the line that follows is that of the table.
/// Energy: a contact that loaded up to M and has parted has kept K1 M^2 (1 - K1/K2)/2, wherever it went in between.
namespace talus::verification::reference {

struct LatchingChain {
  double loading{};              ///< K1 [F/L] > 0
  double unloading{};            ///< K2 [F/L] >= K1
  double mass{};                 ///< m of each disc [M] > 0
  std::vector<double> velocity;  ///< of the discs from left to right at t = 0 [L/T]; two at least
  std::vector<double> gap;       ///< between neighbours at t = 0 [L] >= 0; one fewer
};

/// Discs from left to right, the first of `count` thrown against the others, which are at rest; all touch.
[[nodiscard]] LatchingChain struck_chain(std::size_t count, double ratio, double mass, double loading, double speed);

/// What happens until no force is left and none will come.
struct ChainRebound {
  std::vector<double> velocity;  ///< of the discs in the end [L/T]
  std::vector<double> largest;   ///< overlap of each contact [L]
  double kept{};                 ///< energy that all contacts have kept [F L]
  double end_time{};             ///< when the last force vanished [T]
  int reloads{};                 ///< times that a contact was pressed again before it had parted
  int reloads_from_slack{};      ///< of these, where its force had been zero
};

/// std::invalid_argument outside the ranges above.
[[nodiscard]] ChainRebound chain_rebound(const LatchingChain& chain);

/// Velocities of the discs at ascending times >= 0, one vector for each time.
[[nodiscard]] std::vector<std::vector<double>> chain_velocities(const LatchingChain& chain,
                                                                std::span<const double> times);

}  // namespace talus::verification::reference
